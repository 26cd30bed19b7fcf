// What one line of the table of channels does: a new input is found wherever inputs are looked for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "effects/formula.h"
#include "files/data_file.h"
#include "files/subject.h"
#include "loop/loop.h"
#include "record/channel.h"
#include "report/detail/report_document.h"
#include "report/detail/report_rows.h"
#include "report/report.h"
#include "tests/support/synthetic.h"
#include "verdict/compare.h"

namespace raceway::files {
namespace {

using record::Channel;

constexpr int channel_rows = 32;

/// A file in which speed and one other input vary.
std::string file_with(const Channel& varied) {
  const bool further = !(varied == record::speed || varied == record::axial_load);
  std::string text = "speed_rpm,axial_load_N,friction_torque_Nmm";
  if (further) text += "," + std::string(varied.name);
  text += "\n";
  for (int row = 0; row < channel_rows; ++row) {
    const int level = row < channel_rows / 2 ? 30 : 50;
    text += fmt::format("{},{},{}", 1000 * (1 + row % 8),
                        varied == record::axial_load ? level : 500, 50 + row % 8);
    if (further) text += fmt::format(",{}", level);
    text += "\n";
  }
  return text;
}

class InputChannels : public testing::TestWithParam<const Channel*> {};

TEST_P(InputChannels, AreFoundWhereverInputsAreLookedFor) {
  const Channel& channel = *GetParam();
  const std::string name(channel.name);
  const auto subject = make_subject(fit::synthetic_model());
  const record::Record record = read_record({"d.csv", file_with(channel)}, *subject);
  ASSERT_TRUE(record.has(channel));
  EXPECT_TRUE(record.varies(channel));

  const loop::Check check = loop::check(*subject, record);
  EXPECT_TRUE(std::any_of(check.columns.begin(), check.columns.end(), [&](const auto& c) {
    return *c.channel == channel && c.levels > 1;
  })) << "not checked";

  const std::vector<verdict::Comparison> comparisons = verdict::compare(*subject, record);
  const std::vector<verdict::ErrorRange>& where = comparisons.at(0).where;
  EXPECT_GE(std::count_if(where.begin(), where.end(),
                          [&](const verdict::ErrorRange& r) { return *r.channel == channel; }),
            2)
      << "no place where the model fails";

  const std::vector<fit::Blocking> blockings = subject->blockings(record);
  EXPECT_TRUE(std::any_of(blockings.begin(), blockings.end(), [&](const auto& b) {
    return b.variable == channel.variable;
  })) << "not held out";

  const auto variables = effects::Formula::variables();
  EXPECT_TRUE(std::any_of(variables.begin(), variables.end(), [&](const auto& v) {
    return v.name == channel.name;
  })) << "in no formula";

  report::Document document("compare");
  report::ReportRows page(record, record::friction_torque,
                          report::rows_read(record, record::friction_torque));
  page.finish(document);
  const nlohmann::json shown = nlohmann::json::parse(document.text());
  EXPECT_NE(std::find(shown["inputs"].begin(), shown["inputs"].end(), name), shown["inputs"].end());
  const auto& columns = shown["rows"]["columns"];
  EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [&](const auto& c) {
    return c["name"] == name && c.contains("values");
  })) << "on no page";
}

std::vector<const Channel*> inputs() {
  std::vector<const Channel*> list;
  for (const Channel& channel : record::channels)
    if (channel.is_input()) list.push_back(&channel);
  return list;
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, InputChannels, testing::ValuesIn(inputs()),
                         [](const auto& one) { return std::string(one.param->name); });

}  // namespace
}  // namespace raceway::files
