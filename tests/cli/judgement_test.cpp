// Limits of running bearings, as every command says them, and questions that no bearing can be
// asked (docs/limits.md).
#include <fmt/format.h>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"

namespace raceway::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string of_coarse_cells = "\n[solver]\ncells = \"coarse\"\n";

class Judged : public testing::Test {
 protected:
  [[nodiscard]] Result command(const std::string& verb, const std::string& text,
                               const std::string& flags) const {
    return run(verb + " " + scratch_.write("my.toml", text) + " " + flags);
  }
  /// The finding of a limit in a document; null where it has none.
  [[nodiscard]] static json of(const json& document, const std::string& limit) {
    for (const json& f : document["judgement"])
      if (f["limit"] == limit) return f;
    return nullptr;
  }
  ScratchFolder scratch_;
};

// A spindle with a hot ring and many times its mounted preload was a converged answer without a
// word.
TEST_F(Judged, AHotSpindleIsNotWithoutAWord) {
  const std::string flags = "--speed 15000 --steady ";
  const Result r = command("spindle", base_spindle + of_coarse_cells, flags + "--json");
  EXPECT_EQ(r.status, 0);
  const json answer = parsed(r);
  const json preload = of(answer, "preload_factor"), ring = of(answer, "ring_temperature");
  EXPECT_EQ(preload["kind"], "warning");
  EXPECT_NEAR(preload["value"].get<double>(),
              answer["steady"][0]["rear_force_N"].get<double>() / 300.0, 1e-9);
  EXPECT_GT(preload["value"].get<double>(), 8.0);
  EXPECT_EQ(ring["allowed"], 80.0);
  double hottest = 0.0;
  for (const char* place : {"front_1", "front_2", "rear_1"})
    hottest = std::max(
        hottest,
        answer["steady"][0][std::string(place) + "_inner_ring_temperature_C"].get<double>());
  EXPECT_NEAR(ring["value"].get<double>(), hottest, 1e-6);
  EXPECT_THAT(r.err, AllOf(HasSubstr("warning: " + ring["text"].get<std::string>()),
                           HasSubstr("warning: " + preload["text"].get<std::string>())));
  if (!has_reports()) return;
  const std::string page = scratch_.file("page.html");
  ASSERT_EQ(command("spindle", base_spindle + of_coarse_cells, flags + "--report " + page).status,
            0);
  EXPECT_THAT(page_document(page)["judged"].dump(), HasSubstr("(limit: 3 times)"));
}

TEST_F(Judged, AWarmRunIsJudgedAsTheSteadyState) {
  const std::string profile =
      scratch_.write("day.csv", "time_s,speed_rpm\n0,0\n7200,8000\n14400,8000\n");
  const Result r =
      command("spindle", base_spindle + of_coarse_cells, "--json --speed-profile " + profile);
  EXPECT_EQ(of(parsed(r), "preload_factor")["kind"], "warning");
  EXPECT_THAT(r.err, HasSubstr("times the mounted preload of 300 N"));
}

TEST_F(Judged, AQuietAnswerPassesNoLimit) {
  const Result r =
      command("spindle", base_spindle + of_coarse_cells, "--speed 3000 --steady --json");
  EXPECT_EQ(parsed(r)["judgement"], json::array());
  EXPECT_THAT(r.err, Not(HasSubstr("warning")));
}

TEST_F(Judged, PressureWhileItRunsIsJudgedInEveryCommand) {
  const std::string said = "GPa, above 2 GPa";
  const Result solved = command("solve", model_text, "--speed 1000 --axial-load 30000 --json");
  EXPECT_EQ(of(parsed(solved), "running_pressure")["kind"], "warning");
  EXPECT_THAT(solved.err, HasSubstr(said));
  const Result table = command("table", model_text, "--speed 0,1000 --axial-load 30000 --json");
  EXPECT_EQ(of(parsed(table), "running_pressure")["points"], 1);
  EXPECT_THAT(table.err, HasSubstr("1000 rpm: the contact pressure of the running bearing is"));
  EXPECT_THAT(command("solve", model_text, "--speed 0 --axial-load 30000").err,
              Not(HasSubstr(said)));
}

