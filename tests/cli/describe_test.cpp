#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// Names of the commands, from the help of the program.
std::vector<std::string> all_commands() {
  std::istringstream lines(run("--help").out);
  std::vector<std::string> names;
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Example:")) break;
    if (line.ends_with(':')) {
      listed = line != "Options:";
    } else if (listed && line.starts_with("  ") && line[2] != ' ') {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

/// Flags of a command, from its help.
std::set<std::string> flags_in_help(const std::string& command) {
  const std::string help = run(command + " --help").out;
  std::set<std::string> names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    // "-o,--output FILE"
    std::istringstream spelled(line.substr(2, line.find(' ', 2) - 2));
    for (std::string name; std::getline(spelled, name, ',');) names.insert(name);
  }
  return names;
}

/// As man pages write hyphens.
std::string with_hyphens(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

/// What bash offers behind these words, the last of which is being typed.
std::set<std::string> offered(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  const Result r = run_shell(
      "bash -c 'eval \"$('$raceway' describe bash)\"; COMP_WORDS=(\"$@\"); "
      "COMP_CWORD=$(($# - 1)); _raceway; printf \"%s\\n\" \"${COMPREPLY[@]}\"' -" +
      line);
  EXPECT_EQ(r.err, "");
  std::istringstream lines(r.out);
  std::set<std::string> all;
  for (std::string one; std::getline(lines, one);)
    if (!one.empty()) all.insert(one);
  return all;
}

/// What an interactive zsh offers behind each of these lines.
std::vector<std::set<std::string>> offered_by_zsh(const std::vector<std::string>& begun) {
  const ScratchFolder scratch;
  scratch.write("_raceway", run("describe zsh").out);
  std::string command = "timeout 120 zsh -f " + tests::source_dir() + "/tests/cli/offered.zsh '" +
                        scratch.path().string() + "'";
  for (const std::string& line : begun) command += " '" + line + "'";
  const Result r = run_shell(command);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.err, "");
  std::vector<std::set<std::string>> all(1);
  std::istringstream lines(r.out);
  for (std::string one; std::getline(lines, one);)
    if (one.empty())
      all.emplace_back();
    else
      all.back().insert(one);
  all.pop_back();
  EXPECT_EQ(all.size(), begun.size());
  all.resize(begun.size());
  return all;
}

TEST(Describe, EveryCommandIsOfferedByBash) {
  const std::set<std::string> all = offered({"raceway", ""});
  ASSERT_GE(all_commands().size(), 14U);
  for (const std::string& command : all_commands()) EXPECT_TRUE(all.contains(command)) << command;
  EXPECT_EQ(offered({"raceway", "dia"}), std::set<std::string>{"diagnose"});
}

TEST(Describe, EveryFlagIsOfferedByBash) {
  for (const std::string& command : all_commands()) {
    const std::set<std::string> expected = flags_in_help(command);
    EXPECT_TRUE(expected.contains("--quiet")) << command;
    std::set<std::string> all = offered({"raceway", command, "-"});
    EXPECT_TRUE(all.contains("--quiet")) << command;
    for (const std::string& flag : expected)
      EXPECT_TRUE(all.contains(flag)) << command << " " << flag;
  }
}

TEST(Describe, BashOffersFilesAndEffectsWhereTheyBelong) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("my.toml", model_text);
  const std::string begun = model.substr(0, model.size() - 3);
  EXPECT_EQ(offered({"raceway", "solve", begun}), std::set<std::string>{model});
  EXPECT_EQ(offered({"raceway", "table", "x", "--output", begun}), std::set<std::string>{model});
  EXPECT_EQ(offered({"raceway", "solve", "x", "--speed", ""}), std::set<std::string>{});
  EXPECT_EQ(offered({"raceway", "effects", "wind"}), std::set<std::string>{"windage"});
  EXPECT_EQ(offered({"raceway", "add", "x", "wind"}), std::set<std::string>{"windage"});
}

const std::string over_time_text = "[correction]\ndisplacement = \"displacement_z_um\"\n";

TEST(Describe, BashOffersTheEffectsOfTheModelThatIsNamed) {
  const ScratchFolder scratch;
  const std::string bearing = scratch.write("my.toml", model_text),
                    machine = scratch.write("z.toml", over_time_text);
  EXPECT_EQ(offered({"raceway", "effects", "ambient"}), std::set<std::string>{"ambient-drift"});
  EXPECT_EQ(offered({"raceway", "add", machine, "ambient"}),
            std::set<std::string>{"ambient-drift"});
  EXPECT_EQ(offered({"raceway", "add", machine, "wind"}), std::set<std::string>{});
  EXPECT_EQ(offered({"raceway", "add", bearing, "ambient"}), std::set<std::string>{});
  EXPECT_EQ(offered({"raceway", "add", bearing, "wind"}), std::set<std::string>{"windage"});
}

