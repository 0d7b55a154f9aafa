/// Boxes and hulls in models: all are proven to be inside, and they fill what can be filled.

#include "geometry/inner_boxes.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/inner_hulls.h"
#include "geometry/procedural/furniture.h"
#include "tests/geometry/solid_models.h"

namespace lode::geometry {
namespace {

using test::soup_of;

bool all_contained(const Solid& solid, const std::vector<Bounds>& boxes) {
  return std::ranges::all_of(boxes,
                             [&](const Bounds& b) { return solid.contains_box(glm::vec3(b.low), glm::vec3(b.high)); });
}

/// Of the points of a grid of n³ over the solid that are inside, the share that is in a box.
double filled_share(const Solid& solid, const std::vector<Bounds>& boxes, int n) {
  Bounds all;
  for (const Solid::Part& part : solid.parts()) all.add(part.bounds.low), all.add(part.bounds.high);
  int n_inside = 0, n_filled = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const glm::dvec3 at((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
    const glm::dvec3 p = all.low + (all.high - all.low) * at;
    if (!solid.contains(p)) continue;
    ++n_inside;
    n_filled += std::ranges::any_of(boxes, [&](const Bounds& b) {
      return glm::all(glm::lessThanEqual(b.low, p)) && glm::all(glm::lessThanEqual(p, b.high));
    });
  }
  return n_inside > 0 ? double(n_filled) / n_inside : 0.0;
}

TEST(InnerBoxes, AWallOfTenCentimetresIsFilledByOneBox) {
  const Solid solid = soup_of(box({0, 0, 0}, {8, 2.5, 0.1})).solid();
  const std::vector<Bounds> boxes = inner_boxes(solid);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].low, glm::dvec3(0));
  EXPECT_EQ(boxes[0].high, glm::dvec3(glm::vec3(8.0f, 2.5f, 0.1f)));
}

TEST(InnerBoxes, AnLIsFilledByItsTwoArms) {
  const std::vector<Bounds> boxes = inner_boxes(test::l_shape().solid());
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].high, glm::dvec3(3, 1, 1));
  EXPECT_EQ(boxes[1].high, glm::dvec3(1, 3, 1));
}

// The largest cube in a ball fills 2/(√3·π) = 37 % of it; the flattened balls of a coarse mesh hold a bit less.
TEST(InnerBoxes, ABallHoldsAboutTheLargestCube) {
  const Solid solid = soup_of(sphere({0, 0, 0}, 1.0, 24, 24)).solid();
  const std::vector<Bounds> boxes = inner_boxes(solid, {.resolution = 16, .n_most = 1});
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_TRUE(all_contained(solid, boxes));
  EXPECT_GT(filled_share(solid, boxes, 24), 0.30);
  EXPECT_LT(filled_share(solid, boxes, 24), 0.38);
}

TEST(InnerBoxes, ARingKeepsItsHoleOpen) {
  const Solid solid = soup_of(torus({0, 0, 0}, 2.0, 0.5, 24, 12)).solid();
  const std::vector<Bounds> boxes = inner_boxes(solid, {.resolution = 16});
  EXPECT_GE(boxes.size(), 4u);
  EXPECT_TRUE(all_contained(solid, boxes));
}

TEST(InnerBoxes, AreNoneWhereThereIsNoInside) {
  Mesh open = box({0, 0, 0}, {1, 1, 1});
  open.indices.resize(open.indices.size() - 3);
  EXPECT_TRUE(inner_boxes(soup_of(open).solid()).empty());
  EXPECT_TRUE(inner_boxes(soup_of(test::inside_out(box({0, 0, 0}, {1, 1, 1}))).solid()).empty());
  EXPECT_TRUE(inner_boxes(Solid({}, {})).empty());
}

