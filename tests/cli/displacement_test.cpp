// raceway displacement, and solve and table with an [arrangement].

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"
#include "tests/reference_table.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

const std::string sets = "\n[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload_N = 600\n";

/// Made by the model with other preloads than the rows say.
const std::string curve_text =
    "speed_rpm,preload_N,axial_displacement_um\n2000,320,0.5\n4000,320,2.0\n6000,320,3.6\n"
    "8000,320,4.9\n2000,900,0.2\n4000,900,0.9\n6000,900,2.1\n8000,900,3.3\n";

class Displacement : public testing::Test {
 protected:
  [[nodiscard]] Result raceway(const std::string& command, const std::string& flags,
                               const std::string& model = model_text + sets) const {
    return run(command + " " + scratch_.write("my.toml", model) + " " + flags);
  }
  [[nodiscard]] static std::string spindle(const std::string& name) {
    return tests::source_dir() + "/data/spindles/" + name;
  }
  ScratchFolder scratch_;
};

TEST_F(Displacement, ReproducesTheNumbersOfTheSpindlesThatComeWithIt) {
  const auto rows = reference_table("shaft_displacement.csv");
  const std::vector<std::string> files{"two_against_one.toml", "published_curve.toml"};
  for (std::size_t i = 0; i < 2; ++i) {
    SCOPED_TRACE(files[i]);
    const json d = parsed(run("displacement " + spindle(files[i]) + " --speed 0,10000 --json"));
    EXPECT_NEAR(d["rows"][1]["axial_displacement_um"].get<double>(),
                rows[i]["axial_displacement_um"], rows[i]["tolerance_um"]);
    EXPECT_EQ(d["rows"][0]["axial_displacement_um"], 0.0);
  }
}

// [Brecher2021, eq. 10] over 0 to 10 000 rpm; the mean deviation printed for this spindle is 0.133.
TEST_F(Displacement, PublishedCurveIsReproducedByAPlausibleBearing) {
  const json d = parsed(
      run("displacement " + spindle("published_curve.toml") + " --speed 0:10000:250 --json"));
  double sum = 0.0;
  for (const json& row : d["rows"]) {
    const double n = row["speed_rpm"];
    const double published =
        n > 0.0 ? 1.28e-3 * std::pow(n, 1.0 - 0.697 * std::exp(-5.3e-4 * n)) : 0.0;
    sum += std::abs(row["axial_displacement_um"].get<double>() - published);
  }
  EXPECT_EQ(d["rows"].size(), 41u);
  EXPECT_LT(sum / 41.0, 0.133);
}

TEST_F(Displacement, ShowsACurve) {
  const Result r = raceway("displacement", "--speed 0:10000:5000");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out,
              StartsWith("Shaft position of 7014 in its arrangement, positive towards the "
                         "tool\npreload 600 N at standstill; the front set loses contact at "));
  EXPECT_THAT(r.out, HasSubstr("speed  position  front   rear  stiffness  torque   loss\n"));
  EXPECT_THAT(r.out, HasSubstr("\n    0    0.0000  600.0  600.0 "));
  EXPECT_THAT(r.out, HasSubstr("\n10000    5.4"));
}

TEST_F(Displacement, WritesAFileWithEveryBearing) {
  const std::string file = scratch_.file("k.csv");
  const Result r = raceway("displacement", "--speed 0:10000:2500 -o " + file);
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr(file + " written, 5 speeds\n"));
  const std::string csv = file_text(file);
  EXPECT_THAT(csv, StartsWith("# Shaft position against speed: 7014\n# raceway "));
  EXPECT_THAT(csv, HasSubstr("\n#| [arrangement]\n"));
  EXPECT_THAT(csv,
              HasSubstr("\nspeed_rpm,axial_displacement_um,front_force_N,rear_force_N,"
                        "axial_stiffness_N_um,friction_torque_Nmm,power_loss_W,"
                        "axial_position_um,front_1_axial_load_N,front_1_inner_contact_angle_deg,"));
  EXPECT_THAT(csv, HasSubstr(",rear_1_outer_ring_heat_W,status\n0,0,600,600,"));
  EXPECT_EQ(raceway("displacement", "--speed 0:10000:2500 -o -").out, csv);
  expect_refused(raceway("displacement", "--speed 0 -o " + file), "exists");
  EXPECT_EQ(raceway("displacement", "--speed 0 --force -o " + file).status, 0);
}

