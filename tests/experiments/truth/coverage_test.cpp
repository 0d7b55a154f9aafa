/// Coverage over all placements: against an independent exact criterion, and against placements themselves.

#include "experiments/truth/coverage.h"

#include <gtest/gtest.h>

#include "tests/experiments/truth/placements.h"

namespace lode::experiments::truth {
namespace {

/// An outline can pass over the sample exactly where a segment of it meets the square of half side kSnap_px around it.
TEST(PlacedCoverage, IsUncertainExactlyWithinASquareOfTheOutline) {
  int n_uncertain = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Random random(1, 1, i);
    const ExactPolygon t = random_triangle(random);
    const glm::dvec2 s = random_sample(t, random);
    bool near_outline = false;
    for (std::size_t k = 0; k < 3; ++k) near_outline |= square_distance(t[k], t[(k + 1) % 3], s) <= Rational(kSnap_px);
    const Coverage coverage = exact_coverage(t, s).coverage;
    ASSERT_EQ(coverage == Coverage::uncertain, near_outline) << "case " << i;
    if (!near_outline) {
      ASSERT_EQ(coverage == Coverage::in, side(t, s) > 0) << "case " << i;
    }
    n_uncertain += near_outline;
  }
  EXPECT_GT(n_uncertain, 400);
}

TEST(PlacedCoverage, NoPlacementContradictsWhatIsCertain) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(2, 1, i);
    const ExactPolygon t = random_triangle(random);
    const glm::dvec2 s = random_sample(t, random);
    const Coverage coverage = exact_coverage(t, s).coverage;
    if (coverage == Coverage::uncertain) continue;
    for (int k = 0; k < 20; ++k) {
      ExactPolygon moved;
      for (const ExactVertex& v : t) moved.push_back(placed(v, random));
      ASSERT_EQ(side(moved, s), coverage == Coverage::in ? 1 : -1) << "case " << i;
    }
  }
}

/// Shifted by the offset to its nearest point, the outline runs through the sample: both answers are then a hair away.
TEST(PlacedCoverage, TheFilterGivesTheExactAnswer) {
  int n_filtered = 0;
  for (std::uint64_t i = 0; i < 8000; ++i) {
    Random random(3, 1, i);
    const ExactPolygon t = random_triangle(random);
    const glm::dvec2 s = random_sample(t, random);
    bool asked = false;
    const PlacedCoverage found = coverage(rounded(t), s, [&] {
      asked = true;
      return t;
    });
    const PlacedCoverage expected = exact_coverage(t, s);
    ASSERT_EQ(found.coverage, expected.coverage) << "case " << i;
    if (found.coverage == Coverage::uncertain) {
      ASSERT_EQ(found.doubt, expected.doubt) << "case " << i;
    }
    n_filtered += !asked;
  }
  EXPECT_GT(n_filtered, 7000);
}

ExactPolygon polygon(std::initializer_list<ExactVertex> vertices) { return vertices; }

TEST(PlacedCoverage, ASampleOnAnEdgeIsUncertain) {
  const ExactPolygon t = polygon({{0, 0, 1}, {4, 4, 1}, {0, 4, 1}});  // the diagonal runs through (1.5, 1.5)
  EXPECT_EQ(exact_coverage(t, {1.5, 1.5}).coverage, Coverage::uncertain);
  EXPECT_EQ(exact_coverage(t, {0.5, 2.5}).coverage, Coverage::in);
  EXPECT_EQ(exact_coverage(t, {2.5, 0.5}).coverage, Coverage::out);
}

TEST(PlacedCoverage, BeyondTheEndOfAnEdgeItsLineDoesNotMatter) {
  const ExactPolygon t = polygon({{0, 0, 1}, {4, 4, 1}, {0, 4, 1}});
  EXPECT_EQ(exact_coverage(t, {5.5, 5.5}).coverage, Coverage::out);  // on the diagonal's line
}

TEST(PlacedCoverage, NothingInsideASliverIsCertain) {
  // Half a sub-pixel high: every sample inside is within the snap of both long edges.
  const ExactPolygon t =
      polygon({{0, Rational(1, 2), 1}, {8, Rational(1, 2), 1}, {4, Rational(1, 2) + Rational(1, 512), 1}});
  EXPECT_EQ(exact_coverage(t, {3.5, 0.5}).coverage, Coverage::uncertain);
  EXPECT_EQ(exact_coverage(t, {3.5, 1.5}).coverage, Coverage::out);
}

TEST(PlacedCoverage, TheDoubtIsTheOutlinesWhereACutPassesToo) {
  // The sample lies on the corner of an outline and a cut.
  const ExactPolygon t = polygon({{1.5, 1.5, 1, 1, EdgeKind::outline},
                                  {4, 1.5, 1, 1, EdgeKind::near_or_far},
                                  {1.5, 4, 1, 1, EdgeKind::near_or_far}});
  EXPECT_EQ(exact_coverage(t, {1.5, 1.5}).doubt, EdgeKind::outline);
  EXPECT_EQ(exact_coverage(t, {1.5, 2.5}).doubt, EdgeKind::near_or_far);
}

}  // namespace
}  // namespace lode::experiments::truth
