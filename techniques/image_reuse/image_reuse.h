#pragma once
/// Pictures of far objects, kept from frame to frame (README.md): Ohno, Matsui, Kawaguchi and Harada, "Fast 3-D
/// rendering by reusing 2-D images". An object is drawn as a plate with the picture that it last had, until the
/// direction in which it is seen has turned by more than a threshold.
///
/// The paper copies what is in the frame buffer, with whatever is in front of the object and behind it, and centres the
/// plate on the object's box. `corrected`, the default, captures the object by itself, wherever it is in the view, and
/// keeps the place of its rectangle; `literal` is for seeing what that mends.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "techniques/far_objects.h"
#include "techniques/image_reuse/viewing_angle.h"
#include "techniques/picture_store.h"
#include "techniques/plate_placement.h"
#include "techniques/stage.h"

namespace lode::techniques {

class ImageReuse {
 public:
  struct Params {
    /// A picture is used while its object's viewing angle has turned by less. 0…180°; 0: never, 180: for ever. The
    /// paper recommends 2 to 3.
    double threshold_deg = 2.0;
    AngleRule angle = AngleRule::full;
    PlatePlacement placement = PlatePlacement::corrected;
    FarRule far{};  ///< the paper: "a fixed distance"
    /// A picture is taken anew when its pixels have grown by this factor. Not in the paper, which lets them grow. 0:
    /// off.
    double magnification = 0.0;
    int most_captures = 0;         ///< in one frame, those that turned most first; what has no picture is drawn. 0: any
    std::uint64_t most_bytes = 0;  ///< of pictures that are kept, those shown last the longest. 0: any
  };

  ImageReuse() : ImageReuse(Params{}) {}
  explicit ImageReuse(const Params& params);

  [[nodiscard]] Promise promise() const { return Promise::approximate; }
  void prepare(Stage& stage);
  void cut() { forget_ = true; }
  /// Counters: objects_in_view, near (drawn since they are), reused, captured, postponed (captures over the limit of a
  /// frame), unfit (drawn since no plate of them would be seen, or fit), evicted, picture_bytes.
  /// Throws raster::Error (bad_input if the world's colours are raw; out_of_memory).
  Counters draw(const View& view, Stage& stage);

 private:
  /// What is known of an object's picture.
  struct Plate {
    glm::dvec3 direction{0.0};
    PlateSides sides;
  };
  /// An object that wants a new picture.
  struct Wanted {
    ObjectId object;
    double turned;  ///< angle_measure; larger than any if it has none
    raster::Rect window_px;
  };
  struct Work {
    std::uint64_t near = 0, reused = 0, captured = 0, postponed = 0, unfit = 0;
  };

  void look_at(const View& view, ObjectId id, Stage& stage);
  void capture(const View& view, const Wanted& wanted, Stage& stage);
  void show(const View& view, ObjectId id, Stage& stage);

  Params params_;
  double threshold_;  ///< as angle_measure
  PictureStore pictures_;
  std::vector<Plate> plates_;  ///< [objects] of those that have a picture
  std::vector<Wanted> wanted_;
  std::vector<ObjectId> in_view_;
  bool forget_ = false;
  Work work_;
};

}  // namespace lode::techniques
