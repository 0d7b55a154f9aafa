/// Outputs appear whole, together, or not at all.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kPicture = R"({"size": [64, 64], "clear": [1, 2, 3, 255], "draws": []})";

/// Starts `lodestone draw - --out PATH`, which waits for its picture; `input` is the pipe to it.
pid_t start_waiting_draw(const std::string& out_path, int& input) {
  int ends[2];
  if (::pipe(ends) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[0], 0);
    ::close(ends[1]);
    ::execl(LODESTONE_PROGRAM_PATH, "lodestone", "draw", "-", "--out", out_path.c_str(), nullptr);
    ::_exit(127);
  }
  ::close(ends[0]);
  input = ends[1];
  return child;
}

TEST(WholeFile, ASignalLeavesNothingBehindAndEndsTheProcess) {
  for (const int number : {SIGINT, SIGTERM}) {
    const TemporaryDirectory directory;
    write_text(directory / "kept.npy", "old");
    int input = -1;
    const pid_t child = start_waiting_draw(directory / "kept.npy", input);
    // The temporary file is there before the picture is read.
    for (int i = 0; i < 3000 && directory.names().size() < 2; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(directory.names().size(), 2u);
    ::kill(child, number);
    int code = 0;
    ::waitpid(child, &code, 0);
    ::close(input);
    EXPECT_TRUE(WIFSIGNALED(code) && WTERMSIG(code) == number);
    EXPECT_THAT(directory.names(), ElementsAre("kept.npy"));
    EXPECT_EQ(file_text(directory / "kept.npy"), "old");
  }
}

TEST(WholeFile, AFullDiskIsAFailureOfTheMachineAndLeavesNothing) {
  // A limit of 100 bytes stands for a full disk: every picture file is longer.
  for (const char* ending : {"a.npy", "a.exr", "a.png"}) {
    const TemporaryDirectory directory;
    const std::string noise = R"({"size": [64, 64], "draws": [{"points": [[9, 9, 1]], "point_size": 3}]})";
    const Outcome run = run_child({"draw", "-", "--out", directory / ending}, noise, {.max_file_bytes = 50});
    EXPECT_EQ(run.status, 4) << ending;
    EXPECT_THAT(directory.names(), IsEmpty());
  }
}

TEST(WholeFile, OneOutputThatFailsHoldsBackTheOthers) {
  // A float depth .npy of 64 x 64 has 128 + 16384 bytes, the PNG of one colour a few hundred.
  const TemporaryDirectory directory;
  const Outcome run = run_child({"draw", "-", "--out", directory / "a.png", "--depth", directory / "z.npy"}, kPicture,
                                {.max_file_bytes = 8192});
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("z.npy: cannot be written: File too large"));
  EXPECT_THAT(directory.names(), IsEmpty());
}

TEST(WholeFile, StandardOutputThatFailsHoldsBackTheFiles) {
  const TemporaryDirectory directory;
  const Outcome run =
      run_child({"draw", "-", "--out", directory / "a.png", "--print"}, kPicture, {.out_path = "/dev/full"});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(run.err, "lodestone: standard output: cannot be written\n");
  EXPECT_THAT(directory.names(), IsEmpty());
}

TEST(WholeFile, BadInputLeavesTheOldFile) {
  const TemporaryDirectory directory;
  write_text(directory / "a.png", "old");
  EXPECT_EQ(run_lodestone({"draw", "-", "--out", directory / "a.png"}, "{").status, 3);
  EXPECT_EQ(file_text(directory / "a.png"), "old");
  EXPECT_THAT(directory.names(), ElementsAre("a.png"));
}

TEST(WholeFile, APlaceThatCannotBeWrittenIsBadInput) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "folder.npy");
  const auto draw_to = [](const std::string& path) { return run_lodestone({"draw", "-", "--out", path}, kPicture); };
  const Outcome to_folder = draw_to(directory / "folder.npy");
  EXPECT_EQ(to_folder.status, 3);
  EXPECT_THAT(to_folder.err, HasSubstr("folder.npy: is a directory: expected a file to write"));
  const Outcome to_nowhere = draw_to(directory / "no/a.npy");
  EXPECT_EQ(to_nowhere.status, 3);
  EXPECT_THAT(to_nowhere.err, HasSubstr("no/a.npy: cannot be written: No such file or directory"));
  const Outcome to_device = run_lodestone({"draw", "-", "--stats", "/dev/null"}, kPicture);
  EXPECT_EQ(to_device.status, 3);
  EXPECT_THAT(to_device.err, HasSubstr("is a device or pipe"));
  EXPECT_THAT(directory.names(), ElementsAre("folder.npy"));
}

TEST(WholeFile, ASymbolicLinkIsFollowedNotReplaced) {
  const TemporaryDirectory directory;
  write_text(directory / "real.npy", "old");
  std::filesystem::create_symlink(directory / "real.npy", directory / "link.npy");
  EXPECT_EQ(run_lodestone({"draw", "-", "--out", directory / "link.npy"}, kPicture).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link.npy"));
  EXPECT_EQ(read_npy(directory / "real.npy").bytes.size(), 64u * 64u * 4u);
}

}  // namespace
}  // namespace lode::tests
