#pragma once
/// A vertex of an occluder as the renderer transforms, clips against and snaps it, to the bit (C1 of
/// notes/numerics.md).

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/reference/clip.h"

namespace lode::techniques {

struct OccluderVertex {
  glm::dvec4 clip{0.0};
  glm::ivec2 p_fx8{0, 0};     ///< in the window; only where nothing is outside
  double z = 0.0;             ///< depth; likewise
  std::uint32_t outside = 0;  ///< bit k: beyond clip plane k; kNotANumber where a component is none
};
inline constexpr std::uint32_t kNotANumber = ~0u;

/// Takes an object's points to the screen.
class ToScreen {
 public:
  /// The viewport is the whole picture.
  ToScreen(const glm::dmat4& clip_from_object, glm::ivec2 size_px);

  [[nodiscard]] OccluderVertex operator()(const glm::vec3& p) const {
    OccluderVertex v;
    const double x = p.x, y = p.y, z = p.z;
    const glm::dmat4& m = clip_from_object_;
    for (int row = 0; row < 4; ++row) v.clip[row] = ((m[0][row] * x + m[1][row] * y) + m[2][row] * z) + m[3][row];
    const double w = v.clip.w;
    const bool surely_inside = w > 0x1p-100 && w < 0x1p100 && v.clip.z >= 0.0 && v.clip.z <= w &&
                               v.clip.x <= reach_.x * w && v.clip.x >= -reach_.x * w &&  //
                               v.clip.y <= reach_.y * w && v.clip.y >= -reach_.y * w;
    if (!surely_inside) return anywhere(p);
    v.p_fx8 = {int(round_half_even((v.clip.x / w) * viewport_.half_fx8.x) + viewport_.centre_fx8.x),
               int(round_half_even(-(v.clip.y / w) * viewport_.half_fx8.y) + viewport_.centre_fx8.y)};
    v.z = v.clip.z / w;
    return v;
  }

  [[nodiscard]] const raster::reference::Viewport& viewport() const { return viewport_; }

 private:
  /// By the renderer's own functions; the above are theirs where no clamp can act.
  [[nodiscard]] OccluderVertex anywhere(const glm::vec3& p) const;

  /// As std::rint, for |v| < 2^51: the sum has no places behind the point.
  [[nodiscard]] static double round_half_even(double v) { return (v + 0x1.8p52) - 0x1.8p52; }

  glm::dmat4 clip_from_object_;
  raster::reference::Viewport viewport_;
  glm::dvec2 reach_{0.0};  ///< |x| ≤ reach · w is at most half way to the guard band
};

}  // namespace lode::techniques
