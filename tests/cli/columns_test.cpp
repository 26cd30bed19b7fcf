// Files of other programs, from their columns to a verdict.
#include <fmt/format.h>

#include <cmath>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::string german_export = tests::source_dir() + "/data/measurements/german_export.csv";

/// The header says kN; the map, which a user may have to write against the header, says N.
TEST(Columns, AUnitAgainstTheHeaderIsNamed) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  const Result r =
      run_shell(at + "$raceway new 'S 6014 C' --law palmgren -o my.toml; $raceway check my.toml " +
                german_export +
                " --suggest-columns | sed 's/\"kN\"/\"N\"/' >map.toml; $raceway check my.toml " +
                german_export + " --columns map.toml --drop-nan");
  EXPECT_THAT(r.err, HasSubstr("the file gives the unit kN, but map.toml"));
}

TEST(Columns, AGermanExcelExportGoesInWithoutAScript) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  EXPECT_EQ(run_shell(at + "$raceway new 'S 6014 C' --law palmgren -o my.toml").status, 0);
  // As it stands it is refused, with the way on.
  expect_refused(run_shell(at + "$raceway check my.toml " + german_export), "--suggest-columns");
  EXPECT_EQ(
      run_shell(at + "$raceway check my.toml " + german_export + " --suggest-columns >map.toml")
          .status,
      0);
  const Result refused =
      run_shell(at + "$raceway check my.toml " + german_export + " --columns map.toml");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("Reibmoment = \"#NV\": is not a number"));
  const std::string flags = german_export + " --columns map.toml --drop-nan";
  const Result check = run_shell(at + "$raceway check my.toml " + flags + " -o rows.csv");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("71 rows of friction torque"));
  EXPECT_THAT(check.err, HasSubstr("1 of 72 rows have an empty cell or a cell without a number"));
  EXPECT_THAT(check.err, HasSubstr("1 N m = 1000 N mm"));
  EXPECT_THAT(check.err, Not(HasSubstr("warning:")));
  const Result verdict = run_shell(at + "$raceway diagnose my.toml " + flags + " | tail -n 1");
  EXPECT_THAT(verdict.out, testing::StartsWith("Lubricant drag is missing: 61 N mm"));
  // The map may stand in the model, and the rows as they were read say the same.
  EXPECT_EQ(run_shell(at + "sed '/^#/d' map.toml >>my.toml").status, 0);
  EXPECT_EQ(
      run_shell(at + "$raceway diagnose my.toml " + german_export + " --drop-nan | tail -n 1").out,
      verdict.out);
  EXPECT_EQ(run_shell(at + "$raceway diagnose my.toml rows.csv | tail -n 1").out, verdict.out);
  // As Excel's "Unicode text" has it.
  EXPECT_EQ(run_shell(at + "iconv -f latin1 -t utf-16 " + german_export +
                      " >utf16.csv; $raceway diagnose my.toml utf16.csv --drop-nan | tail -n 1")
                .out,
            verdict.out);
}

/// A model, and a record in N m whose column says N mm.
struct WrongUnit {
  ScratchFolder folder;
  std::string model = folder.write("m.toml", model_text);
  std::string data = folder.write("d.csv", rows());
  std::string question =
      "readings of friction torque are about 1000 times too small for the model: are the values in "
      "N m instead of N mm?";

  std::string map = folder.write(
      "map.toml",
      "[columns]\nfriction_torque_Nmm = { column = \"friction_torque_Nmm\", unit = \"Nmm\" }\n");

  [[nodiscard]] std::vector<std::string> commands() const {
    const std::string both = model + " " + data;
    return {"check " + both,     "compare " + both,  "compare " + model + " " + both,
            "calibrate " + both, "diagnose " + both, "add " + model + " windage --data " + data};
  }
  /// With the unit said, whose numbers are as wrong as they were.
  [[nodiscard]] std::vector<std::string> answered() const {
    std::vector<std::string> list = commands();
    for (std::string& command : list) command += " --columns " + map;
    return list;
  }

