/// Every file of the folder that LODESTONE_ASSETS names, cut off at 50 places; and a thousand times some bytes changed,
/// for each format. Whatever comes of it, it is a scene or a picture, or one line; never a crash, never more than ten
/// seconds, never more memory than eight times the files and one GiB.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/image_file/read_picture.h"
#include "geometry/model_file.h"
#include "tests/geometry/damage.h"
#include "tests/geometry/guarded_child.h"
#include "tests/geometry/small_models.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::geometry {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCuts = 50, kChanges = 1000;
constexpr unsigned kSeconds = 10;

std::string bytes_of(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

/// A file that is damaged, and the one that is read then: itself, or the model that names it.
struct Subject {
  fs::path damaged, read;
};

/// All files under a folder that can be read, in the order of their paths, by their endings.
std::map<std::string, std::vector<Subject>> subjects(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::map<std::string, std::vector<Subject>> by_ending;
  for (const fs::path& path : paths) {
    const std::string ending = ending_of(path);
    const fs::path model = fs::path(path).replace_extension(ending == ".mtl" ? ".obj" : ".gltf");
    const bool is_picture = ending == ".png" || ending == ".jpg" || ending == ".jpeg";
    if (is_picture || is_model_file(path.string())) {
      by_ending[ending == ".jpeg" ? ".jpg" : ending].push_back({path, path});
    } else if ((ending == ".mtl" || ending == ".bin") && fs::exists(model)) {
      by_ending[ending].push_back({path, model});
    }
  }
  return by_ending;
}

/// A copy of a file's folder, all of it links but the file itself.
class DamagedCopy {
 public:
  explicit DamagedCopy(const Subject& subject) : subject_(subject) {
    n_bytes_ = 0;
    for (const auto& entry : fs::directory_iterator(subject.damaged.parent_path())) {
      if (entry.is_regular_file() && entry.path().stem() == subject.damaged.stem()) n_bytes_ += entry.file_size();
      if (entry.path() == subject.damaged) continue;
      fs::create_symlink(fs::absolute(entry.path()), folder_.path() / entry.path().filename());
    }
  }

  std::string read(const std::string& bytes) const {
    std::ofstream(folder_.path() / subject_.damaged.filename(), std::ios::binary) << bytes;
    const std::string path = (folder_.path() / subject_.read.filename()).string();
    return tests::outcome([&] {
      if (is_model_file(path)) {
        (void)read_model_file(path);
      } else {
        (void)read_picture(path);
      }
    });
  }

  /// Eight times the files that belong together, and one GiB.
  [[nodiscard]] std::size_t max_bytes() const { return 8 * n_bytes_ + (std::size_t(1) << 30); }

 private:
  struct Folder : tests::TemporaryFolder {
    [[nodiscard]] fs::path path() const { return tests::TemporaryFolder::path(); }
  } folder_;
  Subject subject_;
  std::size_t n_bytes_;
};

void expect_cuts_survived(const Subject& subject) {
  const std::string whole = bytes_of(subject.damaged);
  const DamagedCopy copy(subject);
  EXPECT_EQ(tests::run_guarded(kCuts, kSeconds, copy.max_bytes(),
                               [&](std::size_t i) { return copy.read(whole.substr(0, whole.size() * i / kCuts)); }),
            "")
      << subject.damaged;
}

/// A share of the thousand changes for one of the files of a format.
void expect_changes_survived(const Subject& subject, std::size_t begin, std::size_t end) {
  const std::string whole = bytes_of(subject.damaged);
  const DamagedCopy copy(subject);
  EXPECT_EQ(tests::run_guarded(
                end - begin, kSeconds, copy.max_bytes(),
                [&](std::size_t i) { return copy.read(tests::with_changed_bytes(whole, std::uint64_t(begin + i))); }),
            "")
      << subject.damaged << " from seed " << begin;
}

void expect_all_survived(const std::string& format, const std::vector<Subject>& files) {
  for (const Subject& subject : files) expect_cuts_survived(subject);
  for (std::size_t k = 0; k < files.size(); ++k) {
    expect_changes_survived(files[k], kChanges * k / files.size(), kChanges * (k + 1) / files.size());
  }
  std::printf("%-12s %4zu files cut at %zu places, %zu times bytes changed\n", format.c_str(), files.size(), kCuts,
              kChanges);
}

TEST(DamagedAssets, AreReadOrRefusedInOneLine) {
  const char* const folder = std::getenv("LODESTONE_ASSETS");
  if (!folder) GTEST_SKIP() << "LODESTONE_ASSETS names no folder of models";
  for (const auto& [ending, files] : subjects(folder)) expect_all_survived(ending, files);
}

TEST(DamagedAssets, InFormatsWithoutAssetsAreReadOrRefusedInOneLine) {
  const char* const folder = std::getenv("LODESTONE_ASSETS");
  if (!folder) GTEST_SKIP() << "LODESTONE_ASSETS names no folder of models";
  const Scene spot = read_model_file(std::string(folder) + "/classic/spot/spot_low_resolution.obj");
  const Mesh& mesh = spot.meshes.at(0);
  const tests::TemporaryFolder converted;
  const auto check = [&](const std::string& name, const std::string& bytes) {
    const fs::path path = converted.write(name, bytes);
    expect_all_survived(name, {{path, path}});
  };
  check("ascii/a.ply", tests::as_ply(mesh, tests::PlyKind::ascii));
  check("little/a.ply", tests::as_ply(mesh, tests::PlyKind::little_endian));
  check("big/a.ply", tests::as_ply(mesh, tests::PlyKind::big_endian));
  check("ascii/a.stl", tests::as_stl(mesh, true));
  check("binary/a.stl", tests::as_stl(mesh, false));
}

}  // namespace
}  // namespace lode::geometry
