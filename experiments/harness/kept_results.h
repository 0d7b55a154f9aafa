#pragma once
/// What took long to find out, kept in a folder from run to run: truth, and the finished cases of a run that was
/// stopped. An entry belongs to a key, a text that names everything that the entry depends on. It appears whole or not
/// at all; one that is damaged, or belongs to another key, is as if it were not there.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace lode::experiments {

class KeptResults {
 public:
  /// The folder is made when the first entry is kept. An empty name: nothing is kept.
  explicit KeptResults(std::string folder) : folder_(std::move(folder)) {}

  [[nodiscard]] std::optional<std::string> find(std::string_view key) const;
  /// Throws Error (bad_input, machine_failed) if it cannot be written.
  void keep(std::string_view key, std::string_view value) const;
  /// What is kept, or what `make` returns, which is then kept.
  [[nodiscard]] std::string get(std::string_view key, const std::function<std::string()>& make) const;

  /// Where an entry is, or would be.
  [[nodiscard]] std::string path_of(std::string_view key) const;

 private:
  std::string folder_;
};

}  // namespace lode::experiments
