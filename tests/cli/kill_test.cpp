#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using Clock = std::chrono::steady_clock;

/// Every writer, stopped at random moments: its file is as it was or wholly new, and of a signal
/// that can be caught nothing else is left.
struct Writer {
  const char* name;
  const char* arguments;  ///< of the program, in its folder; it writes "out"
};

constexpr Writer writers[] = {
    {"table", "table rig.toml --speed 0:12000:3 --axial-load 100,300 -o out"},
    {"displacement", "displacement shaft.toml --speed 0:10000:20 -o out"},
    {"merge", "table --merge 1.csv 2.csv -o out"},
    {"fit_law", "fit-law curve.csv -o out"},
    {"calibrate", "calibrate rig.toml rig.csv -o out"},
    {"conformity", "calibrate \"S 6014 C\" -o out"},
    {"add", "add rig.toml lubricant-drag --data rig.csv -o out"},
    {"new", "new \"S 6014 C\" -o out"},
    {"report", "diagnose rig.toml rig.csv --report out"}};

class Kill : public testing::TestWithParam<Writer> {
 protected:
  /// Files of all writers, made once in a folder of their own.
  void SetUp() override {
    const std::string rig = tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/";
    scratch_.write("rig.toml", file_text(rig + "model.toml"));
    scratch_.write("rig.csv", file_text(rig + "train.csv"));
    scratch_.write("shaft.toml",
                   file_text(tests::source_dir() + "/data/spindles/two_against_one.toml"));
    const std::string part = " table rig.toml --speed 0:12000:3 --axial-load 100,300 --slab ";
    ASSERT_EQ(run_shell("cd " + scratch_.path().string() + " && $raceway" + part +
                        "1/2 -o 1.csv && $raceway" + part +
                        "2/2 -o 2.csv && $raceway displacement "
                        "shaft.toml --speed 0:10000:250 -o curve.csv")
                  .status,
              0);
    expected_ = whole();
    ASSERT_FALSE(expected_.empty());
  }

  /// What the writer writes, and how long that takes.
  std::string whole() {
    const auto before = Clock::now();
    const int status = run_and_stop(0, std::chrono::hours(1));
    time_ = std::chrono::duration<double>(Clock::now() - before).count();
    EXPECT_EQ(status, 0);
    return out();
  }

  [[nodiscard]] std::string out() const { return file_text(scratch_.file("out")); }

  [[nodiscard]] int parts() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.path()))
      count += entry.path().extension() == ".part";
    return count;
  }

  /// Starts the writer, sends it the signal after a while, and gives its status.
  [[nodiscard]] int run_and_stop(int signal, std::chrono::duration<double> after) const {
    const std::string line = std::string("exec '" + tests::program() + "' ") +
                             GetParam().arguments + " --force >/dev/null 2>&1";
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(scratch_.path().c_str()) == 0)
        execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    if (signal != 0) {
      std::this_thread::sleep_for(after);
      kill(child, signal);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  ScratchFolder scratch_;
  std::string expected_;
  double time_ = 0.0;  // [s]
};

TEST_P(Kill, LeavesTheOldFileOrTheNewOne) {
  std::mt19937 random(20260501);
  std::uniform_real_distribution<double> share(0.0, 1.1);
  constexpr int times = 6;
  const std::string old = "what was there before\n";
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGKILL})
    for (int k = 0; k < times; ++k) {
      scratch_.write("out", old);
      const int status = run_and_stop(signal, std::chrono::duration<double>(share(random) * time_));
      const std::string now = out();
      EXPECT_TRUE(now == old || now == expected_) << "signal " << signal << ", " << now.size();
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        EXPECT_EQ(now, expected_);
      }
      if (signal != SIGKILL) {
        ASSERT_EQ(parts(), 0) << "signal " << signal;
      }
    }
  // What SIGKILL has left blocks nobody.
  EXPECT_EQ(run_and_stop(0, {}), 0);
  EXPECT_EQ(out(), expected_);
}

INSTANTIATE_TEST_SUITE_P(EveryWriter, Kill, testing::ValuesIn(writers),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace raceway::tests
