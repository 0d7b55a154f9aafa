// Levels of detail of meshes: which is drawn when, and as what (techniques/mesh_lod/README.md).
#include "techniques/mesh_lod/mesh_lod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>
#include <string>

#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::largest_scale;
using techniques::mesh_levels;
using techniques::MeshLod;
using techniques::ObjectId;
using techniques::pixels_per_unit;
using techniques::View;
using techniques::World;

View view_from(double z, glm::ivec2 size_px = {160, 120}) {
  View view{.camera = {}, .size_px = size_px};
  geometry::look_at(view.camera, {0.0, 0.0, z}, glm::dvec3(0.0));
  return view;
}

/// A ball of radius 1 with 64 · 31 · 2 triangles around the origin.
geometry::Scene ball(const glm::dmat4& place = glm::dmat4(1.0)) {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 1.0, 64, 32), {}, place);
  return scene;
}

int level_of(const TechniquePicture& picture) {
  for (int level = 0; level < 4; ++level) {
    if (picture.count("level" + std::to_string(level)) == 1) return level;
  }
  return -1;
}

TEST(MeshLod, LevelIsTheCoarsestWhoseErrorIsLessThanThePixels) {
  const std::array<double, 3> errors = {0.01, 0.02, 0.04};
  const MeshLod lod({.pixels = 2.0});
  EXPECT_EQ(lod.level_for(errors, 49.0), 3);   // 1.96 px
  EXPECT_EQ(lod.level_for(errors, 50.0), 2);   // 2 px are not less than 2
  EXPECT_EQ(lod.level_for(errors, 150.0), 1);  // 1.5, 3 and 6 px
  EXPECT_EQ(lod.level_for(errors, 200.0), 0);
  EXPECT_EQ(lod.level_for(errors, std::numeric_limits<double>::infinity()), 0);  // the eye is in the box
  EXPECT_EQ(MeshLod({.level = 2}).level_for(errors, 1e9), 2);
}

TEST(MeshLod, PixelsOfAUnitAreThoseAtTheNearestPointOfTheBox) {
  View view = view_from(10.0, {200, 100});
  view.camera.tan_half_fov_y = 0.5;  // 100 px are 1 unit at distance 1
  EXPECT_DOUBLE_EQ(pixels_per_unit(view, {{-1, -1, -1}, {1, 1, 5}}), 20.0);
  EXPECT_DOUBLE_EQ(pixels_per_unit(view, {{3, -1, -1}, {9, 1, 6}}), 20.0);  // at (3, 0, 6), 5 units away
  EXPECT_EQ(pixels_per_unit(view, {{-1, -1, -1}, {1, 1, 11}}), std::numeric_limits<double>::infinity());
  view.camera.projection = geometry::Projection::orthographic;
  view.camera.height = 4.0;
  EXPECT_DOUBLE_EQ(pixels_per_unit(view, {{-1, -1, -1}, {1, 1, 5}}), 25.0);
}

TEST(MeshLod, LargestScaleIsThatOfTheLongestAxisAndNoLessWhereAxesAreOblique) {
  glm::dmat4 place = glm::translate(glm::dmat4(1.0), glm::dvec3(7.0));
  place = glm::rotate(place, 0.7, glm::dvec3(0.6, 0.0, 0.8));
  EXPECT_NEAR(largest_scale(glm::scale(place, glm::dvec3(1.0, -3.0, 2.0))), 3.0, 1e-12);
  // x + y: the vector (1, 1, 0) / √2 becomes (√2, 1 / √2, 0), longer than any column but the sheared one.
  glm::dmat4 sheared(1.0);
  sheared[1][0] = 1.0;
  EXPECT_GE(largest_scale(sheared), glm::length(glm::dvec3(sheared * glm::dvec4(1.0, 1.0, 0.0, 0.0))) / std::sqrt(2.0));
}

TEST(MeshLod, LevelsGrowWithTheDistanceFromNoneToTheLast) {
  const geometry::Scene scene = ball();
  const World world(scene, {}, true, 1);
  Showing technique(world, MeshLod{});
  std::set<int> seen;
  int before = 0;
  for (double z = 1.5; z < 400.0; z *= 1.1) {
    const int level = level_of(technique.picture(view_from(z)));
    EXPECT_GE(level, before) << z;
    before = level;
    seen.insert(level);
  }
  EXPECT_EQ(seen, (std::set<int>{0, 1, 2, 3}));
}

