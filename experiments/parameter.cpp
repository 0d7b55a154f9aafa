#include "experiments/parameter.h"

#include <charconv>

namespace lode::experiments {

std::string number_text(double value) {
  char text[40];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return {text, error == std::errc() ? end : text};
}

}  // namespace lode::experiments
