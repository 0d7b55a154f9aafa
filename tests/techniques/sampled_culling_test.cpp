/// What hierarchical Z and masked occlusion culling both promise: the picture of the whole scene, byte for byte, with
/// less drawn.

#include <gtest/gtest.h>

#include "techniques/hierarchical_z/hierarchical_z.h"
#include "techniques/masked_occlusion/masked_occlusion.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using geometry::box;
using techniques::HierarchicalZ;
using techniques::MaskedOcclusion;
using techniques::View;
using techniques::World;

template <class T>
class SampledCulling : public testing::Test {
 protected:
  /// The technique's picture, after it was found to be that of the whole scene.
  static TechniquePicture checked_picture(const geometry::Scene& scene, const View& view) {
    const World world(scene, kRawUnlit, true, 1);
    TechniquePicture picture = Showing(world, T{}).picture(view);
    EXPECT_EQ(difference_from_plain(picture, Showing(world, techniques::Plain{}).picture(view)), "");
    EXPECT_EQ(picture.count("culled") + std::uint64_t(std::count(picture.drawn.begin(), picture.drawn.end(), true)),
              picture.count("objects_in_view"));
    return picture;
  }
};
using Techniques = testing::Types<HierarchicalZ, MaskedOcclusion>;
TYPED_TEST_SUITE(SampledCulling, Techniques);

/// Looks down −z from the origin; at distance d, 40 px are d world units.
View view_80px() {
  View view;
  view.camera.tan_half_fov_y = 1.0;
  view.camera.near = 0.5;
  view.size_px = {80, 80};
  return view;
}

/// A wall at z = −10, [−5, 5]² (pixels 20 … 59), and a box of side 1 in it or behind it, at x, y, z.
geometry::Scene wall_and_box(const glm::dvec3& centre) {
  geometry::Scene scene;
  geometry::add_instance(scene, box({-5, -5, -11}, {5, 5, -10}));
  geometry::add_instance(scene, box(centre - 0.5, centre + 0.5));
  return scene;
}

TYPED_TEST(SampledCulling, AWallHidesTheBoxesBehindIt) {
  geometry::Scene scene = wall_and_box({0, 0, -20});
  geometry::add_instance(scene, box({3, 3, -30}, {4, 4, -29}));
  geometry::add_instance(scene, box({20, 0, -30}, {21, 1, -29}));  // beside the wall
  geometry::add_instance(scene, box({0, 0, 5}, {1, 1, 6}));        // behind the eye
  const TechniquePicture picture = this->checked_picture(scene, view_80px());
  EXPECT_EQ(picture.drawn, (std::vector<bool>{true, false, false, true, false}));
  EXPECT_EQ(picture.count("objects_in_view"), 4u);
  EXPECT_EQ(picture.count("occluders"), 4u);
  EXPECT_EQ(picture.count("tested"), 4u);
  EXPECT_EQ(picture.count("culled"), 2u);
}

TYPED_TEST(SampledCulling, WhatPeepsOutBehindTheEdgeIsDrawn) {
  // The wall ends at 5/10 of the view; at distance 19.5 that is 9.75. A box up to 9.70 ends a fifth of a pixel before
  // the edge (the pixel beyond is asked too, and is not covered), one up to 9.2 ends more than a pixel before it.
  EXPECT_TRUE(this->checked_picture(wall_and_box({9.20, 0, -20}), view_80px()).drawn[1]);
  EXPECT_FALSE(this->checked_picture(wall_and_box({8.70, 0, -20}), view_80px()).drawn[1]);
  EXPECT_TRUE(this->checked_picture(wall_and_box({9.50, 0, -20}), view_80px()).drawn[1]);
}

TYPED_TEST(SampledCulling, WhatTouchesTheOccludersDepthIsDrawn) {
  // A face in the plane of the wall's face: at equal depth the lower id wins, so both have to be there.
  EXPECT_TRUE(this->checked_picture(wall_and_box({0, 0, -10.5}), view_80px()).drawn[1]);
  EXPECT_FALSE(this->checked_picture(wall_and_box({0, 0, -10.6}), view_80px()).drawn[1]);
}

TYPED_TEST(SampledCulling, WhatReachesTheNearPlaneIsDrawnAndStillHides) {
  // A floor from under the eye to far away, cut by the near plane, seen from above: it hides what lies below it.
  geometry::Scene scene;
  geometry::add_instance(scene, box({-50, -2, -100}, {50, -1, 10}));
  geometry::add_instance(scene, box({-1, -8, -12}, {1, -7, -10}));
  geometry::add_instance(scene, box({-1, -8, -12}, {1, 1, 0.4}));
  const TechniquePicture picture = this->checked_picture(scene, view_80px());
  EXPECT_EQ(picture.drawn, (std::vector<bool>{true, false, true}));
}