TEST(InnerBoxes, AreAsManyAsAskedForAndAddTheShareAskedFor) {
  const Solid solid = test::l_shape().solid();
  EXPECT_TRUE(inner_boxes(solid, {.n_most = 0}).empty());
  EXPECT_EQ(inner_boxes(solid, {.n_most = 1}).size(), 1u);
  EXPECT_EQ(inner_boxes(solid, {.least_share = 0.5}).size(), 1u);  // the first arm has 3/5 of it, the second adds 2/5
  EXPECT_EQ(inner_boxes(solid, {.resolution = 1}).size(), 2u);     // faces alone cut the L into cells
  EXPECT_THROW((void)inner_boxes(solid, {.resolution = 0}), std::logic_error);
  EXPECT_THROW((void)inner_boxes(solid, {.n_most = -1}), std::logic_error);
  EXPECT_THROW((void)inner_boxes(solid, {.least_share = 0.0}), std::logic_error);
}

TEST(InnerBoxes, DoNotDependOnTheOrderOfTriangles) {
  const test::Soup soup = soup_of(torus({0, 0, 0}, 2.0, 0.5, 12, 8));
  test::Soup turned = soup;
  std::rotate(turned.indices.begin(), turned.indices.begin() + 3 * 50, turned.indices.end());
  const std::vector<Bounds> a = inner_boxes(soup.solid(), {.resolution = 12});
  const std::vector<Bounds> b = inner_boxes(turned.solid(), {.resolution = 12});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].low, b[i].low);
    EXPECT_EQ(a[i].high, b[i].high);
  }
}

// A sofa is mostly boxes with rounded edges; eight of them fill nearly three quarters of it.
TEST(InnerBoxes, FillMostOfTheSofa) {
  const Solid solid = soup_of(sofa()).solid();
  EXPECT_EQ(solid.parts().size(), 6u);
  const std::vector<Bounds> boxes = inner_boxes(solid, {.resolution = 16});
  EXPECT_EQ(boxes.size(), 8u);
  EXPECT_TRUE(all_contained(solid, boxes));
  EXPECT_GT(filled_share(solid, boxes, 20), 0.65);
}

// The table's top and two rails of its apron fill half of it, and no other box adds a hundredth. The chair's are cut
// off at eight, the default.
TEST(InnerBoxes, AreFewInATableAndAChair) {
  const Solid table_solid = soup_of(table()).solid(), chair_solid = soup_of(chair()).solid();
  EXPECT_EQ(table_solid.parts().size(), 53u);
  EXPECT_EQ(chair_solid.parts().size(), 32u);
  EXPECT_EQ(chair_solid.n_open(), 1u);  // the seat
  const std::vector<Bounds> in_table = inner_boxes(table_solid), in_chair = inner_boxes(chair_solid);
  EXPECT_EQ(in_table.size(), 3u);
  EXPECT_EQ(in_chair.size(), 8u);
  EXPECT_TRUE(all_contained(table_solid, in_table));
  EXPECT_TRUE(all_contained(chair_solid, in_chair));
  EXPECT_GT(filled_share(table_solid, in_table, 40), 0.4);
}

TEST(InnerHulls, ShrinkUntilTheyAreInsideOrAreDropped) {
  const Solid solid = soup_of(box(glm::dvec3(-1), glm::dvec3(1))).solid();
  const auto cube = [](float half, const glm::vec3& centre = glm::vec3(0)) {
    return test::box_corners(centre - half, centre + half);
  };
  // 1/1.01 = 0.990 > 0.98; 1/1.2 = 0.83 > 0.8; 1/2.1 = 0.48 < 0.5.
  const std::vector<std::vector<glm::vec3>> hulls = {
      cube(1.0f), cube(1.01f), cube(1.2f), cube(2.1f), cube(0.5f, glm::vec3(5)), {}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const std::vector<InnerHull> inner = inner_hulls(solid, hulls);
  ASSERT_EQ(inner.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(inner[i].source, i);
    EXPECT_EQ(inner[i].factor, (std::array{1.0f, 0.98f, 0.8f})[i]);
    EXPECT_TRUE(solid.contains_hull(inner[i].points));
  }
}

}  // namespace
}  // namespace lode::geometry
