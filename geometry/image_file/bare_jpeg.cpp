#include <algorithm>
#include <iterator>
#include <string_view>

#include "geometry/error.h"
#include "geometry/image_file/bare_picture.h"
#include "geometry/loads.h"

namespace lode::geometry {
namespace {

// Markers, ITU-T T.81, table B.1.
constexpr unsigned kTem = 0x01, kSof0 = 0xC0, kSof2 = 0xC2, kDht = 0xC4, kDac = 0xCC, kSofLast = 0xCF, kRst0 = 0xD0,
                   kRst7 = 0xD7, kSoi = 0xD8, kEoi = 0xD9, kSos = 0xDA, kDqt = 0xDB, kDri = 0xDD, kApp0 = 0xE0,
                   kApp14 = 0xEE;

/// A scan that refines nothing takes three bytes and a pass over the picture.
constexpr int kMaxScans = 256;

/// A block of 64 pixels takes at least one bit of the first scan.
constexpr std::uint64_t kMaxPixelsAByte = 512;

/// Takes the segments one after another and keeps some.
class Segments {
 public:
  Segments(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  BarePicture read() {
    keep(0, 2);  // SOI
    at_ = 2;
    for (;;) {
      const unsigned marker = next_marker();
      if (marker == kEoi) break;
      if (marker == kTem || (marker >= kRst0 && marker <= kRst7)) continue;  // they have no segment
      read_segment(marker);
    }
    keep(at_ - 2, 2);  // EOI
    check_against_data();
    return std::move(bare_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, name_ + ": byte " + std::to_string(at_) + ": " + what);
  }
  unsigned byte(std::size_t at) const { return unsigned(bytes_[at]); }
  void keep(std::size_t begin, std::size_t n) {
    const auto kept = bytes_.subspan(begin, n);
    bare_.bytes.insert(bare_.bytes.end(), kept.begin(), kept.end());
  }

  /// The code after 0xFF; at_ is behind it then.
  unsigned next_marker() {
    while (at_ + 1 < bytes_.size() && byte(at_) == 0xFF && byte(at_ + 1) == 0xFF) ++at_;  // fill bytes
    if (at_ + 2 > bytes_.size()) fail("the picture is cut off: expected a marker up to EOI");
    if (byte(at_) != 0xFF) fail("expected a marker");
    at_ += 2;
    return byte(at_ - 1);
  }

  void read_segment(unsigned marker) {
    const std::size_t begin = at_ - 2;
    const std::size_t length = at_ + 2 <= bytes_.size() ? load_be<std::uint16_t>(bytes_, at_) : 0;
    if (length < 2 || length > bytes_.size() - at_) fail("a segment that the file does not hold");
    const auto payload = bytes_.subspan(at_ + 2, length - 2);
    const bool is_frame = marker >= kSof0 && marker <= kSofLast && marker != kDht && marker != kDac;
    if (is_frame) read_frame(marker, payload);
    if (marker == kApp0 && begins_with(payload, std::string_view("JFIF\0", 5))) keep_jfif();
    if (is_frame || marker == kDht || marker == kDqt || marker == kDri || marker == kSos ||
        (marker == kApp14 && payload.size() == 12 && begins_with(payload, "Adobe"))) {
      keep(begin, 2 + length);
    }
    at_ += length;
    if (marker == kSos) read_scan();
  }

  static bool begins_with(std::span<const std::byte> payload, std::string_view word) {
    return payload.size() >= word.size() &&
           std::equal(word.begin(), word.end(), payload.begin(), [](char a, std::byte b) { return std::byte(a) == b; });
  }

  /// The note that the colours are YCbCr, without a thumbnail.
  void keep_jfif() {
    constexpr unsigned char kJfif[] = {0xFF, 0xE0, 0, 16, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0};
    std::transform(std::begin(kJfif), std::end(kJfif), std::back_inserter(bare_.bytes),
                   [](unsigned char c) { return std::byte(c); });
  }

  void read_frame(unsigned marker, std::span<const std::byte> frame) {
    if (marker > kSof2) fail("a JPEG of kind " + std::to_string(marker - kSof0) + ": expected baseline or progressive");
    if (has_frame_) fail("a second frame");
    if (frame.size() < 6) fail("a frame without a size");
    if (frame[0] != std::byte(8)) fail("samples of " + std::to_string(unsigned(frame[0])) + " bits: expected 8");
    const std::uint64_t height = load_be<std::uint16_t>(frame, 1), width = load_be<std::uint16_t>(frame, 3);
    check_picture_size(width, height, name_);
    n_components_ = unsigned(frame[5]);
    if (n_components_ != 1 && n_components_ != 3) {
      fail(std::to_string(n_components_) + " colour components: expected 1 (grey) or 3 (YCbCr, RGB)");
    }
    bare_.size_px = {int(width), int(height)};
    has_frame_ = true;
    is_progressive_ = marker == kSof2;
  }

  /// Entropy-coded data: up to the next marker that is not a restart; 0xFF 0x00 stands for 0xFF.
  void read_scan() {
    if (!has_frame_) fail("a scan before the frame");
    if (++n_scans_ > kMaxScans) fail("more than " + std::to_string(kMaxScans) + " scans");
    const std::size_t begin = at_;
    for (;;) {
      at_ =
          std::size_t(std::find(bytes_.begin() + std::ptrdiff_t(at_), bytes_.end(), std::byte(0xFF)) - bytes_.begin());
      if (at_ + 1 >= bytes_.size()) fail("the picture is cut off inside a scan");
      const unsigned code = byte(at_ + 1);
      if (code != 0 && code != 0xFF && !(code >= kRst0 && code <= kRst7)) break;
      at_ += code == 0xFF ? 1 : 2;
    }
    keep(begin, at_ - begin);
    n_scan_bytes_ += at_ - begin;
  }

  void check_against_data() {
    if (n_scans_ == 0) fail("a picture without a scan");
    const std::uint64_t n_pixels = std::uint64_t(bare_.size_px.x) * std::uint64_t(bare_.size_px.y);
    if (n_pixels > 4096 + kMaxPixelsAByte * n_scan_bytes_) {
      throw Error(ErrorKind::bad_input, name_ + ": claims " + std::to_string(bare_.size_px.x) + " x " +
                                            std::to_string(bare_.size_px.y) + " px: its " +
                                            std::to_string(n_scan_bytes_) + " bytes of data cannot hold them");
    }
    // Several scans need all coefficients at once: 16 bits each, in whole blocks of up to 32 x 32 pixels.
    const std::uint64_t padded = (std::uint64_t(bare_.size_px.x) + 32) * (std::uint64_t(bare_.size_px.y) + 32);
    const bool all_at_once = is_progressive_ || n_scans_ > 1;
    bare_.decoder_bytes = (all_at_once ? 2 * n_components_ * padded : 0) + 256 * std::uint64_t(bare_.size_px.x);
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  BarePicture bare_;
  std::size_t at_ = 0;
  bool has_frame_ = false, is_progressive_ = false;
  unsigned n_components_ = 0;
  int n_scans_ = 0;
  std::uint64_t n_scan_bytes_ = 0;
};

}  // namespace

bool is_jpeg(std::span<const std::byte> bytes) {
  return bytes.size() >= 3 && bytes[0] == std::byte(0xFF) && bytes[1] == std::byte(kSoi) && bytes[2] == std::byte(0xFF);
}

BarePicture bare_jpeg(std::span<const std::byte> bytes, const std::string& name) {
  return Segments(bytes, name).read();
}

}  // namespace lode::geometry
