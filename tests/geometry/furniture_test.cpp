/// The furniture of the paper's Table 1 has the paper's counts, and is made of closed parts that face outwards.

#include "geometry/procedural/furniture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/error.h"
#include "geometry/procedural/parts.h"
#include "tests/geometry/mesh_parts.h"

namespace lode::geometry {
namespace {

Scene placed(const Model& model) {
  ModelScene scene(model.name);
  scene.place(model, model.name);
  return std::move(scene).take();
}

PartCounts parts_of(const Model& model) {
  const Scene scene = placed(model);
  return count_parts(welded(scene, scene.objects.at(0)));
}

// A closed part without holes has 2V − F = 4 (Euler): (2·2080 − 3948)/4 = 53 parts.
TEST(Furniture, TableHasThePapersCountsIn53ClosedParts) {
  const Model model = table();
  EXPECT_EQ(n_triangles(model), 3948u);
  EXPECT_EQ(n_positions(model), 2080u);
  const PartCounts parts = parts_of(model);
  EXPECT_EQ(parts.closed_outwards, 53);
  EXPECT_EQ(parts.closed_inwards + parts.open, 0);
}

// 2·2390 − 4617 = 163 = 32·4 + 35: an open sheet with 33 edges on its rim has 2V − F = 2 + 33.
TEST(Furniture, ChairHasThePapersCountsIn32ClosedPartsAndAnOpenSeat) {
  const Model model = chair();
  EXPECT_EQ(n_triangles(model), 4617u);
  EXPECT_EQ(n_positions(model), 2390u);
  const PartCounts parts = parts_of(model);
  EXPECT_EQ(parts.closed_outwards, 32);
  EXPECT_EQ(parts.closed_inwards, 0);
  EXPECT_EQ(parts.open, 1);
}

// (2·4652 − 9280)/4 = 6.
TEST(Furniture, SofaHasThePapersCountsIn6ClosedParts) {
  const Model model = sofa();
  EXPECT_EQ(n_triangles(model), 9280u);
  EXPECT_EQ(n_positions(model), 4652u);
  const PartCounts parts = parts_of(model);
  EXPECT_EQ(parts.closed_outwards, 6);
  EXPECT_EQ(parts.closed_inwards + parts.open, 0);
}

TEST(Furniture, StandsOnTheFloorAroundTheOriginInMetres) {
  struct Size {
    Model model;
    glm::dvec3 least, most;
  };
  for (const Size& size :
       {Size{table(), {1.5, 0.74, 0.85}, {1.7, 0.78, 0.95}}, Size{chair(), {0.4, 0.9, 0.4}, {0.55, 1.05, 0.65}},
        Size{sofa(), {1.9, 0.75, 0.8}, {2.3, 0.9, 1.0}}}) {
    const Bounds bounds = placed(size.model).bounds();
    EXPECT_NEAR(bounds.low.y, 0.0, 1e-6) << size.model.name;
    EXPECT_LT(std::abs(bounds.centre().x), 0.01) << size.model.name;
    const glm::dvec3 extent = bounds.high - bounds.low;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(extent[k], size.least[k]) << size.model.name << " axis " << k;
      EXPECT_LE(extent[k], size.most[k]) << size.model.name << " axis " << k;
    }
  }
}

TEST(Models, AreFilledUpToACountBySplittingTheLargestTriangles) {
  Model model{.name = "block", .surfaces = {}};
  Mesh& mesh = model.surface(paint("grey", 0.5f, 0.5f, 0.5f));
  add_block(mesh, {0, 0, 0}, {1, 2, 3});
  fill_up(model, mesh, 40);
  EXPECT_EQ(n_triangles(model), 40u);
  EXPECT_EQ(n_positions(model), 22u);  // each split brings two triangles and one vertex
  const PartCounts parts = parts_of(model);
  EXPECT_EQ(parts.closed_outwards, 1);
  EXPECT_THROW(fill_up(model, mesh, 41), Error);
  EXPECT_THROW(fill_up(model, mesh, 30), Error);
}

}  // namespace
}  // namespace lode::geometry
