#pragma once
/// Pictures of far objects, kept from frame to frame as image_reuse keeps them, with what has come since (README.md):
/// they stay where they were taken, can have relief, and are taken anew by the error that is predicted for them, the
/// worst first, so many in a frame.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "techniques/far_objects.h"
#include "techniques/picture_store.h"
#include "techniques/plate_placement.h"
#include "techniques/stage.h"

namespace lode::techniques {

/// What is predicted of a picture that still fades, in units of Params::error_px, at most. More would be seen.
inline constexpr double kMostFadingErrors = 3.0;

class PredictedReuse {
 public:
  struct Params {
    double error_px = 1.0;  ///< a picture is taken anew when more is predicted of it; 0: in every frame
    int most_captures = 4;  ///< in one frame, the worst first; 0: any. The others are late.
    int cell_px = 8;        ///< side of a relief's cells, px of the picture; 0: a plate
    /// In which an old picture goes pixel by pixel as the new one comes, if it is not wrong by more than
    /// kMostFadingErrors times error_px; 0: at once.
    int fade_frames = 0;
    FarRule far{};
    std::uint64_t most_bytes = 0;  ///< of pictures that are kept, those shown last the longest. 0: any
  };

  PredictedReuse() : PredictedReuse(Params{}) {}
  explicit PredictedReuse(const Params& params) : params_(params), pictures_(params.most_bytes) {}

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  void prepare(Stage& stage);
  void cut() { forget_ = true; }
  /// Counters: objects_in_view, near (drawn since they are), reused, captured, late (shown with an error above the
  /// limit), postponed (drawn since too many are captured in this frame), unfit (drawn since no picture of them would
  /// be seen, or fit), faded (shown with the picture that they had before), evicted, picture_bytes, relief_triangles.
  /// Throws raster::Error (bad_input if the world's colours are raw; out_of_memory).
  Counters draw(const View& view, Stage& stage);

 private:
  /// What is known of an object's picture.
  struct Pose {
    glm::dvec3 eye{0.0};  ///< of the capture
    double pixel = 0.0;   ///< width of one in the plane through the centre, world units
    std::array<glm::dvec3, 4> corners_world{};
    std::shared_ptr<const PictureRelief> relief{};  ///< null: a plate
  };
  /// The picture that an object had before, in the place objects + id, as long as it is still seen.
  struct Fading {
    Pose pose{};
    int step = 0;                 ///< frames since the new one came
    std::uint64_t last_seen = 0;  ///< frame
  };
  /// An object that wants a new picture.
  struct Wanted {
    ObjectId object;
    double error_px;
    raster::Rect window_px;
  };
  struct Work {
    std::uint64_t near = 0, reused = 0, captured = 0, late = 0, postponed = 0, unfit = 0, faded = 0,
                  relief_triangles = 0;
  };

  void look_at(const View& view, ObjectId id, Stage& stage);
  void capture(const View& view, const Wanted& wanted, Stage& stage);
  /// Whether the object's old picture, if it has one, may still be seen.
  [[nodiscard]] bool may_fade(const View& view, ObjectId id, Stage& stage) const;
  /// Puts the object's picture where old ones are, or lets it go.
  void retire(const View& view, ObjectId id, Stage& stage);
  void show(const View& view, ObjectId id, Stage& stage);
  void show(ObjectId id, std::size_t place, const Pose& pose, std::uint16_t pixels, Stage& stage);
  [[nodiscard]] std::size_t old_place(ObjectId id) const { return poses_.size() + id; }

  Params params_;
  PictureStore pictures_;
  std::vector<Pose> poses_;     ///< [objects] of those that have a picture
  std::vector<Fading> fading_;  ///< [objects] of those that have an old one, too
  std::vector<Wanted> wanted_;
  std::uint64_t frame_ = 0;
  bool forget_ = false;
  Work work_;
};

/// How wrong a picture is predicted to be, px: a point as far from the plane of the picture as the box reaches has
/// moved by z·sin Δ·f/D (Δ: by how much the eye has turned around the object), and a pixel that has grown by the factor
/// s is up to (s − 1)/2 beside its place.
///   eye     of the capture
///   pixel   width of one of its pixels in the plane through the box's centre, world units
[[nodiscard]] double predicted_error_px(const View& view, const geometry::Bounds& box, const glm::dvec3& eye,
                                        double pixel);

}  // namespace lode::techniques
