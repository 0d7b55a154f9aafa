#pragma once
/// The folder that an experiment's results go to. They appear whole or not at all: everything is written into a hidden
/// folder beside it, which takes its name when all is done.

#include <string>

#include "experiments/experiment.h"

namespace lode::experiments {

/// Keeps other processes out of a folder for as long as it and this process live, however that ends.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Throws Error (bad_input) if another lock holds the folder.
  void take(const std::string& folder);

 private:
  int descriptor_ = -1;
};

class ResultsFolder {
 public:
  /// `folder` is DIR/EXPERIMENT. Makes the hidden one, empty but for images/. Throws Error (bad_input, machine_failed),
  /// also if what is there is not what `publish` writes, and if another one of this folder is alive.
  explicit ResultsFolder(const std::string& folder);
  /// What was not published is gone.
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  [[nodiscard]] std::string images() const { return hidden_ + "/images"; }

  /// Writes results.csv, times.csv and summary.json, and puts the folder in its place. What was there before is gone.
  void publish(const ExperimentResults& results, const std::string& summary_json);

 private:
  std::string folder_, hidden_;
  FolderLock lock_;  ///< Of the hidden one
  bool published_ = false;
};

}  // namespace lode::experiments
