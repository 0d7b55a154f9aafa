#pragma once
/// Static impostors (README.md): twelve pictures of every object, taken once from directions 30° apart around the
/// vertical, and in each frame an upright plate with the one whose direction is nearest to that of the eye. What image
/// caches are measured against: nothing is captured while frames are drawn, and nothing gets better where one looks.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "techniques/far_objects.h"
#include "techniques/stage.h"

namespace lode::techniques {

inline constexpr int kTwelve = 12;

/// The unit vector that view k = 0…11 is taken from: k·30° about the vertical from +z towards +x, and so far up.
///   elevation_deg   0…60
[[nodiscard]] glm::dvec3 twelve_views_direction(int k, double elevation_deg);

/// The view whose direction, seen from above, is nearest to that of a vector; the first of those that are equally near,
/// also of a vector that is vertical.
[[nodiscard]] int nearest_of_twelve(const glm::dvec3& towards_eye);

class TwelveViews {
 public:
  struct Params {
    double elevation_deg = 10.0;  ///< from which the pictures look down, 0…60
    int texels = 128;             ///< of a picture's longer side, 1…1024
    FarRule far{};
    std::uint64_t most_bytes = std::uint64_t{4} << 30;  ///< of all pictures; whose do not fit is drawn. 0: any
  };

  TwelveViews() : TwelveViews(Params{}) {}
  explicit TwelveViews(const Params& params) : params_(params) {}

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  /// Takes the pictures. Throws raster::Error (bad_input if the world's colours are raw; out_of_memory).
  void prepare(Stage& stage);
  void cut() {}
  /// Counters: objects_in_view, near (drawn since they are), unfit (drawn since they have no size or no room for
  /// pictures, or reach the near plane), shown, picture_bytes.
  Counters draw(const View& view, Stage& stage);

 private:
  /// An upright plate around the centre of its object's box.
  struct Plate {
    PictureId picture = 0;
    std::array<glm::dvec3, 4> corners;  ///< from the centre, as Stage::plate takes them
  };
  struct Views {
    std::array<Plate, kTwelve> plates;
    double reach = 0.0;  ///< of their farthest corner, from the centre
  };

  [[nodiscard]] std::optional<Views> take(ObjectId id, Stage& stage);

  Params params_;
  std::vector<std::optional<Views>> views_;  ///< [objects] nothing of those without size or room
  std::uint64_t picture_bytes_ = 0;
};

}  // namespace lode::techniques