TEST_F(Displacement, JsonHasTheKeysOfTheContract) {
  const json d = parsed(raceway("displacement", "--speed 0,8000 --axial-load -100 --json"));
  const json& row = d["rows"][1];
  EXPECT_THAT(keys(row), IsSupersetOf({"speed_rpm", "axial_displacement_um", "front_force_N",
                                       "rear_force_N", "axial_stiffness_N_um", "bearings",
                                       "friction_torque_Nmm", "power_loss_W", "report"}));
  EXPECT_NEAR(row["front_force_N"].get<double>() - row["rear_force_N"].get<double>(), 100, 1e-6);
  ASSERT_EQ(row["bearings"].size(), 3u);
  const json& rear = row["bearings"][2];
  EXPECT_EQ(rear["place"], "rear_1");
  EXPECT_THAT(keys(rear),
              IsSupersetOf({"axial_load_N", "inner_contact_angle_deg", "outer_contact_angle_deg",
                            "inner_load_N", "outer_load_N", "inner_contact_pressure_MPa",
                            "outer_contact_pressure_MPa", "friction_torque_Nmm",
                            "inner_ring_heat_W", "outer_ring_heat_W", "minimum_load_N"}));
  EXPECT_NEAR(rear["axial_load_N"].get<double>(), row["rear_force_N"].get<double>(), 1e-9);
  EXPECT_NEAR(rear["inner_ring_heat_W"].get<double>() + rear["outer_ring_heat_W"].get<double>(),
              rear["power_loss_W"].get<double>(), 1e-9);
  EXPECT_THAT(keys(d["arrangement"]),
              IsSupersetOf({"preload_N", "front_lift_off_load_N", "rear_lift_off_load_N"}));
}

TEST_F(Displacement, WarnsOfTheSpeedWhereAMinimumLoadIsMissed) {
  const std::string spring =
      replaced(model_text + sets, "preload_N = 600", "mounting = \"spring\"\npreload_N = 600");
  const Result r = raceway("displacement", "--speed 0:12000:4000", spring);
  EXPECT_EQ(r.status, 0);
  // Z F_c tan(25 deg) grows with the speed squared and is 300 N near 6800 rpm.
  EXPECT_THAT(r.err, testing::ContainsRegex(
                         "warning: front_1, front_2: the load is below the minimum "
                         "load from 6[5-9][0-9][0-9] rpm on: 300 N instead of at least 300"));
  EXPECT_THAT(r.err,
              testing::ContainsRegex(
                  "warning: rear_1: the load is below the minimum load from 9[0-9]+ rpm on"));
  // The rigid sets load themselves.
  EXPECT_THAT(raceway("displacement", "--speed 0:12000:4000").err, Not(HasSubstr("minimum load")));
}

TEST_F(Displacement, WarnsOfLostContact) {
  const Result r = raceway("displacement", "--speed 0 --axial-load 2000");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("warning: front_1, front_2: no load, so the balls have no contact "
                               "with the inner ring from 0 rpm on\n"));
}

TEST_F(Displacement, SpeedsWithoutBalanceAreNamedAndEndInStatusTwo) {
  const std::string spring =
      replaced(model_text + sets, "preload_N = 600", "mounting = \"spring\"\npreload_N = 600");
  const Result r = raceway("displacement", "--speed 0,3000 --axial-load 900", spring);
  EXPECT_EQ(r.status, 2);
  EXPECT_THAT(
      r.err,
      HasSubstr("2 of 2 speeds have no value; the first is 0 rpm: no_equilibrium: the solver found "
                "no shaft position at which the bearing sets are in equilibrium"));
  const Result s = raceway("solve", "--speed 3000 --axial-load 900 --json", spring);
  EXPECT_EQ(s.status, 2);
  EXPECT_TRUE(parsed(s)["axial_displacement_um"].is_null());
  EXPECT_EQ(parsed(s)["report"]["status"], "no_equilibrium");
}

