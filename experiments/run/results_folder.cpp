#include "experiments/run/results_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
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

/// A folder, or nothing yet in one.
void expect_room_for_a_folder(const fs::path& path) {
  std::error_code error;
  fs::path there = path;
  while (there.has_relative_path() && !fs::exists(fs::status(there, error))) there = there.parent_path();
  if (!there.empty() && !fs::is_directory(there, error)) {
    throw Error(Status::bad_input, there.string() + ": expected a folder, or nothing yet: choose another --out");
  }
}

}  // namespace

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FolderLock::take(const std::string& folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) fail(folder, "cannot be opened", {errno, std::generic_category()});
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // a file system may have no locks
  throw Error(Status::bad_input, folder + ": another run is writing it: wait for that one, or choose another --out");
}

ResultsFolder::ResultsFolder(const std::string& folder) : folder_(folder) {
  expect_older_results(folder);
  const fs::path path(folder);
  expect_room_for_a_folder(path.parent_path());
  hidden_ = (path.parent_path() / ("." + path.filename().string() + ".unfinished")).string();
  std::error_code error;
  fs::create_directories(hidden_, error);
  if (error) fail(hidden_, "cannot be made", error);
  lock_.take(hidden_);
  for (const auto& entry : fs::directory_iterator(hidden_)) {
    fs::remove_all(entry, error);
    if (error) fail(entry.path().string(), "cannot be removed", error);
  }
  fs::create_directory(images(), error);
  if (error) fail(images(), "cannot be made", error);
}

ResultsFolder::~ResultsFolder() {
  std::error_code ignored;
  if (!published_) fs::remove_all(hidden_, ignored);
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
  published_ = true;
}

}  // namespace lode::experiments
