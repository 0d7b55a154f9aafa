#include "experiments/draw/read_geometry.h"

#include <array>
#include <cfloat>
#include <string>

namespace lode::experiments {
namespace {

using geometry::JsonView;
using raster::Topology;

constexpr GeometryKey kGeometryKeys[] = {
    {"triangles", Topology::triangles, Space::window, 3},
    {"quads", Topology::quads, Space::window, 4},
    {"lines", Topology::lines, Space::window, 2},
    {"line_strip", Topology::line_strip, Space::window, 1},
    {"points", Topology::points, Space::window, 1},
    {"discs", Topology::discs, Space::discs, 1},
    {"surfels", Topology::surfels, Space::surfels, 1},
    {"clip", Topology::triangles, Space::clip, 3},
    {"clip_quads", Topology::quads, Space::clip, 4},
    {"clip_lines", Topology::lines, Space::clip, 2},
    {"clip_line_strip", Topology::line_strip, Space::clip, 1},
    {"clip_points", Topology::points, Space::clip, 1},
};

constexpr double kGuardBand_px = 32768.0;
constexpr double kMaxLength_px = 65536.0;

/// A number in the picture's unit, at most `limit_px` either way, in px: exact, as 1/256 is a power of two.
double read_px(const JsonView& view, const DrawContext& context, double limit_px) {
  if (!context.in_fx8) return view.number(-limit_px, limit_px);
  const auto limit_fx8 = std::int64_t(limit_px * 256.0);
  return double(view.integer(-limit_fx8, limit_fx8)) / 256.0;
}

glm::dvec3 read_window_position(const JsonView& view, const DrawContext& context) {
  if (view.size("[x, y, z]") != 3) view.fail_expected("[x, y, z]");
  const double x_px = read_px(view.at(0), context, kGuardBand_px);
  const double y_px = read_px(view.at(1), context, kGuardBand_px);
  return {x_px, y_px, view.at(2).number(0.0, 1.0)};
}

glm::dvec4 read_clip_position(const JsonView& view) {
  if (view.size("[x, y, z, w]") != 4) view.fail_expected("[x, y, z, w]");
  glm::dvec4 p_clip;
  for (int c = 0; c < 4; ++c) p_clip[c] = view.at(std::size_t(c)).number(-DBL_MAX, DBL_MAX);
  return p_clip;
}

glm::vec3 read_vector(const JsonView& view) {
  if (view.size("[x, y, z]") != 3) view.fail_expected("[x, y, z]");
  return {view.at(0).float_number(), view.at(1).float_number(), view.at(2).float_number()};
}

/// Colours given disc by disc: the others are white, so that the draw's colour shows.
void read_element_color(const JsonView& element, std::size_t i, std::size_t n, std::vector<glm::vec4>& colors) {
  const auto color = element.find("color");
  if (!color) return;
  if (colors.empty()) colors.assign(n, glm::vec4(255.0f));
  colors[i] = color->color();
}

/// A member that every disc must have.
template <class Read>
auto read_member(const JsonView& element, std::string_view key, Read read) {
  const auto member = element.find(key);
  if (!member) element.fail("expected a member \"" + std::string(key) + "\"");
  return read(*member);
}

void read_discs(const JsonView& view, std::size_t n, const DrawContext& context, PictureDraw& draw) {
  constexpr std::string_view kKeys[] = {"center", "radius", "color"};
  std::vector<glm::dvec3> centers;
  for (std::size_t i = 0; i < n; ++i) {
    const JsonView disc = view.at(i);
    disc.check_keys(kKeys);
    centers.push_back(read_member(disc, "center", [&](const JsonView& v) { return read_window_position(v, context); }));
    draw.radii.push_back(read_member(disc, "radius", [&](const JsonView& v) { return read_length_px(v, context); }));
    read_element_color(disc, i, n, draw.colors);
  }
  draw.positions = std::move(centers);
}

void read_surfels(const JsonView& view, std::size_t n, PictureDraw& draw) {
  constexpr std::string_view kKeys[] = {"center", "normal", "radius", "color"};
  std::vector<glm::vec3> centers;
  for (std::size_t i = 0; i < n; ++i) {
    const JsonView surfel = view.at(i);
    surfel.check_keys(kKeys);
    centers.push_back(read_member(surfel, "center", read_vector));
    draw.normals.push_back(read_member(surfel, "normal", read_vector));
    draw.radii.push_back(read_member(surfel, "radius", [](const JsonView& v) { return v.float_number(); }));
    read_element_color(surfel, i, n, draw.colors);
  }
  draw.positions = std::move(centers);
}

/// An array of n positions, each read by read(element).
template <class Position, class Read>
std::vector<Position> read_positions(const JsonView& view, std::size_t n, Read read) {
  std::vector<Position> positions;
  positions.reserve(n);
  for (std::size_t i = 0; i < n; ++i) positions.push_back(read(view.at(i)));
  return positions;
}

}  // namespace

std::span<const GeometryKey> geometry_keys() { return kGeometryKeys; }

float read_length_px(const JsonView& view, const DrawContext& context) {
  return float(read_px(view, context, kMaxLength_px));
}

void read_geometry(const JsonView& view, const GeometryKey& key, const DrawContext& context, PictureDraw& draw) {
  draw.state.topology = key.topology;
  const std::size_t n = view.size("an array of vertices");
  if (n % std::size_t(key.vertices_each) != 0) {
    view.fail("expected a multiple of " + std::to_string(key.vertices_each) + " vertices, found " + std::to_string(n));
  }
  switch (key.space) {
    case Space::window:
      draw.positions = read_positions<glm::dvec3>(
          view, n, [&](const JsonView& element) { return read_window_position(element, context); });
      break;
    case Space::clip:
      draw.positions = read_positions<glm::dvec4>(view, n, read_clip_position);
      break;
    case Space::discs:
      read_discs(view, n, context, draw);
      break;
    case Space::surfels:
      read_surfels(view, n, draw);
      break;
  }
}

}  // namespace lode::experiments
