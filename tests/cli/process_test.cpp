#include <string>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// Standard streams that are closed or full, signals, limits: the program as cron starts it.
class Process : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const std::string model_ = scratch_.write("my.toml", model_text);
  const std::string out_ = scratch_.file("t.csv");
  const std::string table_ = "$raceway table " + model_ + " --speed 0:4000:1000 --axial-load 100";

  [[nodiscard]] std::string parts() const {
    std::string names;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.path()))
      if (entry.path().extension() == ".part") names += entry.path().filename().string() + " ";
    return names;
  }
};

TEST_F(Process, AnUnwritableStderrLosesNoFile) {
  EXPECT_EQ(run_shell(table_ + " -o " + out_).status, 0);
  const std::string whole = file_text(out_);
  EXPECT_THAT(whole, HasSubstr("4000,100,0,40,"));
  for (const char* stream : {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    std::filesystem::remove(out_);
    EXPECT_EQ(run_shell(table_ + " -o " + out_ + " " + stream).status, 0) << stream;
    EXPECT_EQ(file_text(out_), whole) << stream;
  }
  // Errors keep their status.
  for (const char* stream : {"2>/dev/full", "2>&-"}) {
    EXPECT_EQ(run_shell(table_ + " -o " + out_ + " " + stream).status, 1) << stream;
    EXPECT_EQ(run_shell(std::string("$raceway tabel ") + stream).status, 1) << stream;
    EXPECT_EQ(run_shell(std::string("$raceway ") + stream).status, 1) << stream;
    EXPECT_EQ(run_shell(std::string("$raceway bearings nonesuch ") + stream).status, 1) << stream;
  }
  EXPECT_EQ(file_text(out_), whole);
}

TEST_F(Process, AnUnwritableStdoutIsAnError) {
  for (const std::string& what :
       {std::string("$raceway --help"), std::string("$raceway --version"),
        std::string("$raceway help"), std::string("$raceway table --help"),
        std::string("$raceway bearings"), table_, table_ + " --json", table_ + " -o -"})
    for (const char* stream : {">/dev/full", ">&-"}) {
      const Result r = run_shell(what + " " + stream);
      EXPECT_EQ(r.status, 1) << what << stream;
      EXPECT_THAT(r.err, HasSubstr("raceway: stdout could not be written")) << what << stream;
    }
}

TEST_F(Process, AClosedStdinIsAnErrorAndNoFile) {
  const Result r = run_shell("$raceway fit-law <&-");
  expect_refused(r, "standard input: cannot be read");
}

TEST_F(Process, ALimitOfFileSizeIsAFullDisk) {
  expect_refused(run_shell("ulimit -f 64; $raceway table " + model_ +
                           " --speed 0:9000:1 --axial-load 100,300 -o " + out_),
                 out_ + ": cannot be written: File too large");
  EXPECT_FALSE(std::filesystem::exists(out_));
  EXPECT_EQ(parts(), "");
}

TEST_F(Process, OneThatIsToldToStopSaysWhatWasKept) {
  // Long enough that the signal comes before the end.
  const std::string longer =
      "$raceway table " + model_ + " --speed 0:9000:0.01 --axial-load 100,300,900 -o " + out_;
  for (const char* signal : {"TERM", "INT", "HUP"}) {
    const Result r = run_shell("env --default-signal=INT timeout -s " + std::string(signal) +
                               " --preserve-status 0.2 " + longer);
    EXPECT_THAT(r.err, HasSubstr("raceway: stopped; no file was written or changed\n")) << signal;
    EXPECT_FALSE(std::filesystem::exists(out_));
    EXPECT_EQ(parts(), "");
  }
}

}  // namespace
}  // namespace raceway::tests
