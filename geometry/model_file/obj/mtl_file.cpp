#include "geometry/model_file/obj/mtl_file.h"

#include <algorithm>
#include <string_view>

#include "geometry/model_file/line_reader.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

/// "-s u [v [w]]": one to three numbers; v and w are as given before if they lack.
glm::dvec2 read_uvw(LineReader& lines, glm::dvec2 values) {
  for (int i = 0; i < 3; ++i) {
    Words ahead = lines.words;
    double number = 0.0;
    if (!parse_number(ahead.next(), number)) {
      if (i == 0) lines.fail_expected("a number", lines.word());
      break;
    }
    lines.words = ahead;
    if (i < 2) values[i] = number;
  }
  return values;
}

bool read_switch(LineReader& lines) {
  const std::string_view word = lines.word();
  if (word != "on" && word != "off") lines.fail_expected("on or off", word);
  return word == "on";
}

/// Options that change what is seen and are not read, unless they ask for nothing.
void refuse_unless(LineReader& lines, std::string_view option, bool asks_for_nothing) {
  if (!asks_for_nothing)
    lines.fail("the option " + std::string(option) + " is not read: expected a picture without it");
}

void read_option(LineReader& lines, std::string_view option, MtlMap& map) {
  if (option == "-s") {
    map.scale = read_uvw(lines, map.scale);
  } else if (option == "-o") {
    map.offset = read_uvw(lines, map.offset);
  } else if (option == "-clamp") {
    map.clamp = read_switch(lines);
  } else if (option == "-blendu" || option == "-blendv") {
    (void)read_switch(lines);  // filtering that we do not do otherwise
  } else if (option == "-texres" || option == "-bm" || option == "-boost") {
    (void)lines.number("a number");
  } else if (option == "-cc") {
    refuse_unless(lines, option, !read_switch(lines));
  } else if (option == "-mm") {
    const float base = lines.number("a number"), gain = lines.number("a number");
    refuse_unless(lines, option, base == 0.0f && gain == 1.0f);
  } else if (option == "-t") {
    refuse_unless(lines, option, read_uvw(lines, glm::dvec2(0.0)) == glm::dvec2(0.0));
  } else if (option == "-imfchan") {
    const std::string_view channel = lines.word();
    refuse_unless(lines, option, channel == "l" || channel == "m");
  } else {
    lines.fail("unknown option \"" + shortened(option, 40) + "\" before a picture's name");
  }
}

MtlMap read_map(LineReader& lines, const std::string& mtl_path) {
  MtlMap map;
  map.place = mtl_path + ": line " + std::to_string(lines.line_number());
  while (lines.words.rest().starts_with('-')) read_option(lines, lines.word(), map);
  std::string name(lines.words.rest());
  if (name.empty()) lines.fail_expected("a picture's name", "");
  std::replace(name.begin(), name.end(), '\\', '/');
  map.path = ModelFiles::resolved(mtl_path, name);
  return map;
}

/// "Kd r g b", or one number for all three.
glm::vec3 read_color(LineReader& lines) {
  constexpr const char* kExpected = "a colour, r g b";
  const float r = lines.number(kExpected);
  if (lines.words.rest().empty()) return glm::vec3(r);
  const float g = lines.number(kExpected);
  return {r, g, lines.number(kExpected)};
}

}  // namespace

std::vector<MtlMaterial> read_mtl(ModelFiles& files, const std::string& path, const std::string& referrer) {
  const FileBytes file = files.read(path, referrer);
  LineReader lines(file.text(), path, true);
  std::vector<MtlMaterial> materials;
  bool has_d = false;
  while (lines.next_line()) {
    const std::string_view key = lines.word();
    if (key == "newmtl") {
      files.budget.take(4 * sizeof(MtlMaterial), path);  // and in the library
      materials.emplace_back().name = lines.words.rest();
      has_d = false;
      continue;
    }
    const bool is_read = key == "Kd" || key == "d" || key == "Tr" || key == "map_Kd" || key == "map_d";
    if (!is_read) continue;  // how light is reflected, and comments
    if (materials.empty()) lines.fail("\"" + std::string(key) + "\" before the first \"newmtl\"");
    MtlMaterial& material = materials.back();
    if (key == "Kd") material.color = read_color(lines);
    if (key == "map_Kd") material.color_map = read_map(lines, path);
    if (key == "map_d") material.opacity_map = read_map(lines, path);
    if (key == "d") {
      material.opacity = lines.number("an opacity");
      has_d = true;
    }
    if (key == "Tr") {
      const float transparency = lines.number("a transparency");
      if (!has_d) material.opacity = 1.0f - transparency;
    }
  }
  return materials;
}

}  // namespace lode::geometry
