#include "geometry/npy_file.h"

#include <bit>
#include <charconv>
#include <string>

#include "geometry/error.h"
#include "geometry/shortened.h"

namespace lode::geometry {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

namespace {

constexpr std::size_t kPreamble = 10;  // magic word (6), version (2), length of the header (2)

/// Takes a header apart, from left to right. Spaces count for nothing.
class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  void expect(std::string_view token) {
    skip_spaces();
    if (!text_.starts_with(token)) fail(token);
    text_.remove_prefix(token.size());
  }
  bool take(std::string_view token) {
    skip_spaces();
    if (!text_.starts_with(token)) return false;
    text_.remove_prefix(token.size());
    return true;
  }
  std::size_t number() {
    skip_spaces();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc() || value > (std::size_t(1) << 32)) fail("a size");
    text_.remove_prefix(std::size_t(end - text_.data()));
    return value;
  }
  std::string quoted() {
    expect("'");
    const std::size_t end = text_.find('\'');
    if (end == std::string_view::npos) fail("'");
    std::string word(text_.substr(0, end));
    text_.remove_prefix(end + 1);
    return word;
  }

 private:
  void skip_spaces() {
    while (text_.starts_with(' ') || text_.starts_with('\n')) text_.remove_prefix(1);
  }
  [[noreturn]] void fail(std::string_view expected) const {
    throw Error(ErrorKind::bad_input, path_ + ": the array's header: expected " + std::string(expected) + ", found \"" +
                                          shortened(text_, 40) + "\"");
  }

  std::string_view text_;
  const std::string& path_;
};

/// The header as NumPy writes it: its three keys in alphabetical order.
void read_header(std::string_view text, const std::string& path, NpyArray& array) {
  HeaderReader header(text, path);
  header.expect("{");
  header.expect("'descr':");
  array.descr = header.quoted();
  header.expect(",");
  header.expect("'fortran_order':");
  header.expect("False");
  header.expect(",");
  header.expect("'shape':");
  header.expect("(");
  while (!header.take(")")) {
    if (array.shape.size() == 4) header.expect(")");
    array.shape.push_back(header.number());
    if (!header.take(",")) {
      header.expect(")");
      break;
    }
  }
}

}  // namespace

void write_npy(OutputFile& file, std::string_view descr, std::initializer_list<int> shape,
               std::span<const std::byte> bytes) {
  std::string header = "{'descr': '" + std::string(descr) + "', 'fortran_order': False, 'shape': (";
  for (const int n : shape) header += std::to_string(n) + ", ";
  header += "), }";

  // Spaces and a newline fill up to 64 bytes.
  const std::size_t n_bytes = (kPreamble + header.size() + 1 + 63) / 64 * 64 - kPreamble;
  header.resize(n_bytes - 1, ' ');
  header += '\n';
  const unsigned char preamble[kPreamble] = {0x93,
                                             'N',
                                             'U',
                                             'M',
                                             'P',
                                             'Y',
                                             1,
                                             0,
                                             static_cast<unsigned char>(n_bytes & 255),
                                             static_cast<unsigned char>(n_bytes >> 8)};
  file.write(preamble, sizeof preamble);
  file.write(header.data(), header.size());
  file.write(bytes.data(), bytes.size());
  file.check();
}

NpyArray read_npy(const std::string& path) {
  NpyArray array;
  array.file = read_whole_file(path);
  const std::string_view text = array.file.text();
  if (text.size() < kPreamble || !text.starts_with(std::string_view("\x93NUMPY\x01\x00", 8))) {
    throw Error(ErrorKind::bad_input, path + ": expected a NumPy array, version 1.0");
  }
  const auto byte = [&](std::size_t i) { return std::size_t(static_cast<unsigned char>(text[i])); };
  const std::size_t n_header = byte(8) + 256 * byte(9);
  if (n_header > text.size() - kPreamble) {
    throw Error(ErrorKind::bad_input, path + ": the array's header is cut off");
  }
  read_header(text.substr(kPreamble, n_header), path, array);
  if (array.descr != "|u1" && array.descr != "<f4" && array.descr != "<u4") {
    throw Error(ErrorKind::bad_input,
                path + ": elements \"" + shortened(array.descr, 20) + "\": expected |u1, <f4 or <u4");
  }
  array.bytes = array.file.span().subspan(kPreamble + n_header);
  std::size_t n_bytes = array.descr == "|u1" ? 1 : 4;
  for (const std::size_t n : array.shape) {
    // Compared with what is there before it can overflow.
    if (n != 0 && n_bytes > array.bytes.size() / n)
      n_bytes = array.bytes.size() + 1;
    else
      n_bytes *= n;
  }
  if (n_bytes != array.bytes.size()) {
    throw Error(ErrorKind::bad_input, path + ": expected as many elements as the array's shape has, found " +
                                          std::to_string(array.bytes.size()) + " bytes");
  }
  return array;
}

}  // namespace lode::geometry