TEST_F(Displacement, SolveShowsTheSets) {
  const Result r = raceway("solve", "--speed 10000");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, StartsWith("7014 in its arrangement at 10000 rpm, external load 0 N, 40 C\n"));
  EXPECT_THAT(r.out, HasSubstr("\nfront_2 "));
  EXPECT_THAT(r.out, HasSubstr("\naxial displacement "));
  const json curve = parsed(raceway("displacement", "--speed 10000 --json"));
  const json one = parsed(raceway("solve", "--speed 10000 --json"));
  EXPECT_EQ(one["axial_displacement_um"], curve["rows"][0]["axial_displacement_um"]);
  EXPECT_EQ(one["bearings"], curve["rows"][0]["bearings"]);
}

TEST_F(Displacement, TableHasTheTorqueOfTheSetUnderItsOwnLoad) {
  const json t = parsed(raceway("table", "--speed 0:8000:4000 --axial-load -200,0 --json"));
  ASSERT_EQ(t["rows"].size(), 6u);
  const json s = parsed(raceway("solve", "--speed 8000 --axial-load -200 --json"));
  EXPECT_NEAR(t["rows"][2]["friction_torque_Nmm"].get<double>(),
              s["friction_torque_Nmm"].get<double>(), 1e-6);
  EXPECT_NEAR(t["rows"][2]["rear_1_axial_load_N"].get<double>(), s["rear_force_N"].get<double>(),
              1e-6);
  EXPECT_THAT(keys(t["rows"][0]),
              IsSupersetOf({"power_loss_W", "front_force_N", "front_2_friction_torque_Nmm",
                            "axial_displacement_um"}));
}

TEST_F(Displacement, IsComparedInMicrometres) {
  const std::string data = scratch_.write("u.csv", curve_text);
  const json c = parsed(raceway("compare", data + " --json"));
  EXPECT_EQ(c["quantity"], "axial_displacement");
  EXPECT_EQ(c["unit"], "um");
  EXPECT_EQ(c["rows"], 8);
  const json& worst = c["worst_rows"][0];
  const int row = worst["line"].get<int>() - 2;  // four speeds at each preload
  const json curve = parsed(raceway("displacement", "--speed 2000:8000:2000 --json",
                                    replaced(model_text + sets, "preload_N = 600",
                                             row < 4 ? "preload_N = 320" : "preload_N = 900")));
  const double predicted =
      curve["rows"][static_cast<std::size_t>(row % 4)]["axial_displacement_um"];
  EXPECT_NEAR(worst["predicted"].get<double>(), predicted, 1e-6);
  EXPECT_NEAR(worst["residual"].get<double>(), predicted - worst["measured"].get<double>(), 1e-6);
  const Result text = raceway("compare", data);
  EXPECT_THAT(text.out, HasSubstr("8 rows, axial displacement"));
  EXPECT_THAT(text.out, Not(HasSubstr("N mm")));
  EXPECT_THAT(text.out, HasSubstr("std_um is not given in every row"));
  const Result ladder =
      run("compare " + scratch_.file("my.toml") + " " + scratch_.file("my.toml") + " " + data);
  EXPECT_EQ(ladder.status, 0) << ladder.err;
  EXPECT_THAT(ladder.out, Not(HasSubstr("N mm")));
}

