#include "experiments/run/results_folder.h"

#include <filesystem>

#include "experiments/error.h"
#include "experiments/whole_file.h"

namespace lode::experiments {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* what, const std::error_code& error) {
  throw Error(Status::bad_input, path + ": " + what + ": " + error.message());
}

/// What stands in the way must be what a run wrote.
void expect_older_results(const std::string& folder) {
  const auto refuse = [](const std::string& path) {
    throw Error(Status::bad_input, path + ": expected nothing, or results of an earlier run, which these replace: " +
                                       "remove it, or choose another --out");
  };
  const fs::file_status status = fs::symlink_status(folder);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) refuse(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "results.csv" && name != "times.csv" && name != "summary.json" && name != "images") {
      refuse(entry.path().string());
    }
  }
}

}  // namespace

ResultsFolder::ResultsFolder(const std::string& folder) : folder_(folder) {
  expect_older_results(folder);
  const fs::path path(folder);
  hidden_ = (path.parent_path() / ("." + path.filename().string() + ".unfinished")).string();
  std::error_code error;
  fs::remove_all(hidden_, error);
  if (error) fail(hidden_, "cannot be removed", error);
  fs::create_directories(images(), error);
  if (error) fail(images(), "cannot be made", error);
}

ResultsFolder::~ResultsFolder() {
  std::error_code ignored;
  fs::remove_all(hidden_, ignored);
}

void ResultsFolder::publish(const ExperimentResults& results, const std::string& summary_json) {
  write_whole_file(hidden_ + "/results.csv", csv_text(results.results));
  write_whole_file(hidden_ + "/times.csv", csv_text(results.times));
  write_whole_file(hidden_ + "/summary.json", summary_json);
  std::error_code error;
  fs::remove_all(folder_, error);
  if (error) fail(folder_, "cannot be removed", error);
  fs::rename(hidden_, folder_, error);
  if (error) fail(folder_, "cannot be made", error);
}

}  // namespace lode::experiments
