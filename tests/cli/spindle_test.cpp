// raceway spindle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"
#include "text/number_text.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string coarse_cells = "\n[solver]\ncells = \"coarse\"\n";
const std::string programme_of_an_hour =
    "time_s,speed_rpm\n600,6000\n1200,6000\n1800,6000\n2400,6000\n3000,6000\n3600,6000\n";

class SpindleCommand : public testing::Test {
 protected:
  [[nodiscard]] Result spindle(const std::string& flags,
                               const std::string& text = base_spindle + coarse_cells) {
    return run("spindle " + scratch_.write("my.toml", text) + " " + flags);
  }
  [[nodiscard]] std::string profile(const std::string& text = programme_of_an_hour) {
    return " --speed-profile " + scratch_.write("day.csv", text) + " ";
  }
  ScratchFolder scratch_;
};

TEST_F(SpindleCommand, HeatOfASteadyStateGoesWhereItSays) {
  const json s = parsed(spindle("--speed 6000 --steady --json"))["steady"][0];
  EXPECT_EQ(s["report"]["status"], "converged");
  const double in = s["friction_power_W"].get<double>() + s["drive_heat_W"].get<double>();
  const double out = s["heat_to_coolant_W"].get<double>() + s["heat_to_air_W"].get<double>() +
                     s["heat_to_machine_W"].get<double>();
  EXPECT_GT(in, 100.0);
  EXPECT_NEAR(in, out, 1e-6 * in);
}

// The cooled housing shrinks onto the sets: 717 N cooled and 379 N uncooled in an independent
// model; the sets here are the same, the cells coarser.
TEST_F(SpindleCommand, CooledHousingRaisesTheForces) {
  const auto front = [&](const std::string& flags) {
    return parsed(spindle("--speed 6000 --steady --json " + flags))["steady"][0]["front_force_N"]
        .get<double>();
  };
  const double cooled = front(""), uncooled = front("--coolant off");
  EXPECT_NEAR(cooled, 717, 0.1 * 717);
  EXPECT_NEAR(uncooled, 379, 0.1 * 379);
}

TEST_F(SpindleCommand, ARoomInKelvinIsDoubted) {
  const auto said = [&](const std::string& temperature) {
    return spindle(profile("time_s,speed_rpm,ambient_temperature_C\n600,0," + temperature + "\n"))
        .err;
  };
  EXPECT_THAT(said("293.15"),
              HasSubstr("ambient_temperature_C = 293.15 C: the value is probably in kelvin"));
  EXPECT_THAT(said("20"), testing::Not(HasSubstr("kelvin")));
}

TEST_F(SpindleCommand, TextAndJsonOfASteadyStateAgree) {
  const json s = parsed(spindle("--speed 6000 --steady --json"))["steady"][0];
  const Result text = spindle("--speed 6000 --steady");
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, HasSubstr(fmt::format("forces of the bearing sets: front {:.4g} N, rear",
                                              s["front_force_N"].get<double>())));
  EXPECT_THAT(text.out, HasSubstr("cells; "));
  for (const json& surface : s["surfaces"])
    EXPECT_THAT(text.out, testing::ContainsRegex(fmt::format(
                              "\n{} +[0-9]+ +{} +- ", surface["name"].get<std::string>(),
                              text::number(surface["conductance_W_m2K"].get<double>(), 3))));
  EXPECT_GE(s["surfaces"].size(), 6u);
  const json& most = s["stress"]["largest"];
  EXPECT_THAT(text.out,
              HasSubstr(fmt::format("largest stress: {:.1f} MPa von Mises in the inner ring",
                                    most["von_mises_MPa"].get<double>())));
  double largest = 0.0;
  for (const json& section : s["stress"]["sections"])
    for (const json& at : section["at"])
      largest = std::max(largest, at["von_mises_MPa"].get<double>());
  EXPECT_EQ(largest, most["von_mises_MPa"].get<double>());
}

