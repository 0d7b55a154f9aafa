/// Small files of every format, damaged: read, or refused in one line. (damaged_files_stress.cpp does this to real
/// ones, and limits memory and time.)

#include <gtest/gtest.h>

#include "geometry/model_file.h"
#include "tests/geometry/damage.h"
#include "tests/geometry/small_models.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::geometry {
namespace {

/// The outcome with the k-th of the files replaced.
std::string read_damaged(const tests::TemporaryFolder& folder, const tests::SmallFiles& files, std::size_t k,
                         const std::string& bytes) {
  folder.write(files[k].first, bytes);
  return tests::outcome([&] { (void)read_model_file(folder.path(files.back().first)); });
}

TEST(DamagedFiles, WholeOnesAreRead) {
  for (const tests::SmallFiles& files : tests::small_models()) {
    const tests::TemporaryFolder folder;
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
    EXPECT_NO_THROW((void)read_model_file(folder.path(files.back().first))) << files.back().second.substr(0, 100);
  }
}

TEST(DamagedFiles, CutOffAnywhereOrChangedTheyAreReadOrRefusedInOneLine) {
  for (const tests::SmallFiles& files : tests::small_models()) {
    const tests::TemporaryFolder folder;
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
    for (std::size_t k = 0; k < files.size(); ++k) {
      const auto& [name, whole] = files[k];
      const std::size_t step = 1 + whole.size() / 150;
      for (std::size_t n = 0; n < whole.size(); n += step) {
        EXPECT_EQ(read_damaged(folder, files, k, whole.substr(0, n)), "") << name << " cut at " << n;
      }
      for (std::uint64_t seed = 0; seed < 150; ++seed) {
        EXPECT_EQ(read_damaged(folder, files, k, tests::with_changed_bytes(whole, seed)), "")
            << name << ", seed " << seed;
      }
      folder.write(name, whole);
    }
  }
}

}  // namespace
}  // namespace lode::geometry
