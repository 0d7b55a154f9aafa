#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::string shortened(std::string_view text, std::size_t n_max) {
  if (text.size() <= n_max) return std::string(text);
  std::size_t end_of_head = n_max / 2;
  while (end_of_head > 0 && continues_utf8(text[end_of_head])) --end_of_head;
  std::size_t begin_of_tail = text.size() - n_max / 4;
  while (begin_of_tail < text.size() && continues_utf8(text[begin_of_tail])) ++begin_of_tail;
  return std::string(text.substr(0, end_of_head)) + "..." + std::string(text.substr(begin_of_tail));
}

}  // namespace lode::geometry
