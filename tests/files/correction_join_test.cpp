#include "files/correction_join.h"

#include <gmock/gmock.h>

#include "correction/numbers.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"
#include "text/error.h"

namespace raceway::files {
namespace {

using correction::MadeRecord;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string of_z = "[correction]\ndisplacement = \"displacement_z_um\"\n";

/// As step-response writes it, with a table beside it.
CorrectionFile spindle_part() {
  return parse_correction(
      of_z +
          "name = \"spindle\"\noffset_um = 0.5\n\n# by step responses\n[[correction.channel]]\n"
          "name = \"spindle\"\ninput = \"power_W\"\nfriction_table = \"torque.csv\"\n"
          "gain = { slope_um_W = 0.17, offset_um = 5.9 }\n"
          "time_constant = { slope_min_W = -0.06, offset_min = 33.9 }\n\n"
          "[correction.kinematic]\nA = 0.00115\nB = 0.6151\nC = 0.000634\n\n"
          "[correction.range]\nspeed_rpm = [0, 9000]\n",
      "spindle/part.toml",
      {{"torque.csv", "/data/torque.csv",
        "speed_rpm,friction_torque_Nmm\n0,100\n5000,200\n10000,300\n"}});
}

CorrectionFile machine_part(const std::string& more = "") {
  return parse_correction(of_z +
                              "name = \"machine\"\ntolerance_um = 2.0\noffset_um = -0.2\n\n"
                              "[[correction.channel]]\nname = \"x\"\ninput = \"x_feed_m_min\"\n"
                              "sections = [{ gain_um_m_min = 0.46, time_constant_s = 4200 }]\n\n"
                              "[[correction.effect]]\nid = \"ambient-drift\"\n"
                              "input = [\"room_1_temperature_C\", \"room_2_temperature_C\"]\n"
                              "gain_um_K = -3.0\ntime_constant_s = 7500\n" +
                              more,
                          "machine.toml");
}

CorrectionFile joined(std::vector<CorrectionFile> files) {
  JoinedCorrection sum = join_corrections(files, "");
  return parse_correction(std::move(sum.text), "sum.toml", std::move(sum.files));
}

std::vector<double> displacement(const CorrectionFile& file, const record::Record& record) {
  const correction::Series series(record);
  std::vector<double> u(series.rows());
  correction::simulate(file.models.front(), series, u);
  return u;
}

TEST(CorrectionJoin, TheSumMovesByWhatItsPartsMove) {
  MadeRecord made(40000, 120);
  made.with("speed_rpm", [](double t) { return correction::stepped_speed(t, 5000); })
      .with("x_feed_m_min", [](double t) { return t > 9000 ? 12.0 : 0.0; })
      .with("room_1_temperature_C", [](double t) { return 20 + std::sin(t / 9000); })
      .with("room_2_temperature_C", [](double t) { return 21 + std::cos(t / 9000); });
  const CorrectionFile spindle = spindle_part(), machine = machine_part();
  const std::vector<double> a = displacement(spindle, made.record),
                            b = displacement(machine, made.record),
                            sum = displacement(joined({spindle, machine}), made.record);
  double largest = 0.0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    EXPECT_NEAR(sum[k], a[k] + b[k], 1e-18);
    largest = std::max(largest, std::abs(sum[k]));
  }
  EXPECT_GT(largest, 10 * um);
}

TEST(CorrectionJoin, KeepsWhatThePartsSay) {
  const CorrectionFile sum = joined({spindle_part(), machine_part()});
  const correction::Model& m = sum.models.front();
  EXPECT_EQ(m.name, "spindle and machine");
  EXPECT_DOUBLE_EQ(m.offset, 0.3 * um);
  EXPECT_DOUBLE_EQ(m.tolerance, 2 * um);
  ASSERT_EQ(m.range.size(), 1U);
  EXPECT_DOUBLE_EQ(m.range[0].upper, 9000 * rpm);
  EXPECT_THAT(sum.text, HasSubstr("# by step responses\n[[correction.channel]]"));
  EXPECT_THAT(sum.text, HasSubstr("friction_table = \"/data/torque.csv\""));
  // The spindle stays near its step responses, by priors.
  EXPECT_THAT(correction::free_names(m),
              ElementsAre("offset", "spindle.scale", "x.gain_1", "x.time_constant_1", "kinematic.A",
                          "kinematic.B", "kinematic.C", "ambient-drift.gain",
                          "ambient-drift.time_constant_s"));
  ASSERT_EQ(m.priors.size(), 4U);
  EXPECT_EQ(m.priors[1].name, "kinematic.B");
  EXPECT_DOUBLE_EQ(m.priors[1].prior.value, 0.6151);
  EXPECT_DOUBLE_EQ(m.priors[1].prior.std, 0.1);
  // What a part says of its uncertainty, or fits itself, is its own.
  CorrectionFile stated = spindle_part();
  stated = parse_correction(
      stated.text + "[correction.prior]\n\"kinematic.A\" = { value = 0.001, std = 0.0001 }\n",
      stated.source, stated.files);
  EXPECT_EQ(joined({stated, machine_part()}).models.front().priors.size(), 1U);
  stated = spindle_part();
  stated = parse_correction(stated.text + "[calibration]\nfree = [\"kinematic\"]\n", stated.source,
                            stated.files);
  EXPECT_TRUE(joined({stated, machine_part()}).models.front().priors.empty());
}

TEST(CorrectionJoin, WhatCannotBeOneIsRefused) {
  const auto refused = [](const std::string& message) {
    return ThrowsMessage<text::InputError>(HasSubstr(message));
  };
  const auto join = [](std::vector<CorrectionFile> files) {
    return [files] { (void)join_corrections(files, "sum.toml"); };
  };
  EXPECT_THAT(join({spindle_part()}),
              refused("raceway join: only one file is given; name at least two corrections"));
  EXPECT_THAT(join({machine_part(), machine_part()}),
              refused("machine.toml: an earlier file also has a channel \"x\""));
  EXPECT_THAT(join({spindle_part(), machine_part("[correction.kinematic]\nA = 0.001\nB = 0.6\n"
                                                 "C = 0.0006\n")}),
              refused("also has [correction.kinematic]"));
  EXPECT_THAT(
      join({spindle_part(), machine_part("[correction.range]\nspeed_rpm = [9500, 9900]\n")}),
      refused("speed_rpm: the range of this input does not overlap"));
  EXPECT_THAT(
      join({spindle_part(),
            parse_correction("[correction]\ndisplacement = \"displacement_y_um\"\n", "y.toml")}),
      refused(
          "y.toml: corrects displacement_y_um, but spindle/part.toml corrects displacement_z_um"));
}

}  // namespace
}  // namespace raceway::files
