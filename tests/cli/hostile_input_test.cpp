#include <cctype>
#include <sstream>
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Input that was made to do harm, or by mistake looks so: each ends at once with one message.
class HostileInput : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const std::string model_ = scratch_.write("my.toml", model_text);
  const std::string data_ = scratch_.write("rig.csv", data_text);

  [[nodiscard]] Result table_of(const std::string& model) const {
    return run("table " + scratch_.write("m.toml", model) + " --speed 0,1000 --axial-load 100");
  }
};

TEST_F(HostileInput, ATableTooLargeToCountIsRefused) {
  const auto axes = [&](const std::string& step, const std::string& more) {
    return run("table " + model_ + " --speed 0:9999:" + step + " --axial-load 1:10000:" + step +
               " --radial-load 1:10000:" + step + " --temperature 0:100:0.01 " + more);
  };
  // 1e5 x 1e5 x 1e5 x 1e4 = 1e19 and more: beyond 2^64 it wrapped to few, or none.
  expect_refused(axes("0.1", ""), "points: at most 1e8 in one run; even a million slabs");
  expect_refused(axes("0.01", "-o " + scratch_.file("t.csv")), "points: at most 1e8 in one run;");
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("t.csv")));
  expect_refused(run("table " + model_ + " --speed 0:9999:0.001 --axial-load 1:100:1"),
                 "999900100 points: at most 1e8 in one run; calculate the table in 10 slabs "
                 "with --slab 1/10 to --slab 10/10");
}

TEST_F(HostileInput, MemoryIsAskedForBeforeItIsTaken) {
  const Result r =
      run("table " + model_ + " --json --speed 0:9999:0.001 --axial-load 1,2,3,4,5,6,7,8,9");
  expect_refused(r, "raceway table: 89991009 points need 5");
  EXPECT_THAT(r.err, HasSubstr(" GB of memory, but only "));
  EXPECT_THAT(r.err, HasSubstr(" GB are available; calculate the table in "));
  EXPECT_THAT(r.err, HasSubstr(" slabs with --slab 1/"));
}

TEST_F(HostileInput, ASlabOfCountlessManyIsRefusedAtOnce) {
  const std::string slab = scratch_.write(
      "s.csv", "# slab 1/99999999999999: 1 of 1 points, grid 0123456789abcdef\na\n1\n");
  expect_refused(run_shell("timeout 60 $raceway table --merge " + slab + " -o -"),
                 "missing slabs: 99999999999998 of 99999999999999; the first is "
                 "2/99999999999999");
}

/// Behind each "_" a unit may begin; all that followed was read for each, for minutes.
TEST_F(HostileInput, AColumnNameOfCountlessUnderscoresIsReadAtOnce) {
  const std::string data =
      scratch_.write("u.csv", std::string(200000, '_') + "," + data_text.substr(0, 43) +
                                  "0,1000,100,92\n0,2000,100,140\n0,4000,100,221\n");
  const Result r = run_shell("timeout 60 $raceway compare " + model_ + " " + data);
  EXPECT_EQ(r.status, 0) << r.err.substr(0, 200);
}

TEST_F(HostileInput, AKeyOfCountlessDotsIsRefused) {
  std::string dots = "a";
  for (int k = 0; k < 50000; ++k) dots += ".a";
  for (const std::string& text :
       {dots + " = 1\n", "[" + dots + "]\nb = 1\n", "x = { " + dots + " = 1 }\n",
        "x = { y = \"\"\"\"\"\"\", " + dots + " = 1 }\n", "\"#\"." + dots + " = 1\n"})
    expect_refused(table_of(text),
                   "m.toml:1: a key has more than 16 dots, so the file is not a model\n");
  // Dots of numbers, texts and comments count for nothing.
  const Result r = table_of("# " + dots + "\n" +
                            replaced(model_text, "\"7014\"", "\"" + dots.substr(0, 99) + "\""));
  EXPECT_EQ(r.status, 0) << r.err;
}

TEST_F(HostileInput, ControlCharactersInNamesAreRefused) {
  for (const auto& [escaped, code] : {std::pair{"\\n", "U+000A"},
                                      {"\\u0000", "U+0000"},
                                      {"\\u001b[2J", "U+001B"},
                                      {"\\r", "U+000D"},
                                      {"\\u009b", "U+009B"},
                                      {"\\u007f", "U+007F"}}) {
    expect_refused(
        table_of(replaced(model_text, "\"7014\"", "\"70" + std::string(escaped) + "14\"")),
        std::string("m.toml:2: \"70\\x"));
    expect_refused(
        table_of(replaced(model_text, "\"7014\"", "\"70" + std::string(escaped) + "14\"")),
        std::string(" contains the control character ") + code);
  }
  expect_refused(table_of("\"a\\nb\" = 1\n" + model_text), "contains the control character U+000A");
  for (const char* name : {"speed_rpm\x1b[2J", "speed_rpm\x07", "speed_rpm\xc2\x9b"})
    expect_refused(
        run("check " + model_ + " " + scratch_.write("d.csv", std::string(name) + data_text)),
        "d.csv:1: the file contains the control character U+00");
}

