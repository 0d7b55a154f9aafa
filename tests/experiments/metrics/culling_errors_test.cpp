/// What a culling method got wrong, on pictures small enough to count by hand.

#include "experiments/metrics/culling_errors.h"

#include <gtest/gtest.h>

#include <string>

#include "experiments/metrics/id_difference.h"
#include "experiments/metrics/largest_region.h"

namespace lode::experiments {
namespace {

/// 'A' is draw 0, 'B' draw 1, …; '.' nothing. Primitive 0, or 1 for small letters.
std::vector<raster::Ids> ids_of(const std::string& picture) {
  std::vector<raster::Ids> ids;
  for (const char c : picture) {
    if (c == '.') ids.push_back({raster::kNoId, raster::kNoId});
    if (c >= 'A' && c <= 'Z') ids.push_back({std::uint32_t(c - 'A'), 0});
    if (c >= 'a' && c <= 'z') ids.push_back({std::uint32_t(c - 'a'), 1});
  }
  return ids;
}

std::vector<std::uint8_t> mask_of(const std::string& picture) {
  std::vector<std::uint8_t> mask;
  for (const char c : picture) mask.push_back(c == '#' ? 255 : 0);
  return mask;
}

/// Five draws of four objects: A and B are object 0; C, D and E are 1, 2 and 3.
constexpr std::uint32_t kObjectOfDraw[] = {0, 0, 1, 2, 3};

CullingErrors errors_of(glm::ivec2 size_px, const std::string& reference, const std::vector<std::uint8_t>& drawn) {
  const std::vector<raster::Ids> ids = ids_of(reference);
  return culling_errors({size_px, ids, kObjectOfDraw, drawn});
}

constexpr const char* kReference =
    "A.BBC"
    "..CCC"
    "DD..C"
    ".D.CC";

TEST(CullingErrors, OfACullerThatIsRightAreNone) {
  // Object 3 owns nothing.
  const CullingErrors e = errors_of({5, 4}, kReference, {1, 1, 1, 0});
  EXPECT_EQ(e.n_objects, 4u);
  EXPECT_EQ(e.visible, 3u);
  EXPECT_EQ(e.culled, 1u);
  EXPECT_EQ(e.falsely_culled_objects, 0u);
  EXPECT_EQ(e.falsely_culled_pixels, 0u);
  EXPECT_EQ(e.largest_missing_region, 0u);
  EXPECT_EQ(e.missed_culls, 0u);
  EXPECT_EQ(e.culled_share(), 1.0);
  EXPECT_EQ(e.owned_pixels, 13u);
  EXPECT_EQ(e.falsely_culled_share(), 0.0);
}

TEST(CullingErrors, AnObjectThatOwnsAPixelIsFalselyCulled) {
  // Objects 1 and 2 own 7 + 3 pixels. C's are all connected; D's touch none of them. Object 3 is a missed cull.
  const CullingErrors e = errors_of({5, 4}, kReference, {1, 0, 0, 1});
  EXPECT_EQ(e.falsely_culled_objects, 2u);
  EXPECT_EQ(e.falsely_culled_pixels, 10u);
  EXPECT_EQ(e.largest_missing_region, 7u);
  EXPECT_EQ(e.falsely_culled_share(), 10.0 / 13.0);
  EXPECT_EQ(e.missed_culls, 1u);
  EXPECT_EQ(e.culled_share(), 0.0);
}

TEST(CullingErrors, TheDrawsOfAnObjectAreOne) {
  // A and B own 1 + 2 pixels, apart.
  const CullingErrors e = errors_of({5, 4}, kReference, {0, 1, 1, 1});
  EXPECT_EQ(e.falsely_culled_objects, 1u);
  EXPECT_EQ(e.falsely_culled_pixels, 3u);
  EXPECT_EQ(e.largest_missing_region, 2u);
}

TEST(CullingErrors, MissingObjectsThatTouchAreOneRegion) {
  EXPECT_EQ(errors_of({3, 1}, "CDA", {1, 0, 0, 0}).largest_missing_region, 2u);
}

TEST(CullingErrors, WhereNothingCouldBeCulledThereIsNoShare) {
  EXPECT_FALSE(errors_of({4, 1}, "ACDE", {1, 1, 1, 1}).culled_share().has_value());
  EXPECT_EQ(errors_of({0, 0}, "", {0, 0, 1, 1}).culled_share(), 0.5);
}

TEST(CullingErrors, OwnedPixelsAreCountedByObject) {
  EXPECT_EQ(owned_pixels(ids_of(kReference), kObjectOfDraw, 4), (std::vector<std::uint64_t>{3, 7, 3, 0}));
}

TEST(CullingErrors, WhatDoesNotFitIsTheCallersMistake) {
  EXPECT_THROW((void)errors_of({2, 1}, "A", {1, 1, 1, 1}), std::logic_error);
  EXPECT_THROW((void)errors_of({1, 1}, "F", {1, 1, 1, 1}), std::logic_error);  // no such draw
  EXPECT_THROW((void)errors_of({1, 1}, "E", {1, 1, 1}), std::logic_error);     // no such object
}

TEST(IdDifference, CountsIdsDrawsAndWhatIsMissingOrAdded) {
  // Column by column: equal, another primitive, another draw, missing, added, nothing.
  const IdDifference d = id_difference(ids_of("AABB.."), ids_of("AaC.A."));
  EXPECT_EQ(d.wrong_ids, 4u);
  EXPECT_EQ(d.wrong_draws, 3u);
  EXPECT_EQ(d.missing, 1u);
  EXPECT_EQ(d.added, 1u);
  EXPECT_THROW((void)id_difference(ids_of("A"), ids_of("AA")), std::logic_error);
}

TEST(LargestRegion, DiagonalsDoNotConnectAndRowsDoNotWrap) {
  EXPECT_EQ(largest_region({4, 3}, mask_of("#..#"
                                           "##.#"
                                           "..##")),
            4u);
  EXPECT_EQ(largest_region({3, 2}, mask_of("..#"
                                           "#..")),
            1u);
  EXPECT_EQ(largest_region({3, 3}, mask_of("###"
                                           "#.#"
                                           "###")),
            8u);
  EXPECT_EQ(largest_region({2, 2}, mask_of("....")), 0u);
  EXPECT_EQ(largest_region({0, 7}, {}), 0u);
  EXPECT_THROW((void)largest_region({2, 2}, mask_of("...")), std::logic_error);
}

TEST(LargestRegion, ASpiralIsOne) {
  EXPECT_EQ(largest_region({5, 5}, mask_of("#####"
                                           "....#"
                                           "###.#"
                                           "#...#"
                                           "#####")),
            17u);
}

}  // namespace
}  // namespace lode::experiments
