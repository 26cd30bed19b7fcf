// A correction as a user takes it to a control.
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string z_model =
    "[correction]\ndisplacement = \"displacement_z_um\"\noffset_um = -1.5\n[[correction.channel]]\n"
    "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
    "sections = [{ gain_um_K = 5.0, time_constant_s = 5400 }]\n[correction.kinematic]\n"
    "A = 1.28e-3\nB = 0.697\nC = 5.3e-4\n[correction.range]\nfront_temperature_C = [18, 48]\n";

std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

TEST(Export, RunsAsCorrectDoes) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model), program = scratch.file("z.py");
  std::string record = "time_s,speed_rpm,front_temperature_C\n";
  for (int k = 0; k < 200; ++k)
    record += std::to_string(17 * k + k % 5) + "," + std::to_string(k % 40 < 20 ? 6000 : 0) + "," +
              std::to_string(22.0 + 0.1 * k - 0.0002 * k * k) + "\n";
  const std::string data = scratch.write("record.csv", record);
  const Result written = run("export " + model + " --format python -o " + program);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(written.err, HasSubstr("z.py written: 1 displacement with 2 terms from 2 inputs"));
  EXPECT_THAT(
      written.err,
      HasSubstr(", so the exported program cannot detect values outside the training data"));
  const auto exported = rows_of(run_shell("python3 " + program + " " + data).out);
  const auto corrected = rows_of(run("correct " + model + " " + data + " -o - --quiet").out);
  ASSERT_EQ(exported.size(), 200u);
  ASSERT_EQ(corrected.size(), 200u);
  for (std::size_t k = 0; k < exported.size(); ++k)
    EXPECT_NEAR(exported[k][1], corrected[k][1], 1e-8 + 1e-8 * std::abs(corrected[k][1])) << k;
}

TEST(Export, OfAModelThatPredictsNothingIsRefused) {
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "bare.toml", "[[correction]]\nname = \"z\"\ndisplacement = \"displacement_z_um\"\n");
  const Result refused = run("export " + model + " --format c -o " + scratch.file("z.h"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(
      refused.err,
      HasSubstr(": the model has neither a channel nor an effect, so it corrects nothing. Export "
                "the file that identify wrote, or use --accept-untrusted to export this model"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("z.h")));
}

TEST(Export, WritesToStdoutAndNeverOverAFile) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model);
  EXPECT_THAT(run("export " + model + " --format csv --quiet").out,
              HasSubstr("\ndisplacement_z_um,spindle,section 1,time_constant,5400,s\n"));
  EXPECT_THAT(run("export " + model + " --format c -o -").out,
              HasSubstr("static inline void raceway_correction_update("));
  const std::string kept = scratch.write("kept.h", "kept");
  expect_refused(run("export " + model + " --format c -o " + kept), "--force");
  EXPECT_EQ(file_text(kept), "kept");
  ASSERT_EQ(run("export " + model + " --format c --force -o " + kept).status, 0);
  EXPECT_THAT(file_text(kept), HasSubstr("static inline void kept_update("));
}

TEST(Export, OfLinuxcncIsAComponentWithItsHalFiles) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model), program = scratch.file("z.py");
  const Result written = run("export " + model + " --format linuxcnc -o " + program);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(written.err, HasSubstr("z.hal and " + scratch.file("z_shutdown.hal") + " written"));
  EXPECT_THAT(file_text(scratch.file("z.hal")),
              HasSubstr("net z-z-counts z.z-counts => axis.z.eoffset-counts\n"));
  EXPECT_THAT(file_text(scratch.file("z_shutdown.hal")), HasSubstr("\nsetp z.stop 1\n"));
  EXPECT_THAT(run_shell("python3 " + program + " --check").out, HasSubstr(": good"));
  // None of the three is written where one is there.
  std::filesystem::remove(program);
  expect_refused(run("export " + model + " --format linuxcnc -o " + program), "z.hal");
  EXPECT_FALSE(std::filesystem::exists(program));
  const std::string other = scratch.write(
      "a.toml",
      std::string(z_model).replace(z_model.find("displacement_z_um"), 17, "displacement_tip_um"));
  expect_refused(run("export " + other + " --format linuxcnc -o " + scratch.file("tip.py")),
                 "[export] axis = { displacement_tip_um = \"z\" }");
}

TEST(Export, StoresARecordThatTheProgramReplays) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model), program = scratch.file("z.py");
  std::string record = "time_s;speed_rpm;front_temperature_C\n";  // of a German Excel
  for (int k = 0; k < 50; ++k)
    record += std::to_string(60 * k) + ";3000;2" + std::to_string(k % 9) + ",5\n";
  const std::string data = scratch.write("record.csv", record);
  ASSERT_EQ(run("export " + model + " --format python -o " + program + " --record " + data).status,
            0);
  EXPECT_THAT(run_shell("python3 " + program + " --check").out, HasSubstr("check: 50 rows over"));
  const std::string coarse = scratch.write(
      "coarse.toml",
      std::string(z_model).replace(z_model.find("sections"), 0, "feedthrough_um_K = 2.0\n"));
  EXPECT_THAT(run("export " + coarse + " --format c --record " + data).err,
              HasSubstr("front_temperature_C has steps of 1 K, and each step moves "
                        "displacement_z_um by 2 um immediately; [export] smoothing_s = { "
                        "front_temperature_C = 60 } smooths the steps"));
  expect_refused(
      run("export " + model + " --format python --force -o " + data + " --record " + data),
      ": this run reads this file, so it cannot write to the same file; name another file");
}

TEST(Export, ReadsItsTableBack) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model), table = scratch.file("z.csv");
  ASSERT_EQ(run("export " + model + " --format csv -o " + table).status, 0);
  EXPECT_EQ(run("export " + table + " --format csv").out, file_text(table));
  EXPECT_EQ(run("export " + table + " --format python").out,
            run("export " + model + " --format python").out);
  expect_refused(
      run("export " + table + " --format csv --record " + table),
      "is a table that export wrote, and it already contains its record; remove --record");
}

TEST(Export, RefusesInOneMessage) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model);
  EXPECT_THAT(run("export " + model + " --format st").err, HasSubstr("--format"));
  EXPECT_EQ(run("export " + model).status, 1);
  expect_refused(run("export " + model + " --format linuxcnc -o " + scratch.file("z-axis.c")),
                 "z_axis.py");
  const std::string swings = scratch.write(
      "swings.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 1\n[[correction.channel]]\n"
      "name = \"published\"\ninput = \"front_temperature_C\"\nnumerator = [1, 0]\n"
      "denominator = [1, -1.2, 0.72]\n");
  const Result exported = run("export " + swings + " --format python -o " + scratch.file("s.py"));
  EXPECT_EQ(exported.status, 0) << exported.err;
  EXPECT_THAT(exported.err, HasSubstr("note: channel published: exported as a difference equation, "
                                      "because the poles 0.6 +- 0.6i "
                                      "are complex, but a sum of lags has only real poles. The "
                                      "control must call the program every 1 s"));
  EXPECT_THAT(exported.err, HasSubstr("warning: channel published: complex poles: the output "
                                      "oscillates, which no thermal body does"));
  EXPECT_THAT(run("export " + scratch.write("b.toml", "[bearing]\n") + " --format c").err,
              HasSubstr("table [correction] is missing"));
}

}  // namespace
}  // namespace raceway::tests
