// Rows of a record as columns of a page.

#include "report/detail/report_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace raceway::report {
namespace {

using testing::ElementsAre;

record::Record measured(const record::Channel& channel) {
  record::Record r{.source = "d.csv", .columns = {}, .runs = {}, .lines = {}, .notes = {}};
  std::vector<double> speed, readings, one(12, 1.0), warm(12, record::temperature.to_SI(40));
  for (int row = 0; row < 12; ++row) {
    speed.push_back(record::speed.to_SI(1000 * row));
    readings.push_back(row == 3 ? unset : channel.to_SI(row));
    r.lines.push_back(row + 2);
  }
  r.set(record::speed, speed);
  r.set(record::axial_load, one);
  r.set(record::radial_load, one);
  r.set(record::temperature, warm);
  r.set(record::preload, std::vector<double>(12, unset));
  r.set(channel, readings);
  return r;
}

nlohmann::json page(const ReportRows& rows) {
  Document document("compare");
  rows.finish(document);
  return nlohmann::json::parse(document.text());
}

nlohmann::json column(const nlohmann::json& page, const std::string& name) {
  for (const auto& c : page["rows"]["columns"])
    if (c["name"] == name) return c.contains("values") ? c["values"] : c["constant"];
  return "no such column";
}

TEST(ReportRows, AreThoseThatWereRead) {
  const record::Record record = measured(record::friction_torque);
  ReportRows rows(record, record::friction_torque, rows_read(record, record::friction_torque));
  const nlohmann::json p = page(rows);
  EXPECT_EQ(p["rows"]["total"], 11);
  EXPECT_EQ(column(p, "line")[3], 6);
  EXPECT_EQ(column(p, "measured_Nmm")[3], 4.0);
  EXPECT_EQ(column(p, "temperature_C"), 40.0);
  EXPECT_EQ(p["inputs"],
            nlohmann::json({"speed_rpm", "axial_load_N", "radial_load_N", "temperature_C"}));
}

TEST(ReportRows, OfAShaftHaveThrustAloneAndTheLubricantWhereItVaries) {
  record::Record record = measured(record::axial_displacement);
  const auto inputs = [&] {
    return page(ReportRows(record, record::axial_displacement,
                           rows_read(record, record::axial_displacement)))["inputs"];
  };
  EXPECT_EQ(inputs(), nlohmann::json({"speed_rpm", "axial_load_N"}));
  record.find(record::temperature)->values[5] += 0.1;
  EXPECT_EQ(inputs(), nlohmann::json({"speed_rpm", "axial_load_N", "temperature_C"}));
}

TEST(ReportRows, OfAComparisonStandAtTheirPlace) {
  const record::Record record = measured(record::friction_torque);
  std::vector<double> predicted(12, 0.001);
  predicted[5] = unset;
  const verdict::Comparison c =
      verdict::compare(predicted, record, {.channel = &record::friction_torque});
  ReportRows rows(record, record::friction_torque, rows_compared(c));
  rows.add_std(std::vector<double>(rows.rows().size(), 0.002));
  rows.add_model("mine", c);
  const nlohmann::json p = page(rows);
  EXPECT_THAT(rows.rows(), ElementsAre(0, 1, 2, 4, 6, 7, 8, 9, 10, 11));
  EXPECT_EQ(column(p, "predicted_0_Nmm"), 1.0);
  EXPECT_EQ(column(p, "std_Nmm"), 2.0);
  const auto& map = p["models"][0]["map"];
  EXPECT_EQ(map["across_column"], "speed_rpm");
  EXPECT_EQ(map["up_column"], "axial_load_N");
  EXPECT_FALSE(map["cells"].empty());
}

}  // namespace
}  // namespace raceway::report
