#include "raster/reference/disc.h"

#include <algorithm>
#include <cmath>

namespace lode::raster::reference {
namespace {

/// Texture coordinates across the square [centre − half, centre + half], given doubled to stay exact.
Footprint across_square(glm::ivec2 centre_fx8, std::int32_t doubled_half_fx8, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  if (uvs) return {glm::dvec2((*uvs)[0]), {0.0, 0.0}, {0.0, 0.0}};
  const double side_fx8 = double(doubled_half_fx8);
  const glm::dvec2 from_low = glm::dvec2(2 * (p_fx8 - centre_fx8) + doubled_half_fx8);
  return {from_low / (2.0 * side_fx8), {256.0 / side_fx8, 0.0}, {0.0, 256.0 / side_fx8}};
}

}  // namespace

std::optional<std::int32_t> snap_size(double size_px) {
  if (!(size_px > 0.0)) return std::nullopt;
  const double size_fx8 = std::rint(std::min(256.0 * size_px, double(kMaxSize_fx8)));
  if (size_fx8 == 0.0) return std::nullopt;
  return static_cast<std::int32_t>(size_fx8);
}

std::optional<Square> make_square(glm::ivec2 centre_fx8, double size_px, double z) {
  const std::optional<std::int32_t> size_fx8 = snap_size(size_px);
  if (!size_fx8) return std::nullopt;
  return Square{centre_fx8, *size_fx8, z};
}

std::optional<Disc> make_disc(glm::ivec2 centre_fx8, double radius_px, double z) {
  const std::optional<std::int32_t> radius_fx8 = snap_size(radius_px);
  if (!radius_fx8) return std::nullopt;
  return Disc{centre_fx8, *radius_fx8, z};
}

PixelBox bounds_px(const Square& s, glm::ivec2 sample_fx8) {
  // c − s/2 ≤ p < c + s/2 in whole sub-pixels; the shift rounds down.
  const glm::ivec2 low = s.centre_fx8 - (s.size_fx8 >> 1);
  const glm::ivec2 high = s.centre_fx8 + ((s.size_fx8 - 1) >> 1);
  return pixels_with_samples_in(low, high, sample_fx8);
}

PixelBox bounds_px(const Disc& d, glm::ivec2 sample_fx8) {
  return pixels_with_samples_in(d.centre_fx8 - d.radius_fx8, d.centre_fx8 + d.radius_fx8, sample_fx8);
}

Footprint footprint_at(const Square& s, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  return across_square(s.centre_fx8, s.size_fx8, uvs, p_fx8);
}

Footprint footprint_at(const Disc& d, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  return across_square(d.centre_fx8, 2 * d.radius_fx8, uvs, p_fx8);
}

}  // namespace lode::raster::reference
