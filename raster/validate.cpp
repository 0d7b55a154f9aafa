#include "raster/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/error.h"
#include "raster/fast/scene.h"

namespace lode::raster {
namespace {

constexpr std::size_t kMaxPrimitives = 0xFFFFFFFEu;  // the last two ids have meanings of their own
constexpr int kMaxViewport_px = 65536;
constexpr std::size_t kMaxSamples = 1024;

const char* name_of(Topology topology) {
  constexpr const char* kNames[] = {"triangles", "quads", "lines", "line_strip", "points", "discs", "surfels"};
  return kNames[std::size_t(topology)];
}

std::size_t vertices_per_primitive(Topology topology) {
  switch (topology) {
    case Topology::triangles:
      return 3;
    case Topology::quads:
      return 4;
    case Topology::lines:
      return 2;
    default:
      return 1;
  }
}

void check_rect(const std::optional<Rect>& rect, const char* what, int limit) {
  if (!rect) return;
  const glm::ivec2 o = rect->origin_px, s = rect->size_px;
  if (s.x < 0 || s.y < 0) throw Error(ErrorKind::bad_input, "%s: size %d x %d, expected 0 or more", what, s.x, s.y);
  const auto beyond = [limit](int origin) { return origin < -limit || origin > limit; };  // abs(INT_MIN) is undefined
  if (limit > 0 && (s.x > limit || s.y > limit || beyond(o.x) || beyond(o.y))) {
    throw Error(ErrorKind::bad_input, "%s: %d x %d at (%d, %d), expected at most %d", what, s.x, s.y, o.x, o.y, limit);
  }
}

void check_image(const Frame& frame, const Image& image) {
  const glm::ivec2 size = image.size_px;
  if (size.x < 0 || size.y < 0 || size.x > kMaxTargetSize_px || size.y > kMaxTargetSize_px) {
    throw Error(ErrorKind::bad_input, "image size %d x %d: expected 0 to %d a side", size.x, size.y, kMaxTargetSize_px);
  }
  const std::size_t n_px = std::size_t(size.x) * std::size_t(size.y);
  const auto check_plane = [&](std::size_t n, const char* plane) {
    if (n != 0 && n != n_px) {
      throw Error(ErrorKind::bad_input, "image plane %s: %zu elements, expected none or %zu", plane, n, n_px);
    }
  };
  const bool bytes = image.format == ColorFormat::rgba8;
  check_plane(image.rgba8.size(), "rgba8");
  check_plane(image.rgba32f.size(), "rgba32f");
  check_plane(image.depth.size(), "depth");
  check_plane(image.ids.size(), "ids");
  if (!(bytes ? image.rgba32f.empty() : image.rgba8.empty())) {
    throw Error(ErrorKind::bad_input, "image: the colour plane is not of the image's format");
  }
  if (frame.samples_fx8.empty() || frame.samples_fx8.size() > kMaxSamples) {
    throw Error(ErrorKind::bad_input, "frame: %zu samples a pixel, expected 1 to %zu", frame.samples_fx8.size(),
                kMaxSamples);
  }
  for (const glm::ivec2 s : frame.samples_fx8) {
    if (s.x < 0 || s.y < 0 || s.x > 255 || s.y > 255) {
      throw Error(ErrorKind::bad_input, "frame: sample (%d, %d), expected 0 to 255 in 1/256 px", s.x, s.y);
    }
  }
  if (frame.samples_fx8.size() > 1 && !(image.depth.empty() && image.ids.empty())) {
    throw Error(ErrorKind::bad_input, "image: depth and ids cannot be averaged; use one sample a pixel");
  }
}

/// Each enumeration's last value; a number cast to it may be any other.
void check_enumerations(const Draw& draw, std::size_t i) {
  const bool known = draw.topology <= Topology::surfels && draw.cull <= Cull::front && draw.blend <= Blend::add &&
                     draw.sampler.filter <= Filter::anisotropic && draw.sampler.wrap_u <= Wrap::border &&
                     draw.sampler.wrap_v <= Wrap::border;
  if (!known) {
    throw Error(ErrorKind::bad_input, "draw %zu: topology, cull, blend, filter or wrap is none of its values", i);
  }
}

void check_texture(const Draw& draw, std::size_t i, ColorFormat format) {
  const Texture& texture = *draw.texture;
  const bool raw = texture.format == TextureFormat::raw;
  if (texture.levels.empty()) throw Error(ErrorKind::bad_input, "draw %zu: the texture has no levels", i);
  if (!raw && format == ColorFormat::rgba8) {
    throw Error(ErrorKind::bad_input, "draw %zu: a linear texture cannot be drawn into an rgba8 target", i);
  }
  for (std::size_t l = 0; l < texture.levels.size(); ++l) {
    const TextureLevel& level = texture.levels[l];
    if (l > 0) {
      const glm::ivec2 above = texture.levels[l - 1].size_px,
                       expected(std::max(1, above.x / 2), std::max(1, above.y / 2));
      if (level.size_px != expected) {
        throw Error(ErrorKind::bad_input, "draw %zu: texture level %zu is %d x %d, expected %d x %d", i, l,
                    level.size_px.x, level.size_px.y, expected.x, expected.y);
      }
    }
    const bool sized = level.size_px.x >= 1 && level.size_px.y >= 1 && level.size_px.x <= kMaxTextureSize_px &&
                       level.size_px.y <= kMaxTextureSize_px;
    const std::size_t n = sized ? std::size_t(level.size_px.x) * std::size_t(level.size_px.y) : 0;
    if (!sized || (raw ? level.raw.size() : level.linear.size()) != n) {
      throw Error(ErrorKind::bad_input, "draw %zu: texture level %zu does not hold its %d x %d texels", i, l,
                  level.size_px.x, level.size_px.y);
    }
  }
  if (draw.sampler.max_anisotropy < 1 || draw.sampler.max_anisotropy > 16) {
    throw Error(ErrorKind::bad_input, "draw %zu: max_anisotropy %d, expected 1 to 16", i, draw.sampler.max_anisotropy);
  }
}

void check_attributes(const Draw& draw, std::size_t i) {
  const std::size_t n = position_count(draw);
  const auto check = [&](std::size_t size, const char* what, bool required) {
    if (size != n && (required || size != 0)) {
      throw Error(ErrorKind::bad_input, "draw %zu: %zu %s, expected one for each of its %zu positions", i, size, what,
                  n);
    }
  };
  check(draw.colors.size(), "colors", false);
  check(draw.normals.size(), "normals", draw.topology == Topology::surfels);
  check(draw.uvs.size(), "uvs", false);
  check(draw.radii.size(), "radii", draw.topology == Topology::discs || draw.topology == Topology::surfels);
}

void check_vertices(const Draw& draw, std::size_t i, bool by_clusters) {
  const std::size_t n = vertex_count(draw);
  const std::size_t each = vertices_per_primitive(draw.topology);
  if (n % each != 0) {
    throw Error(ErrorKind::bad_input, "draw %zu: %zu vertices for %s, expected a multiple of %zu", i, n,
                name_of(draw.topology), each);
  }
  const std::size_t n_positions = position_count(draw);
  if (n_positions > 0xFFFFFFFFu || primitive_count(draw) > kMaxPrimitives) {
    throw Error(ErrorKind::bad_input, "draw %zu: more than 2^32 - 2 primitives", i);
  }
  if (draw.clusters != nullptr) {
    const std::size_t n_triangles = draw.topology == Topology::triangles ? n / 3 : 0;
    if (draw.clusters->n_positions != position_count(draw) || draw.clusters->n_primitives != n_triangles) {
      throw Error(ErrorKind::bad_input, "draw %zu: clusters of %zu triangles over %zu positions, expected %zu over %zu",
                  i, draw.clusters->n_primitives, draw.clusters->n_positions, n_triangles, position_count(draw));
    }
    if (by_clusters && fast::drawn_by_clusters(draw)) return;  // the indices were checked when they were cut
  }
  const std::span<const std::uint32_t> indices = draw.indices.value_or(std::span<const std::uint32_t>{});
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (indices[k] >= n_positions) {
      throw Error(ErrorKind::bad_input, "draw %zu: index %zu is %u, expected below %zu", i, k, indices[k], n_positions);
    }
  }
  if (draw.topology == Topology::surfels && !std::holds_alternative<ObjectVertices>(draw.vertices)) {
    throw Error(ErrorKind::bad_input, "draw %zu: surfels need object-space positions", i);
  }
  if (const auto* window = std::get_if<WindowVertices>(&draw.vertices)) {
    for (std::size_t k = 0; k < window->positions_px.size(); ++k) {
      const glm::dvec3& p = window->positions_px[k];
      if (std::abs(p.x) > kMaxTargetSize_px || std::abs(p.y) > kMaxTargetSize_px) {
        throw Error(ErrorKind::bad_input, "draw %zu: position %zu (%g, %g) is beyond the guard band of +-%d px", i, k,
                    p.x, p.y, kMaxTargetSize_px);
      }
    }
  }
}

}  // namespace