TYPED_TEST(SampledCulling, AnOccluderThatOthersHideIsLeftOut) {
  geometry::Scene scene = wall_and_box({0, 0, -20});
  geometry::add_instance(scene, box({-2, -2, -20}, {2, 2, -13}));  // itself behind the wall
  EXPECT_EQ(this->checked_picture(scene, view_80px()).drawn, (std::vector<bool>{true, false, false}));
}

TYPED_TEST(SampledCulling, WhatHasHolesHidesNothing) {
  for (const auto mode : {geometry::AlphaMode::mask, geometry::AlphaMode::blend}) {
    geometry::Scene scene = wall_and_box({0, 0, -20});
    scene.materials[0].alpha_mode = mode;
    const TechniquePicture picture = this->checked_picture(scene, view_80px());
    EXPECT_TRUE(picture.drawn[1]);
    EXPECT_EQ(picture.count("occluders"), 1u);
  }
}

TYPED_TEST(SampledCulling, BackFacesThatAreNotShownHideNothing) {
  // From inside the wall's box only back faces are seen: culled where the material is one-sided.
  geometry::Scene scene = wall_and_box({0, 0, -20});
  View view = view_80px();
  view.camera.near = 0.1;
  view.camera.eye = {0, 0, -10.5};
  EXPECT_TRUE(this->checked_picture(scene, view).drawn[1]);
  scene.materials[0].double_sided = true;
  EXPECT_FALSE(this->checked_picture(scene, view).drawn[1]);
}

TYPED_TEST(SampledCulling, NothingIsDrawnOfNothing) {
  EXPECT_EQ(this->checked_picture(geometry::Scene{}, view_80px()).count("culled"), 0u);
}

TYPED_TEST(SampledCulling, RandomScenesLookTheSame) {
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const geometry::Scene scene = random_scene(seed, 40);
    const World world(scene, kRawUnlit, seed % 2 == 0, 1);
    Showing technique(world, TypeParam{});
    Showing plain(world, techniques::Plain{});
    for (std::uint64_t k = 0; k < 8; ++k) {
      const View view = random_view(seed, k);
      const TechniquePicture picture = technique.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "") << "scene " << seed << ", view " << k;
      n_culled += picture.count("culled");
    }
  }
  EXPECT_GT(n_culled, 50u);
}

TYPED_TEST(SampledCulling, EdgesThroughSamplesAndSharedPlanesLookTheSame) {
  std::uint64_t n_culled = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const geometry::Scene scene = lattice_scene(seed, 30);
    const World world(scene, kRawUnlit, seed % 2 == 0, 1);
    Showing technique(world, TypeParam{});
    Showing plain(world, techniques::Plain{});
    for (std::uint64_t k = 0; k < 6; ++k) {
      const View view = lattice_view(seed, k);
      const TechniquePicture picture = technique.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "") << "scene " << seed << ", view " << k;
      n_culled += picture.count("culled");
    }
  }
  EXPECT_GT(n_culled, 20u);
}

TEST(HierarchicalZ, CoarserTexelsHideLessAndNeverMore) {
  for (std::uint64_t k = 0; k < 8; ++k) {
    const geometry::Scene scene = random_scene(77, 40);
    const World world(scene, kRawUnlit, true, 1);
    const View view = random_view(77, k);
    std::uint64_t culled = ~0ull;
    const TechniquePicture plain = Showing(world, techniques::Plain{}).picture(view);
    for (const int scale : {1, 2, 8, 64}) {
      const TechniquePicture picture = Showing(world, HierarchicalZ({.occluders = {}, .scale = scale})).picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain), "");
      EXPECT_LE(picture.count("culled"), culled);
      culled = picture.count("culled");
    }
  }
}

TEST(MaskedOcclusion, HidesNothingThatTheOccludersDepthDoesNot) {
  // The same occluders in the renderer's own depth buffer, at every sample, are the oracle.
  for (std::uint64_t k = 0; k < 16; ++k) {
    const geometry::Scene scene = random_scene(500 + k % 4, 40);
    const World world(scene, kRawUnlit, true, 1);
    const View view = random_view(5, k);
    const TechniquePicture exact = Showing(world, HierarchicalZ{}).picture(view);
    const TechniquePicture masked = Showing(world, MaskedOcclusion{}).picture(view);
    for (std::size_t id = 0; id < exact.drawn.size(); ++id) {
      EXPECT_TRUE(!exact.drawn[id] || masked.drawn[id]) << "object " << id << ", view " << k;
    }
  }
}

}  // namespace
}  // namespace lode::tests
