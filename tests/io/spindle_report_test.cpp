// The documents of the pages of a spindle; how they are drawn is tested in tests/report.

#include "io/spindle_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/model_file.h"
#include "tests/io/spindle_text.h"

namespace raceway::io {
namespace {

using nlohmann::json;
using testing::ElementsAre;

json document_of(const std::string& page) {
  const std::string open = "id=\"document\">";
  const std::size_t begin = page.find(open) + open.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

json column(const json& document, const std::string& name) {
  for (const json& c : document["rows"]["columns"])
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
                  .model = parse_model(tests::shortest_spindle, "my.toml").model,
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
  const json d = document_of(page_of(profile));
  EXPECT_EQ(d["kind"], "spindle_run");
  EXPECT_EQ(d["bearings"], json({"front_1", "front_2", "rear_1"}));
  EXPECT_EQ(d["inputs"], json({"speed_rpm", "coolant_on", "ambient_temperature_C", "axial_load_N",
                               "radial_load_N"}));
  for (const char* name : {"axial_displacement_um", "thermal_displacement_um", "front_force_N",
                           "heat_stored_W", "rear_1_inner_ring_temperature_C", "front_2_force_N"})
    EXPECT_EQ(column(d, name)["values"].size(), d["rows"]["rows"]) << name;
  const json& section = d["section"];
  const std::size_t cells = spindle::Simulator(of_.model).cells();
  EXPECT_EQ(section["cells"]["part"].size(), cells);
  for (const json& moment : section["moments"]) EXPECT_EQ(moment["temperature_C"].size(), cells);
  EXPECT_EQ(section["moments"].back()["time_s"], 3600.0);
  EXPECT_FALSE(section.contains("channel")) << "it has no coolant";
  // Of an O: the front set presses rearwards, the rear one forwards.
  std::vector<bool> rearwards;
  for (const json& b : section["bearings"]) rearwards.push_back(b["pressed_rearwards"]);
  EXPECT_THAT(rearwards, ElementsAre(true, true, false));
  EXPECT_EQ(section["bearings"][2]["position_mm"], 290.0);
}

TEST_F(SpindleReport, IsTheSameForTheSameInput) {
  const std::vector<spindle::ProfileRow> profile{{.time = 600, .inputs = {.speed = 4000 * rpm}}};
  EXPECT_TRUE(page_of(profile) == page_of(profile)) << "other bytes";
}

TEST_F(SpindleReport, OfASpeedWithoutSteadyStateHasNoNumbers) {
  std::vector<SteadyState> states(2);
  states[0].inputs.speed = 3000 * rpm;
  spindle::Simulator simulator(of_.model);
  states[0].moment = simulator.steady(states[0].inputs, states[0].report);
  states[1].inputs.speed = 9000 * rpm;
  states[1].report.status = spindle::Status::thermal_runaway;
  const json d = document_of(spindle_steady_report(of_, states, {}, {}, "cells"));
  EXPECT_FALSE(d.contains("section"));
  EXPECT_EQ(d["reports"][1]["status"], "thermal_runaway");
  EXPECT_TRUE(column(d, "friction_power_W")["values"][1].is_null());
  EXPECT_TRUE(column(d, "axial_displacement_um")["values"][1].is_null());
  EXPECT_GT(column(d, "friction_power_W")["values"][0], 10.0);
}

}  // namespace
}  // namespace raceway::io