TEST_F(SpindleCommand, CircuitsHaveARowEachInTextJsonAndRun) {
  const std::string model = with_circuit() + coarse_cells;
  const json s = parsed(spindle("--speed 6000 --steady --json", model))["steady"][0];
  ASSERT_EQ(s["circuits"].size(), 2u);
  const json& jacket = s["circuits"][1];
  EXPECT_EQ(s["circuits"][0]["name"], "coolant");
  EXPECT_EQ(jacket["name"], "jacket");
  EXPECT_EQ(jacket["inlet_temperature_C"], 25.0);
  EXPECT_GT(jacket["velocity_m_s"].get<double>(), 1.0);
  EXPECT_EQ(jacket["outlet_temperature_C"], s["jacket_outlet_temperature_C"]);
  EXPECT_EQ(jacket["heat_W"], s["heat_to_jacket_W"]);
  const Result shown = spindle("--speed 6000 --steady", model);
  EXPECT_THAT(shown.out, testing::ContainsRegex(
                             fmt::format("jacket +25.00 +{} +{} ",
                                         text::number(jacket["outlet_temperature_C"].get<double>()),
                                         text::number(jacket["heat_W"].get<double>()))));
  const Result off = spindle("--speed 6000 --steady --coolant off", model);
  EXPECT_THAT(off.out, testing::ContainsRegex("jacket +25.00 +[0-9.]+ +0 +- +25.0 +- +-"));
  const std::string run_csv = scratch_.file("run.csv");
  const Result run = spindle(profile() + " -o " + run_csv, model);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(
      file_text(run_csv),
      HasSubstr("coolant_outlet_temperature_C,jacket_outlet_temperature_C,heat_to_jacket_W"));
}

// The jacket of the record has 29 °C at its inlet, its model 25 °C.
TEST_F(SpindleCommand, TheInletOfACircuitIsFittedAndCheckedByName) {
  const std::string sensors =
      "[[sensor]]\nname = \"rear\"\npart = \"housing\"\nposition_mm = 290\nradius_mm = 57\n"
      "[[sensor]]\nname = \"return\"\npart = \"coolant\"\nposition_mm = 299\n";
  const std::string believed = with_circuit() + sensors + coarse_cells;
  const std::string record = scratch_.file("run.csv");
  std::string programme = "time_s,speed_rpm\n0,0\n";
  for (int k = 1; k <= 60; ++k)
    programme += fmt::format("{},{}\n", 240 * k, k <= 20 ? 8000 : k <= 40 ? 3000 : 6000);
  ASSERT_EQ(spindle(profile(programme) + "-o " + record,
                    replaced(believed, "inlet_temperature_C = 25", "inlet_temperature_C = 29"))
                .status,
            0);
  const std::string model = scratch_.write("believed.toml", believed);
  const Result said = run("diagnose " + model + " " + record);
  EXPECT_THAT(said.out, HasSubstr("check the inlet temperature of circuit jacket, inlet 29"));
  const std::string better = scratch_.file("better.toml");
  ASSERT_EQ(run("add " + model + " coolant-inlet:jacket --data " + record + " -o " + better).status,
            0);
  EXPECT_THAT(file_text(better), testing::ContainsRegex("inlet_temperature_C = (29|28\\.9)"));
  const std::string free = believed + "[calibration]\nfree = [\"jacket.inlet_temperature_C\"]\n";
  const json fitted = parsed(run("calibrate " + scratch_.write("free.toml", free) + " " + record +
                                 " -o " + scratch_.file("fitted.toml") + " --json"))["parameters"];
  EXPECT_NEAR(fitted["jacket.inlet_temperature_C"]["value"].get<double>(), 29.0, 0.05);
}

TEST_F(SpindleCommand, ClampedFacesHaveTheirPressureInTextAndJson) {
  const std::string model = replaced(base_spindle, "outer_clearance_um = 4.0",
                                     "outer_clearance_um = 4.0\ninner_clamping_force_N = 8000") +
                            coarse_cells;
  const json surfaces =
      parsed(spindle("--speed 6000 --steady --json", model))["steady"][0]["surfaces"];
  const auto face = std::find_if(surfaces.begin(), surfaces.end(),
                                 [](const json& s) { return s["name"] == "front_1_inner_front"; });
  ASSERT_NE(face, surfaces.end());
  // 8000 N on the ring from 70 to 82 mm, by hand.
  EXPECT_NEAR((*face)["pressure_MPa"].get<double>(), 5.584, 0.001);
  EXPECT_NEAR((*face)["conductance_W_m2K"].get<double>(), 37116, 5);
  EXPECT_THAT(spindle("--speed 6000 --steady", model).out,
              testing::ContainsRegex("front_1_inner_front +1433 +37116 +5\\.58 "));
}

