// The documents of the pages of a spindle; how they are drawn is tested in tests/report.

#include "report/spindle_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "files/model_file.h"
#include "report/beam_report.h"
#include "report/step_report.h"
#include "spindle/loaded_shaft.h"
#include "tests/files/spindle_text.h"

namespace raceway::report {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

Json document_of(const std::string& page) {
  const std::string open = "id=\"document\">";
  const std::size_t begin = page.find(open) + open.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

Json column_of_page(const Json& document, const std::string& name) {
  for (const Json& c : document["rows"]["columns"])
    if (c["name"] == name) return c;
  ADD_FAILURE() << "no column " << name;
  return {};
}

class SpindleReport : public testing::Test {
 protected:
  void SetUp() override {
    if (!report_available()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  }

  ModelOfPage of_{.file = "my.toml",
                  .model = files::parse_model(tests::shortest_spindle, "my.toml").model,
                  .defaults = {}};

  [[nodiscard]] std::string page_of(const std::vector<spindle::ProfileRow>& profile) const {
    spindle::Simulator simulator(of_.model);
    const spindle::Run run = simulator.simulate(profile);
    const spindle::DrawnRun drawn = spindle::drawn_run(simulator, profile, nullptr, run);
    std::vector<DrawnField> fields;
    for (const spindle::State& s : drawn.states)
      fields.push_back({.time = s.time, .speed = 0.0, .cells = simulator.field(s)});
    return spindle_run_report(of_, "day.csv", profile.size(), run, drawn, fields, {}, "cells");
  }
};

TEST_F(SpindleReport, OfARunHasTheSectionAndTheColumnsOfItsCsv) {
  const std::vector<spindle::ProfileRow> profile{
      {.time = 1800, .inputs = {.speed = 4000 * rpm, .ambient_temperature = kelvin(20)}},
      {.time = 3600, .inputs = {.speed = 0.0, .ambient_temperature = kelvin(22)}}};
  const Json d = document_of(page_of(profile));
  EXPECT_EQ(d["kind"], "spindle_run");
  EXPECT_EQ(d["bearings"], Json({"front_1", "front_2", "rear_1"}));
  EXPECT_EQ(d["inputs"], Json({"speed_rpm", "coolant_on", "ambient_temperature_C", "axial_load_N",
                               "radial_load_N", "moment_Nm"}));
  for (const char* name : {"axial_displacement_um", "thermal_displacement_um", "front_force_N",
                           "heat_stored_W", "rear_1_inner_ring_temperature_C", "front_2_force_N"})
    EXPECT_EQ(column_of_page(d, name)["values"].size(), d["rows"]["rows"]) << name;
  const Json& section = d["section"];
  const std::size_t cells = spindle::Simulator(of_.model).cells();
  EXPECT_EQ(section["cells"]["part"].size(), cells);
  for (const Json& moment : section["moments"]) EXPECT_EQ(moment["temperature_C"].size(), cells);
  EXPECT_EQ(section["moments"].back()["time_s"], 3600.0);
  EXPECT_FALSE(section.contains("channels")) << "it has no coolant";
  // Of an O: the front set presses rearwards, the rear one forwards.
  std::vector<bool> rearwards;
  for (const Json& b : section["bearings"]) rearwards.push_back(b["pressed_rearwards"]);
  EXPECT_THAT(rearwards, ElementsAre(true, true, false));
  EXPECT_EQ(section["bearings"][2]["position_mm"], 290.0);
}

TEST_F(SpindleReport, SectionHasTheChannelOfEachCircuit) {
  of_.model = files::parse_model(tests::with_circuit(), "my.toml").model;
  const Json d = document_of(page_of({{.time = 1800, .inputs = {.speed = 4000 * rpm}}}));
  const Json& channels = d["section"]["channels"];
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[0]["end_mm"], 180.0);
  EXPECT_EQ(channels[1]["start_mm"], 190.0);
  EXPECT_EQ(channels[1]["depth_mm"], 5.0);
  EXPECT_EQ(column_of_page(d, "heat_to_jacket_W")["values"].size(), d["rows"]["rows"]);
}

TEST_F(SpindleReport, IsTheSameForTheSameInput) {
  const std::vector<spindle::ProfileRow> profile{{.time = 600, .inputs = {.speed = 4000 * rpm}}};
  EXPECT_TRUE(page_of(profile) == page_of(profile)) << "other bytes";
}

TEST_F(SpindleReport, OfASpeedWithoutSteadyStateHasNoNumbers) {
  std::vector<results::SteadyState> states(2);
  states[0].inputs.speed = 3000 * rpm;
  spindle::Simulator simulator(of_.model);
  states[0].moment = simulator.steady(states[0].inputs, states[0].report);
  states[1].inputs.speed = 9000 * rpm;
  states[1].report.status = spindle::Status::thermal_runaway;
  const Json d = document_of(spindle_steady_report(of_, states, {}, {}, "cells"));
  EXPECT_FALSE(d.contains("section"));
  EXPECT_EQ(d["reports"][1]["status"], "thermal_runaway");
  EXPECT_TRUE(column_of_page(d, "friction_power_W")["values"][1].is_null());
  EXPECT_TRUE(column_of_page(d, "axial_displacement_um")["values"][1].is_null());
  EXPECT_GT(column_of_page(d, "friction_power_W")["values"][0], 10.0);
}

TEST_F(SpindleReport, OfModesHasTheRowsOfItsJsonAndShapesOfSlowestAndFastest) {
  spindle::SetsOfSpindle mounted(of_.model);
  const std::vector<double> places = spindle::bearing_places(*of_.model.spindle);
  const spindle::Beam beam(of_.model.spindle->shaft, places);
  std::vector<results::ModesAtSpeed> speeds(12);
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    results::ModesAtSpeed& m = speeds[k];
    m.speed = 1000.0 * static_cast<double>(k) * rpm;
    m.sets = mounted.at({.speed = m.speed}, false);
    m.springs = spindle::bearing_springs(mounted.arrangement(), places, m.sets.bearings);
    m.modes = spindle::find_modes(beam, m.springs, m.speed);
  }
  const Json d = document_of(modes_report(of_, mounted.arrangement(), beam, places, false, speeds));
  EXPECT_EQ(d["kind"], "modes");
  EXPECT_EQ(d["results"],
            Json::parse(results::campbell_json(mounted.arrangement(), speeds, of_.file)));
  ASSERT_EQ(d["shapes"].size(), 8u);
  EXPECT_EQ(d["shapes"].front()["speed_rpm"], 0.0);
  EXPECT_NEAR(d["shapes"].back()["speed_rpm"].get<double>(), 11000.0, 1e-9);
  for (const Json& mode : d["shapes"].back()["modes"]) {
    ASSERT_EQ(mode["y"].size(), beam.nodes().size());
    ASSERT_EQ(mode["z"].size(), beam.nodes().size());
  }
  EXPECT_EQ(d["shaft"]["pieces"].size(), 5u);
  EXPECT_EQ(d["shaft"]["pieces"].back()["end_mm"], d["nodes_mm"].back());
  EXPECT_EQ(d["shaft"]["bearings"][2]["position_mm"], 290.0);
}

TEST_F(SpindleReport, OfAShaftWithoutBalanceHasNoLine) {
  spindle::SetsOfSpindle mounted(of_.model);
  const std::vector<double> places = spindle::bearing_places(*of_.model.spindle);
  const spindle::Beam beam(of_.model.spindle->shaft, places);
  const results::DeflectionResult none{.force = 1e7, .sets = {}, .shaft = {}};
  const Json d =
      document_of(deflection_report(of_, mounted.arrangement(), beam, places, false, none, {}, {}));
  EXPECT_EQ(d["kind"], "deflection");
  EXPECT_TRUE(d["line"].empty());
  EXPECT_TRUE(d["results"]["displacement_um"].is_null());
}

/// K = 0.1 um/W P + 1 um, T = 10 min - 0.02 min/W P: zero at 500 W.
spindle::StepResponses steps_of(const std::vector<double>& powers) {
  spindle::StepResponses responses;
  for (const double power : powers) {
    spindle::StepResponse step{
        .speed = 1000 * rpm,
        .power_start = power,
        .power_end = power,
        .kinematic = 0.0,
        .end = 0.0,
        .front_force = 300.0,
        .highest_force = 300.0,
        .fit = {.one = {.gain = (0.1 * power + 1.0) * um, .time_constant = 600.0 - 1.2 * power},
                .rms = 0.0},
        .status = spindle::Status::converged};
    for (int k = 0; k < 50; ++k) {
      step.time.push_back(120.0 * k);
      step.displacement.push_back(displacement_at(step.fit.one, 120.0 * k));
    }
    responses.steps.push_back(std::move(step));
  }
  return responses;
}

TEST_F(SpindleReport, OfStepsDrawsLinesWhereTheyAreValidAlone) {
  const spindle::StepResponses responses = steps_of({100.0, 300.0, 480.0});
  const spindle::PowerLaws laws = spindle::fit_power_laws(at_powers(responses.steps));
  ASSERT_NEAR(laws.valid_to, 500.0, 1e-6);
  const Json d = document_of(
      step_report("fe.csv", responses, laws, {record::note::assumed("a note")}, nullptr, "", {}));
  EXPECT_EQ(d["kind"], "steps");
  EXPECT_EQ(d["results"]["notes"], Json({"a note"}));
  EXPECT_FALSE(d.contains("rows")) << "there is no programme";
  const Json& drawn = d["laws"];
  ASSERT_EQ(drawn["power_W"].size(), drawn["T_line_min"].size());
  for (std::size_t k = 0; k < drawn["power_W"].size(); ++k) {
    const double power = drawn["power_W"][k];
    EXPECT_EQ(drawn["T_line_min"][k].is_null(), power > 500.0) << power;
    if (power > 500.0) continue;
    EXPECT_NEAR(drawn["T_line_min"][k].get<double>(), 10.0 - 0.02 * power, 1e-4);
  }
  EXPECT_EQ(drawn["K_curve_um"][0], 0.0) << "no power, no way";
  EXPECT_TRUE(drawn["K_power_um"][0].is_null());
  EXPECT_EQ(d["courses"][2]["time_s"].size(), 50u);
}

}  // namespace
}  // namespace raceway::report