TEST_F(HostileInput, NoMessageObeysTheTerminal) {
  const std::string esc = "$(printf '\\033]0;x\\007')";
  for (const std::string& line :
       {"$raceway \"" + esc + "\"", "$raceway solve \"" + esc + "\" --speed 1",
        "$raceway solve " + model_ + " --speed \"" + esc + "\"",
        "$raceway bearings \"" + esc + "\"", "$raceway effects \"" + esc + "\"",
        "$raceway new \"" + esc + "\"",
        "cp " + model_ + " \"" + scratch_.file(esc) + "\"; $raceway solve \"" + scratch_.file(esc) +
            "\" --speed 1000 --axial-load 100"}) {
    const Result r = run_shell(line);
    EXPECT_EQ(r.status, 1) << line;
    EXPECT_EQ((r.out + r.err).find('\x1b'), std::string::npos) << line;
    EXPECT_THAT(r.err, HasSubstr("\\x1b")) << line;
  }
}

TEST_F(HostileInput, AnEffectIsNamedSoThatItCanHeadAColumn) {
  for (const char* id : {"a,b", "=1+1", "-x", "@x", "+x", "a b", "a\\\"b", "a;b", "'x"})
    expect_refused(table_of(model_text + "[[effect]]\nid = \"" + id +
                            "\"\ntorque_Nmm = \"c * speed_rpm\"\nc = 0.0\n"),
                   ": must be a name without blanks, dots, commas, semicolons and quotes, and must "
                   "not begin with =, +, - or @");
  const Result r = table_of(
      model_text + "[[effect]]\nid = \"Lüfter_2\"\ntorque_Nmm = \"c * speed_rpm\"\nc = 0.0\n");
  EXPECT_EQ(r.status, 0) << r.err;
}

TEST_F(HostileInput, AMillionColumnsAreRefusedAtOnce) {
  std::string header = "speed_rpm";
  for (int k = 0; k < 1'000'000; ++k) header += ",c" + std::to_string(k);
  expect_refused(run("check " + model_ + " " + scratch_.write("d.csv", header + "\n1\n")),
                 "d.csv:1: the file has 1000001 columns; at most 10000 are allowed");
}

TEST_F(HostileInput, ANameOfMegabytesIsNoSearch) {
  const std::string name(3'000'000, '6');
  const Result r = run_shell("timeout 60 $raceway solve " +
                             scratch_.write("n.toml", "[bearing]\ncatalogue = \"" + name + "\"\n") +
                             " --speed 1");
  expect_refused(r, "n.toml:2: bearing \"6666");
  EXPECT_LT(r.err.size(), 1000U);
  expect_refused(
      run_shell("timeout 60 $raceway solve " +
                scratch_.write("k.toml", "[bearing]\n" + name + " = 1\n") + " --speed 1"),
      "unknown key in [bearing]");
}

TEST_F(HostileInput, ADiagnosisInTheWrongUnitEndsWithAQuestion) {
  const std::string rig = tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/";
  const std::string model = scratch_.write(
      "rig.toml", file_text(rig + "model.toml") + "\n[[effect]]\nid = \"spin-friction\"\n");
  // As if the speeds stood in krpm: far below where the laws hold.
  std::istringstream rows(file_text(rig + "train.csv"));
  std::string krpm, row;
  while (std::getline(rows, row)) {
    const auto comma = row.find(',', row.find(',') + 1) + 1;
    if (!row.empty() && std::isdigit(static_cast<unsigned char>(row[0])) != 0)
      row.replace(comma, row.find(',', comma) - comma,
                  std::to_string(1e-3 * std::stod(row.substr(comma))));
    krpm += row + "\n";
  }
  const Result r = run_shell("timeout 60 $raceway diagnose --time-limit 0.05 " + model + " " +
                             scratch_.write("krpm.csv", krpm));
  EXPECT_EQ(r.status, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr("raceway diagnose: no verdict within 0.05 s; allow more time with "
                               "--time-limit 0.5, or use --no-pairs. The speeds are 0.6 to "));
  EXPECT_THAT(r.err, HasSubstr("rpm: is rpm the correct unit?"));
}

TEST_F(HostileInput, InputWithoutEndIsGivenUp) {
  for (const std::string& line :
       {std::string("$raceway solve /dev/zero --speed 1"),
        "$raceway check " + model_ + " /dev/zero", std::string("$raceway fit-law /dev/zero"),
        std::string("$raceway fit-law < /dev/zero"),
        std::string("$raceway table --merge /dev/zero -o -")})
    expect_refused(run_shell("timeout 60 " + line),
                   ": the file contains NUL bytes, so it is not a text file");
  const std::string large = scratch_.file("large.csv");
  expect_refused(
      run_shell("truncate -s 5G " + large + "; timeout 60 $raceway fit-law " + large),
      "large.csv: the file is larger than 4 GB, the largest size that the program reads\n");
  const std::string model = scratch_.write("big.toml", std::string(11'000'000, '\n'));
  expect_refused(run("solve " + model + " --speed 1"),
                 "big.toml: the file has 11 MB; a model has at most 10 MB");
}

}  // namespace
}  // namespace raceway::tests