// A preload of 3e5 N presses the balls of this bearing with 5.2 GPa: solve and table said so, the
// rest of the commands did not.
TEST_F(Judged, APreloadThatLeavesDentsIsSaidByAll) {
  const std::string text =
      replaced(base_spindle, "preload_N = 300", "preload_N = 300000") + of_coarse_cells;
  const std::string said = "GPa as mounted; above 4.2 GPa the balls leave permanent dents";
  for (const auto& [verb, flags] : {std::pair("displacement", "--speed 0,100"),
                                    {"check", ""},
                                    {"deflection", "--force 100"},
                                    {"modes", "--speed 0"},
                                    {"solve", "--speed 100"}})
    EXPECT_THAT(command(verb, text, flags).err, HasSubstr(said)) << verb;
  expect_refused(command("check", replaced(text, "300000", "30000000"), ""),
                 "which the hardest steel yields");
}

TEST_F(Judged, SpeedsAreJudgedByCatalogueAndSpeedFactor) {
  const std::string catalogue =
      "[bearing]\ncatalogue = \"S 6014 C\"\n\n[lubricant]\nviscosity_40C_mm2_s = 22.0\n"
      "viscosity_100C_mm2_s = 4.8\n";
  const json fast = parsed(command("solve", catalogue, "--speed 20000 --axial-load 300 --json"));
  EXPECT_NEAR(of(fast, "catalogue_speed")["allowed"].get<double>(), 19000.0, 1e-6);
  EXPECT_EQ(of(fast, "speed_factor"), nullptr);
  const json skf = parsed(command("solve", catalogue + "[friction]\nlaw = \"skf\"\n",
                                  "--speed 55555 --axial-load 300 --json"));
  EXPECT_NEAR(of(skf, "speed_factor")["value"].get<double>(), 5.0e6, 1e3);
}

TEST_F(Judged, ASpeedAtWhichTheRingBurstsIsRefused) {
  for (const char* verb : {"solve", "table"})
    expect_refused(command(verb, model_text, "--speed 500000 --axial-load 300"),
                   "--speed = 500000 rpm: must be from 0 to 1");
  const std::string data =
      scratch_.write("d.csv", replaced(data_text, "8000,100,347", "500000,100,347"));
  const Result r = command("compare", model_text, data);
  expect_refused(r, "d.csv: line 5: speed_rpm = 500000 rpm: must be from 0 to");
}

TEST_F(Judged, AnOilThatIsSolidIsRefused) {
  expect_refused(
      command("solve", model_text, "--speed 1000 --axial-load 300 --temperature -95"),
      "--temperature = -95 C: must be from -78 to 400 C; below the lower limit, this oil is solid");
  expect_refused(command("table", model_text, "--speed 1000 --axial-load 300 --temperature -95,20"),
                 "below the lower limit, this oil is solid");
  EXPECT_THAT(command("solve", model_text, "--speed 1000 --axial-load 300 --temperature -65").err,
              HasSubstr("near its pour point"));
}

TEST_F(Judged, WaterThatIsIceOrSteamIsRefused) {
  for (const char* inlet : {"-40", "140"})
    expect_refused(command("check",
                           replaced(base_spindle, "inlet_temperature_C = 20.0",
                                    std::string("inlet_temperature_C = ") + inlet),
                           ""),
                   fmt::format("inlet_temperature_C = {} C: must be from 0 to 100 C", inlet));
}

TEST_F(Judged, PartsThatDoNotFitAreRefused) {
  expect_refused(command("check",
                         replaced(base_spindle, "inner_interference_um = 6.0",
                                  "inner_interference_um = 500.0"),
                         ""),
                 "inner_interference_um = 500 um: must be at most 350 um on the bore of 70 mm");
  EXPECT_THAT(command("check",
                      replaced(base_spindle, "inner_interference_um = 6.0",
                               "inner_interference_um = 100.0"),
                      "")
                  .err,
              HasSubstr("warning: "));
  expect_refused(
      command("check",
              base_spindle + "\n[motor]\nheat_W = 100\nposition_mm = 200\nlength_mm = 50\n"
                             "rotor_diameter_mm = 4000\n",
              ""),
      "rotor_diameter_mm = 4000 mm: must be below 180 mm");
}

TEST_F(Judged, AShaftBentBeyondABeamIsRefused) {
  const std::string text = base_spindle + of_coarse_cells;
  EXPECT_THAT(command("deflection", text, "--force 100").err,
              Not(HasSubstr("N: the slope of the nose would be")));
  expect_refused(command("deflection", text, "--force 50000000"),
                 "N: the slope of the nose would be");
}

