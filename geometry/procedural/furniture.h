#pragma once
/// Furniture of the sizes in Table 1 of Onozawa and Kitazawa, "Occlusion culling with a hierarchical convex
/// approximation of models": as many triangles and, after welding equal positions, as many vertices. What the paper's
/// own models look like is not known; these are furniture as it is, in metres, standing on y = 0 around the origin,
/// front towards +z. Each throws Error (bad_input) if its counts were not exact.

#include "geometry/procedural/model.h"

namespace lode::geometry {

/// 3948 triangles, 2080 vertices, 53 closed parts: a farmhouse table with turned legs and a slatted shelf.
[[nodiscard]] Model table();

/// 4617 triangles, 2390 vertices: 32 closed parts and an open sheet, the seat: a Windsor chair with a woven seat.
[[nodiscard]] Model chair();

/// 9280 triangles, 4652 vertices, 6 closed parts: base, back, two arms, two cushions.
[[nodiscard]] Model sofa(const Material& fabric = paint("slate fabric", 0.10f, 0.15f, 0.21f),
                         const Material& cushions = paint("sand fabric", 0.48f, 0.40f, 0.29f));

}  // namespace lode::geometry
