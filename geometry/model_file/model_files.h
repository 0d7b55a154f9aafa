#pragma once
/// The files that a model consists of: they are read through here, which keeps count of the memory they may take.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/image_file/read_picture.h"
#include "geometry/input_file.h"
#include "geometry/memory_budget.h"

namespace lode::geometry {

class ModelFiles {
 public:
  explicit ModelFiles(std::string model_path);

  [[nodiscard]] const std::string& model_path() const { return model_path_; }
  /// A path that stands in the file `from`: relative to its folder unless it is absolute.
  [[nodiscard]] static std::string resolved(const std::string& from, std::string_view path);

  /// The file's bytes. Errors begin with `referrer` (the place that names the file) unless that is empty.
  [[nodiscard]] FileBytes read(const std::string& path, const std::string& referrer);
  [[nodiscard]] Picture read_picture(const std::string& path, const std::string& referrer);

  /// All that have been read.
  [[nodiscard]] std::vector<std::string> paths() const { return {seen_.begin(), seen_.end()}; }

  MemoryBudget budget;

 private:
  std::string model_path_;
  std::set<std::string> seen_;  ///< a file that is read twice allows for no more memory than once
};

}  // namespace lode::geometry
