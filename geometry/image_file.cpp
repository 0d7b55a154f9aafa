#include "geometry/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/npy_file.h"

namespace lode::geometry {
namespace {

/// Rows handed to OpenImageIO at a time: enough for its compressors' blocks, little to hold.
constexpr int kRowsAtATime = 64;

/// Lets OpenImageIO write into an OutputFile, which keeps the errors.
class OutputProxy : public OIIO::Filesystem::IOProxy {
 public:
  explicit OutputProxy(OutputFile& file) : IOProxy(OIIO::string_view(file.shown_name()), Write), file_(file) {}
  const char* proxytype() const override { return "lodestone"; }
  std::size_t write(const void* bytes, std::size_t n) override {
    file_.write(bytes, n);
    return n;
  }
  bool seek(std::int64_t offset) override {
    file_.seek(offset);
    return true;
  }
  std::int64_t tell() override { return file_.tell(); }

 private:
  OutputFile& file_;
};

/// One picture being written by OpenImageIO, row by row.
class RowWriter {
 public:
  RowWriter(OutputFile& file, ImageFormat format, OIIO::ImageSpec spec) : file_(file), proxy_(file), spec_(spec) {
    if (spec.width == 0 || spec.height == 0) {
      throw Error(ErrorKind::bad_input, file.shown_name() + ": an empty picture (" + std::to_string(spec.width) +
                                            " x " + std::to_string(spec.height) + "): expected a .npy file");
    }
    OIIO::attribute("exr_threads", -1);  // no thread pools for our one stream of rows
    OIIO::attribute("threads", 1);
    spec_.attribute("oiio:UnassociatedAlpha", 1);  // bytes as given: the PNG writer divides by alpha otherwise
    spec_.attribute("DateTime", "");               // the EXR writer adds the time of day otherwise
    OIIO::Filesystem::IOProxy* const proxy = &proxy_;
    spec_.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    output_ = OIIO::ImageOutput::create(format == ImageFormat::png ? "png" : "exr");
    if (!output_ || !output_->open(file.shown_name(), spec_)) fail();
  }

  /// Rows [y_begin, y_begin + n), tightly packed, in the spec's format.
  void write_rows(int y_begin, int n, const void* rows) {
    if (!output_->write_scanlines(y_begin, y_begin + n, 0, spec_.format, rows)) fail();
    file_.check();
  }

  void finish() {
    if (!output_->close()) fail();
    file_.check();
  }

 private:
  [[noreturn]] void fail() {
    file_.check();  // the machine's own words first
    const std::string reason = output_ ? output_->geterror() : OIIO::geterror();
    throw Error(ErrorKind::machine, file_.shown_name() + ": cannot be written: " + reason);
  }

  OutputFile& file_;
  OutputProxy proxy_;
  OIIO::ImageSpec spec_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

/// Writes a plane as it lies in memory, in the spec's format.
void write_plane(OutputFile& file, ImageFormat format, const OIIO::ImageSpec& spec, std::span<const std::byte> plane) {
  RowWriter writer(file, format, spec);
  for (int y = 0; y < spec.height; y += kRowsAtATime) {
    writer.write_rows(y, std::min(kRowsAtATime, spec.height - y), &plane[spec.scanline_bytes() * std::size_t(y)]);
  }
  writer.finish();
}

void refuse_png(const OutputFile& file, ImageFormat format, const char* what) {
  if (format != ImageFormat::png) return;
  throw Error(ErrorKind::bad_input, file.shown_name() + ": " + what + ": expected an .exr or .npy file");
}

OIIO::ImageSpec rgba_spec(glm::ivec2 size_px, OIIO::TypeDesc type) { return {size_px.x, size_px.y, 4, type}; }

}  // namespace

std::optional<ImageFormat> image_format(std::string_view path) {
  const auto ends_in = [&](std::string_view ending) {
    // A bare ".png" is a hidden file's name, not an ending.
    if (path.size() <= ending.size() || path[path.size() - ending.size() - 1] == '/') return false;
    return std::equal(ending.begin(), ending.end(), path.end() - std::ptrdiff_t(ending.size()),
                      [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? char(b - 'A' + 'a') : b); });
  };
  if (ends_in(".png")) return ImageFormat::png;
  if (ends_in(".exr")) return ImageFormat::exr;
  if (ends_in(".npy")) return ImageFormat::npy;
  return std::nullopt;
}

void write_color(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const glm::u8vec4> colors) {
  if (format == ImageFormat::npy) return write_npy(file, "|u1", {size_px.y, size_px.x, 4}, std::as_bytes(colors));
  if (format == ImageFormat::png) {
    return write_plane(file, format, rgba_spec(size_px, OIIO::TypeDesc::UINT8), std::as_bytes(colors));
  }
  RowWriter writer(file, format, rgba_spec(size_px, OIIO::TypeDesc::FLOAT));
  std::vector<glm::vec4> rows;
  for (int y = 0; y < size_px.y; y += kRowsAtATime) {
    const int n = std::min(kRowsAtATime, size_px.y - y);
    const std::size_t w = std::size_t(size_px.x);
    rows.clear();
    for (const glm::u8vec4& c : colors.subspan(w * std::size_t(y), w * std::size_t(n))) {
      rows.push_back(glm::vec4(c) / 255.0f);
    }
    writer.write_rows(y, n, rows.data());
  }
  writer.finish();
}

void write_color(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const glm::vec4> colors) {
  refuse_png(file, format, "float colours");
  if (format == ImageFormat::npy) return write_npy(file, "<f4", {size_px.y, size_px.x, 4}, std::as_bytes(colors));
  write_plane(file, format, rgba_spec(size_px, OIIO::TypeDesc::FLOAT), std::as_bytes(colors));
}

void write_depth(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const float> depths) {
  refuse_png(file, format, "depth");
  if (format == ImageFormat::npy) return write_npy(file, "<f4", {size_px.y, size_px.x}, std::as_bytes(depths));
  OIIO::ImageSpec spec(size_px.x, size_px.y, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"Z"};
  write_plane(file, format, spec, std::as_bytes(depths));
}

void write_ids(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const std::uint32_t> ids) {
  refuse_png(file, format, "ids");
  if (format == ImageFormat::npy) return write_npy(file, "<u4", {size_px.y, size_px.x, 2}, std::as_bytes(ids));
  OIIO::ImageSpec spec(size_px.x, size_px.y, 2, OIIO::TypeDesc::UINT32);
  spec.channelnames = {"draw", "primitive"};
  write_plane(file, format, spec, std::as_bytes(ids));
}

}  // namespace lode::geometry