std::size_t position_count(const Draw& draw) {
  if (const auto* object = std::get_if<ObjectVertices>(&draw.vertices)) return object->positions.size();
  if (const auto* clip = std::get_if<ClipVertices>(&draw.vertices)) return clip->positions.size();
  return std::get<WindowVertices>(draw.vertices).positions_px.size();
}

std::size_t vertex_count(const Draw& draw) { return draw.indices ? draw.indices->size() : position_count(draw); }

std::size_t primitive_count(const Draw& draw) {
  const std::size_t n = vertex_count(draw);
  if (draw.topology == Topology::line_strip) return n < 2 ? 0 : n - 1;
  return n / vertices_per_primitive(draw.topology);
}

void validate(const Frame& frame, const Image& image, const RenderOptions& options) {
  check_image(frame, image);
  check_rect(frame.viewport, "viewport", kMaxViewport_px);
  check_rect(frame.scissor, "scissor", 0);
  const int tile = options.tile_size_px;
  if (tile < 8 || tile > 256 || (tile & (tile - 1)) != 0) {
    throw Error(ErrorKind::bad_input, "tile size %d px: expected a power of two from 8 to 256", tile);
  }
  if (options.pipeline == Pipeline::fast && !can_run(options.target)) {
    throw Error(ErrorKind::bad_input, "target %s: this processor or build does not have it", name_of(options.target));
  }
  if (options.threads < 0) throw Error(ErrorKind::bad_input, "%d threads: expected 0 (all) or more", options.threads);
  if (!options.per_draw.empty() && options.per_draw.size() != frame.draws.size()) {
    throw Error(ErrorKind::bad_input, "%zu statistics for %zu draws", options.per_draw.size(), frame.draws.size());
  }
  if (frame.draws.size() > kMaxPrimitives) throw Error(ErrorKind::bad_input, "more than 2^32 - 2 draws");
  for (std::size_t i = 0; i < frame.draws.size(); ++i) {
    const Draw& draw = frame.draws[i];
    check_enumerations(draw, i);
    check_attributes(draw, i);
    check_vertices(draw, i, options.pipeline == Pipeline::fast && options.per_draw.empty());
    if (draw.texture) check_texture(draw, i, image.format);
    if (draw.scissor) {
      const glm::ivec2 s = draw.scissor->size_px;
      if (s.x < 0 || s.y < 0) {
        throw Error(ErrorKind::bad_input, "draw %zu: scissor size %d x %d, expected 0 or more", i, s.x, s.y);
      }
    }
    if (draw.stipple && (draw.stipple->factor < 1 || draw.stipple->factor > 256)) {
      throw Error(ErrorKind::bad_input, "draw %zu: stipple factor %d, expected 1 to 256", i, draw.stipple->factor);
    }
    if (draw.alpha_test && std::isnan(*draw.alpha_test)) {
      throw Error(ErrorKind::bad_input, "draw %zu: the alpha test is not a number", i);
    }
  }
}

}  // namespace lode::raster
