/// What is drawn into the masked depth buffer in a model's place.

#include "techniques/masked_occlusion/stand_ins.h"

#include <gmock/gmock.h>

#include "techniques/masked_occlusion/masked_occlusion.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::MaskedOcclusion;
using techniques::MaskedShape;
using techniques::Shape;
using techniques::StandIn;
using techniques::View;
using techniques::World;

Shape shape_of(const geometry::Mesh& mesh) { return {mesh.positions, mesh.indices, true}; }

/// Six times the volume that the triangles enclose, positive if they are outward.
double volume_x6(const StandIn& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < s.indices.size(); i += 3) {
    const glm::dvec3 a(s.positions[s.indices[i]]), b(s.positions[s.indices[i + 1]]), c(s.positions[s.indices[i + 2]]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum;
}

TEST(StandIns, TheHullOfABoxIsTheBox) {
  const StandIn hull = techniques::hull_of(shape_of(geometry::box({1, 2, 3}, {2, 4, 6})));
  EXPECT_EQ(hull.positions.size(), 8u);
  EXPECT_EQ(hull.indices.size(), 36u);
  EXPECT_EQ(volume_x6(hull), 36.0);  // 6 · 1·2·3
}

TEST(StandIns, AFlatShapeHasNoHull) {
  EXPECT_TRUE(techniques::hull_of(shape_of(geometry::terrain(4.0, 2, 0.0, 1))).indices.empty());
  EXPECT_TRUE(techniques::hull_of(Shape{}).indices.empty());
}

TEST(StandIns, ABoxIsShrunkInwardsAndGoneWhereNothingIsLeft) {
  StandIn boxes;
  techniques::add_box({{0, 0, 0}, {1, 2, 4}}, {0.25, 0.5, 1.0}, boxes);
  EXPECT_EQ(boxes.positions.front(), glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(boxes.positions.back(), glm::vec3(0.75f, 1.5f, 3.0f));
  EXPECT_EQ(volume_x6(boxes), 6.0 * 0.5 * 1.0 * 2.0);
  techniques::add_box({{0, 0, 0}, {1, 2, 4}}, {0.5, 0.5, 0.5}, boxes);
  EXPECT_EQ(boxes.positions.size(), 8u);
  // 0.1 and 0.7 are no floats.
  StandIn rounded;
  techniques::add_box({{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}}, {0, 0, 0}, rounded);
  EXPECT_GE(double(rounded.positions.front().x), 0.1);
  EXPECT_LE(double(rounded.positions.back().x), 0.7);
}

TEST(StandIns, TheInsetIsAFewSubPixelsAtTheFarthestCorner) {
  // 100 px for 2 units at distance 1, so 0.02 · 50 = 1 unit a pixel at 50; the shape's x axis is twice as long in the
  // world.
  View view;
  view.camera.tan_half_fov_y = 1.0;
  view.size_px = {100, 100};
  const glm::dmat4 wide = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 1.0, 1.0));
  const glm::dvec3 inset = techniques::inset_of(view, {{-1, -1, -50}, {1, 1, -10}}, wide);
  EXPECT_DOUBLE_EQ(inset.x, 2.5 / 256.0 / 2.0);
  EXPECT_DOUBLE_EQ(inset.y, 2.5 / 256.0);
  EXPECT_DOUBLE_EQ(inset.z, 2.5 / 256.0);
}

TEST(StandIns, WithInnerBoxesPicturesOfClosedModelsLookTheSame) {
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const geometry::Scene scene = seed % 2 == 0 ? random_scene(seed, 40) : lattice_scene(seed, 30);
    const World world(scene, kRawUnlit, true, 1);
    Showing technique(
        world, MaskedOcclusion({.occluders = {}, .shape = MaskedShape::inner_boxes, .boxes = {.resolution = 6}}));
    Showing plain(world, techniques::Plain{});
    for (std::uint64_t k = 0; k < 6; ++k) {
      const View view = seed % 2 == 0 ? random_view(seed, k) : lattice_view(seed, k);
      const TechniquePicture picture = technique.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "") << "scene " << seed << ", view " << k;
      n_culled += picture.count("culled");
    }
  }
  EXPECT_GT(n_culled, 20u);
}

TEST(StandIns, HullsHideWhatModelsLeaveFreeAndSaySo) {
  // Two walls with a gap, as one object; the box behind the gap is seen through it, and a hull closes the gap.
  geometry::Mesh walls = geometry::box({-5, -5, -11}, {-2, 5, -10});
  const geometry::Mesh right = geometry::box({2, -5, -11}, {5, 5, -10});
  const auto n = std::uint32_t(walls.positions.size());
  walls.positions.insert(walls.positions.end(), right.positions.begin(), right.positions.end());
  for (const std::uint32_t i : right.indices) walls.indices.push_back(n + i);
  walls.normals.clear();
  walls.uvs.clear();
  geometry::Scene scene;
  geometry::add_instance(scene, walls);
  geometry::add_instance(scene, geometry::box({-1, -1, -20}, {1, 1, -19}));
  const World world(scene, kRawUnlit, true, 1);
  View view;
  view.size_px = {64, 64};
  EXPECT_TRUE(Showing(world, MaskedOcclusion{}).picture(view).drawn[1]);
  const MaskedOcclusion hulls({.occluders = {}, .shape = MaskedShape::hulls});
  EXPECT_EQ(hulls.promise(), techniques::Promise::approximate);
  EXPECT_FALSE(Showing(world, hulls).picture(view).drawn[1]);
}

}  // namespace
}  // namespace lode::tests