 private:
  static std::string rows() {
    std::string text = "speed_rpm,axial_load_N,friction_torque_Nmm\n";
    for (int speed = 1000; speed < 12000; speed += 500)
      text += std::to_string(speed) + ",300," + std::to_string(0.02 + 4e-5 * speed) + "\n";
    return text;
  }
};

TEST(Columns, AnotherUnitIsAskedAboutBeforeTheVerdict) {
  const WrongUnit wrong;
  for (const std::string& command : wrong.commands())
    expect_refused(run(command), wrong.question +
                                     " If so, set the unit in [columns]: friction_torque_Nmm = { "
                                     "column = \"friction_torque_Nmm\", unit = \"Nm\" }");
}

TEST(Columns, AUnitThatIsSaidIsNotAskedAboutAgain) {
  const WrongUnit wrong;
  for (const std::string& command : wrong.answered()) {
    const Result answer = run(command);
    EXPECT_THAT(answer.err, HasSubstr("warning: " + wrong.question)) << command;
    EXPECT_THAT(answer.err, Not(HasSubstr("If so, set the unit in [columns]:"))) << command;
  }
  // The name of a rule says a unit as well, where the file says none.
  std::string unnamed = file_text(wrong.data);
  unnamed.replace(unnamed.find("friction_torque_Nmm"), 19, "Moment");
  const std::string theirs = wrong.folder.write("theirs.csv", unnamed);
  const auto named = [&](const std::string& name) {
    const std::string map =
        wrong.folder.write(name + ".toml", "[columns]\n" + name + " = \"Moment\"\n");
    return run("compare " + wrong.model + " " + theirs + " --columns " + map);
  };
  EXPECT_EQ(named("friction_torque_Nm").status, 0);
  expect_refused(named("friction_torque_Nmm"), "friction_torque_Nmm = { column = \"Moment\"");
  const std::string right = wrong.folder.write(
      "right.toml",
      "[columns]\nfriction_torque_Nmm = { column = \"friction_torque_Nmm\", unit = \"Nm\" }\n");
  EXPECT_THAT(run("compare " + wrong.model + " " + wrong.data + " --columns " + right).err,
              Not(HasSubstr("too small for the model")));
}

TEST(Columns, AReversedTorqueStopsBeforeTheVerdict) {
  const ScratchFolder folder;
  const std::string model = folder.write("my.toml", model_text);
  const auto rows = [](double factor, double zero) {
    std::string text = "speed_rpm,axial_load_N,temperature_C,Moment\n";
    for (const double n : {1000.0, 2000.0, 4000.0, 8000.0})
      for (const double load : {100.0, 500.0, 900.0})
        text += fmt::format("{},{},40,{}\n", n, load,
                            factor * (std::pow(n, 2.0 / 3.0) + 0.02 * load) / 1000.0 + zero);
    return text;
  };
  const std::string map = folder.write("map.toml", "[columns]\nfriction_torque_Nm = \"Moment\"\n");
  const auto compared = [&](const std::string& text, const std::string& columns) {
    return run("compare " + model + " " + folder.write("r.csv", text) + " --columns " + columns);
  };
  const std::string answer =
      "friction_torque_Nmm = { column = \"Moment\", unit = \"Nm\", factor = -1 }";
  expect_refused(compared(rows(-1.0, 0.0), map), "Reverse the sign in [columns]: " + answer);
  const std::string right = folder.write("right.toml", "[columns]\n" + answer + "\n");
  EXPECT_EQ(compared(rows(-1.0, 0.0), right).status, 0);
  // A zero that is off by more than the friction is no reversed sign.
  EXPECT_EQ(compared(rows(1.0, -1.0), map).status, 0);
}

/// Who reads documents alone reads neither stderr nor its warnings.
TEST(Columns, WhatIsAskedAndNotedOfARecordStandsInEveryDocument) {
  const WrongUnit wrong;
  for (const std::string& command : wrong.answered()) {
    const json document = parsed(run(command + " --json"));
    const json& notes = document["notes"];
    EXPECT_THAT(notes, Contains(wrong.question)) << command;
    EXPECT_THAT(notes, Contains("no column temperature_C: 40 C for all rows, from [rig]"))
        << command;
    EXPECT_THAT(
        document["said"],
        Contains(json{
            {"kind", "doubt"}, {"code", "unit"}, {"text", wrong.question}, {"file", wrong.data}}))
        << command;
    EXPECT_THAT(document["said"],
                Contains(json{{"kind", "note"},
                              {"code", "filled-in"},
                              {"text", "no column temperature_C: 40 C for all rows, from [rig]"},
                              {"file", wrong.data},
                              {"key", "temperature_C"}}))
        << command;
  }
}

