#include <gmock/gmock.h>

#include <cmath>
#include <sstream>
#include <string>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// A machine of 6 um/K where the model believes 5, read every ten minutes for 30 h.
class CorrectLearn : public testing::Test {
 protected:
  CorrectLearn() {
    write("z.toml",
          "[correction]\ndisplacement = \"displacement_z_um\"\ntolerance_um = 1.0\n"
          "measurement_std_um = 0.1\n[[correction.channel]]\nname = \"spindle\"\n"
          "input = \"front_temperature_C\"  # at the nose\nfeedthrough_um_K = 5.0\n");
    write("day.csv", record(-1));
  }

  /// `wild`: the hour of a reading that is 80 um off.
  static std::string record(int wild) {
    std::ostringstream text;
    text << "time_s,front_temperature_C,displacement_z_um\n";
    for (int k = 0; k <= 180; ++k) {
      const double t = 600.0 * k, rise = 8.0 * std::sin(t / 8000.0);
      text << t << ',' << 20.0 + rise << ',' << 6.0 * rise + 40.0 + (k == 6 * wild ? 80.0 : 0.0)
           << '\n';
    }
    return text.str();
  }

  void write(const std::string& name, const std::string& text) { scratch_.write(name, text); }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  [[nodiscard]] Result learnt(const std::string& more, const std::string& data = "day.csv") const {
    return run("correct " + path("z.toml") + " " + path(data) + " --learn " + more);
  }
  ScratchFolder scratch_;
};

TEST_F(CorrectLearn, LearnsGainAndZeroAndSavesThem) {
  const json d = parsed(learnt("--every 2h --json --save " + path("learnt.toml")));
  EXPECT_EQ(d["readings_learnt"], 16);
  EXPECT_EQ(d["readings_refused"], 0);
  EXPECT_EQ(d["between_readings"]["readings"], 165);
  EXPECT_EQ(d["gains"][0]["name"], "spindle");
  EXPECT_NEAR(d["gains"][0]["value"].get<double>(), 0.2, 0.01);
  const json& error = d["between_readings"];
  EXPECT_LT(error["rmse_learnt_um"], 0.5 * error["rmse_last_zero_um"].get<double>());
  // The saved model has it, and all else of the file.
  const std::string saved = file_text(path("learnt.toml"));
  EXPECT_THAT(saved, HasSubstr("# at the nose"));
  const json plain =
      parsed(run("correct " + path("learnt.toml") + " " + path("day.csv") + " --json"));
  EXPECT_LT(plain["metrics"]["rmse_um"], 0.5);
  EXPECT_NEAR(plain["predicted_range_um"][1].get<double>(), 88.0, 1.0);
}

TEST_F(CorrectLearn, FileTextAndJsonSayTheSame) {
  const json d = parsed(learnt("--every 2h --json"));
  const std::string csv = learnt("--every 2h -o -").out;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time_s,predicted_um,std_um,residual_um,reading");
  int count = 0, offered = 0;
  double squares = 0.0;
  while (std::getline(lines, line)) {
    if (line.ends_with(",learnt")) {
      ++offered;
      continue;
    }
    std::istringstream cells(line);
    std::string cell;
    for (int k = 0; k < 4; ++k) std::getline(cells, cell, ',');
    squares += std::stod(cell) * std::stod(cell);
    ++count;
  }
  EXPECT_EQ(offered, d["readings_learnt"]);
  EXPECT_EQ(count, d["between_readings"]["readings"]);
  EXPECT_NEAR(std::sqrt(squares / count), d["between_readings"]["rmse_learnt_um"].get<double>(),
              1e-6);
  const std::string text = learnt("--every 2h").out;
  EXPECT_THAT(text, HasSubstr("spindle"));
  EXPECT_THAT(text, HasSubstr("165"));
}

TEST_F(CorrectLearn, NamesAWildReading) {
  write("wild.csv", record(14));
  const Result text = learnt("--every 2h", "wild.csv");
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.err, HasSubstr("line 86 (14 h)"));
  EXPECT_THAT(text.err,
              HasSubstr("was expected: the reading is rejected and not used for learning"));
  const json d = parsed(learnt("--every 2h --json", "wild.csv"));
  EXPECT_EQ(d["readings_refused"], 1);
  EXPECT_EQ(d["identification_due"], json::array());
  EXPECT_EQ(d["readings"][7]["learnt"], false);
  EXPECT_EQ(d["readings"][7]["line"], 86);
}

TEST_F(CorrectLearn, SaysWhatIsWrongWithItsFlags) {
  const std::string files = "correct " + path("z.toml") + " " + path("day.csv");
  const Result alone = run(files + " --every 4h");
  EXPECT_EQ(alone.status, 1);
  EXPECT_THAT(alone.err, HasSubstr("--every: only possible with --learn"));
  for (const char* const every : {"4", "4 mm", "h", "-1h", "0h", "nanh"}) {
    const Result r = run(files + " --learn --every '" + every + "'");
    EXPECT_EQ(r.status, 1) << every;
    EXPECT_THAT(r.err, HasSubstr("--every")) << every;
  }
  const Result onto = run(files + " --learn --force --save " + path("z.toml"));
  EXPECT_EQ(onto.status, 1);
  EXPECT_THAT(
      onto.err,
      HasSubstr(
          ": this run reads this file, so it cannot write to the same file; name another file"));
  write("none.csv", "time_s,front_temperature_C,displacement_z_um\n0,20,\n60,21,\n");
  const Result none = learnt("--save " + path("not.toml"), "none.csv");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("has no reading: there is nothing to learn from"));
  EXPECT_FALSE(std::filesystem::exists(path("not.toml")));
}

}  // namespace
}  // namespace raceway::tests
