#pragma once
/// Streets of houses, for techniques that show far objects by pictures: the subject of Ohno, Matsui, Kawaguchi and
/// Harada, "Fast 3-D rendering by reusing 2-D images", who do not say what theirs was. Metres, y up.

#include <cstddef>
#include <cstdint>

#include "geometry/scene.h"

namespace lode::geometry {

struct HousesParams {
  int n_rows = 2;             ///< along x, two to a street
  int n_in_row = 12;          ///< 16 m from one to the next
  std::size_t n_each = 4000;  ///< triangles of a house: even, kFewestHouseTriangles or more
  std::uint64_t seed = 1;     ///< which of six kinds of house stands where
};

/// Objects: the houses, one a model, and the ground. Paths, 2000 frames each, that look at the middle of the houses
/// from an eye height of 1.7 m: "approach", along the middle street from 40 m before the first houses to 200 m and
/// back; "sideways", across 120 m, 58 m behind the last row; of two rows, 80 m
/// from the middle. Free space: the street.
/// Throws Error (bad_input).
[[nodiscard]] Scene houses(const HousesParams& params);

}  // namespace lode::geometry
