#pragma once
/// A rasterized picture against one that was ray-traced: every pixel where they differ is explained in exact
/// arithmetic, or it is a failure.
///
/// The rasterizer's answer at a pixel is *possible* if its triangle covers the sample in some placement of its vertices
/// (coverage.h), with a depth that some placement gives (depth_interval.h), and no other triangle must have won: one
/// that covers the sample in every placement, at a depth that is nearer in every placement, or with the same corners
/// and lower ids (C6). Nothing drawn is possible if no triangle covers the sample in every placement. An answer that is
/// not possible is never explained, whatever the rays say; nor is one where both agree on the triangle and the depth is
/// not possible.
///
/// A possible answer that differs from the rays' is explained by the first of these that holds:
///
///   edge        an outline of either triangle can pass over the sample
///   depth_tie   both triangles may cover it, and their depths, as the floats of a picture, overlap
///   range       a cut at the near or far plane of either triangle can pass over the sample
///   embree      what is left: the rays' triangle is not there in any placement, or behind in every one, or the rays
///               missed what is there in every one. Placements include the exact one, so each of these proves that the
///               rays' answer is not the nearest hit of the exact ray.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "raster/frame.h"
#include "raster/image.h"

namespace lode::experiments::truth {

enum class Verdict : std::uint8_t { same, edge, depth_tie, range, embree, unexplained };
inline constexpr std::size_t kVerdicts = 6;
[[nodiscard]] const char* verdict_name(Verdict verdict);

/// A pixel that is not explained.
struct Unexplained {
  glm::ivec2 px{0, 0};
  raster::Ids raster{raster::kNoId, raster::kNoId};
  raster::Ids rays{raster::kNoId, raster::kNoId};
  float depth = 0.0f;  ///< the rasterizer's
  std::string why;     ///< one line
};

struct PictureCheck {
  std::array<std::uint64_t, kVerdicts> pixels{};  ///< by verdict
  std::uint64_t on_edge_line = 0;     ///< of those explained by edge: the sample lies exactly on an exact outline
  std::vector<Verdict> verdicts;      ///< [w·h], row 0 first
  std::vector<Unexplained> examples;  ///< the first in reading order, at most kMaxExamples

  [[nodiscard]] std::uint64_t of(Verdict verdict) const { return pixels[std::size_t(verdict)]; }
  [[nodiscard]] std::uint64_t different() const;
};
inline constexpr std::size_t kMaxExamples = 10;

/// What is compared. One sample a pixel, in its centre.
struct PicturePair {
  std::span<const raster::Draw> draws;  ///< triangles of ObjectVertices, drawn as solid ones, each with a draw_id
  glm::ivec2 size_px{0, 0};
  std::span<const raster::Ids> raster_ids;  ///< [w·h]
  std::span<const float> raster_depth;      ///< [w·h]
  std::span<const raster::Ids> ray_ids;     ///< [w·h]
};

/// Steps that a check takes, for showing progress.
[[nodiscard]] std::size_t check_steps(const PicturePair& pair);

/// The same for any number of threads. `on_step`, if given, is called at the end of each step, from any thread.
/// O(w·h + triangles + pairs of a differing pixel and a triangle whose bounds contain it).
[[nodiscard]] PictureCheck check_picture(const PicturePair& pair, int threads,
                                         const std::function<void()>& on_step = {});

}  // namespace lode::experiments::truth
