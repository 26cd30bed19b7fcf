// What pages show is tested in tests/report, in a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Report : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_reports()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  }
  ScratchFolder scratch_;
  std::string model_ = scratch_.write("my.toml", model_text);
  std::string data_ = scratch_.write("rig.csv", data_text);
  std::string shaft_ = tests::source_dir() + "/data/spindles/two_against_one.toml";
  std::string spindle_ = tests::source_dir() + "/data/spindles/small.toml";
  std::string page_ = scratch_.file("page.html");
};

constexpr const char* short_programme = "time_s,speed_rpm\n0,0\n1800,4000\n3600,0\n";

constexpr const char* moved_measurements =
    "speed_rpm,axial_displacement_um\n2000,0.2\n5000,1.9\n8000,4.1\n10000,5.4\n";

TEST_F(Report, IsWrittenBesideWhatTheCommandPrints) {
  const Result plain = run("compare " + model_ + " " + data_);
  const Result r = run("compare " + model_ + " " + data_ + " --report " + page_);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.out, plain.out);
  EXPECT_THAT(r.err, HasSubstr("page.html written"));
  EXPECT_THAT(file_text(page_), StartsWith("<!doctype html>"));
}

TEST_F(Report, ThatCannotBeWrittenIsRefusedBeforeTheWork) {
  const std::string old = scratch_.write("old.html", "old");
  for (const std::string& command :
       {"compare " + model_ + " " + data_, "diagnose " + model_ + " " + data_,
        "add " + model_ + " lubricant-drag --data " + data_,
        "table " + model_ + " --speed 0:1000:500 --axial-load 100",
        "displacement " + shaft_ + " --speed 0:1000:500",
        "compare " + shaft_ + " " + scratch_.write("u.csv", moved_measurements),
        "spindle " + spindle_ + " --speed 2000 --steady",
        "spindle " + spindle_ + " --speed-profile " + scratch_.write("p.csv", short_programme),
        "modes " + spindle_ + " --speed 2000", "step-response " + spindle_ + " --speed 2000",
        "deflection " + spindle_ + " --force 100"}) {
    expect_refused(run(command + " --report " + scratch_.file("no/such/page.html")),
                   ": cannot be written: this folder does not exist:");
    const char* const flag = command.starts_with("deflection") ? "--replace" : "--force";
    expect_refused(run(command + " --report " + old),
                   std::string("exists already; ") + flag + " replaces it");
  }
  EXPECT_EQ(file_text(old), "old");
}

TEST_F(Report, OfARecordOverTimeIsWrittenByEveryCommandThatTakesACorrection) {
  const std::string folder = tests::source_dir() + "/data/corrections/ambient/";
  const std::string model = folder + "correction.toml ", record = folder + "train.csv ";
  for (const std::string& command :
       {"compare " + model + record, "diagnose --no-pairs " + model + record,
        "add " + model + "ambient-drift --data " + record, "correct " + model + record}) {
    const Result r = run(command + "--report " + page_);
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr("page.html written"));
    EXPECT_NE(file_text(page_).find("\"kind\":\"record\""), std::string::npos) << command;
    expect_refused(run(command + "--report " + page_), "exists already; --force replaces it");
    EXPECT_EQ(run(command + "--force --report " + page_).status, 0);
    EXPECT_EQ(run("compare " + model + record + "--json").out,
              run("compare " + model + record + "--json --force --report " + page_).out);
    std::remove(page_.c_str());
  }
}

TEST_F(Report, OfADisplacementIsWrittenAndReplacedByForceAlone) {
  const std::string command = "compare " + shaft_ + " " +
                              scratch_.write("u.csv", moved_measurements) + " --report " + page_;
  EXPECT_EQ(run(command).status, 0);
  const std::string first = file_text(page_);
  EXPECT_NE(first.find("{\"name\":\"measured_um\""), first.npos);
  EXPECT_EQ(first.find("{\"name\":\"measured_Nmm\""), first.npos);
  expect_refused(run(command), "exists already; --force replaces it");
  scratch_.write("page.html", "of another day");
  EXPECT_EQ(run(command + " --force").status, 0);
  EXPECT_TRUE(file_text(page_) == first) << "other bytes";
}