TEST_F(SpindleCommand, ListOfSpeedsHasARowForEach) {
  const json all = parsed(spindle("--speed 0:6000:3000 --steady --json"))["steady"];
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[0]["axial_displacement_um"].get<double>(), 0.0, 0.01);
  EXPECT_LT(all[1]["friction_power_W"].get<double>(), all[2]["friction_power_W"].get<double>());
}

TEST_F(SpindleCommand, RunHasARowForEachRowOfTheProgramme) {
  const Result r = spindle(profile() + "--json");
  const json d = parsed(r);
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_LT(d["report"]["energy_error"].get<double>(), 1e-10);
  ASSERT_EQ(d["rows"].size(), 6u);
  EXPECT_EQ(d["rows"][5]["time_s"], 3600.0);
  EXPECT_GT(d["rows"][5]["front_bearing_temperature_C"].get<double>(), 21.0);
  EXPECT_GE(d["highest_front_force"]["force_N"].get<double>(),
            d["rows"][5]["front_force_N"].get<double>());
}

TEST_F(SpindleCommand, CsvHasTheColumnsOfTheRun) {
  const Result r = spindle(profile() + "-o -");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out,
              HasSubstr("\ntime_s,speed_rpm,axial_displacement_um,kinematic_displacement_um,"
                        "thermal_displacement_um,front_force_N,rear_force_N,friction_power_W,"
                        "drive_heat_W,heat_to_coolant_W,heat_to_air_W,heat_to_machine_W,"
                        "heat_stored_W,front_bearing_temperature_C,shaft_end_temperature_C,"
                        "front_1_inner_ring_temperature_C,front_1_outer_ring_temperature_C,"
                        "front_1_force_N,front_1_radial_force_N,front_2_"));
}

TEST_F(SpindleCommand, StateGoesOnWhereItWasLeft) {
  const std::string state = scratch_.file("state.json");
  const std::string half = "time_s,speed_rpm\n600,6000\n1200,6000\n1800,6000\n";
  const std::string rest = "time_s,speed_rpm\n2400,6000\n3000,6000\n3600,6000\n";
  const json whole = parsed(spindle(profile() + "--json"))["rows"];
  ASSERT_EQ(spindle(profile(half) + "--end-state " + state).status, 0);
  const json second = parsed(spindle(profile(rest) + "--json --start " + state))["rows"];
  // Steps begin anew at the state, and with them their errors.
  EXPECT_NEAR(second[2]["shaft_end_temperature_C"].get<double>(),
              whole[5]["shaft_end_temperature_C"].get<double>(), 0.02);
}

