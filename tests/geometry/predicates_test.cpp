/// Orientation signs (C14).

#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/geometry/predicates_cases.h"

namespace lode::geometry {
namespace {

TEST(Orientation, IsPositiveForCounterClockwiseWithYUp) {
  EXPECT_EQ(orientation(glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)), 1);
  EXPECT_EQ(orientation(glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 0)), -1);
  EXPECT_EQ(orientation(glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(3, 3)), 0);
}

TEST(Orientation, IsPositiveOnTheSideFromWhichThePlaneTurnsCounterClockwise) {
  const glm::dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orientation(a, b, c, glm::dvec3(0, 0, 1)), 1);
  EXPECT_EQ(orientation(a, b, c, glm::dvec3(0, 0, -1)), -1);
  EXPECT_EQ(orientation(a, b, c, glm::dvec3(7, -3, 0)), 0);
}

TEST(Orientation, EqualsTheRationalsOnHardInputs) {
  EXPECT_EQ(test::wrong_signs(0, 30000, orientation, orientation), 0u);
}

TEST(Orientation, SeesTheSmallestDenormalBesideTheLargestDouble) {
  // c lies above the line through a and b by the smallest double there is.
  const double big = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation(glm::dvec2(-big, 0), glm::dvec2(big, 0), glm::dvec2(0, tiny)), 1);
  EXPECT_EQ(orientation(glm::dvec2(-big, 0), glm::dvec2(big, 0), glm::dvec2(0, -tiny)), -1);
  EXPECT_EQ(orientation(glm::dvec3(-big, 0, 0), glm::dvec3(big, 0, 0), glm::dvec3(0, big, 0), glm::dvec3(1, 1, tiny)),
            1);
  EXPECT_EQ(orientation(glm::dvec3(tiny, 0, 0), glm::dvec3(0, tiny, 0), glm::dvec3(0, 0, tiny), glm::dvec3(0, 0, 0)),
            -1);
}

TEST(Orientation, ChangesSignWhenTwoPointsAreSwapped) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    test::predicate_case(
        i, [](auto& a, auto& b, auto& c) { EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c)); },
        [](auto& a, auto& b, auto& c, auto& d) { EXPECT_EQ(orientation(a, b, c, d), -orientation(b, a, c, d)); });
  }
}

TEST(SideOfDirections, IsPositiveWhereFirstAndSecondTurnCounterClockwise) {
  const glm::dvec3 a(1, 2, 3), x(1, 0, 0), y(0, 1, 0), c(9, 9, 9);
  EXPECT_EQ(side_of_directions(a, a + x, c, c + y, a + glm::dvec3(5, 5, 1)), 1);
  EXPECT_EQ(side_of_directions(a, a + y, c, c + x, a + glm::dvec3(5, 5, 1)), -1);
  EXPECT_EQ(side_of_directions(a, a + x, c, c + y, a + glm::dvec3(5, 5, 0)), 0);
  EXPECT_EQ(side_of_directions(a, a + x, c, c + x, glm::dvec3(0)), 0);  // no plane
}

TEST(SideOfDirections, EqualsTheRationalsOnHardInputs) {
  for (std::uint64_t i = 0; i < 10000; ++i) EXPECT_FALSE(test::wrong_side(i)) << i;
}

TEST(Orientation, RefusesWhatIsNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)orientation(glm::dvec2(inf, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)), std::logic_error);
}

}  // namespace
}  // namespace lode::geometry