TEST_F(Report, OfASpindleIsWrittenBesideWhatTheCommandPrints) {
  for (const std::string& command :
       {"spindle " + spindle_ + " --speed 2000:6000:2000 --steady",
        "spindle " + spindle_ + " --speed-profile " + scratch_.write("p.csv", short_programme),
        "modes " + spindle_ + " --speed 0:6000:2000",
        "step-response " + spindle_ + " --speed 2000:6000:2000"}) {
    const Result plain = run(command), r = run(command + " --report " + page_);
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_EQ(r.out, plain.out);
    EXPECT_THAT(r.err, HasSubstr("page.html written"));
    const std::string first = file_text(page_);
    expect_refused(run(command + " --report " + page_), "exists already; --force replaces it");
    EXPECT_EQ(run(command + " --json --force --report " + page_).out, run(command + " --json").out);
    EXPECT_TRUE(file_text(page_) == first) << "other bytes";
    std::remove(page_.c_str());
  }
}

TEST_F(Report, OfARecordOfASpindleIsThatOfARecordOverTime) {
  const std::string folder = tests::source_dir() + "/data/spindles/seats/";
  const std::string command = "compare " + folder + "model.toml " + folder + "test.csv --report ";
  const Result r = run(command + page_);
  EXPECT_EQ(r.status, 0) << r.err;
  const json page = page_document(page_);
  EXPECT_EQ(page["kind"], "record");
  ASSERT_EQ(page["models"].size(), 7u) << "the displacement and six sensors";
  EXPECT_EQ(page["models"][0]["unit"], "um");
  EXPECT_EQ(page["models"][6]["displacement"], "front_outer_ring_temperature_C");
  EXPECT_EQ(page["models"][6]["unit"], "C");
}

TEST_F(Report, OfARefusedEffectShowsWhy) {
  const std::string rig = tests::source_dir() + "/tests/hidden_effect/rigs/dev-08/";
  const Result r = run("add " + rig + "model.toml torque-time-drift --data " + rig +
                       "train.csv --json --report " + page_);
  const json d = parsed(r);
  ASSERT_TRUE(d["refused"]) << r.out;
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(file_text(page_), HasSubstr(d["reason"].get<std::string>().substr(0, 20)));
}

TEST_F(Report, DrawsMeasuredDisplacementOfAShaftAsItWasRead) {
  // Of a rig with three bearings a torque is shown per bearing; a shaft has one position.
  const std::string model =
      scratch_.write("shaft.toml", file_text(shaft_) + "\n[rig]\nbearings = 3\n");
  const std::string data =
      scratch_.write("u.csv",
                     "speed_rpm,axial_load_N,axial_displacement_um\n2000,0,0.2\n5000,0,1.9\n"
                     "8000,0,4.1\n10000,0,5.4\n");
  const Result r =
      run("table " + model + " --speed 0:10000:5000 --data " + data + " --report " + page_);
  ASSERT_EQ(r.status, 0) << r.err;
  const json columns = page_document(page_)["measured"]["rows"]["columns"];
  const auto measured = std::find_if(columns.begin(), columns.end(),
                                     [](const json& c) { return c["name"] == "measured_um"; });
  ASSERT_NE(measured, columns.end()) << columns;
  EXPECT_EQ((*measured)["values"], json({0.2, 1.9, 4.1, 5.4}));
}

TEST_F(Report, MeasuredPointsNeedAReportToBeDrawnIn) {
  expect_refused(run("table " + model_ + " --speed 0:1000:500 --axial-load 100 --data " + data_),
                 "--data needs --report FILE, because the data are drawn in the report");
}

}  // namespace
}  // namespace raceway::tests
