// What the pages in docs/ show is what the program prints.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

namespace fs = std::filesystem;

struct Session {
  int line;
  std::string command;
  std::vector<std::string> shown;  ///< without the blank lines at its end
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

/// The commands of all ```console blocks: after "$ ", continued after a backslash.
std::vector<Session> sessions_of(const std::string& page) {
  std::vector<Session> sessions;
  bool inside = false, continued = false;
  int number = 0;
  for (const std::string& line : lines_of(page)) {
    ++number;
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && (continued || line.starts_with("$ "))) {
      if (!continued) sessions.push_back({number, "", {}});
      sessions.back().command += continued ? "\n" + line : line.substr(2);
      continued = line.ends_with("\\");
    } else if (inside) {
      sessions.back().shown.push_back(line);
    }
  }
  for (Session& s : sessions)
    while (!s.shown.empty() && s.shown.back().empty()) s.shown.pop_back();
  return sessions;
}

/// Words alike, or numbers that differ by no more than their last digits may between compilers.
bool same_word(const std::string& shown, const std::string& printed) {
  if (shown == printed) return true;
  const auto number = [](const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    // Punctuation may follow.
    return std::string(end).find_first_not_of(".,;:)%") == std::string::npos ? value : NAN;
  };
  const double a = number(shown), b = number(printed);
  return std::abs(a - b) <= 0.02 * std::abs(a) || (a != 0.0 && std::abs(a) < 1e-30 && b < 1e-30);
}

bool same_line(const std::string& shown, const std::string& printed) {
  std::istringstream a(shown), b(printed);
  std::string x, y;
  while (a >> x)
    if (!(b >> y) || !same_word(x, y)) return false;
  return !(b >> y);
}

/// First line shown that the program does not print; "..." stands for any number of lines, at the
/// end of a line for its rest.
std::string first_difference(const std::vector<std::string>& shown,
                             const std::vector<std::string>& printed) {
  std::size_t at = 0;
  bool skip = false;
  for (const std::string& line : shown) {
    if (line == "...") {
      skip = true;
      continue;
    }
    while (skip && at < printed.size() && !same_line(line, printed[at])) ++at;
    if (at == printed.size()) return line + "\n  is not printed";
    if (!same_line(line, printed[at])) return line + "\n  printed: " + printed[at];
    skip = false;
    ++at;
  }
  return skip || at == printed.size() ? "" : "not shown: " + printed[at];
}

/// The command with more time than people wait for: sanitizers and a loaded machine take it.
std::string with_time(std::string command) {
  const std::string diagnose = "raceway diagnose ";
  if (command.starts_with(diagnose) && command.find("--time-limit") == std::string::npos)
    command.insert(diagnose.size(), "--time-limit 3600 ");
  return command;
}

class Page : public testing::TestWithParam<const char*> {};

TEST_P(Page, PrintsWhatItShows) {
  const fs::path root = tests::source_dir();
  const auto sessions = sessions_of(file_text(root / GetParam()));
  ASSERT_GE(sessions.size(), 1u);
  // The page's commands run in a folder with the data, one after the other.
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "build/release");
  fs::create_symlink(tests::program(), scratch.path() / "build/release/raceway");
  fs::create_directory_symlink(root / "data", scratch.path() / "data");
  fs::create_directory_symlink(root / "tests", scratch.path() / "tests");
  fs::create_directory_symlink(root / "tests/hidden_effect/rigs/dev-03", scratch.path() / "rig");
  for (const Session& s : sessions) {
    SCOPED_TRACE(std::string(GetParam()) + ":" + std::to_string(s.line) + ": " + s.command);
    const Result r = run_shell("cd '" + scratch.path().string() +
                               "'; PATH=$PWD/build/release:$PATH; " + with_time(s.command));
    // What stderr has is left out of a page unless the command sends it to stdout.
    std::vector<std::string> shown = s.shown;
    if (s.command.find("2>&1") == std::string::npos)
      std::erase_if(shown, [](const std::string& line) {
        return line.starts_with("note: ") || line.starts_with("warning: ");
      });
    if (shown.empty()) {  // not shown on purpose, but it must do its work
      EXPECT_EQ(r.status, 0) << r.err;
      continue;
    }
    EXPECT_EQ(first_difference(shown, lines_of(r.out)), "") << r.out << r.err;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Documentation, Page,
    testing::Values("README.md", "docs/case-study.md", "docs/chain.md", "docs/coast-down.md",
                    "docs/control.md", "docs/correction.md", "docs/german-excel-and-loggers.md",
                    "docs/kinematic-law.md", "docs/laws.md", "docs/limits.md", "docs/loop.md",
                    "docs/race-control.md", "docs/roller.md", "docs/sensitivity.md",
                    "docs/shaft.md", "docs/spindle.md", "docs/spindle-heat.md",
                    "docs/spindle-record.md", "docs/torque-sensor.md", "docs/tutorial.md",
                    "docs/validation.md", "docs/verdicts.md", "docs/worked-examples.md"),
    [](const auto& p) {
      std::string name = fs::path(p.param).stem().string();
      std::erase(name, '-');
      return name;
    });

TEST(Documentation, TheTestSeesADifference) {
  EXPECT_EQ(first_difference({"a 1.00 b", "...", "c"}, {"a 1.01 b", "x", "y", "c"}), "");
  EXPECT_NE(first_difference({"a 1.00 b"}, {"a 1.10 b"}), "");
  EXPECT_NE(first_difference({"a"}, {"a", "b"}), "");
  EXPECT_NE(first_difference({"a", "...", "c"}, {"a", "b"}), "");
  EXPECT_NE(first_difference({"verdict: effect"}, {"verdict: ambiguous"}), "");
}

}  // namespace
}  // namespace raceway::tests