TEST(Columns, OfSeveralFilesNotesSayWhichIsMeant) {
  const WrongUnit wrong;
  const std::string other = wrong.folder.write(
      "other.csv",
      "speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm\n1000,300,0,40,90\n");
  const Result text =
      run("compare " + wrong.model + " " + other + " " + wrong.data + " --columns " + wrong.map);
  EXPECT_THAT(text.err, HasSubstr("warning: " + wrong.data + ": " + wrong.question));
  EXPECT_THAT(text.err, HasSubstr("note: " + wrong.data + ": no column temperature_C"));
  EXPECT_THAT(text.err, Not(HasSubstr("note: " + other)));
  EXPECT_THAT(parsed(run("compare " + wrong.model + " " + other + " " + wrong.data + " --columns " +
                         wrong.map + " --json"))["notes"],
              Contains(wrong.data + ": " + wrong.question));
}

TEST(Columns, WorkbooksAndBinaryFilesAreNamed) {
  const ScratchFolder folder;
  const std::string model = folder.write("m.toml", model_text);
  const auto refused = [&](const std::string& text, const std::string& message) {
    const std::string data = folder.write("d.csv", text);
    expect_refused(run("check " + model + " " + data), message);
  };
  refused(std::string("PK\3\4\0\0", 6), "d.csv: is an Excel workbook (.xlsx)");
  refused("\xd0\xcf\x11\xe0\xa1",
          "is an old Excel workbook (.xls); save the sheet as CSV (in Excel: Save as, CSV)");
  refused("\x89HDF\r\n", "is an HDF5 file");
}

TEST(Columns, ABearingOfNoCatalogueIsProposed) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  const Result made =
      run_shell(at + "$raceway new '7014 C' --balls 20 --ball-material silicon-nitride -o my.toml");
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("7014 C is not in the catalogue: 70 x 110 mm, 15 deg"));
  EXPECT_EQ(run_shell(at + "$raceway solve my.toml --speed 10000 --axial-load 300").status, 0);
  // In inches it is the same.
  EXPECT_EQ(
      run_shell(at + "$raceway new '7014 C' --balls 20 --ball-material silicon-nitride --bore "
                     "2.755906in --outer-diameter 4.330709in | grep ball_diameter")
          .out,
      run_shell(at + "grep ball_diameter my.toml").out);
  expect_refused(run("new X99"), "bearing \"X99\" is not in the catalogue");
  expect_refused(run("new X99 --bore 70"), "--bore and --outer-diameter");
  expect_refused(run("new X99 --bore 70furlong"),
                 "--bore = \"70furlong\": not a number with a unit of length");
  expect_refused(run("new 'S 6014 C' --bore 70"),
                 "raceway new: the catalogue has the inner geometry of");
  const Result list = run("bearings --bore 70");
  EXPECT_THAT(list.out, HasSubstr("S 6014 C"));
  EXPECT_THAT(list.out, Not(HasSubstr("S 6010 C")));
}

TEST(Columns, ANewHybridDiffersFromSteelAndSaysWhy) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  const auto torque = [&](const std::string& flags) {
    EXPECT_EQ(run_shell(at + "$raceway new 'S 6014 C' --force -o my.toml " + flags).status, 0);
    const Result r = run_shell(at + "$raceway table my.toml --speed 15000 --axial-load 300");
    EXPECT_EQ(r.status, 0) << r.err;
    return std::pair(r.out, r.err);
  };
  const auto steel = torque(""), hybrid = torque("--ball-material silicon-nitride");
  EXPECT_NE(steel.first.substr(steel.first.find("15000")),
            hybrid.first.substr(hybrid.first.find("15000")));
  EXPECT_THAT(hybrid.second, HasSubstr("steel balls"));
  EXPECT_EQ(torque("--law contact"), steel);
}

