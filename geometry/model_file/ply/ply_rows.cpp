#include "geometry/model_file/ply/ply_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "geometry/error.h"
#include "geometry/loads.h"
#include "geometry/model_file/line_reader.h"

namespace lode::geometry {
namespace {

/// Each element is a line of words.
class AsciiRows : public PlyRows {
 public:
  AsciiRows(const PlyHeader& header, std::string_view text, const std::string& name)
      : lines_(text.substr(header.n_bytes), name, false), n_header_lines_(header.n_lines), name_(name) {}

  void read(const PlyElement& element, PlyRow& row) override {
    do {
      if (!lines_.next_line()) fail("the file ends: expected another element \"" + element.name + "\"");
    } while (lines_.words.rest().empty());
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      row.values[i] = number(property.list_count.value_or(property.type), property);
      if (!property.list_count) continue;
      // A list's words take two bytes each, so that what is left of the line bounds its length.
      if (!(row.values[i] >= 0.0 && row.values[i] <= double(lines_.words.left.size()))) {
        fail("a list \"" + property.name + "\" of another length than the line has words for");
      }
      row.lists[i].resize(std::size_t(row.values[i]));
      for (double& value : row.lists[i]) value = number(property.type, property);
    }
  }

 private:
  std::string place() const override {
    return name_ + ": line " + std::to_string(n_header_lines_ + lines_.line_number());
  }

  /// As the binary formats would hold it: a float's text is rounded once, to float.
  double number(PlyType type, const PlyProperty& property) {
    const std::string_view word = lines_.word();
    float narrow = 0.0f;
    double wide = 0.0;
    const bool ok = type == PlyType::float32 ? parse_number(word, narrow) : parse_number(word, wide);
    if (!ok) fail("expected a number for \"" + property.name + "\", found \"" + std::string(word.substr(0, 40)) + "\"");
    return type == PlyType::float32 ? double(narrow) : wide;
  }

  LineReader lines_;
  std::size_t n_header_lines_;
  const std::string& name_;
};

class BinaryRows : public PlyRows {
 public:
  BinaryRows(const PlyHeader& header, std::string_view text, const std::string& name)
      : bytes_(std::as_bytes(std::span(text))),
        at_(header.n_bytes),
        swaps_(header.format == PlyFormat::big_endian),
        name_(name) {}

  void read(const PlyElement& element, PlyRow& row) override {
    row_at_ = at_;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      row.values[i] = number(property.list_count.value_or(property.type));
      if (!property.list_count) continue;
      if (!(row.values[i] >= 0.0 && row.values[i] * double(ply_size(property.type)) <= double(bytes_.size() - at_))) {
        fail("a list \"" + property.name + "\" that the file does not hold");
      }
      row.lists[i].resize(std::size_t(row.values[i]));
      for (double& value : row.lists[i]) value = number(property.type);
    }
  }

 private:
  std::string place() const override { return name_ + ": byte " + std::to_string(row_at_); }

  double number(PlyType type) {
    const std::size_t n = ply_size(type);
    if (n > bytes_.size() - at_) fail("the file ends within an element");
    std::array<std::byte, 8> b{};
    std::memcpy(b.data(), &bytes_[at_], n);
    at_ += n;
    if (swaps_) std::reverse(b.begin(), b.begin() + std::ptrdiff_t(n));
    switch (type) {
      case PlyType::int8:
        return load_le<std::int8_t>(b, 0);
      case PlyType::uint8:
        return load_le<std::uint8_t>(b, 0);
      case PlyType::int16:
        return load_le<std::int16_t>(b, 0);
      case PlyType::uint16:
        return load_le<std::uint16_t>(b, 0);
      case PlyType::int32:
        return load_le<std::int32_t>(b, 0);
      case PlyType::uint32:
        return load_le<std::uint32_t>(b, 0);
      case PlyType::float32:
        return double(load_le<float>(b, 0));
      default:
        return load_le<double>(b, 0);
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t at_, row_at_ = 0;
  bool swaps_;
  const std::string& name_;
};

}  // namespace

void PlyRows::fail(const std::string& what) const { throw Error(ErrorKind::bad_input, place() + ": " + what); }

std::unique_ptr<PlyRows> ply_rows(const PlyHeader& header, std::string_view text, const std::string& name) {
  if (header.format == PlyFormat::ascii) return std::make_unique<AsciiRows>(header, text, name);
  return std::make_unique<BinaryRows>(header, text, name);
}

}  // namespace lode::geometry
