/// Masked occlusion culling with boxes inside the occluders: the picture of the whole scene, byte for byte.

#include <gtest/gtest.h>

#include "techniques/masked_occlusion/draw_inner_box.h"
#include "techniques/masked_occlusion/masked_occlusion.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::MaskedDepth;
using techniques::MaskedOcclusion;
using techniques::OccluderWork;
using techniques::View;
using techniques::World;

MaskedOcclusion with_boxes() {
  return MaskedOcclusion({.occluders = {}, .input = MaskedOcclusion::Input::inner_boxes, .boxes = {.resolution = 8}});
}

/// Looks down −z from the origin, 80² px; at distance d, 40 px are d world units.
View view_80px() {
  View view;
  view.camera.tan_half_fov_y = 1.0;
  view.camera.near = 0.5;
  view.size_px = {80, 80};
  return view;
}

// The box [−5, 5]² at z = −10 covers pixels 20 … 59, whose samples end half a pixel before its edges: none is lost.
// Its depth is that of its front, 0.5/10, up to the rounding of a float.
TEST(MaskedInnerBox, CoversTheSamplesOfItsFrontFaceAtTheirDepth) {
  MaskedDepth buffer;
  buffer.begin({80, 80});
  OccluderWork work;
  const View view = view_80px();
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  draw_inner_box({{-5, -5, -11}, {5, 5, -10}}, clip_from_world, false, view.size_px, buffer, work);
  EXPECT_EQ(work.drawn, 4u);  // the outline and the front face
  EXPECT_LT(buffer.bound_at({40, 40}), 0.05f);
  EXPECT_GT(buffer.bound_at({40, 40}), 0.05f * 0.999999f);
  EXPECT_GT(buffer.bound_at({20, 20}), 0.0f);
  EXPECT_GT(buffer.bound_at({59, 59}), 0.0f);
  EXPECT_EQ(buffer.bound_at({19, 40}), 0.0f);
  EXPECT_EQ(buffer.bound_at({40, 60}), 0.0f);
}

// The edge of what is drawn is 2/256 px inside and then snaps by up to 1/512 px: a sample counts if it is 2.5/256 px
// inside for sure, and never if it is less than 1.5/256 px. A vertex of the picture snaps by 0.5/256 px.
TEST(MaskedInnerBox, LeavesOutSamplesThatASnapCouldUncover) {
  const View view = view_80px();
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  for (const double inside_px : {-0.01, 0.0, 0.001, 0.0058, 0.0098, 0.02}) {
    MaskedDepth buffer;
    buffer.begin({80, 80});
    OccluderWork work;
    const double left = (20.5 - inside_px - 40.0) / 40.0 * 10.0;
    draw_inner_box({{left, -5, -11}, {5, 5, -10}}, clip_from_world, false, view.size_px, buffer, work);
    EXPECT_EQ(buffer.bound_at({20, 40}) > 0.0f, inside_px > 2.0 / 256.0) << inside_px;
  }
}

TEST(MaskedInnerBox, DrawsNothingThatReachesTheNearPlane) {
  MaskedDepth buffer;
  buffer.begin({80, 80});
  OccluderWork work;
  const View view = view_80px();
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  draw_inner_box({{-5, -5, -11}, {5, 5, -0.5}}, clip_from_world, false, view.size_px, buffer, work);
  draw_inner_box({{-5, -5, -11}, {5, 5, 3}}, clip_from_world, false, view.size_px, buffer, work);
  draw_inner_box({{-5, -5, 1}, {5, 5, 3}}, clip_from_world, false, view.size_px, buffer, work);
  EXPECT_EQ(work.triangles, 0u);
}

TEST(MaskedInnerBoxes, RandomScenesLookTheSame) {
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const bool lattice = seed % 2 == 1;
    const geometry::Scene scene = lattice ? lattice_scene(seed, 30) : random_scene(seed, 40);
    const World world(scene, kRawUnlit, true, 1);
    Showing boxes(world, with_boxes());
    Showing plain(world, techniques::Plain{});
    for (std::uint64_t k = 0; k < 6; ++k) {
      const View view = lattice ? lattice_view(seed, k) : random_view(seed, k);
      const TechniquePicture picture = boxes.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "") << "scene " << seed << ", view " << k;
      n_culled += picture.count("culled");
    }
  }
  EXPECT_GT(n_culled, 20u);
}

}  // namespace
}  // namespace lode::tests
