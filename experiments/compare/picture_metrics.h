#pragma once
/// The metrics of two stored pictures by name, each computed once, when it is first asked for.

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "experiments/compare/stored_picture.h"
#include "experiments/metrics/error_map.h"

namespace lode::experiments {

class PictureMetrics {
 public:
  /// Of pictures of one kind and size, which it refers to. `threads`: 0 is one per processor.
  PictureMetrics(const StoredPicture& a, const StoredPicture& b, int threads);

  PictureMetrics(const PictureMetrics&) = delete;
  PictureMetrics& operator=(const PictureMetrics&) = delete;

  /// False where pictures of this kind have no such metric.
  [[nodiscard]] bool has(const std::string& name) const { return metrics_.contains(name); }

  /// Nothing where it is not defined for these pictures. Throws Error (bad_input) where !has(name).
  [[nodiscard]] std::optional<double> value(const std::string& name);

  /// Of flip and hdr-flip. Throws Error (bad_input) where there is none.
  [[nodiscard]] const ErrorMap& map(const std::string& name);

 private:
  using Value = std::function<std::optional<double>()>;
  using Map = std::function<std::optional<ErrorMap>()>;
  void add_color_metrics(int threads);
  void add_depth_metrics();
  void add_id_metrics();
  void add_map(const std::string& name, const Map& make);
  const std::optional<ErrorMap>& map_if_any(const std::string& name);

  const StoredPicture &a_, &b_;
  std::map<std::string, Value> metrics_;
  std::map<std::string, Map> make_map_;
  std::map<std::string, std::optional<double>> values_;
  std::map<std::string, std::optional<ErrorMap>> maps_;
};

}  // namespace lode::experiments
