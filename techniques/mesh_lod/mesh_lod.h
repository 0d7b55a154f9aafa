#pragma once
/// Discrete levels of detail (README.md): Clark, "Hierarchical geometric models for visible surface algorithms", CACM
/// 1976. Each object in view is drawn from the coarsest of its meshes' levels whose error, as a length on the screen at
/// the object's nearest point, is below a limit. Approximate: the error is the simplifier's estimate of how far the
/// surface has moved, no bound, and says nothing of normals and texture coordinates.

#include <cstdint>
#include <memory>
#include <vector>

#include "techniques/mesh_lod/mesh_levels.h"
#include "techniques/stage.h"

namespace lode::techniques {

class MeshLod {
 public:
  struct Params {
    MeshShares shares = {0.5, 0.2, 0.05};  ///< of a mesh's triangles that levels 1, 2, 3 keep; each 0…1
    double pixels = 1.0;                   ///< a level's error on the screen is below this; 0: level 0 only
    int level = 0;                         ///< 1…3: that level everywhere; 0: by the error
  };

  MeshLod() : MeshLod(Params{}) {}
  explicit MeshLod(const Params& params) : params_(params) {}

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  /// Makes the levels. Throws raster::Error (out_of_memory).
  void prepare(Stage& stage);
  void cut() {}
  /// Counters: objects_in_view; level0 … level3 (objects drawn at each; at level 0, too, what has no simpler mesh at
  /// the level chosen); primitives_drawn, of all levels; extra_bytes, of all levels' vertices and indices.
  Counters draw(const View& view, Stage& stage);

  /// The level of an object whose levels have these errors (world units), with so many pixels a world unit.
  [[nodiscard]] int level_for(const std::array<double, kMeshLevels>& errors, double pixels_per_unit) const;

 private:
  Params params_;
  std::shared_ptr<const MeshLevels> levels_;
  std::vector<std::array<double, kMeshLevels>> errors_;  ///< [objects] world units, the largest of its instances
  std::vector<const AlternateMesh*> meshes_;             ///< of one object
};

/// Pixels that a world unit covers at the point of a box that is nearest to the eye, in the middle of the picture (at
/// its edge perspective shows lengths larger); infinite with the eye in the box.
[[nodiscard]] double pixels_per_unit(const View& view, const geometry::Bounds& box);

}  // namespace lode::techniques
