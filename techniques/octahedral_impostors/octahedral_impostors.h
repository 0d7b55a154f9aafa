#pragma once
/// Hemi-octahedral impostors (README.md): pictures of every object from a grid of directions over the upper hemisphere,
/// taken once; in each frame a plate that faces the view and mixes the three pictures around the direction to the eye.
/// Brucks, "Octahedral impostors", 2018, on the mapping of Cigolle et al., "A survey of efficient representations for
/// independent unit vectors", 2014.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "techniques/far_objects.h"
#include "techniques/stage.h"

namespace lode::techniques {

/// three: those of the grid's triangle, by their barycentric weights; nearest: the one with the greatest weight.
enum class ViewBlend : std::uint8_t { three, nearest };

class OctahedralImpostors {
 public:
  struct Params {
    int grid = 6;     ///< directions along a side of the grid, 2…32
    int texels = 73;  ///< of a picture's longer side, 1…1024; 6² · 73² are as many as twelve pictures of 128² have
    ViewBlend blend = ViewBlend::three;
    bool parallax = true;  ///< pictures are read at the height that their depth has: one step
    FarRule far{};
    std::uint64_t most_bytes = std::uint64_t{4} << 30;  ///< of all pictures; whose do not fit is drawn. 0: any
  };

  OctahedralImpostors() : OctahedralImpostors(Params{}) {}
  explicit OctahedralImpostors(const Params& params) : params_(params) {}

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  /// Takes the pictures. Throws raster::Error (bad_input if the world's colours are raw; out_of_memory).
  void prepare(Stage& stage);
  void cut() {}
  /// Counters: objects_in_view, near (drawn since they are), unfit (drawn since they have no size or no room for
  /// pictures, reach the near plane, or have their middle beyond the far one), shown, blended (pictures that plates
  /// were mixed from), picture_bytes.
  Counters draw(const View& view, Stage& stage);

 private:
  [[nodiscard]] bool take(ObjectId id, Stage& stage);
  void show(const View& view, ObjectId id, Stage& stage);

  Params params_;
  std::vector<std::vector<PictureId>> pictures_;  ///< [objects][grid²], row by row; none of those without size or room
  std::uint64_t picture_bytes_ = 0, blended_ = 0;
};

}  // namespace lode::techniques
