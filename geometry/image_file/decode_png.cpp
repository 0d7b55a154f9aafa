#include "geometry/image_file/decode_png.h"

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

/// What libpng's callbacks work on. libpng leaves by longjmp, so that nothing here has a destructor.
struct Decoding {
  const std::byte* bytes;
  std::size_t n_left;
  char message[120];
};

void on_error(png_structp png, png_const_charp message) {
  auto* const decoding = static_cast<Decoding*>(png_get_error_ptr(png));
  std::snprintf(decoding->message, sizeof decoding->message, "%s", message);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t n) {
  auto* const decoding = static_cast<Decoding*>(png_get_io_ptr(png));
  if (n > decoding->n_left) png_error(png, "the data ends too early");
  std::memcpy(to, decoding->bytes, n);
  decoding->bytes += n;
  decoding->n_left -= n;
}

/// Every kind of PNG becomes 8-bit RGBA with straight alpha.
void set_conversions(png_structp png) {
  png_set_expand(png);    // palettes, fewer than 8 bits, tRNS
  png_set_scale_16(png);  // round(v · 255 / 65535)
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
}

/// False, with decoding.message set, if it fails.
bool decode(Decoding& decoding, glm::ivec2 size_px, glm::u8vec4* texels) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoding, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    std::snprintf(decoding.message, sizeof decoding.message, "no memory");
    return false;
  }
  if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT: libpng's way to fail
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_set_read_fn(png, &decoding, on_read);
  png_set_user_limits(png, png_uint_32(size_px.x), png_uint_32(size_px.y));
  png_read_info(png, info);
  set_conversions(png);
  const int n_passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != sizeof(glm::u8vec4) * std::size_t(size_px.x))
    png_error(png, "rows of another size");
  for (int pass = 0; pass < n_passes; ++pass) {
    for (int y = 0; y < size_px.y; ++y) {
      png_read_row(png, reinterpret_cast<png_bytep>(texels + std::size_t(y) * std::size_t(size_px.x)), nullptr);
    }
  }
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

}  // namespace

void decode_png(const BarePicture& bare, const std::string& name, std::span<glm::u8vec4> texels) {
  Decoding decoding{bare.bytes.data(), bare.bytes.size(), ""};
  if (decode(decoding, bare.size_px, texels.data())) return;
  throw Error(ErrorKind::bad_input, name + ": a damaged PNG picture: " + decoding.message);
}

}  // namespace lode::geometry
