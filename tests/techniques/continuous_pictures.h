#pragma once
/// Whether a culler that promises every point of the screen loses one: its choice for a view, drawn with 4 × 4 samples
/// a pixel.

#include <string>

#include "tests/techniques/technique_pictures.h"

namespace lode::tests {

/// Draws the objects that another one drew.
struct TheSame {
  std::vector<bool> drawn;
  [[nodiscard]] techniques::Promise promise() const { return techniques::Promise::approximate; }
  void prepare(techniques::Stage&) {}
  void cut() {}
  techniques::Counters draw(const techniques::View&, techniques::Stage& stage) {
    for (techniques::ObjectId id = 0; id < drawn.size(); ++id) {
      if (drawn[id]) stage.object(id);
    }
    return {};
  }
};

/// Empty if the objects drawn in the picture of the view give the whole scene's picture at 4 × 4 samples a pixel.
inline std::string difference_at_4x4(const techniques::World& world, const TechniquePicture& picture,
                                     techniques::View view) {
  view.size_px *= 4;
  return difference_from_plain(Showing(world, TheSame{picture.drawn}).picture(view),
                               Showing(world, techniques::Plain{}).picture(view));
}

}  // namespace lode::tests
