// Documents of the loop: keys, lines, units and digits.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "results/diagnosis_results.h"
#include "results/results.h"

namespace raceway::results {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

/// Two sensors over speed and temperature, in lines 3, 5, 7, ...
record::Record two_sensors() {
  record::Record r{.source = "d.csv", .columns = {}, .runs = {}, .lines = {}, .notes = {}};
  std::vector<double> speed, temperature, torque, position;
  for (int row = 0; row < 20; ++row) {
    speed.push_back(record::speed.to_SI(1000 + 1000 * (row % 5)));
    temperature.push_back(record::temperature.to_SI(row < 10 ? 25.61 : 65.67));
    torque.push_back(0.05 + 0.001 * row);
    position.push_back(row == 4 ? unset : 1e-6 * row);
    r.lines.push_back(3 + 2 * row);
  }
  r.set(record::speed, speed);
  r.set(record::temperature, temperature);
  r.set(record::friction_torque, torque);
  r.set(record::axial_displacement, position);
  return r;
}

verdict::Comparison compared(const record::Channel& channel, double tolerance = unset) {
  const record::Record record = two_sensors();
  std::vector<double> predicted(record.rows(), 0.0);
  predicted[1] = unset;
  return verdict::compare(predicted, record, {.channel = &channel, .tolerance = tolerance});
}

std::set<std::string> keys(const Json& object) {
  std::set<std::string> result;
  for (const auto& [key, _] : object.items()) result.insert(key);
  return result;
}

TEST(Results, AComparisonOfOneChannelHasItAtTheTop) {
  const std::string text =
      comparison_json({"m.toml"}, {{compared(record::friction_torque)}}, two_sensors());
  const Json d = Json::parse(text);
  EXPECT_EQ(keys(d), (std::set<std::string>{"format", "model", "quantity", "unit", "rows",
                                            "rows_not_predicted", "rmse", "mae", "max_abs", "bias",
                                            "fit_percent", "noise", "lack_of_fit", "statement",
                                            "where", "worst_rows", "data", "notes", "said"}));
  EXPECT_EQ(d["quantity"], "friction_torque");
  EXPECT_EQ(d["unit"], "Nmm");
  EXPECT_EQ(d["rows_not_predicted"], Json({5}));
  EXPECT_EQ(d["worst_rows"][0]["line"], 41);
  EXPECT_EQ(keys(d["noise"]), (std::set<std::string>{"rms", "source"}));
  // Digits of an offset are no digits of a temperature.
  EXPECT_THAT(text, HasSubstr("\"from\": 65.67,"));
  EXPECT_THAT(text, HasSubstr("\"from\": 25.61,"));
  EXPECT_THAT(text, HasSubstr("\"to\": 5000.0,"));
}

TEST(Results, SeveralChannelsAreListedBelowTheFirst) {
  const Json d = Json::parse(comparison_json(
      {"m.toml"}, {{compared(record::friction_torque), compared(record::axial_displacement, 1e-5)}},
      two_sensors()));
  EXPECT_EQ(d["quantity"], "friction_torque");
  EXPECT_FALSE(d.contains("within_tolerance"));
  ASSERT_EQ(d["channels"].size(), 2u);
  EXPECT_EQ(d["channels"][0]["rmse"], d["rmse"]);
  const Json& position = d["channels"][1];
  EXPECT_EQ(position["quantity"], "axial_displacement");
  EXPECT_EQ(position["unit"], "um");
  EXPECT_EQ(position["rows"], 18) << "one was not read, one not predicted";
  EXPECT_NEAR(position["tolerance_um"].get<double>(), 10.0, 1e-12);
  EXPECT_EQ(position["within_tolerance"], false);
}

TEST(Results, NoiseThatWasEstimatedIsStated) {
  verdict::Comparison c = compared(record::friction_torque);
  c.noise = {};
  c.estimated_noise = 0.00125;
  const Json d = Json::parse(comparison_json({"m.toml"}, {{c}}, two_sensors()));
  EXPECT_TRUE(d["noise"]["rms"].is_null());
  EXPECT_EQ(d["noise"]["source"], "none");
  EXPECT_DOUBLE_EQ(d["noise"]["estimated_rms"].get<double>(), 1.25);
}

TEST(Results, ACalibrationHas15Digits) {
  verdict::Calibration c;
  c.parameters = {{.name = "f0", .unit = "1", .start = 1.5, .value = 2.0 / 3.0}};
  c.channels = {{&record::friction_torque, 0.0657, 0.0123}};
  c.rows_not_predicted = {0, 2};
  const std::string text = calibration_json(c, two_sensors());
  EXPECT_THAT(text, HasSubstr("\"value\": 0.666666666666667,"));
  const Json d = Json::parse(text);
  EXPECT_EQ(d["rows_not_predicted"], Json({3, 7}));
  EXPECT_DOUBLE_EQ(d["rmse_before"].get<double>(), 65.7);
  EXPECT_DOUBLE_EQ(d["rmse"].get<double>(), 12.3);
  EXPECT_FALSE(d.contains("channels"));
}

TEST(Results, ALikelihoodIsOfReadingsInTheUnitsOfTheDocument) {
  verdict::Calibration c;
  c.channels = {{&record::friction_torque, 0.0657, 0.0123, 20},
                {&record::axial_displacement, 2e-6, 1e-6, 19}};
  c.likelihood = {.readings = 39, .parameters = 2, .chi_square = 40.0, .log_determinant = -500.0};
  c.likelihood.deviance = -460.0;
  c.degrees_of_freedom = 37;
  const Json d = Json::parse(calibration_json(c, two_sensors()));
  // A reading in N mm is 1000 times as large a number, one in um a million times.
  const double shift = 2.0 * (20 * std::log(1e3) + 19 * std::log(1e6));
  EXPECT_NEAR(d["noise"]["log_determinant"].get<double>(), -500.0 + shift, 1e-9);
  EXPECT_NEAR(d["aic"].get<double>(), -460.0 + shift + 4.0, 1e-9);
  EXPECT_NEAR(d["bic"].get<double>(), -460.0 + shift + 2.0 * std::log(39.0), 1e-9);
  EXPECT_EQ(d["chi_square"], 40.0);
  EXPECT_EQ(d["readings"], 39);
  EXPECT_EQ(d["channels"][0]["readings"], 20);
  EXPECT_EQ(d["channels"][1]["readings"], 19);
  // Where only the size of the noise is unknown there are criteria all the same.
  c.likelihood.chi_square = c.likelihood.log_determinant = unset;
  const Json unknown = Json::parse(calibration_json(c, two_sensors()));
  EXPECT_TRUE(unknown["chi_square"].is_null() && unknown["noise"]["log_determinant"].is_null());
  EXPECT_EQ(unknown["aic"], d["aic"]);
}

TEST(Results, AnIntervalSaysAtWhichSideItIsOpen) {
  verdict::Calibration c;
  c.parameters = {{.name = "f0", .unit = "1", .start = 1.5, .value = 0.5},
                  {.name = "z", .unit = "1", .start = 1.5, .value = 1.5, .held = true}};
  c.channels = {{&record::friction_torque, 0.0657, 0.0123}};
  c.profile = {{.lower = 0.1, .upper = HUGE_VAL, .open_upper = true, .refits = 7}, {}};
  c.error_factor = 2.0;
  const Json d = Json::parse(calibration_json(c, two_sensors()));
  const Json& f0 = d["parameters"]["f0"]["profile"];
  EXPECT_EQ(f0["from"], 0.1);
  EXPECT_TRUE(f0["to"].is_null());
  EXPECT_EQ(f0["open_from"], false);
  EXPECT_EQ(f0["open_to"], true);
  EXPECT_EQ(d["parameters"]["f0"]["held"], false);
  EXPECT_EQ(d["parameters"]["z"]["held"], true);
  EXPECT_TRUE(d["parameters"]["z"]["profile"]["from"].is_null());
  EXPECT_EQ(d["profile"]["refits"], 7);
  EXPECT_NEAR(d["profile"]["rise"].get<double>(), 4.0 * 3.841459, 1e-5);
}

verdict::Diagnosis diagnosis() {
  verdict::Diagnosis d;
  verdict::ChannelDiagnosis channel{.baseline = compared(record::friction_torque)};
  channel.rmse_before = 0.01;
  channel.rmse_after = 0.002;
  channel.rmse_held_out_before = 0.011;
  d.channels = {channel};
  verdict::RankedEffect effect{.id = "lubricant-drag"};
  effect.rmse = {0.002};
  effect.rmse_held_out = {0.0025};
  effect.parameters = {{.name = "size", .unit = "N mm", .value = 40.0}};
  effect.base = {{.name = "f0", .unit = "1", .start = 2.0, .value = 1.5}};
  d.effects = {effect};
  d.suggested_measurements = {{.point = {{&record::speed, record::speed.to_SI(6000)},
                                         {&record::temperature, record::temperature.to_SI(65.67)},
                                         {&record::preload, unset}},
                               .words = "6000 rpm",
                               .separates = "a / b"}};
  d.outliers = {4, 1};
  d.hold_out = {{.variable = "speed", .rmse_before = {0.011}, .rmse_after = {0.003}}};
  d.shape = fit::Shape{.key = "torque_Nmm",
                       .formula = "c * speed_rpm^a",
                       .coefficients = {},
                       .statement = "most at high speed"};
  return d;
}

TEST(Results, ADiagnosisNamesPointsByTheirChannels) {
  const Json d = Json::parse(diagnosis_json("m.toml", two_sensors(), diagnosis()));
  EXPECT_THAT(keys(d), IsSupersetOf({"model", "data", "verdict", "unit", "rmse_before", "noise",
                                     "baseline", "hold_out", "outlier_lines"}));
  for (const char* key : {"quantity", "channels", "within_tolerance", "rmse_held_out_Nmm"})
    EXPECT_FALSE(d.contains(key)) << key;
  const Json& point = d["suggested_measurements"][0];
  EXPECT_EQ(point["speed_rpm"], 6000.0);
  EXPECT_EQ(point["temperature_C"], 65.67);
  EXPECT_TRUE(point["preload_N"].is_null());
  EXPECT_EQ(point["repeats"], 2);
  EXPECT_EQ(d["outlier_lines"], Json({5, 11}));
  EXPECT_EQ(d["shape"]["torque_Nmm"], "c * speed_rpm^a");
  EXPECT_EQ(d["baseline"]["data"], "d.csv");
  EXPECT_DOUBLE_EQ(d["hold_out"][0]["rmse_after"].get<double>(), 3.0);
  const Json& effect = d["effects"][0];
  EXPECT_DOUBLE_EQ(effect["rmse_cross_validated"].get<double>(), 2.5);
  EXPECT_EQ(effect["parameters"]["size"]["value"], 40.0);
  EXPECT_EQ(effect["base_parameters"]["f0"]["before"], 2.0);
  EXPECT_EQ(effect["base_parameters"]["f0"]["after"], 1.5);
}

TEST(Results, ADiagnosisWithAToleranceSaysWhatDecides) {
  verdict::Diagnosis d = diagnosis();
  d.channels[0].tolerance = 0.02;
  d.within_tolerance = true;
  d.significant_but_immaterial = {"lubricant-drag"};
  const Json j = Json::parse(diagnosis_json("m.toml", two_sensors(), d));
  EXPECT_DOUBLE_EQ(j["tolerance_Nmm"].get<double>(), 20.0);
  EXPECT_DOUBLE_EQ(j["rmse_held_out_Nmm"].get<double>(), 11.0);
  EXPECT_EQ(j["within_tolerance"], true);
  EXPECT_EQ(j["significant_but_immaterial"], Json({"lubricant-drag"}));
  EXPECT_DOUBLE_EQ(j["effects"][0]["rmse_held_out_Nmm"].get<double>(), 2.5);
}

TEST(Results, WhatAddBoughtHoldsItsCalibration) {
  verdict::AddResult r;
  r.channels = {
      {.before = compared(record::friction_torque), .after = compared(record::friction_torque)}};
  r.channels[0].rmse_held_out_after = 0.003;
  r.calibration.channels = {{&record::friction_torque, 0.01, 0.002}};
  const Json d = Json::parse(add_json("m.toml", two_sensors(), r));
  EXPECT_EQ(keys(d),
            (std::set<std::string>{"format", "model", "data", "refused", "reason", "gain", "unit",
                                   "before", "after", "rmse_held_out_before", "rmse_held_out_after",
                                   "hold_out", "calibration", "messages", "notes", "said"}));
  EXPECT_DOUBLE_EQ(d["rmse_held_out_after"].get<double>(), 3.0);
  EXPECT_DOUBLE_EQ(d["calibration"]["rmse"].get<double>(), 2.0);
  EXPECT_EQ(d["before"]["model"], "m.toml");
}

TEST(Results, ACheckListsColumnsInTheirUnits) {
  loop::Check check;
  check.rows = 20;
  check.measured = {{.channel = &record::friction_torque, .rows = 20, .noise = {}}};
  check.columns = {{.channel = &record::temperature,
                    .lower = record::temperature.to_SI(25.61),
                    .upper = record::temperature.to_SI(65.67),
                    .levels = 2}};
  check.catalogue = {
      {.id = "spin-friction", .ruled_out = "", .missing = "", .levels = ""},
      {.id = "torque-time-drift", .ruled_out = "", .missing = "time_s of every row", .levels = ""},
      {.id = "churning", .ruled_out = "another supply", .missing = "", .levels = ""}};
  const Json d =
      Json::parse(check_json("7014", check, {{.table = "a", .key = "b", .value = "1"}},
                             {record::note::left_out("b", {.file = "d.csv", .line = 3})}));
  EXPECT_EQ(keys(d), (std::set<std::string>{"format", "model", "quantity", "rows", "runs", "unit",
                                            "noise", "columns", "free_parameters", "effects",
                                            "defaults", "notes", "said"}));
  EXPECT_EQ(d["notes"], Json({"b"}));
  EXPECT_EQ(
      d["said"],
      Json::parse(
          R"([{"kind": "note", "code": "left-out", "text": "b", "file": "d.csv", "line": 3}])"));
  EXPECT_EQ(d["columns"][0]["name"], "temperature_C");
  EXPECT_EQ(d["columns"][0]["from"], 25.61);
  EXPECT_EQ(d["columns"][0]["to"], 65.67);
  EXPECT_EQ(d["effects"][0]["testable"], true);
  EXPECT_EQ(d["effects"][0]["ruled_out"], "");
  EXPECT_EQ(d["effects"][1]["missing"], "time_s of every row");
  EXPECT_EQ(d["effects"][2]["testable"], false);
  EXPECT_EQ(d["effects"][2]["ruled_out"], "another supply");
}

}  // namespace
}  // namespace raceway::results