TEST_F(SpindleCommand, FieldHasEverySolidPart) {
  const std::string field = scratch_.file("field.csv");
  ASSERT_EQ(spindle("--speed 6000 --steady --field " + field).status, 0);
  const std::string text = file_text(field);
  EXPECT_THAT(text, HasSubstr("\nposition_mm,radius_mm,part,temperature_C\n"));
  for (const char* part : {",shaft,", ",ring,", ",housing,"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(SpindleCommand, RowsBeforeTheEndAreWritten) {
  const std::string hot = "time_s,speed_rpm\n60,1000\n120,1000\n7200,60000\n";
  const Result r = spindle(profile(hot) + "--json");
  EXPECT_EQ(r.status, 2);
  const json d = json::parse(r.out);
  EXPECT_NE(d["report"]["status"], "converged");
  EXPECT_EQ(d["rows_asked"], 3);
  EXPECT_EQ(d["rows_reached"], 2);
  EXPECT_THAT(r.err, HasSubstr("the result has 2 of 3 rows"));
}

TEST_F(SpindleCommand, AnEarlyEndIsTheLastRowAndTerminalAndFilesAgreeOnIt) {
  const std::string hot = "time_s,speed_rpm\n60,1000\n7200,30000\n";
  const std::string csv = scratch_.file("run.csv"), state = scratch_.file("end.json");
  const Result r = spindle(profile(hot) + "--json -o " + csv + " --end-state " + state);
  EXPECT_EQ(r.status, 2);
  const json d = json::parse(r.out);
  EXPECT_EQ(d["report"]["status"], "thermal_runaway");
  ASSERT_EQ(d["rows"].size(), 2u);
  EXPECT_EQ(d["rows_reached"], 1);
  const double end = d["rows"][1]["time_s"];
  EXPECT_EQ(end, json::parse(file_text(state))["time_s"].get<double>());
  EXPECT_GT(end, 60.0);
  EXPECT_GT(d["rows"][1]["front_force_N"].get<double>(), 1000.0);
  EXPECT_THAT(file_text(csv), HasSubstr(fmt::format("\n{:.6g}", end).substr(0, 5)));
  const Result text = spindle(profile(hot));
  EXPECT_THAT(text.out, HasSubstr(fmt::format("ended early after {:.6g} s: thermal runaway", end)));
  EXPECT_THAT(text.out, HasSubstr(": 1 of 2 rows"));
}

TEST_F(SpindleCommand, HeatAtAPlaceComesInAndIsListed) {
  const std::string heated = base_spindle + coarse_cells +
                             "[[heat]]\nname = \"belt\"\nat = \"rear_1\"\nheat_W = 80\n"
                             "[[heat]]\nname = \"rotor\"\nat = \"motor\"\n"
                             "heat_W = \"0.05*motor_power_W\"\n";
  const json s =
      parsed(spindle("--speed 6000 --steady --motor-power 2000 --json", heated))["steady"][0];
  EXPECT_EQ(s["belt_heat_W"], 80.0);
  EXPECT_NEAR(s["rotor_heat_W"].get<double>(), 100.0, 1e-9);
  EXPECT_NEAR(s["drive_heat_W"].get<double>(), 180.0, 1e-9);
  // With the assumptions, the share of the heat of the belt among them.
  EXPECT_EQ(spindle("--speed 6000 --steady --motor-power 2000", heated).status, 0);
  const Result lacking = spindle("--speed 6000 --steady", heated);
  EXPECT_EQ(lacking.status, 1);
  EXPECT_THAT(lacking.err, HasSubstr("needs motor_power_W, which is not given"));
  const Result row = spindle(profile(), heated);
  EXPECT_EQ(row.status, 1);
  EXPECT_THAT(row.err, HasSubstr("column motor_power_W is missing"));
  const Result run = spindle(
      profile("time_s,speed_rpm,motor_power_W\n600,6000,1000\n1200,6000,3000\n") + "-o -", heated);
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr(",belt_heat_W,rotor_heat_W"));
}

TEST_F(SpindleCommand, TheAssumptionsThatMatterMostAreToldWithTheirSpread) {
  const json d = parsed(spindle("--speed 6000 --steady --assumptions --json"));
  const json& of = d["assumptions"];
  EXPECT_EQ(of["speed_rpm"], 6000.0);
  EXPECT_NEAR(of["axial_displacement_um"].get<double>(),
              d["steady"][0]["axial_displacement_um"].get<double>(), 1e-3);
  ASSERT_EQ(of["most"].size(), 5u);
  double before = 1e9;
  for (const json& one : of["most"]) {
    const double nose = of["axial_displacement_um"];
    const double moved = std::max(std::abs(one["displacement_at_less_um"].get<double>() - nose),
                                  std::abs(one["displacement_at_more_um"].get<double>() - nose));
    EXPECT_LE(moved, before);
    EXPECT_GT(one["spread"].get<double>(), 0.0);
    before = moved;
  }
  // One of them, held against the model with that number.
  const std::string name = of["most"][0]["name"];
  EXPECT_EQ(base_spindle.find(name.substr(name.find('.') + 1)), std::string::npos) << name;
  EXPECT_FALSE(parsed(spindle("--speed 6000 --steady --json")).contains("assumptions"));
  EXPECT_THAT(spindle("--speed 6000 --steady").out,
              HasSubstr("assumed numbers on the nose displacement (steady state at"));
}

TEST_F(SpindleCommand, NumbersMarkedAsAGuessAreAssumptions) {
  const auto assumed = [&](const std::string& comment) {
    const std::string text = replaced(base_spindle, "lubricant_conductance_W_K = 1.5",
                                      "lubricant_conductance_W_K = 1.5" + comment) +
                             coarse_cells;
    return parsed(spindle("--speed 6000 --steady --assumptions --json", text))["assumptions"];
  };
  const json stated = assumed(""), marked = assumed("  # assumed: that of a ball bearing");
  EXPECT_EQ(marked["assumed"].get<int>(), stated["assumed"].get<int>() + 1);
  const auto named = [](const json& of) {
    std::vector<std::string> names;
    for (const json& one : of["most"]) names.push_back(one["name"]);
    return names;
  };
  EXPECT_THAT(named(marked), testing::Contains("bearing.lubricant_conductance_W_K"));
  EXPECT_THAT(named(stated), testing::Not(testing::Contains("bearing.lubricant_conductance_W_K")));
}

TEST_F(SpindleCommand, TheFlowOfTheCoolantIsTold) {
  const std::string throttled =
      replaced(base_spindle, "flow_l_min", "throttle_diameter_mm = 3\nflow_l_min");
  const json s =
      parsed(spindle("--speed 6000 --steady --json", throttled + coarse_cells))["steady"][0];
  const json& flow = s["coolant"];
  EXPECT_GT(flow["velocity_m_s"].get<double>(), 0.1);
  EXPECT_GT(flow["film_W_m2K"].get<double>(), 500.0);
  EXPECT_GT(flow["pressure_drop_bar"].get<double>(), 0.001);
  EXPECT_GT(flow["throttle_pressure_drop_bar"].get<double>(), 0.001);
  EXPECT_THAT(spindle("--speed 6000 --steady", throttled + coarse_cells).out,
              HasSubstr(" bar at the throttle"));
  const json off = parsed(spindle("--speed 6000 --steady --coolant off --json"))["steady"][0];
  EXPECT_FALSE(off.contains("coolant"));
}

TEST_F(SpindleCommand, SeatsAndTheShaftToItsRearEndAreTold) {
  const json s = parsed(spindle("--speed 6000 --steady --json"))["steady"][0];
  const json& seats = s["seats"];
  ASSERT_EQ(seats.size(), 3u);
  EXPECT_EQ(seats[2]["bearing"], "rear_1");
  EXPECT_GT(seats[0]["on_shaft"]["pressure_MPa"], 0.0);
  EXPECT_GT(seats[0]["in_housing"]["conductance_W_m2K"], 1000.0);
  const json& shaft = s["shaft"];
  EXPECT_EQ(shaft.front()["position_mm"], 0.0);
  EXPECT_NEAR(shaft.front()["axial_displacement_um"].get<double>(),
              s["axial_displacement_um"].get<double>(), 1e-9);
  EXPECT_DOUBLE_EQ(shaft.back()["position_mm"], 375.0);
  const std::string text = spindle("--speed 6000 --steady").out;
  EXPECT_THAT(text, HasSubstr("seat     on shaft  conducts  in housing  conducts\n"));
  EXPECT_THAT(text, HasSubstr("rear end of the shaft relative to the flange: -"));
}

// A spindle whose roller bearing at the belt is hidden: `add` once ended at 0 W, its bound, where
// `calibrate` finds heat.
TEST_F(SpindleCommand, BeltHeatIsAddedAsItIsCalibrated) {
  const std::string truth =
      replaced(file_text(tests::source_dir() + "/data/spindles/case_study/model.toml"), "[solver]",
               "[[sensor]]\nname = \"belt\"\npart = \"shaft\"\nposition_mm = 365\n"
               "radius_mm = 29\n[solver]");
  const std::size_t roller = truth.find("[[shaft.roller_bearing]]"), end = truth.find("[housing]");
  const std::string believed = truth.substr(0, roller) +
                               "[[shaft.support]]\nposition_mm = 320\nradial_N_um = 680\n" +
                               truth.substr(end);
  const std::string record = scratch_.file("run.csv");
  std::string programme = "time_s,speed_rpm\n0,0\n";
  for (int k = 1; k <= 40; ++k)
    programme += fmt::format("{},{}\n", 600 * k, k <= 10 ? 2000 : k <= 25 ? 5000 : 3000);
  ASSERT_EQ(spindle(profile(programme) + "-o " + record, truth).status, 0);
  const json with_effect =
      parsed(run("add " + scratch_.write("believed.toml", believed) + " drive-heat --data " +
                 record + " -o " + scratch_.file("added.toml") + " --json"));
  const double added =
      with_effect["calibration"]["parameters"]["drive-heat.heat_at_10000_rpm_W"]["value"];
  const std::string with_heat =
      replaced(replaced(believed, "belt_force_N", "heat_W = \"0.01*speed_rpm\"\nbelt_force_N"),
               "free = [\"f0\"]", "free = [\"f0\", \"drive.heat_factor\"]");
  const json fitted = parsed(run("calibrate " + scratch_.write("heated.toml", with_heat) + " " +
                                 record + " -o " + scratch_.file("c.toml") + " --json"));
  const double calibrated = fitted["parameters"]["drive.heat_factor"]["value"];
  EXPECT_GT(added, 10.0);
  EXPECT_NEAR(added, 100.0 * calibrated, 0.02 * added);
}

TEST_F(SpindleCommand, ModelWithoutShaftIsRefused) {
  const Result r = spindle("--speed 1000 --steady", model_text);
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr(": the model is not a spindle; a spindle needs [shaft] and "
                               "[housing] in addition to [arrangement]"));
}

TEST_F(SpindleCommand, SpeedAloneIsRefused) {
  EXPECT_THAT(spindle("--speed 1000").err, HasSubstr("--speed needs --steady"));
}

TEST_F(SpindleCommand, StateOfOtherCellsIsRefused) {
  const std::string state = scratch_.file("state.json");
  ASSERT_EQ(spindle("--speed 3000 --steady --end-state " + state).status, 0);
  EXPECT_EQ(spindle(profile() + "--start " + state).status, 0);
  const Result r = spindle(profile() + "--start " + state, base_spindle);
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("another mesh"));
}

