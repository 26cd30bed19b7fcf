// The document of a page of a record over time; how it is drawn is tested in tests/report.

#include "report/record_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "correction/alignment.h"
#include "files/correction_file.h"
#include "record/series_channel.h"
#include "report/report.h"
#include "report/report_columns.h"

namespace raceway::report {
namespace {

using Json = nlohmann::json;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

constexpr const char* model_text = R"([correction]
name = "z"
displacement = "displacement_z_um"
tolerance_um = 2

[[correction.channel]]
name = "spindle"
input = "nose_temperature_C"
reference = "base_temperature_C"
sections = [{ gain_um_K = 5, time_constant_s = 3000 }, { gain_um_K = -1, time_constant_s = 400 }]

[[correction.channel]]
name = "screw"
input = "x_feed_m_min"
sections = [{ gain_um_m_min = 0.5, time_constant_s = 900 }]

[[correction.effect]]
id = "slow-drift"
size_um = 3
time_constant_s = 20000
)";

using Of = std::function<double(double)>;

/// Rows at these times, with the displacement read at every third.
record::Record made(const std::vector<double>& time, const std::vector<double>& runs = {}) {
  record::Record record{.source = "day.csv"};
  record.set(record::time, time);
  if (!runs.empty()) {
    record.set(record::run, runs);
    record.runs = {"monday", "friday"};
  }
  const auto set = [&](const std::string& name, const Of& of) {
    const record::Channel& channel = *record::series_channel(name);
    std::vector<double> values;
    for (const double t : time) values.push_back(channel.to_SI(of(t)));
    record.set(channel, std::move(values));
  };
  set("nose_temperature_C", [](double t) { return 25 + 8 * std::sin(t / 5000); });
  set("base_temperature_C", [](double) { return 22; });
  set("hall_temperature_C", [](double t) { return 20 + t / 20000; });
  set("x_feed_m_min", [](double t) { return std::fmod(t, 6000) < 3000 ? 0 : 10; });
  set("displacement_z_um", [](double t) { return 40 * std::sin(t / 6000); });
  std::vector<double>& read = record.find(*record::series_channel("displacement_z_um"))->values;
  for (std::size_t k = 0; k < read.size(); ++k)
    if (k % 3 != 0) read[k] = unset;
  return record;
}

std::vector<double> evenly(std::size_t rows, double step) {
  std::vector<double> time;
  for (std::size_t k = 0; k < rows; ++k) time.push_back(static_cast<double>(k) * step);
  return time;
}

class RecordReport : public testing::Test {
 protected:
  void SetUp() override {
    if (!report_available()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  }

  /// The document in the page of the model above.
  static Json document(const record::Record& record) {
    const files::CorrectionFile file = files::parse_correction(model_text, "z.toml");
    const auto subject = correction::aligned(file.models.front(), record, correction::Zero::mean);
    const std::string page = record_report("compare", "{}", record, {{"z.toml", subject, {}, {}}});
    const std::string open = "id=\"document\">";
    const std::size_t begin = page.find(open) + open.size();
    return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  static std::vector<double> column(const Json& document, const std::string& name) {
    for (const Json& c : document["rows"]["columns"]) {
      if (c["name"] != name) continue;
      if (!c.contains("values"))
        return std::vector<double>(document["rows"]["rows"], c["constant"].get<double>());
      std::vector<double> values;
      for (const Json& v : c["values"]) values.push_back(v.is_null() ? unset : v.get<double>());
      return values;
    }
    ADD_FAILURE() << "no column " << name;
    return {};
  }
};

TEST_F(RecordReport, PartsAddUpToThePredictionButForOneConstant) {
  const Json d = document(made(evenly(900, 60)));
  const Json& model = d["models"][0];
  ASSERT_EQ(model["parts"].size(), 3U);
  EXPECT_EQ(model["parts"][0]["inputs"], Json({"nose_temperature_C", "base_temperature_C"}));
  EXPECT_EQ(model["parts"][2]["name"], "slow-drift");
  std::vector<double> rest = column(d, model["predicted"]);
  for (const Json& part : model["parts"]) {
    const std::vector<double> share = column(d, part["column"]);
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] -= share[k];
  }
  // Seven digits of each.
  EXPECT_THAT(rest, Each(DoubleNear(rest.front(), 1e-4)));
}

TEST_F(RecordReport, WhatWasNotReadIsNotOnThePage) {
  const Json d = document(made(evenly(900, 60)));
  const std::vector<double> read = column(d, d["models"][0]["measured"]);
  for (std::size_t k = 0; k < read.size(); ++k) EXPECT_EQ(std::isnan(read[k]), k % 3 != 0) << k;
}

TEST_F(RecordReport, APieceEndsBeforeEveryGapAndWithEveryRun) {
  std::vector<double> time = evenly(600, 60), runs(600, 0.0);
  for (std::size_t k = 200; k < 600; ++k) time[k] += 7200;  // a gap of two hours
  for (std::size_t k = 400; k < 600; ++k) runs[k] = 1.0;
  const Json d = document(made(time, runs));
  const std::vector<double> piece = column(d, "piece"), hours = column(d, "hours");
  EXPECT_EQ(piece[199], 0.0);
  EXPECT_EQ(piece[200], 1.0);
  EXPECT_EQ(piece[399], 1.0);
  EXPECT_EQ(piece[400], 2.0);
  EXPECT_FALSE(d["runs_in_sequence"]);
  EXPECT_NEAR(hours[599], time[599] / 3600, 1e-5);
}

TEST_F(RecordReport, RunsWhoseClocksBeginAnewStandOneAfterTheOther) {
  std::vector<double> time = evenly(600, 60), runs(600, 0.0);
  for (std::size_t k = 300; k < 600; ++k) time[k] = time[k - 300], runs[k] = 1.0;
  const Json d = document(made(time, runs));
  const std::vector<double> hours = column(d, "hours");
  EXPECT_TRUE(d["runs_in_sequence"]);
  EXPECT_TRUE(std::is_sorted(hours.begin(), hours.end()));
  EXPECT_GT(hours[300], hours[299]);
  EXPECT_EQ(column(d, "time_s")[300], 0.0);
}

TEST_F(RecordReport, EightPartsHoldAllReadings) {
  const Json d = document(made(evenly(900, 60)));
  const Json& parts = d["models"][0]["held_out_parts"];
  ASSERT_EQ(parts.size(), 8U);
  EXPECT_EQ(parts.front()["from_h"], 0.0);
  for (std::size_t k = 1; k < parts.size(); ++k)
    EXPECT_NEAR(parts[k]["from_h"].get<double>() - parts[k - 1]["to_h"].get<double>(), 60.0 / 3600,
                1e-5);
  EXPECT_NEAR(parts.back()["to_h"].get<double>(), 899 * 60.0 / 3600, 1e-5);
}

TEST_F(RecordReport, OfMoreRowsThanAPageHoldsTheExtremesAreKept) {
  record::Record record = made(evenly(250000, 1));
  const auto set = [&](const std::string& name, std::size_t row, double value) {
    const record::Channel& channel = *record::series_channel(name);
    record.find(channel)->values[row] = channel.to_SI(value);
  };
  // Rows that are not among those evenly spread, one spike in each column.
  const std::map<std::string, std::size_t> spikes{
      {"hall_temperature_C", 1003}, {"x_feed_m_min", 77778}, {"displacement_z_um", 150006}};
  for (const auto& [name, row] : spikes) set(name, row, 99.0);
  const Json d = document(record);
  EXPECT_LT(d["rows"]["rows"].get<std::size_t>(), ReportColumns::most_rows + 20000);
  EXPECT_EQ(d["rows"]["total"], 250000);
  const auto most = [&](const std::string& name) {
    double high = 0.0;
    for (const double v : column(d, name)) high = std::fmax(high, v);
    return high;
  };
  EXPECT_EQ(most("hall_temperature_C"), 99.0);
  EXPECT_EQ(most("x_feed_m_min"), 99.0);
  EXPECT_EQ(most("measured_displacement_z_um"), 99.0);
}

TEST_F(RecordReport, TellsWhatAStepOfEachInputDoes) {
  const Json d = document(made(evenly(900, 60)));
  const Json& responses = d["models"][0]["responses"];
  ASSERT_EQ(responses.size(), 3U);
  EXPECT_EQ(responses[0]["input"], "nose temperature less base temperature");
  EXPECT_NEAR(responses[0]["parts"][0]["gain"].get<double>(), 5.0, 1e-9);
  EXPECT_EQ(responses[0]["parts"][1]["time_constant_s"], 400.0);
  EXPECT_EQ(responses[1]["unit"], "m/min");
  EXPECT_NEAR(responses[1]["parts"][0]["gain"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(responses[2]["input"], "the start of the record");
}

TEST_F(RecordReport, SameInputsGiveTheSameBytes) {
  const record::Record record = made(evenly(500, 60));
  EXPECT_EQ(document(record).dump(), document(record).dump());
}

}  // namespace
}  // namespace raceway::report
