#pragma once
/// What `lodestone truth --check` says: JSON for programs, and for pixels that are not explained how to look at them.

#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/error.h"
#include "experiments/truth/check_view.h"

namespace lode::experiments::truth {

struct CheckedView {
  std::string camera;   ///< of a tour: the stop's name; else empty
  std::string options;  ///< the camera's words on the command line, as tour.h's command_line
  ViewCheck check;
};

struct CheckReport {
  std::string scene;  ///< as named on the command line
  glm::ivec2 size_px{0, 0};
  std::vector<CheckedView> views;  ///< at least one

  [[nodiscard]] std::uint64_t unexplained() const;
};

/// One JSON object and a line break: the sums over all views, and, where there is a tour, each view under "cameras".
[[nodiscard]] std::string check_json(const CheckReport& report);

/// done, or check_failed if a pixel is unexplained; then `err` gets two lines for each, up to ten pixels in all: ids,
/// depth, why, and the command that shows it.
[[nodiscard]] Status conclude(const CheckReport& report, std::ostream& err);

}  // namespace lode::experiments::truth
