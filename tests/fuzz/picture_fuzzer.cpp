// libFuzzer target of the picture reader: PNG and JPEG. Whatever the bytes are, there is a picture of the size that it
// says, or one Error in one line.
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "geometry/error.h"
#include "geometry/image_file/read_picture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t n) {
  using namespace lode::geometry;
  MemoryBudget budget;
  budget.add_file(n);
  try {
    const Picture picture = decode_picture(std::as_bytes(std::span(data, n)), "picture", budget);
    if (picture.texels.size() != std::size_t(picture.size_px.x) * std::size_t(picture.size_px.y)) std::abort();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::bad_input && std::string_view(error.what()).find('\n') == std::string_view::npos)
      return 0;
    std::fprintf(stderr, "picture_fuzzer: %s\n", error.what());
    std::abort();
  }
  return 0;
}
