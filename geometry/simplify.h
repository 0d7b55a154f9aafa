#pragma once
/// The same surface of fewer triangles: the one door to meshoptimizer, whose simplifier collapses edges in the order of
/// their quadric errors (Garland and Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997).
///
/// Edges are collapsed over welded positions, so that creases and texture seams, where a position has several vertices,
/// do not stop it. A corner of the result then takes, of the vertices at its position, the one whose normal is nearest
/// to the triangle's; where several are, those whose texture coordinates span least. Every vertex of the result is one
/// of the input's, with all its attributes.

#include "geometry/mesh.h"

namespace lode::geometry {

struct SimplifiedMesh {
  Mesh mesh;           ///< every vertex is used
  double error = 0.0;  ///< as the library reports it: about how far the surface has moved, object units; no bound
};

/// The mesh with about `share` of its triangles.
///   share     of the triangles to keep, 0…1; a NaN counts as 1, less than 0 as 0
///   returns   at most a few triangles fewer than asked for, never none; more where the library finds no edge that may
///             go: it keeps the outline of open borders in shape, and what is not manifold as it is
///   as it is  with error 0, comes back: a share of 1; a mesh of lines or points; an empty one; one with an index
///   beyond
///             its positions, an attribute of another length, or a position in use that is not finite; one whose
///             triangles all lie in one point or of which nothing would be left
///   degenerate triangles, with two corners at one position, are dropped before (they count in `share`)
///   cost      O(n log n) for n triangles
/// The same on any number of threads. The library computes in float and decides by comparing, so that a build of it for
/// another kind of processor, or another version, may choose other edges.
[[nodiscard]] SimplifiedMesh simplify(const Mesh& mesh, double share);

}  // namespace lode::geometry