TEST(Columns, ANewModelOfEachLawReadsBackWithoutAWord) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  for (const char* law : {"palmgren", "skf", "contact"}) {
    const std::string name = law;
    EXPECT_EQ(
        run_shell(at + "$raceway new 'S 6014 C' --law " + name + " -o " + name + ".toml").status,
        0);
    const Result text = run_shell(at + "cat " + name + ".toml");
    EXPECT_THAT(text.out, HasSubstr("law = \"" + name + "\""));
    // What it says is what is taken without it.
    EXPECT_EQ(run_shell(at +
                        "grep -Ev '^(f1_load|mu_|K_rs|rolling_f|hysteresis_f|oil_f|type|"
                        "eyring|race_r|ball_r)' " +
                        name + ".toml >short.toml")
                  .status,
              0);
    const std::string flags = " --speed 10000 --axial-load 600 --json";
    EXPECT_EQ(parsed(run_shell(at + "$raceway solve " + name + ".toml" + flags))["friction"],
              parsed(run_shell(at + "$raceway solve short.toml" + flags))["friction"])
        << law;
  }
  expect_refused(run("new 'S 6014 C' --law newton"), "--law");
}

TEST(Columns, ATableGoesOutForOtherPrograms) {
  const ScratchFolder folder;
  const std::string model = folder.write("m.toml", model_text + spin_effect);
  const std::string at = "cd '" + folder.path().string() +
                         "'; $raceway table m.toml --speed 0:4000:1000 --axial-load 100,300 ";
  const Result plain = run_shell(at + "--format plain -o - | head -n 1");
  EXPECT_THAT(plain.out, HasSubstr("friction_torque_Nmm,load_Nmm,viscous_Nmm,spin_friction_Nmm"));
  EXPECT_THAT(run_shell(at + "--format modelica -o -").out,
              HasSubstr("double friction_torque(6,3)\n0 100 300\n"));
  EXPECT_EQ(run_shell(at + "--plot t.svg").status, 0);
  EXPECT_THAT(file_text(folder.path() / "t.svg"), testing::StartsWith("<svg "));
  expect_refused(run_shell(at + "--format plain"), "--format needs --output FILE");
}

/// From a machine's own export to a correction, and no file by hand.
TEST(Columns, OfARecordOverTimeAreProposedForACorrection) {
  const ScratchFolder folder;
  const std::string at = "cd '" + folder.path().string() + "'; ";
  folder.write("bare.toml", "[correction]\ndisplacement = \"displacement_z_um\"\n");
  std::string rows = "Zeit [min];T Lager [\u00b0C];Verlagerung Z [mm]\n";
  for (int k = 0; k < 90; ++k) {
    const double t = 2.0 * k, rise = t < 60 || t > 120 ? 0.0 : 8.0;
    rows += fmt::format("{};{:.2f};{:.5f}\n", t, 20 + rise + 0.1 * (k % 3), 1e-3 * rise);
  }
  folder.write("machine.csv", rows);
  const Result written =
      run_shell(at + "$raceway check bare.toml machine.csv --suggest-columns -o map.toml");
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_THAT(written.err, HasSubstr("map.toml written"));
  EXPECT_THAT(
      file_text(folder.file("map.toml")),
      HasSubstr("\ndisplacement_z_um = { column = \"Verlagerung Z [mm]\", unit = \"mm\" }\n"));
  EXPECT_EQ(file_text(folder.file("map.toml")),
            run_shell(at + "$raceway check bare.toml machine.csv --suggest-columns").out);
  const Result check = run_shell(at + "$raceway check bare.toml machine.csv --columns map.toml");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("90 rows of displacement z"));
  expect_refused(
      run_shell(at + "$raceway check bare.toml machine.csv --suggest-columns -o map.toml"),
      "--force");
  expect_refused(run_shell(at + "$raceway check bare.toml --suggest-columns"), "needs DATA");
}

}  // namespace
}  // namespace raceway::tests
