#include "report/report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/report_columns.h"
#include "tests/support/message_of.h"

namespace raceway::report {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::vector<double> rising(std::size_t rows) {
  std::vector<double> values;
  for (std::size_t i = 0; i < rows; ++i) values.push_back(static_cast<double>(i));
  return values;
}

TEST(ReportColumns, AreJsonWithSevenDigitsAndNullForWhatIsNotKnown) {
  ReportColumns columns(3);
  columns.add("speed_rpm", {1.0 / 3.0, unset, -0.0});
  columns.add("a\"<b>", {40.0, 40.0, 40.0});
  columns.add("unknown", {unset, unset, unset});
  const Json d = Json::parse(columns.json());
  EXPECT_EQ(d["total"], 3);
  EXPECT_EQ(d["rows"], 3);
  EXPECT_EQ(d["columns"][0]["values"], Json::parse("[0.3333333, null, 0]"));
  EXPECT_EQ(d["columns"][1]["name"], "a\"<b>");
  EXPECT_EQ(d["columns"][1]["constant"], 40.0);
  EXPECT_TRUE(d["columns"][2]["constant"].is_null());
}

TEST(ReportColumns, OfTooManyRowsSomeAreKeptEvenlySpreadAndThoseAskedFor) {
  constexpr std::size_t rows = 250000;
  ReportColumns columns(rows);
  columns.add("line", rising(rows));
  columns.keep(3);
  const Json d = Json::parse(columns.json());
  const std::vector<double> kept = d["columns"][0]["values"];
  EXPECT_EQ(d["total"], rows);
  EXPECT_EQ(d["rows"], kept.size());
  EXPECT_LE(kept.size(), ReportColumns::most_rows + 1);
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 3.0));
  for (std::size_t i = 1; i < kept.size(); ++i) ASSERT_LE(kept[i] - kept[i - 1], 3.0);
}

TEST(ReportColumns, MoreColumnsMakeFewerRows) {
  constexpr std::size_t rows = 60000;
  ReportColumns columns(rows);
  for (int k = 0; k < 50; ++k) columns.add(fmt::format("c{}", k), rising(rows));
  const Json d = Json::parse(columns.json());
  EXPECT_LE(d["rows"].get<std::size_t>() * 50, ReportColumns::most_numbers);
}

TEST(ReportColumns, RefuseAColumnOfAnotherLength) {
  ReportColumns columns(2);
  EXPECT_THROW(columns.add("x", {1.0}), std::invalid_argument);
}

TEST(Report, NoTextOfTheDocumentCanEndItsData) {
  if (!report_available()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  const Json document = {{"name", "</script><script>alert(1)</script><!-- & \u2028"}};
  const std::string page = report_page(document.dump());
  const std::string open = "id=\"document\">";
  const std::size_t begin = page.find(open) + open.size();
  const std::string data = page.substr(begin, page.find("</script>", begin) - begin);
  EXPECT_EQ(Json::parse(data), document);
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
}

TEST(Report, OfSeveralChannelsThePageDrawsTheFirstAndNamesTheOthers) {
  if (!report_available()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  record::Record record{.source = "d.csv", .columns = {}, .runs = {}, .lines = {}, .notes = {}};
  record.set(record::speed, rising(20));
  record.set(record::friction_torque, rising(20));
  record.set(record::axial_displacement, rising(20));
  record.find(record::friction_torque)->values[3] = unset;
  const std::vector<double> predicted(20, 1.0);
  std::vector<verdict::Comparison> channels;
  for (const record::Channel* c : {&record::friction_torque, &record::axial_displacement})
    channels.push_back(verdict::compare(predicted, record, {.channel = c}));
  const std::string page = comparison_report({"m.toml"}, {}, {channels}, record);
  const std::string open = "id=\"document\">";
  const std::size_t begin = page.find(open) + open.size();
  const Json d = Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(d["quantity"]["name"], "friction_torque");
  EXPECT_EQ(d["other_channels"], Json({"axial displacement"}));
  EXPECT_EQ(d["rows"]["total"], 19) << "rows in which the first was read";
  EXPECT_EQ(d["results"]["channels"].size(), 2u);
}

TEST(Report, ThePageAllowsItsOwnScriptAndStyleAlone) {
  if (!report_available()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  const std::string page = report_page("{}");
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'sha256-"));
  EXPECT_THAT(page, Not(HasSubstr("unsafe-")));
  EXPECT_THAT(page, Not(HasSubstr("@DOCUMENT@")));
}

}  // namespace
}  // namespace raceway::report
