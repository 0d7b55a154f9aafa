// Depth (C5) and attributes (C7) at full counts: 10^7 samples, 10^9 in a long run.
#include "rational_checks.h"
#include "stress_count.h"

namespace lode::raster::test {
namespace {

void expect_pictures(const char* what, const Family& family, std::uint64_t ci) {
  const Measured m = check_pictures(family, stress_count(what, ci, 100 * ci), 2);
  print(what, m);
  expect_contract(m);
}

TEST(DepthAndAttributesStress, OfTrianglesInPerspectiveAreWithinTheirBounds) {
  expect_pictures("triangles, w ratio to 10^6",
                  {.topology = Topology::triangles, .perspective = true, .size_px = {256, 256}}, 5'000'000);
}
TEST(DepthAndAttributesStress, OfTrianglesAcrossTheGuardBandAreWithinTheirBounds) {
  expect_pictures("triangles in window space",
                  {.topology = Topology::triangles, .perspective = false, .size_px = {256, 256}}, 4'000'000);
}
TEST(DepthAndAttributesStress, OfLinesInPerspectiveAreWithinTheirBounds) {
  expect_pictures("lines, w ratio to 10^6",
                  {.topology = Topology::lines, .perspective = true, .size_px = {256, 256}, .primitives = 200},
                  500'000);
}
TEST(DepthAndAttributesStress, OfLinesAcrossTheGuardBandAreWithinTheirBounds) {
  expect_pictures("lines in window space",
                  {.topology = Topology::lines, .perspective = false, .size_px = {256, 256}, .primitives = 200},
                  500'000);
}

TEST(AttributesStress, AreSumsOfCorrectlyRoundedWeightsInCanonicalOrder) {
  const RationalMeasured m = check_any_numbers(stress_count("samples in rationals", 100'000, 10'000'000), 2);
  print("triangles and lines of any finite numbers", m);
  expect_contract(m);
}

TEST(TextureCoordinatesStress, AndTheirDerivativesFollowTheExactPlane) {
  const FootprintMeasured m = check_footprints(stress_count("footprints in rationals", 100'000, 10'000'000), 2);
  print(m);
  expect_contract(m);
}

TEST(ClippedTrianglesStress, InterpolateTheAttributesOfTheirOwnVertices) {
  const ClippedMeasured m =
      check_clipped(stress_count("samples of clipped triangles in rationals", 100'000, 10'000'000), 2);
  print(m);
  expect_contract(m);
}

}  // namespace
}  // namespace lode::raster::test