/// Twice as large and twice as far: the same picture, and the same level.
TEST(MeshLod, AnObjectsScaleCounts) {
  const geometry::Scene once = ball(), twice = ball(glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
  const World world(once, {}, true, 1), world_twice(twice, {}, true, 1);
  Showing technique(world, MeshLod{}), technique_twice(world_twice, MeshLod{});
  std::set<int> seen;
  for (double z = 1.5; z < 400.0; z *= 1.3) {
    const int level = level_of(technique.picture(view_from(z)));
    EXPECT_EQ(level_of(technique_twice.picture(view_from(2.0 * z))), level) << z;
    seen.insert(level);
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST(MeshLod, FixedLevelHasItsShareOfTrianglesUnderTheObjectsId) {
  const geometry::Scene scene = ball();
  const World world(scene, {}, true, 1);
  const double n = double(scene.meshes[0].n_primitives());
  const double shares[] = {0.5, 0.2, 0.05};
  for (int level = 1; level <= 3; ++level) {
    const TechniquePicture picture = Showing(world, MeshLod({.level = level})).picture(view_from(4.0));
    EXPECT_EQ(level_of(picture), level);
    EXPECT_NEAR(double(picture.count("primitives_drawn")), shares[level - 1] * n, 0.01 * n);
    std::size_t n_drawn = 0;
    for (const raster::Ids& ids : picture.image.ids) {
      if (ids.draw == raster::kNoId) continue;
      ++n_drawn;
      EXPECT_EQ(ids.draw, 0u);
      EXPECT_EQ(ids.primitive, techniques::kStandInPrimitive);
    }
    EXPECT_GT(n_drawn, 1000u);
  }
}

TEST(MeshLod, WithNoErrorAllowedThePictureIsThatOfThePlainScene) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const geometry::Scene scene = random_scene(seed, 30);
    const World world(scene, kRawUnlit, true, 1);
    Showing technique(world, MeshLod({.pixels = 0.0}));
    Showing plain(world, techniques::Plain{});
    for (std::uint64_t k = 0; k < 4; ++k) {
      const View view = random_view(seed, k);
      const TechniquePicture picture = technique.picture(view);
      EXPECT_EQ(difference_from_plain(picture, plain.picture(view)), "") << "scene " << seed << ", view " << k;
      EXPECT_EQ(picture.count("level0"), picture.count("objects_in_view"));
    }
  }
}

/// The error on the screen is what moves: with one of less than a pixel, all but the outline covers what it did.
TEST(MeshLod, OnlyTheOutlineOfABallMoves) {
  const geometry::Scene scene = ball();
  const World world(scene, kRawUnlit, true, 1);
  const View view = view_from(30.0, {320, 240});
  const TechniquePicture picture = Showing(world, MeshLod{}).picture(view);
  const TechniquePicture plain = Showing(world, techniques::Plain{}).picture(view);
  EXPECT_GT(level_of(picture), 0);
  int n_covered = 0, n_other = 0;
  for (std::size_t i = 0; i < plain.image.ids.size(); ++i) {
    const bool covered = plain.image.ids[i].draw != raster::kNoId;
    n_covered += covered;
    n_other += covered != (picture.image.ids[i].draw != raster::kNoId);
  }
  EXPECT_GT(n_covered, 200);
  EXPECT_LT(n_other, n_covered / 5);
}

TEST(MeshLod, DrawsLinesAndPointsAsTheyAre) {
  geometry::Scene scene;
  for (const geometry::MeshKind kind : {geometry::MeshKind::lines, geometry::MeshKind::points}) {
    geometry::Mesh mesh = geometry::sphere(glm::dvec3(0.0), 1.0, 8, 6);
    mesh.kind = kind;
    geometry::add_instance(scene, mesh, {});
  }
  const World world(scene, {}, true, 1);
  const TechniquePicture picture = Showing(world, MeshLod({.level = 3})).picture(view_from(4.0));
  EXPECT_EQ(picture.count("level0"), 2u);
  EXPECT_EQ(picture.count("extra_bytes"), 0u);
  EXPECT_EQ(difference_from_plain(picture, Showing(world, techniques::Plain{}).picture(view_from(4.0))), "");
}

/// An object of a ball and of lines: the ball is simpler, the lines are not, and both keep their ids.
TEST(MeshLod, AnObjectOfSeveralMeshesHasOneLevel) {
  geometry::Scene scene = ball();
  geometry::Mesh lines = geometry::sphere(glm::dvec3(0.0), 1.2, 8, 6);
  lines.kind = geometry::MeshKind::lines;
  geometry::add_instance(scene, lines, {});
  scene.objects = {{"both", 0, 2}};
  const World world(scene, {}, true, 1);
  const TechniquePicture picture = Showing(world, MeshLod({.level = 1})).picture(view_from(4.0));
  EXPECT_EQ(level_of(picture), 1);
  for (const raster::Ids& ids : picture.image.ids) {
    if (ids.draw == 0) {
      EXPECT_EQ(ids.primitive, techniques::kStandInPrimitive);
    }
    if (ids.draw == 1) {
      EXPECT_LT(ids.primitive, lines.n_primitives());
    }
  }
}

TEST(MeshLod, LevelsAndPicturesAreTheSameForAnyNumberOfThreads) {
  const geometry::Scene scene = random_scene(3, 60);
  const World one(scene, {}, true, 1), many(scene, {}, true, 4);
  const techniques::MeshShares shares = MeshLod::Params{}.shares;
  const auto levels = mesh_levels(one, shares, 1), again = mesh_levels(many, shares, 4);
  EXPECT_EQ(levels->bytes, again->bytes);
  std::size_t n_levels = 0;
  for (std::size_t mesh = 0; mesh < levels->of_mesh.size(); ++mesh) {
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const techniques::MeshLevel &a = levels->of_mesh[mesh][k], &b = again->of_mesh[mesh][k];
      ASSERT_EQ(a.alternate.has_value(), b.alternate.has_value());
      EXPECT_EQ(a.error, b.error);
      if (!a.alternate) continue;
      ++n_levels;
      EXPECT_EQ(a.alternate->mesh.positions, b.alternate->mesh.positions);
      EXPECT_EQ(a.alternate->mesh.indices, b.alternate->mesh.indices);
    }
  }
  EXPECT_GT(n_levels, 20u);
  const View view = view_from(20.0);
  EXPECT_EQ(difference_from_plain(Showing(one, MeshLod({.level = 2})).picture(view),
                                  Showing(many, MeshLod({.level = 2})).picture(view)),
            "");
}

}  // namespace
}  // namespace lode::tests
