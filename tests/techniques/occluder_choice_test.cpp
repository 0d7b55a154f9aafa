/// Who is an occluder, by Onozawa and Kitazawa's eq. 4.

#include "techniques/occluder_choice.h"

#include <gmock/gmock.h>

#include "techniques/objects_in_view.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::choose_occluders;
using techniques::occluder_areas;
using techniques::View;
using techniques::World;
using testing::ElementsAre;

/// Cubes of the sides given, their near faces at the view distances given from an eye in the origin that looks down −z.
geometry::Scene cubes(const std::vector<std::pair<double, double>>& side_at) {
  geometry::Scene scene;
  for (const auto& [side, distance] : side_at) {
    geometry::add_instance(
        scene, geometry::box({-0.5 * side, -0.5 * side, -distance - side}, {0.5 * side, 0.5 * side, -distance}));
  }
  return scene;
}

std::vector<techniques::ObjectId> chosen(const geometry::Scene& scene, const techniques::OccluderRule& rule) {
  const World world(scene, kRawUnlit, false);
  const View view{.camera = {}, .size_px = {64, 64}};
  return choose_occluders(world, view, techniques::objects_in_view(world, view), occluder_areas(world), rule);
}

TEST(OccluderDegree, IsEquationFour) {
  // (1 − 25/100) · 2/8.
  EXPECT_EQ(techniques::occluder_degree(25.0, 100.0, 2.0, 8.0), 0.1875);
  EXPECT_EQ(techniques::occluder_degree(0.0, 100.0, 8.0, 8.0), 1.0);
  EXPECT_EQ(techniques::occluder_degree(100.0, 100.0, 8.0, 8.0), 0.0);
  EXPECT_EQ(techniques::occluder_degree(101.0, 100.0, 8.0, 8.0), 0.0);
}

TEST(OccluderAreas, AreTheBoxesFacesOnTheThreePlanes) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_THAT(occluder_areas(World(scene, kRawUnlit, false)), ElementsAre(2.0 * 3.0 + 3.0 * 1.0 + 1.0 * 2.0));
}

TEST(OccluderAreas, WhatHasHolesHidesNothing) {
  geometry::Scene scene;
  for (const auto mode : {geometry::AlphaMode::opaque, geometry::AlphaMode::mask, geometry::AlphaMode::blend}) {
    geometry::Material material;
    material.alpha_mode = mode;
    geometry::add_instance(scene, geometry::box({0, 0, 0}, {1, 1, 1}), material);
  }
  EXPECT_THAT(occluder_areas(World(scene, kRawUnlit, false)), ElementsAre(3.0, 0.0, 0.0));
}

TEST(ChooseOccluders, BestDegreeFirstAndTiesByLowerId) {
  // Sides 1, 2, 2, 4 at 10, 20, 20, 60 of 100: 0.9 · 1/16, 0.8 · 4/16 twice, 0.4 · 16/16.
  const geometry::Scene scene = cubes({{1, 10}, {2, 20}, {2, 20}, {4, 60}});
  EXPECT_THAT(chosen(scene, {.far = 100.0}), ElementsAre(3, 1, 2, 0));
  EXPECT_THAT(chosen(scene, {.most = 2, .far = 100.0}), ElementsAre(3, 1));
  EXPECT_THAT(chosen(scene, {.least_degree = 0.2, .far = 100.0}), ElementsAre(3, 1, 2));
  EXPECT_THAT(chosen(scene, {.most = 0}), ElementsAre());
}

TEST(ChooseOccluders, BeyondFarThereAreNone) {
  EXPECT_THAT(chosen(cubes({{1, 10}, {2, 20}}), {.far = 15.0}), ElementsAre(0));
}

TEST(ChooseOccluders, FromOutsideTheSceneThereAreSome) {
  // The scene's own diagonal is below 3; the box of scene and eye is as long as the view.
  EXPECT_THAT(chosen(cubes({{1, 100}, {1, 101}}), {}), ElementsAre(0, 1));
}

TEST(ChooseOccluders, TheLargestOfTheCandidatesCountsAsOne) {
  // The one behind the eye is ten times as large; were it counted, the other's degree would be below 0.01.
  const geometry::Scene scene = cubes({{1, 10}, {10, -30}});
  EXPECT_THAT(chosen(scene, {.least_degree = 0.5, .far = 100.0}), ElementsAre(0));
}

TEST(ChooseOccluders, OfNothingIsNothing) { EXPECT_THAT(chosen(geometry::Scene{}, {}), ElementsAre()); }

}  // namespace
}  // namespace lode::tests
