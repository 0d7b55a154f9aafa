#include "geometry/model_file/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/error.h"
#include "geometry/model_file/line_reader.h"

namespace lode::geometry {
namespace {

/// Both sets of names, in the order of PlyType.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kTypeNames = {{{"char", "int8"},
                                                                                      {"uchar", "uint8"},
                                                                                      {"short", "int16"},
                                                                                      {"ushort", "uint16"},
                                                                                      {"int", "int32"},
                                                                                      {"uint", "uint32"},
                                                                                      {"float", "float32"},
                                                                                      {"double", "float64"}}};

PlyType read_type(LineReader& lines) {
  const std::string_view word = lines.word();
  for (std::size_t i = 0; i < kTypeNames.size(); ++i) {
    if (word == kTypeNames[i].first || word == kTypeNames[i].second) return PlyType(i);
  }
  lines.fail_expected("a type (char, uchar, short, ushort, int, uint, float, double)", word);
}

PlyFormat read_format(LineReader& lines) {
  const std::string_view word = lines.word();
  const std::string_view version = lines.word();
  if (version != "1.0") lines.fail_expected("version 1.0", version);
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::little_endian;
  if (word == "binary_big_endian") return PlyFormat::big_endian;
  lines.fail_expected("ascii, binary_little_endian or binary_big_endian", word);
}

PlyElement read_element(LineReader& lines) {
  PlyElement element;
  element.name = lines.word();
  const std::int64_t count = lines.integer("a name and a count");
  if (count < 0) lines.fail_expected("a count that is not negative", std::to_string(count));
  element.count = std::uint64_t(count);
  return element;
}

PlyProperty read_property(LineReader& lines) {
  PlyProperty property;
  if (Words ahead = lines.words; ahead.next() == "list") {
    lines.words = ahead;
    property.list_count = read_type(lines);
    if (*property.list_count >= PlyType::float32) lines.fail_expected("a whole number's type for a list's length", "");
  }
  property.type = read_type(lines);
  property.name = lines.word();
  if (property.name.empty()) lines.fail_expected("a property's name", "");
  return property;
}

/// The least that one of these elements takes in the file: a list may be empty, and a number in text may be one digit
/// and a blank.
std::uint64_t least_bytes(const PlyElement& element, PlyFormat format) {
  std::uint64_t n = 0;
  for (const PlyProperty& p : element.properties) {
    n += format == PlyFormat::ascii ? 2 : ply_size(p.list_count.value_or(p.type));
  }
  return n;
}

void check_counts(const PlyHeader& header, std::size_t n_text, const std::string& name) {
  std::uint64_t left = n_text - header.n_bytes + 1;  // the last line need not end
  for (const PlyElement& element : header.elements) {
    const std::uint64_t each = least_bytes(element, header.format);
    if (each > 0 && element.count > left / each) {
      throw Error(ErrorKind::bad_input, name + ": claims " + std::to_string(element.count) + " elements \"" +
                                            element.name + "\" of at least " + std::to_string(each) +
                                            " bytes: the file has " + std::to_string(left - 1) + " left for them");
    }
    left -= element.count * each;
  }
}

}  // namespace

std::size_t ply_size(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[std::size_t(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view wanted, std::string_view other) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == wanted || (!other.empty() && properties[i].name == other)) return i;
  }
  return std::nullopt;
}

PlyHeader read_ply_header(std::string_view text, const std::string& name) {
  LineReader lines(text, name, false);
  PlyHeader header;
  if (!lines.next_line() || lines.word() != "ply") lines.fail("expected \"ply\"");
  bool has_format = false;
  for (;;) {
    if (!lines.next_line()) lines.fail("the file ends within its header: expected \"end_header\"");
    const std::string_view key = lines.word();
    if (key == "end_header") break;
    if (key == "format") {
      header.format = read_format(lines);
      has_format = true;
    } else if (key == "element") {
      header.elements.push_back(read_element(lines));
    } else if (key == "property") {
      if (header.elements.empty()) lines.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(lines));
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      lines.fail_expected("format, element, property, comment or end_header", key);
    }
  }
  if (!has_format) lines.fail("the header ends without \"format\"");
  header.n_bytes = std::min(lines.offset(), text.size());
  header.n_lines = lines.line_number();
  check_counts(header, text.size(), name);
  return header;
}

}  // namespace lode::geometry