TEST_F(Displacement, IsCalibratedToAndWrittenBack) {
  // Two sweeps of a model whose groove conformity the other does not know.
  const std::string truth =
      replaced(replaced(model_text, "inner_conformity = 0.52", "inner_conformity = 0.53") + sets,
               "outer_conformity = 0.52", "outer_conformity = 0.53");
  std::string csv = "speed_rpm,preload_N,axial_displacement_um,std_um\n";
  for (const std::string preload : {"300", "1200"}) {
    const json d = parsed(raceway("displacement", "--speed 1000:10000:1000 --json",
                                  replaced(truth, "preload_N = 600", "preload_N = " + preload)));
    for (const json& row : d["rows"])
      csv += row["speed_rpm"].dump() + "," + preload + "," + row["axial_displacement_um"].dump() +
             ",0.01\n";
  }
  const std::string data = scratch_.write("u.csv", csv), fitted = scratch_.file("fitted.toml");
  const std::string model =
      model_text + sets + "\n[calibration]\nfree = [\"conformity\", \"preload_N\"]\n";
  const Result r = raceway("calibrate", data + " -o " + fitted, model);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("held: not identifiable")) << "the preload stands in the data";
  EXPECT_THAT(r.out, HasSubstr(" um before, "));
  EXPECT_THAT(r.err, HasSubstr("the readings do not depend on preload_N, which stays at 600 N"));
  const std::string text = file_text(fitted);
  EXPECT_THAT(text, HasSubstr("preload_N = 600\n"));
  EXPECT_THAT(text, Not(HasSubstr("conformity = 0.52\n")));
  const json c = parsed(raceway("calibrate", data + " --json", model));
  EXPECT_EQ(c["quantity"], "axial_displacement");
  EXPECT_EQ(c["unit"], "um");
  EXPECT_NEAR(c["parameters"]["conformity"]["value"].get<double>(), 0.53, 1e-5);
  EXPECT_LT(parsed(run("compare " + fitted + " " + data + " --json"))["rmse"].get<double>(), 1e-3);
}

TEST_F(Displacement, PreloadIsWrittenWhereItStands) {
  const std::string data =
      scratch_.write("u.csv",
                     "speed_rpm,axial_load_N,axial_displacement_um\n2000,-50,0.3\n5000,-50,1.9\n"
                     "8000,-50,4.4\n10000,0,6.1\n");
  const std::string fitted = scratch_.file("fitted.toml");
  const Result r = raceway("calibrate", data + " -o " + fitted);
  ASSERT_EQ(r.status, 0) << r.err;
  const json c = parsed(raceway("calibrate", data + " --json"));
  const std::string value = c["parameters"]["preload_N"]["value"].dump();
  EXPECT_THAT(file_text(fitted),
              StartsWith(replaced(model_text + sets, "preload_N = 600", "preload_N = " + value) +
                         "\n[calibration.covariance]"));
}

TEST_F(Displacement, CheckSaysWhatWasRead) {
  const std::string data = scratch_.write("u.csv", curve_text);
  const Result r = raceway("check", data);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("8 rows of axial displacement"));
  EXPECT_THAT(r.out, testing::ContainsRegex("preload_N +320.00 +900.00 +2"));
  EXPECT_THAT(r.out, HasSubstr("free parameter preload_N: these data do not determine it"));
  EXPECT_THAT(r.err, HasSubstr("no column axial_load_N: 0 N for all rows, from external_load_N of "
                               "[arrangement]"));
}

TEST_F(Displacement, WrongUseIsRefused) {
  expect_refused(raceway("displacement", "--speed 0", model_text),
                 ": the model has no [arrangement]; the shaft position needs this table with "
                 "layout, front, rear and preload_N");
  const std::string unmeasured = scratch_.write("d.csv", "speed_rpm,axial_load_N\n1000,100\n");
  for (const char* command : {"compare", "calibrate", "diagnose"}) {
    expect_refused(raceway(command, unmeasured),
                   "a measured column is missing: friction_torque_Nmm or axial_displacement_um");
    expect_refused(raceway(command, scratch_.write("u.csv", curve_text),
                           model_text + "\n[rig]\naxial_load_N = 0\n"),
                   "which needs a model with an [arrangement]");
  }
  expect_refused(raceway("solve", "--speed 0 --radial-load 50"),
                 "for a shaft, only --axial-load is possible");
  expect_refused(raceway("table", "--speed 0 --radial-load 50"),
                 "for a shaft, only --axial-load is possible");
  expect_refused(raceway("solve", "--speed 0 --axial-load -5", model_text),
                 "--axial-load = -5 N: must be from 0 to 100000000 N");
  expect_refused(raceway("displacement", "--speed 5:1:1"), "the end of a range");
  expect_refused(raceway("displacement", "--speed 0 --json -o -"),
                 "write to stdout; omit one of them");
}

}  // namespace
}  // namespace raceway::tests