TEST(Describe, ZshOffersTheEffectsOfTheModelThatIsNamed) {
  const ScratchFolder scratch;
  const std::string bearing = scratch.write("my.toml", model_text),
                    machine = scratch.write("z.toml", over_time_text);
  const std::set<std::string> drift{"ambient-drift"}, windage{"windage"}, none;
  EXPECT_THAT(
      offered_by_zsh({"raceway effects ambient", "raceway add " + machine + " ambient",
                      "raceway add " + machine + " wind", "raceway add " + bearing + " ambient",
                      "raceway add " + bearing + " wind"}),
      testing::ElementsAre(drift, drift, none, none, windage));
}

TEST(Describe, EveryCommandAndFlagIsOfferedByZsh) {
  const std::vector<std::string> every = all_commands();
  std::vector<std::string> begun{"raceway ", "raceway dia"};
  for (const std::string& command : every) begun.push_back("raceway " + command + " -");
  const auto offers = offered_by_zsh(begun);
  std::set<std::string> expected(every.begin(), every.end());
  expected.insert("help");
  EXPECT_EQ(offers[0], expected);
  EXPECT_EQ(offers[1], std::set<std::string>{"diagnose"});
  for (std::size_t k = 0; k < every.size(); ++k)
    EXPECT_EQ(offers[k + 2], flags_in_help(every[k])) << every[k];
}

TEST(Describe, ZshOffersFilesAndEffectsWhereTheyBelong) {
  const ScratchFolder scratch;
  scratch.write("my.toml", model_text);
  const std::string in_folder = scratch.file("m");
  const std::set<std::string> model{"my.toml"}, windage{"windage"};
  EXPECT_THAT(
      offered_by_zsh({"raceway solve " + in_folder, "raceway table x --output " + in_folder,
                      "raceway solve x --speed ", "raceway effects wind", "raceway add x wind",
                      "raceway add x " + in_folder, "raceway help dia"}),
      testing::ElementsAre(model, model, std::set<std::string>{}, windage, windage, model,
                           std::set<std::string>{"diagnose"}));
}

TEST(Describe, EveryCommandAndFlagIsInZshAndInItsManPage) {
  const std::string zsh = run("describe zsh").out;
  const std::string all = run("describe man").out;
  EXPECT_THAT(zsh, testing::StartsWith("#compdef raceway\n"));
  for (const std::string& command : all_commands()) {
    EXPECT_THAT(zsh, HasSubstr("\n    " + command + ")\n"));
    EXPECT_THAT(zsh, HasSubstr("'" + command + ":"));
    EXPECT_THAT(all, HasSubstr("raceway\\-" + with_hyphens(command)));
    const Result page = run("describe man " + command);
    ASSERT_EQ(page.status, 0) << page.err;
    const std::size_t begin = zsh.find("\n    " + command + ")\n");
    const std::string own = zsh.substr(begin, zsh.find(";;", begin) - begin);
    for (const std::string& flag : flags_in_help(command)) {
      EXPECT_THAT(own, HasSubstr("'" + flag + "[")) << command;
      EXPECT_THAT(page.out, HasSubstr("\\fB" + with_hyphens(flag) + "\\fR")) << command;
    }
  }
}

TEST(Describe, WritesTheTreeOfAnInstallation) {
  const ScratchFolder scratch;
  const Result r = run("describe --tree " + scratch.file("share"));
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(file_text(scratch.file("share/bash-completion/completions/raceway")),
            run("describe bash").out);
  EXPECT_EQ(file_text(scratch.file("share/zsh/site-functions/_raceway")), run("describe zsh").out);
  EXPECT_EQ(file_text(scratch.file("share/man/man1/raceway.1")), run("describe man").out);
  for (const std::string& command : all_commands())
    EXPECT_EQ(file_text(scratch.file("share/man/man1/raceway-" + command + ".1")),
              run("describe man " + command).out);
}

TEST(Describe, RefusesWhatItDoesNotKnow) {
  expect_refused(run("describe"), "FORMAT must be bash, zsh or man");
  expect_refused(run("describe fish"), "FORMAT must be bash, zsh or man");
  expect_refused(run("describe man slove"), "slove: no such command; did you mean solve?");
}

}  // namespace
}  // namespace raceway::tests
