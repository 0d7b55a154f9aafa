#pragma once
/// A folder of model files to build scenes from: each is read once, when it is first placed, and normalised by its
/// bounds. Scenes of real models are assembled so.

#include <map>
#include <string>
#include <utility>

#include "geometry/procedural/model.h"

namespace lode::geometry {

class Kit {
 public:
  /// `units`: metres to one unit of the kit. The scene is borrowed.
  Kit(ModelScene& scene, std::string folder, double units) : scene_(scene), folder_(std::move(folder)), units_(units) {}

  /// Models are read without the parts whose node's name ends so: the leaves of doors, say.
  void leave_out(std::string ending) { left_out_ = std::move(ending); }

  /// The model of a file of the folder. Throws Error (bad_input; see model_file.h).
  std::size_t model(const std::string& file);
  /// Its bounds in metres.
  [[nodiscard]] Bounds bounds(const std::string& file);

  /// The file's own origin at `at`, in the kit's unit.
  void place(const std::string& file, const glm::dmat4& at);
  /// Standing at `at`: the middle of its box's floor there.
  void stand(const std::string& file, const glm::dmat4& at) { stand_scaled(file, at, units_); }
  /// The same, as high as said.
  void stand_high(const std::string& file, const glm::dmat4& at, double height_m);

 private:
  void stand_scaled(const std::string& file, const glm::dmat4& at, double scale);

  ModelScene& scene_;
  std::string folder_;
  double units_;
  std::string left_out_;  ///< nothing, if empty
  std::map<std::string, std::size_t> models_;
};

}  // namespace lode::geometry
