#include "experiments/draw/read_draw.h"

#include <cfloat>
#include <iterator>
#include <string>
#include <vector>

#include "experiments/draw/read_geometry.h"
#include "experiments/draw/read_texture.h"

namespace lode::experiments {
namespace {

using geometry::JsonView;

/// Keys that any draw may have.
constexpr std::string_view kStateKeys[] = {"color", "colors", "uv",         "texture",     "alpha_test",
                                           "cull",  "blend",  "depth_test", "depth_write", "scissor"};

/// The key that gives the draw its geometry: exactly one.
const GeometryKey& find_geometry(const JsonView& view) {
  const GeometryKey* found = nullptr;
  std::vector<std::string_view> known(std::begin(kStateKeys), std::end(kStateKeys));
  known.insert(known.end(), {"stipple", "point_size", "clip_from_world"});
  std::string list;
  for (const GeometryKey& g : geometry_keys()) {
    list.append(list.empty() ? "" : ", ").append(g.key);
    known.push_back(g.key);
    if (!view.find(g.key)) continue;
    if (found) {
      view.fail("expected one geometry, found \"" + std::string(found->key) + "\" and \"" + std::string(g.key) + "\"");
    }
    found = &g;
  }
  if (found) return *found;
  view.check_keys(known);  // a geometry misspelt, perhaps
  view.fail("expected a geometry: one of " + list);
}

/// State that only some geometries have is an error elsewhere, not ignored.
void check_keys(const JsonView& view, const GeometryKey& geometry) {
  std::vector<std::string_view> allowed = {geometry.key};
  allowed.insert(allowed.end(), std::begin(kStateKeys), std::end(kStateKeys));
  if (geometry.is_line()) allowed.push_back("stipple");
  if (geometry.topology == raster::Topology::points) allowed.push_back("point_size");
  if (geometry.space == Space::surfels) allowed.push_back("clip_from_world");
  view.check_keys(allowed);
}

raster::Stipple read_stipple(const JsonView& view) {
  constexpr std::string_view kKeys[] = {"pattern", "factor"};
  view.check_keys(kKeys);
  raster::Stipple stipple;
  if (const auto pattern = view.find("pattern")) stipple.pattern = std::uint16_t(pattern->integer(0, 65535));
  if (const auto factor = view.find("factor")) stipple.factor = int(factor->integer(1, 256));
  return stipple;
}

void read_state(const JsonView& view, const DrawContext& context, raster::Draw& state) {
  using raster::Blend, raster::Cull;
  constexpr Cull kCulls[] = {Cull::none, Cull::back, Cull::front};
  constexpr Blend kBlends[] = {Blend::none, Blend::over, Blend::add};
  if (const auto color = view.find("color")) state.color = color->color();
  if (const auto cull = view.find("cull")) state.cull = kCulls[cull->choice({"none", "back", "front"})];
  if (const auto blend = view.find("blend")) state.blend = kBlends[blend->choice({"none", "over", "add"})];
  if (const auto test = view.find("depth_test")) state.depth_test = test->boolean();
  if (const auto write = view.find("depth_write")) state.depth_write = write->boolean();
  if (const auto alpha = view.find("alpha_test")) state.alpha_test = alpha->number(0.0, 1.0);
  if (const auto scissor = view.find("scissor")) state.scissor = read_rect(*scissor);
  if (const auto stipple = view.find("stipple")) state.stipple = read_stipple(*stipple);
  if (const auto size = view.find("point_size")) state.point_size_px = read_length_px(*size, context);
}

std::size_t vertex_count(const PictureDraw& draw) {
  return std::visit([](const auto& positions) { return positions.size(); }, draw.positions);
}

/// An array with one element a vertex.
std::size_t checked_count(const JsonView& view, const PictureDraw& draw) {
  const std::string expected = "an array of " + std::to_string(vertex_count(draw)) + ", one a vertex";
  if (view.size(expected) != vertex_count(draw)) view.fail_expected(expected);
  return vertex_count(draw);
}

void read_attributes(const JsonView& view, const GeometryKey& geometry, PictureDraw& draw) {
  if (const auto colors = view.find("colors")) {
    if (!draw.colors.empty()) colors->fail("expected colours here or in the elements, not both");
    const std::size_t n = checked_count(*colors, draw);
    for (std::size_t i = 0; i < n; ++i) draw.colors.push_back(colors->at(i).color());
  }
  if (const auto uvs = view.find("uv")) {
    const std::size_t n = checked_count(*uvs, draw);
    for (std::size_t i = 0; i < n; ++i) {
      const JsonView uv = uvs->at(i);
      if (uv.size("[u, v]") != 2) uv.fail_expected("[u, v]");
      draw.uvs.emplace_back(uv.at(0).float_number(), uv.at(1).float_number());
    }
  }
  if (const auto texture = view.find("texture")) {
    // Points, discs and surfels have a square of their own; what has vertices must say where they lie in it.
    if (geometry.vertices_each > 1 || geometry.is_line()) {
      if (!view.find("uv")) view.fail("a texture without \"uv\": expected [u, v] for every vertex");
    }
    SampledTexture sampled = read_texture(*texture);
    draw.texture = std::move(sampled.texture);
    draw.state.sampler = sampled.sampler;
  }
}

}  // namespace

raster::Rect read_rect(const JsonView& view) {
  if (view.size("[x, y, width, height]") != 4) view.fail_expected("[x, y, width, height]");
  constexpr std::int64_t kFar = 1'000'000'000;  // corner plus size still fits an int
  const auto read = [&](std::size_t i, std::int64_t low) { return int(view.at(i).integer(low, kFar)); };
  return {{read(0, -kFar), read(1, -kFar)}, {read(2, 0), read(3, 0)}};
}

glm::dmat4 read_matrix(const JsonView& view) {
  if (view.size("16 numbers, column-major") != 16) view.fail_expected("16 numbers, column-major");
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = view.at(std::size_t(i)).number(-DBL_MAX, DBL_MAX);
  return m;
}

PictureDraw read_draw(const JsonView& view, const DrawContext& context) {
  const GeometryKey& geometry = find_geometry(view);
  check_keys(view, geometry);
  PictureDraw draw;
  read_geometry(*view.find(geometry.key), geometry, context, draw);
  draw.clip_from_world = context.clip_from_world;
  if (const auto matrix = view.find("clip_from_world")) draw.clip_from_world = read_matrix(*matrix);
  read_state(view, context, draw.state);
  read_attributes(view, geometry, draw);
  return draw;
}

}  // namespace lode::experiments
