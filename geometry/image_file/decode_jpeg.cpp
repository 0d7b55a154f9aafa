#include "geometry/image_file/decode_jpeg.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

constexpr int kRowsAtATime = 64;

/// The first line of what OpenImageIO says, without its own words around the decoder's.
std::string first_line(std::string text) {
  text.resize(std::min(text.size(), text.find('\n')));
  if (const std::size_t place = text.find(" (\"picture\")"); place != std::string::npos) text.resize(place);
  if (text.starts_with("JPEG error: ")) text.erase(0, 12);
  return text;
}

class JpegReader {
 public:
  JpegReader(const BarePicture& bare, const std::string& name)
      : name_(name), memory_(bare.bytes.data(), bare.bytes.size()), input_(OIIO::ImageInput::create("jpeg")) {
    OIIO::attribute("threads", 1);  // no thread pools for our one stream of rows
    OIIO::Filesystem::IOProxy* const proxy = &memory_;
    OIIO::ImageSpec options;
    options.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    OIIO::ImageSpec spec;
    if (!input_) throw Error(ErrorKind::machine, name_ + ": this OpenImageIO reads no JPEG: " + OIIO::geterror());
    if (!input_->open("picture", spec, options)) fail();
    n_channels_ = std::size_t(spec.nchannels);
    const bool as_expected = spec.width == bare.size_px.x && spec.height == bare.size_px.y &&
                             spec.format == OIIO::TypeDesc::UINT8 && (n_channels_ == 1 || n_channels_ == 3);
    if (!as_expected) throw Error(ErrorKind::bad_input, name_ + ": a damaged JPEG picture: expected 8-bit grey or RGB");
  }

  [[nodiscard]] std::size_t n_channels() const { return n_channels_; }

  void read_rows(int y_begin, int n, std::uint8_t* rows) {
    if (!input_->read_scanlines(0, 0, y_begin, y_begin + n, 0, 0, int(n_channels_), OIIO::TypeDesc::UINT8, rows))
      fail();
    // What the decoder had to guess is an error; bytes too many between segments are none.
    if (!input_->has_error()) return;
    if (const std::string text = input_->geterror(); text.find("extraneous bytes") == std::string::npos) fail(text);
  }

 private:
  [[noreturn]] void fail() { fail(input_->geterror()); }
  [[noreturn]] void fail(const std::string& text) {
    throw Error(ErrorKind::bad_input, name_ + ": a damaged JPEG picture: " + first_line(text));
  }

  const std::string& name_;
  OIIO::Filesystem::IOMemReader memory_;
  std::unique_ptr<OIIO::ImageInput> input_;
  std::size_t n_channels_ = 0;
};

}  // namespace

void decode_jpeg(const BarePicture& bare, const std::string& name, std::span<glm::u8vec4> texels) {
  JpegReader reader(bare, name);
  const std::size_t n_channels = reader.n_channels();
  const std::size_t width = std::size_t(bare.size_px.x);
  std::vector<std::uint8_t> rows(kRowsAtATime * width * n_channels);
  for (int y = 0; y < bare.size_px.y; y += kRowsAtATime) {
    const int n = std::min(kRowsAtATime, bare.size_px.y - y);
    reader.read_rows(y, n, rows.data());
    for (std::size_t i = 0; i < width * std::size_t(n); ++i) {
      const std::uint8_t* const c = &rows[i * n_channels];
      texels[std::size_t(y) * width + i] =
          n_channels == 3 ? glm::u8vec4(c[0], c[1], c[2], 255) : glm::u8vec4(c[0], c[0], c[0], 255);
    }
  }
}

}  // namespace lode::geometry
