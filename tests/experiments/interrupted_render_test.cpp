/// A long render on a terminal: it shows how far it is, and an interrupt leaves nothing behind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "experiments/error.h"
#include "experiments/make_target.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct TerminalRun {
  std::string text;  ///< what the terminal got
  int signal = 0;    ///< that ended the program
};

/// Renders what takes minutes, on a terminal of its own, until `seen` is shown; then interrupts it.
TerminalRun interrupted_when(const std::string& seen, const std::string& out_path) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::execl(LODESTONE_PROGRAM_PATH, "lodestone", "render", "spheres", "--size", "4096x4096", "--samples", "128",
            "--out", out_path.c_str(), nullptr);
    ::_exit(127);
  }
  TerminalRun run;
  char block[4096];
  bool interrupted = false;
  for (;;) {
    const ssize_t n = ::read(terminal, block, sizeof block);
    if (n <= 0) break;  // the program has ended
    run.text.append(block, std::size_t(n));
    if (!interrupted && run.text.find(seen) != std::string::npos) {
      ::kill(child, SIGINT);
      interrupted = true;
    }
  }
  int code = 0;
  ::waitpid(child, &code, 0);
  ::close(terminal);
  if (WIFSIGNALED(code)) run.signal = WTERMSIG(code);
  return run;
}

TEST(InterruptedRender, ShowsProgressAndLeavesNothingBehind) {
  const TemporaryDirectory directory;
  const TerminalRun run = interrupted_when(" tiles/s  ", directory / "picture.png");
  EXPECT_EQ(run.signal, SIGINT);
  EXPECT_THAT(run.text, HasSubstr("rendering  "));
  EXPECT_THAT(run.text, HasSubstr(" left"));
  EXPECT_THAT(run.text, testing::EndsWith("\r\033[K"));  // the line is gone
  EXPECT_THAT(directory.names(), IsEmpty());
}

TEST(InterruptedRender, WithoutATerminalNothingIsShown) {
  const TemporaryDirectory directory;
  const Outcome run =
      run_child({"render", "sphere", "--size", "600x600", "--samples", "8", "--out", directory / "a.png"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
}

TEST(LargeTargets, ThatTheMachineCannotHoldAreRefused) {
  EXPECT_GT(experiments::machine_memory_bytes(), 0u);
  // 32768 x 32768 x 28 bytes are 28 GiB.
  if (experiments::machine_memory_bytes() >= (std::uint64_t(28) << 30))
    GTEST_SKIP() << "the machine can hold any target";
  const Outcome run = run_lodestone({"render", "cube", "--size", "32768x32768", "--stats", "-"});
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("out of memory: 32768 x 32768 pixels take 28 GiB"));
}

}  // namespace
}  // namespace lode::tests