// The command spindle printed the force of bearings that are not on the shaft, displacement that of
// the mounted ones.
TEST_F(Judged, OneMountedPreloadIsSaidByAll) {
  const std::string text = replaced(base_spindle, "preload_N = 300", "preload_offset_um = 15") +
                           of_coarse_cells +
                           "\n[[effect]]\nid = \"interference-fit\"\ninterference_um = 6\n";
  const double mounted =
      parsed(command("displacement", text, "--speed 0 --json"))["arrangement"]["preload_N"];
  const double free = parsed(command("displacement", replaced(text, "um = 6\n", "um = 0\n"),
                                     "--speed 0 --json"))["arrangement"]["preload_N"];
  EXPECT_GT(mounted, 1.2 * free);
  const std::string said = fmt::format("{:.4g} N", mounted);
  EXPECT_THAT(command("spindle", text, "--speed 3000 --steady").out,
              HasSubstr("preload as mounted " + said));
  EXPECT_THAT(command("deflection", text, "--force 100").out, HasSubstr(said + " as mounted"));
  EXPECT_THAT(command("displacement", text, "--speed 0").out, HasSubstr("preload " + said));
  const json lift = parsed(command("solve", text, "--speed 0 --json"))["arrangement"];
  EXPECT_THAT(command("solve", text, "--speed 0").out,
              HasSubstr(fmt::format("{:.4g} N", lift["front_lift_off_load_N"].get<double>())));
  if (!has_reports()) return;
  const std::string page = scratch_.file("page.html");
  ASSERT_EQ(command("spindle", text, "--speed 3000 --steady --report " + page).status, 0);
  EXPECT_NEAR(page_document(page)["preload_N"].get<double>(), mounted, 1e-6 * mounted);
}

// With a preload that is ground in, the interference of the seats changes no force: it is named,
// with the force that the fit would make.
TEST_F(Judged, AFitThatDoesNotActOnThePreloadIsNamed) {
  const std::string ground =
      replaced(base_spindle, "preload_N = 300", "preload_offset_um = 15") + of_coarse_cells;
  const std::string said =
      "inner_interference_um = 6 um changes the heat through the seat, but not";
  const std::string err = command("displacement", ground, "--speed 0").err;
  EXPECT_THAT(err, HasSubstr(said));
  const double fitted = parsed(command(
      "displacement", ground + "\n[[effect]]\nid = \"interference-fit\"\ninterference_um = 6\n",
      "--speed 0 --json"))["arrangement"]["preload_N"];
  EXPECT_THAT(err, HasSubstr(fmt::format("the preload as mounted is {:.4g} N", fitted)));
  EXPECT_THAT(command("displacement", base_spindle + of_coarse_cells, "--speed 0").err,
              Not(HasSubstr("changes the heat")));
  EXPECT_THAT(command("displacement",
                      ground + "\n[[effect]]\nid = \"interference-fit\"\ninterference_um = 8\n",
                      "--speed 0")
                  .err,
              HasSubstr("warning: "));
}

// Flags that change nothing were taken without a word.
TEST_F(Judged, FlagsThatChangeNothingAreNamed) {
  const std::string dry = base_spindle.substr(0, base_spindle.find("[coolant]")) +
                          base_spindle.substr(base_spindle.find("[ambient]")) + of_coarse_cells;
  const std::string wet = base_spindle + of_coarse_cells;
  for (const auto& [verb, flags] : {std::pair("spindle", "--speed 3000 --steady"),
                                    {"deflection", "--force 100 --warm"},
                                    {"modes", "--speed 0 --warm"}}) {
    EXPECT_THAT(command(verb, dry, std::string(flags) + " --coolant off").err,
                HasSubstr("the model has no [coolant]"))
        << verb;
    EXPECT_THAT(
        command(verb, wet, std::string(flags) + " --coolant off").err,
        Not(HasSubstr("switching off the coolant has no effect: the model has no [coolant]")))
        << verb;
  }
  EXPECT_THAT(
      command("deflection", wet, "--force 100 --coolant off").err,
      HasSubstr(
          "switching off the coolant has no effect: the spindle is calculated cold, not warm"));
  EXPECT_THAT(command("deflection", wet, "--force 100 --direction axial --at 30").err,
              HasSubstr("the position of an axial force has no effect, because the force acts "
                        "along the axis of the shaft"));
  expect_refused(command("spindle", wet, "--speed 3000 --steady --drop-nan"),
                 "--columns and --drop-nan are only possible with --speed-profile");
  expect_refused(command("table", model_text, "--speed 100 --axial-load 100 --drop-nan"),
                 "--columns and --drop-nan need --data");
}

}  // namespace
}  // namespace raceway::tests