TEST_F(SpindleCommand, ARadialLoadInAProgrammeWarmsTheFrontBearings) {
  const auto friction = [&](const std::string& text) {
    const json rows = parsed(spindle(profile(text) + "--json"))["rows"];
    return rows.back()["friction_power_W"].get<double>();
  };
  const double idle = friction("time_s,speed_rpm\n1800,6000\n");
  const double loaded = friction("time_s,speed_rpm,radial_load_N\n1800,6000,1000\n");
  EXPECT_GT(loaded, 1.01 * idle);
  EXPECT_GT(friction("time_s,speed_rpm,radial_load_N,moment_Nm\n1800,6000,1000,100\n"), loaded);
  const Result refused = spindle(profile("time_s,speed_rpm,belt_force_N\n600,6000,800\n"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("belt_force_N: the model has no belt"));
  EXPECT_THAT(spindle(profile() + "--radial-load 300").err,
              HasSubstr("--axial-load, --radial-load, --moment, --belt-force and --motor-power "
                        "need --steady; with --speed-profile, use columns of the file"));
}

TEST_F(SpindleCommand, ARollerBearingAtTheBeltIsPrintedWithItsReaction) {
  const std::string model = source_dir() + "/data/spindles/belt_driven.toml";
  const Result said = run("spindle " + model + " --speed 6000 --steady");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("clearance"));
  EXPECT_THAT(said.out, HasSubstr("belt_end"));
  const json s = parsed(run("spindle " + model + " --speed 6000 --steady --json"))["steady"][0];
  EXPECT_GT(s["belt_end_radial_force_N"].get<double>(), 1000.0);
  EXPECT_LT(s["belt_end_clearance_um"].get<double>(), 15.0);
  EXPECT_GT(s["belt_end_friction_W"].get<double>(), 10.0);
  EXPECT_FALSE(s.contains("belt_end_force_N"));
  const json free =
      parsed(run("spindle " + model + " --speed 6000 --steady --belt-force 0 --json"))["steady"][0];
  EXPECT_NEAR(free["belt_end_radial_force_N"].get<double>(), 0.0, 1e-3);
  EXPECT_LT(free["friction_power_W"].get<double>(), s["friction_power_W"].get<double>());
  // Of the belt by rows, and of the shaft on both kinds of bearings.
  const std::string day =
      scratch_.write("belt.csv", "time_s,speed_rpm,belt_force_N\n600,6000,0\n1200,6000,2000\n");
  const json rows = parsed(run("spindle " + model + " --speed-profile " + day + " --json"))["rows"];
  EXPECT_NEAR(rows[0]["belt_end_radial_force_N"].get<double>(), 0.0, 1e-3);
  EXPECT_GT(rows[1]["belt_end_radial_force_N"].get<double>(), 1300.0);
  const json bent = parsed(run("deflection " + model + " --force 500 --json"));
  EXPECT_EQ(bent["roller_bearings"][0]["name"], "belt_end");
  EXPECT_GT(bent["roller_bearings"][0]["unloaded_radial_load_N"].get<double>(), 1000.0);
  const Result modes = run("modes " + model + " --speed 6000 --warm -o -");
  EXPECT_EQ(modes.status, 0) << modes.err;
  EXPECT_THAT(modes.out, HasSubstr("belt_end_radial_N_um"));
}

TEST_F(SpindleCommand, DisplacementWorksOnItsSets) {
  const Result r =
      run("displacement " + scratch_.write("sets.toml", base_spindle) + " --speed 6000");
  EXPECT_EQ(r.status, 0);
}

}  // namespace
}  // namespace raceway::tests
