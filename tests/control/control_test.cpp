// What `export` writes, run by Python and a C compiler, gives what the model gives here.
#include "control/table_reader.h"
#include "tests/control/control_case.h"

namespace raceway::control::control_test {
namespace {

using testing::HasSubstr;
using testing::Not;

INSTANTIATE_TEST_SUITE_P(Ways, Control, testing::Values(Way::python, Way::c, Way::single), name_of);

TEST_P(Control, GivesWhatCorrectGives) {
  const Case c(everything);
  const auto expected = c.corrected();
  const auto got = run(c, c.calls());
  EXPECT_LT(distance(got, expected), tolerance());
  // The record is one that moves, and goes beyond the friction table (250 rpm are within it).
  EXPECT_GT(expected[500][0] - expected[0][0], 10.0);
  EXPECT_EQ(got.front().flags & ~beyond_table, 0);
}

TEST_P(Control, GoesOnAfterARestartAsIfItWereAGap) {
  const Case c(everything);
  const auto through = run(c, c.calls());
  const auto restarted =
      run(c, c.calls(0, 250) + "restart\n" + c.calls(250, 300) + "restart\n" + c.calls(300));
  ASSERT_EQ(restarted.size(), through.size());
  for (std::size_t k = 0; k < through.size(); ++k) {
    EXPECT_EQ(restarted[k].displacements, through[k].displacements) << k;
    EXPECT_EQ(restarted[k].flags, through[k].flags) << k;
  }
}

TEST_P(Control, SaysThatAnInputIsBeyondItsRangeAndHoldsInstantParts) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\nfeedthrough_um_K = 2.0\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n[correction.kinematic]\n"
      "A = 1.28e-3\nB = 0.697\nC = 5.3e-4\n[correction.range]\nfront_temperature_C = [15, 40]\n"
      "speed_rpm = [0, 6000]\n";
  const Case c(model, "time_s,speed_rpm,front_temperature_C\n0,0,20\n100,6000,40\n");
  // The order of the inputs is that of the plan: temperature, speed.
  ASSERT_EQ(c.plan.inputs[0].column, "front_temperature_C");
  const auto got = run(
      c,
      "u 0 20 0\nu 1e6 40 6000\nu 2e6 40 9000\nu 3e6 50 -6000\nu 4e6 50 -12000\nu 5e6 40 6000\n");
  ASSERT_EQ(got.size(), 6u);
  const double at_6000 = 1.28e-3 * std::pow(6000, 1 - 0.697 * std::exp(-5.3e-4 * 6000));
  const double settled[] = {0.0, 100.0, 100.0, 150.0, 150.0, 100.0};  // linear goes on, no steeper
  const int flags[] = {0, 0, beyond_range, beyond_range, beyond_range, 0};
  for (std::size_t k = 1; k < 6; ++k) {
    // Straight from one call to the next: the section lags by tau times the slope.
    const double behind = (settled[k] - settled[k - 1]) * 600 / 1e6;
    EXPECT_NEAR(got[k].displacements[0], settled[k] - behind + 40.0 + at_6000, 1e-3) << k;
    EXPECT_EQ(got[k].flags, flags[k]) << k;
  }
}

/// Two lags of the speed with opposite gains, one of a power of it: neither is held while the other
/// goes on, so an overspeed does not turn the correction round. The power goes on along its
/// tangent.
TEST_P(Control, APowerOfTheSpeedGoesOnAlongItsTangent) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n" +
          std::string("[[correction.channel]]\nname = \"speed\"\ninput = \"speed_rpm\"\n"
                      "sections = [{ gain_um_rpm = 0.01, time_constant_s = 600 }]\n"
                      "[[correction.channel]]\nname = \"friction\"\ninput = \"speed_rpm\"\n"
                      "exponent = 1.5\n"
                      "sections = [{ gain_um_rpm = -0.005, time_constant_s = 600 }]\n"
                      "[correction.range]\nspeed_rpm = [0, 4000]\n"),
      "time_s,speed_rpm\n0,0\n100,4000\n");
  const auto got = run(c, "u 0 4000\nu 1e6 4000\nu 2e6 6000\nu 3e6 6000\n");
  ASSERT_EQ(got.size(), 4u);
  EXPECT_NEAR(got[1].displacements[0], 40.0 - 5.0 * 4.0 * 2.0, 1e-3);
  // 4 * 4^0.5 and 1.5 * 4^0.5 for each 1000 rpm above it.
  EXPECT_NEAR(got[3].displacements[0], 60.0 - 5.0 * (8.0 + 2.0 * 3.0), 1e-3);
  EXPECT_EQ(got[3].flags, beyond_range);
}

/// At rest nothing is moved by speed, though the model was found while it turned.
TEST_P(Control, RestIsNoEdgeOfARange) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[correction.kinematic]\n"
      "A = 1.28e-3\nB = 0.697\nC = 5.3e-4\n[correction.range]\nspeed_rpm = [2000, 6000]\n",
      "time_s,speed_rpm\n0,0\n100,6000\n");
  const auto got = run(c, "u 0 0\nu 10 1000\nu 20 2000\n");
  ASSERT_EQ(got.size(), 3u);
  const auto law = [](double n) {
    return n > 0 ? 1.28e-3 * std::pow(n, 1 - 0.697 * std::exp(-5.3e-4 * n)) : 0.0;
  };
  const double speeds[] = {0, 1000, 2000};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(got[k].displacements[0], law(speeds[k]), 1e-5) << k;
    EXPECT_EQ(got[k].flags, k < 2 ? beyond_range : 0) << k;
  }
}

/// Each input where it has stood before, and both where they never were together.
TEST_P(Control, SaysThatInputsStandTogetherAsNeverBefore) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n[[correction.channel]]\n"
      "name = \"room\"\ninput = \"room_temperature_C\"\n"
      "sections = [{ gain_um_K = 2.0, time_constant_s = 900 }]\n[correction.range]\n"
      "front_temperature_C = [20, 40]\nroom_temperature_C = [18, 26]\n[correction.together]\n"
      "columns = [\"front_temperature_C\", \"room_temperature_C\"]\nmean = [30, 22]\n"
      "std = [5, 2]\ncorrelation = [[1.0], [0.9, 1.0]]\nfarthest = 2.5\n",
      "time_s,front_temperature_C,room_temperature_C\n0,20,18\n100,40,26\n");
  ASSERT_EQ(c.plan.inputs[0].column, "front_temperature_C");
  // d² = zᵀ (R + 0.01 I)^-1 z: 2.05 along the diagonal, 6 across it.
  const auto got = run(c, "u 0 20 18\nu 10 40 26\nu 20 22 25\nu 30 38 19\nu 40 30 22\n");
  ASSERT_EQ(got.size(), 5u);
  const int flags[] = {0, 0, 64, 64, 0};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(got[k].flags, flags[k]) << k;
}

TEST_P(Control, KeepsTheLastValueOfAnInputThatIsNoNumber) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n";
  const Case c(model, "time_s,front_temperature_C\n0,20\n100,30\n");
  const auto got = run(c, "u 0 nan\nu 10 20\nu 20 30\nu 30 nan\nu 40 inf\nu 50 30\n");
  const auto same = run(c, "u 10 20\nu 20 30\nu 30 30\nu 40 30\nu 50 30\n");
  ASSERT_EQ(got.size(), 6u);
  ASSERT_EQ(same.size(), 5u);
  EXPECT_EQ(got[0].flags, no_value | 32);
  EXPECT_EQ(got[0].displacements[0], 0.0);
  const int flags[] = {0, 0, no_value, no_value, 0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(got[k + 1].displacements, same[k].displacements) << k;
    EXPECT_EQ(got[k + 1].flags, flags[k]) << k;
  }
}

TEST_P(Control, StandsStillWhereTheClockDoesNotGoOn) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"table_speed_rpm\"\n"
      "sections = [{ gain_um_rpm = 0.5, time_constant_s = 600 }]\n";
  const Case c(model, "time_s,table_speed_rpm\n0,20\n100,30\n");
  const auto got = run(c, "u 1000 20\nu 1600 20\nu 1600 20\nu 500 20\nu 1100 20\n");
  ASSERT_EQ(got.size(), 5u);
  const double once = 10 * (1 - std::exp(-1.0)), twice = 10 * (1 - std::exp(-2.0));
  const double expected[] = {0, once, once, once, twice};
  const int flags[] = {0, 0, clock_stood, clock_stood, 0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(got[k].displacements[0], expected[k], 1e-4) << k;
    EXPECT_EQ(got[k].flags, flags[k]) << k;
  }
}

TEST_P(Control, HoldsADelayElementAtAPowerThatItCannotTake) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = "
      "\"losses\"\n"
      "input = \"power_W\"\nfriction_table = \"friction.csv\"\naxial_load_N = 400\n"
      "temperature_C = 20\ngain = { slope_um_W = 0.5, offset_um = 10 }\n"
      "time_constant = { slope_min_W = -0.6, offset_min = 60 }\n";  // positive below 100 W
  const Case c(model, "time_s,speed_rpm\n0,3000\n100,3000\n");
  const auto got =
      run(c, "u 0 3000\nu 600 3000\nu 1200 9000\nu 1800 9000\nu 2400 3000\nu 3000 3000\n");
  ASSERT_EQ(got.size(), 6u);
  const int flags[] = {0, 0, beyond_element, beyond_element, 0, 0};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(got[k].flags, flags[k]) << k;
  const auto y = [&](std::size_t k) { return got[k].displacements[0]; };
  EXPECT_GT(y(1), 1.0);
  EXPECT_GT(y(2), y(1));  // the power of the call before holds
  EXPECT_EQ(y(3), y(2));
  EXPECT_EQ(y(4), y(2));
  EXPECT_GT(y(5), y(4));
}

/// Inputs that a control records: a power and a current drive lags, a load drives delay
/// elements at two speeds and at once, a feed by a delay element, an axis by a window.
const std::string by_recorded_columns =
    "[correction]\ndisplacement = \"displacement_z_um\"\n"
    "[[correction.channel]]\nname = \"power\"\ninput = \"spindle_power_W\"\n"
    "sections = [{ gain_um_W = 0.02, time_constant_s = 900 }]\n"
    "window = { column = \"x_position_mm\", points = [100, 200, 300, 500] }\n"
    "[[correction.channel]]\nname = \"current\"\ninput = \"motor_current_A\"\n"
    "sections = [{ gain_um_A = -0.3, time_constant_s = 400 }]\n"
    "[[correction.channel]]\nname = \"axial_at_once\"\ninput = \"axial_load_N\"\n"
    "feedthrough_um_N = -0.004\n"
    "[[correction.channel]]\nname = \"axial_3000\"\ninput = \"axial_load_N\"\n"
    "window = { column = \"speed_rpm\", points = [0, 3000, 3000, 8000], acts_on = \"input\" }\n"
    "gain = { table = \"K_F.csv\" }\ntime_constant = { table = \"K_F.csv\" }\nscale = 1.2\n"
    "[[correction.channel]]\nname = \"axial_8000\"\ninput = \"axial_load_N\"\n"
    "window = { column = \"speed_rpm\", points = [3000, 8000, inf, inf], acts_on = \"input\" }\n"
    "gain = { slope_um_N = 0.01, offset_um = 0.5 }\n"
    "time_constant = { slope_min_N = 0.004, offset_min = 12 }\n"
    "[[correction.channel]]\nname = \"feed\"\ninput = \"x_feed_m_min\"\n"
    "gain = { factor = 0.6, exponent = 0.8 }\ntime_constant = { factor = 20, exponent = -0.1 }\n";

std::string record_of_columns() {
  std::string text =
      "time_s,speed_rpm,spindle_power_W,motor_current_A,axial_load_N,x_feed_m_min,x_position_mm\n";
  double t = 0.0;
  for (int k = 0; k < 600; ++k) {
    t += 20.0 + 15.0 * std::sin(1.0 * k * k);
    const double speed = std::vector{0.0, 3000.0, -5500.0, 9000.0}[k / 40 % 4];
    text += fmt::format("{:.3f},{},{:.1f},{:.2f},{:.0f},{},{:.1f}\n", t, speed,
                        400 + 300 * std::sin(k / 30.0), 8 + 5 * std::cos(k / 17.0),
                        900 * std::sin(k / 23.0), k % 70 < 20 ? 0.0 : -9.0,
                        300 + 280 * std::sin(k / 11.0));
  }
  return text;
}

TEST_P(Control, RecordedColumnsDriveLagsAndDelayElements) {
  const Case c(by_recorded_columns, record_of_columns());
  EXPECT_EQ(c.plan.axes[0].elements.size(), 3u);
  EXPECT_LT(distance(run(c, c.calls()), c.corrected()), tolerance());
  const ControlPlan again = read_control_table(control_csv(c.plan), "table.csv");
  EXPECT_EQ(control_python(again), control_python(c.plan));
  EXPECT_EQ(control_c(again, "correction"), control_c(c.plan, "correction"));
}

/// Friction over speed, both loads and temperature heats the spindle at the loads of the record.
std::string friction_over_loads() {
  std::string table = "speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm\n";
  for (const int T : {20, 60})
    for (const int radial : {0, 400, 1000})
      for (const int axial : {0, 300, 800})
        for (const int n : {0, 3000, 9000})
          table += fmt::format("{},{},{},{},{}\n", n, axial, radial, T,
                               20 + 0.02 * n * 20 / T + 0.1 * axial + 0.00005 * radial * axial);
  return table;
}
const std::string by_friction_over_loads =
    "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = "
    "\"spindle\"\ninput = \"power_W\"\nfriction_table = \"loads.csv\"\n"
    "axial_load_N = \"axial_load_N\"\nradial_load_N = \"cutting_N\"\n"
    "temperature_C = \"oil_temperature_C\"\n"
    "gain = { slope_um_W = 0.17, offset_um = 6 }\n"
    "time_constant = { slope_min_W = -0.02, offset_min = 34 }\n"
    "[[correction.channel]]\nname = \"axial\"\ninput = \"power_W\"\n"
    "friction_table = \"loads.csv\"\naxial_load_N = \"axial_load_N\"\nradial_load_N = 250\n"
    "temperature_C = 31\nsections = [{ gain_um_W = 0.1, time_constant_s = 900 }]\n";

TEST_P(Control, ReadsAFrictionTableAtRecordedLoads) {
  std::string record = "time_s,speed_rpm,axial_load_N,cutting_N,oil_temperature_C\n";
  for (int k = 0; k < 500; ++k)
    record += fmt::format("{},{},{:.1f},{:.1f},{:.2f}\n", 30 * k + k % 11,
                          std::vector{0, 3000, -5500, 9500}[static_cast<std::size_t>(k / 40 % 4)],
                          500 * std::sin(k / 23.0), 600 + 700 * std::sin(k / 31.0),
                          40 + 25 * std::sin(k / 60.0));
  const Case c(by_friction_over_loads, record, {{"loads.csv", friction_over_loads()}});
  const auto expected = c.corrected();
  const auto got = run(c, c.calls());
  EXPECT_LT(distance(got, expected), tolerance());
  double high = 0;
  for (const auto& y : expected) high = std::max(high, y[0]);
  EXPECT_GT(high, 20.0);
  EXPECT_TRUE(
      std::any_of(got.begin(), got.end(), [](const Answer& a) { return a.flags & beyond_table; }));
  const std::string table = control_csv(c.plan);
  EXPECT_THAT(table, HasSubstr(",axial_load_input,axial_load_N,\n"));
  EXPECT_THAT(table, HasSubstr(",torque at 3000 rpm 300 N axial 400 N radial 20 C,116,N mm\n"));
  const ControlPlan again = read_control_table(table, "table.csv");
  EXPECT_EQ(control_csv(again), table);
  EXPECT_EQ(control_python(again), control_python(c.plan));
  EXPECT_EQ(control_c(again, "correction"), control_c(c.plan, "correction"));
}

TEST_P(Control, HoldsADelayElementAtALoadThatItCannotTake) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = "
      "\"axial\"\ninput = \"axial_load_N\"\ngain = { slope_um_N = 0.01, offset_um = 0 }\n"
      "time_constant = { slope_min_N = 0.02, offset_min = 10 }\n",  // positive above -500 N
      "time_s,axial_load_N\n0,100\n100,100\n");
  const auto got = run(c, "u 0 -400\nu 600 -600\nu 1200 -600\nu 1800 100\nu 2400 100\n");
  ASSERT_EQ(got.size(), 5u);
  const int flags[] = {0, beyond_element, beyond_element, 0, 0};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(got[k].flags, flags[k]) << k;
  EXPECT_NEAR(got[1].displacements[0], -4.0 * (1 - std::exp(-600.0 / 120.0)), 1e-4);
  EXPECT_EQ(got[2].displacements[0], got[1].displacements[0]);
  EXPECT_EQ(got[3].displacements[0], got[1].displacements[0]);
  EXPECT_GT(got[4].displacements[0], got[3].displacements[0]);
}

// The published transfer function of one pole, and one of two: sections at their own sampling.
TEST_P(Control, TurnsPolynomialsIntoSections) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = "
      "10\n[[correction.channel]]\n"
      "name = \"published\"\ninput = \"front_temperature_C\"\nnumerator = [4.30702, -4.28923]\n"
      "denominator = [1, -0.9984]\nscale = 0.9\n[[correction.channel]]\nname = \"two\"\n"
      "input = \"room_temperature_C\"\nnumerator = [0, 0.02, -0.018]\n"
      "denominator = [1, -1.98, 0.9801]\n";  // (1 - 0.99/z)^2: no sections, below
  const std::string apart =
      std::string(model).replace(model.find("-1.98, 0.9801"), 13, "-1.985, 0.98505");
  std::string record = "time_s,front_temperature_C,room_temperature_C\n";
  for (int k = 0; k < 1000; ++k)
    record += fmt::format("{},{:.2f},{:.2f}\n", 10 * k, 22 + 8 * std::sin(k / 90.0),
                          20 + std::sin(k / 200.0));
  const Case c(apart, record);
  EXPECT_EQ(c.plan.axes[0].sections.size(), 3u);
  EXPECT_LT(distance(run(c, c.calls()), c.corrected()), tolerance());
  EXPECT_THAT(c.plan.notes,
              testing::Contains(HasSubstr(": the polynomials were converted to 2 sections")));
  const Case twice(model, record);
  EXPECT_EQ(twice.plan.axes[0].equations.size(), 1u);
  EXPECT_LT(distance(run(twice, twice.calls()), twice.corrected()), tolerance());
}

/// Published functions of a five-axis machine whose poles belong to no lag, one that swings, and
/// one with an integrator that is cancelled on paper.
const std::string printed_model =
    "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 1\n"
    "[[correction.channel]]\nname = \"amb\"\ninput = \"room_temperature_C\"\n"
    "numerator = [0.0174675, -0.0174683]\n"
    "denominator = [1, -1.0074457, -0.9830456, 0.99049153]\n"
    "[[correction.channel]]\nname = \"x\"\ninput = \"front_temperature_C\"\n"
    "numerator = [0.000870091]\ndenominator = [1, 0.000296341, -0.9995287]\n"
    "[[correction.channel]]\nname = \"y\"\ninput = \"rear_temperature_C\"\nscale = 0.9\n"
    "reference = \"room_temperature_C\"\nnumerator = [0.0557978, -0.0073149, -0.0481798]\n"
    "denominator = [1, -0.1719017, -0.8278259]\n"
    "[[correction.channel]]\nname = \"swings\"\ninput = \"speed_rpm\"\n"
    "numerator = [0, 2e-6]\ndenominator = [1, -1.98, 0.9802]\n"
    "[[correction.channel]]\nname = \"cancelled\"\ninput = \"room_temperature_C\"\n"
    "numerator = [-0.0251, 0.0251]\ndenominator = [1, -1.9985, 0.9985]\n";

std::string printed_record(int rows) {
  std::string text = "time_s,speed_rpm,front_temperature_C,rear_temperature_C,room_temperature_C\n";
  for (int k = 0; k < rows; ++k)
    text += fmt::format("{},{},{:.1f},{:.1f},{:.1f}\n", k, 1000 * (k / 300 % 4),
                        22 + 8 * std::sin(k / 900.0), 21 + 5 * std::sin(k / 700.0),
                        20 + std::sin(k / 2000.0));
  return text;
}

TEST_P(Control, RunsPolynomialsOfNoLagAsDifferenceEquations) {
  const Case c(printed_model, printed_record(4000));
  EXPECT_EQ(c.plan.axes[0].equations.size(), 4u);
  EXPECT_EQ(c.plan.axes[0].sections.size(), 1u);  // the cancelled one is a lag
  const auto got = run(c, c.calls());
  const auto expected = c.corrected();
  EXPECT_LT(distance(got, expected), tolerance());
  double largest = 0.0;
  for (const auto& y : expected) largest = std::max(largest, std::abs(y[0]));
  EXPECT_GT(largest, 10.0);
  for (const Answer& a : got) ASSERT_EQ(a.flags, 0);
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr(
                                "channel x: exported as a difference equation, because the "
                                "pole -0.9999125037 is not between 0 and 1")));
  EXPECT_THAT(c.plan.warnings, testing::ElementsAre(HasSubstr("channel amb: negative real pole"),
                                                    HasSubstr("channel x: negative real pole"),
                                                    HasSubstr("channel y: negative real pole"),
                                                    HasSubstr("channel swings: complex poles")));
}

/// Columns with a sign, and windows of a position: of what drives, and of what is felt.
TEST_P(Control, RunsRecordedColumnsAndWindows) {
  const std::string channel = "[[correction.channel]]\nname = \"";
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n" + channel +
          "load\"\ninput = \"axial_load_N\"\nfeedthrough_um_N = 0.002\n"
          "sections = [{ gain_um_N = 0.01, time_constant_s = 900 }]\n" +
          channel +
          "screw\"\ninput = \"x_feed_m_min\"\n"
          "sections = [{ gain_um_m_min = 2, time_constant_s = 1500 }]\nfeedthrough_um_m_min = 0.1\n"
          "window = { column = \"x_position_mm\", points = [0, 500, inf, inf] }\n" +
          channel +
          "nut\"\ninput = \"x_feed_m_min\"\n"
          "sections = [{ gain_um_m_min = 1, time_constant_s = 600 }]\nwindow = { column = "
          "\"x_position_mm\", points = [100, 300], acts_on = \"input\" }\n" +
          channel +
          "bed\"\ninput = \"room_temperature_C\"\n"
          "sections = [{ gain_um_K = -3, time_constant_s = 4000 }]\nwindow = { column = "
          "\"x_position_mm\", points = [-200, 0, 100, 400] }\n"
          "[[correction.effect]]\nid = \"input\"\ninput = \"x_position_mm\"\n"
          "gain_um_mm = 0.004\n",
      [] {
        std::string text = "time_s,axial_load_N,x_feed_m_min,x_position_mm,room_temperature_C\n";
        for (int k = 0; k < 600; ++k)
          text += fmt::format("{},{},{},{:.2f},{:.2f}\n", 20 * k + k % 7,
                              k / 40 % 3 == 0 ? -300 : 500, k / 25 % 2 == 0 ? -10 : 4,
                              250 + 400 * std::sin(k / 31.0), 20 + std::sin(k / 60.0));
        return text;
      }());
  const auto expected = c.corrected();
  const auto got = run(c, c.calls());
  EXPECT_LT(distance(got, expected), tolerance());
  double low = 0, high = 0;
  for (const auto& y : expected) low = std::min(low, y[0]), high = std::max(high, y[0]);
  EXPECT_LT(low, -1.0);
  EXPECT_GT(high, 10.0);
  const std::string table = control_csv(c.plan);
  EXPECT_THAT(table, HasSubstr(",window_full_from,500,mm\n"));
}

// Two coefficients, y(k) = 0.01 u(k-1) - 0.99 y(k-1): its sign shows how often it went on.
TEST_P(Control, EquationsStandStillAtAnyOtherInterval) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 2\n"
      "[[correction.channel]]\nname = \"x\"\ninput = \"speed_rpm\"\nnumerator = [0, 0.01]\n"
      "denominator = [1, 0.99]\n[export]\nlongest_gap_s = 1\n",
      "time_s,speed_rpm\n0,100\n2,100\n");
  EXPECT_EQ(c.plan.settings.longest_gap_s, 3);
  const auto got = run(c,
                       "u 0 100\nu 2 100\nu 4.09 100\nu 6.2 100\nu 7 100\nu 7 100\nrestart\n"
                       "u 9 100\nu 30 100\nu 32 100\n");
  const double first = 0, second = 1, third = 1 - 0.99, fourth = 1 - 0.99 * third,
               fifth = 1 - 0.99 * fourth;
  const double y[] = {first, second, third, third, third, third, fourth, fourth, fifth};
  const int flags[] = {0, 0, 0, wrong_interval, wrong_interval, clock_stood, 0, wrong_interval, 0};
  ASSERT_EQ(got.size(), std::size(y));
  for (std::size_t k = 0; k < got.size(); ++k) {
    EXPECT_NEAR(got[k].displacements[0], y[k], 1e-6) << k;
    EXPECT_EQ(got[k].flags, flags[k]) << k;
  }
}

// The first row of a control's calls has no interval; a clock that stands is no other interval.
TEST_P(Control, OffsetsOfEquationsStandAtAnyOtherInterval) {
  const Case c(printed_model, printed_record(10));
  std::string script;
  for (const double t : {0.0, 1.0, 2.0, 5.5, 6.5})
    script += fmt::format("g {} 1 {} {} {} 1000\n", t, 20.0, 20 + 0.1 * t, 20 + 0.1 * t);
  const auto got = run(c, script);
  ASSERT_EQ(got.size(), 5u);
  EXPECT_EQ(got[3].flags & wrong_interval, wrong_interval);
  for (const std::size_t k : {0u, 1u, 2u, 4u}) EXPECT_EQ(got[k].flags & wrong_interval, 0) << k;
}

TEST(ControlPlan, RefusesEquationsThatNeverDecayOrHaveTwoSamplings) {
  const auto refused = [](const std::string& model) {
    try {
      (void)Case(model, "time_s,speed_rpm\n0,0\n1,1\n");
    } catch (const text::InputError& e) {
      return std::string(e.what());
    }
    return std::string("taken");
  };
  const auto model = [](const char* axis, int sampling, const char* denominator) {
    return fmt::format(
        "[[correction]]\ndisplacement = \"displacement_{}_um\"\nsampling_s = {}\n"
        "[[correction.channel]]\nname = \"a\"\ninput = \"speed_rpm\"\nnumerator = [1]\n"
        "denominator = {}\n",
        axis, sampling, denominator);
  };
  EXPECT_THAT(
      refused(model("z", 1, "[1, 1.01]")),
      HasSubstr("channel a: the polynomials cannot run in a control: pole on or outside the "
                "unit circle"));
  EXPECT_THAT(
      refused(model("z", 1, "[1, 0.5]") + model("y", 2, "[1, 0.5]")),
      HasSubstr(
          "for calls every 2 s, but the polynomials of another channel are for calls every 1 s"));
  EXPECT_EQ(refused(model("z", 2, "[1, 0.5]") + model("y", 2, "[1, 0.5]")), "taken");
}

TEST(ControlPython, ARecordWithOtherHeadersIsRefusedWithTheOnesThatAreNeeded) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 2000 }]\n",
      "time_s,front_temperature_C\n0,22\n1,40\n");
  (void)c.folder.write("z.py", control_python(c.plan));
  (void)c.folder.write("other.csv", "Time,T front,speed_rpm\n0,22,0\n1,40,0\n");
  (void)c.folder.write("empty.csv", "");
  for (const char* record : {"other.csv", "empty.csv"}) {
    const std::string said = c.folder.shell(
        fmt::format("python3 z.py {} > numbers 2> said; test $? -eq 1; cat said", record));
    EXPECT_EQ(
        said,
        fmt::format("{}: the header has no time_s, front_temperature_C; the record needs time_s, "
                    "front_temperature_C\n",
                    record));
    EXPECT_EQ(text_of(c.folder.file("numbers")), "");
  }
}

// Timers of seconds in float: 0.1 ms are below the last digit of half an hour.
TEST(ControlC, ASensorThatSticksIsFoundAtShortSteps) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 2000 }]\n[export]\nstuck_s = 3600\n",
      "time_s,front_temperature_C\n0,22\n1,40\n");
  (void)c.folder.write("machine.h", control_c(c.plan, "machine"));
  (void)c.folder.write("steps.c",
                       "#include <stdio.h>\n#include \"machine.h\"\n"
                       R"(int main(void) {
  static machine_state machine;
  machine_real in[machine_inputs + 1] = {20}, out[machine_outputs];
  long k;
  machine_init(&machine);
  machine_update(&machine, 0, in, 1, out);
  machine_update(&machine, 1, in, 1, out);
  machine.still[0] = 3599; /* it has stood for so long */
  for (k = 1; k <= 20000 && !(machine.flags & machine_stuck); ++k)
    machine_update(&machine, (machine_real)1e-4, in, 1, out);
  printf("%ld\n", k);
  return 0;
}
)");
  for (const char* precision : {"", "-DMACHINE_SINGLE"}) {
    const double found_at = std::stod(c.folder.shell(
        fmt::format("cc -std=c99 -O2 {} steps.c -o steps -lm && ./steps", precision)));
    EXPECT_NEAR(found_at, 10000, 10) << precision;
  }
}

// In float the step of a slow section is far below the last digit of its sum.
TEST(ControlC, RunsElevenHoursAtTenHertzWithoutDrift) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 20000 }]\n",
      "time_s,front_temperature_C\n0,22\n1,40\n");
  std::string script = "u 0 22\nu 1 40\n";
  for (int k = 1; k <= 400000; ++k) script += fmt::format("u {:.1f} 40\n", 1 + 0.1 * k);
  // Straight from 22 to 40 in the first second, then constant.
  const double tau = 20000.0, first = 90.0 * (1 + tau * std::expm1(-1 / tau));
  const double exact = 90.0 + (first - 90.0) * std::exp(-40000.0 / tau);
  for (const Way way : {Way::c, Way::single}) {
    const auto got = answers(c, way, script);
    ASSERT_EQ(got.size(), 400002u);
    EXPECT_NEAR(got.back().displacements[0], exact, way == Way::single ? 1e-3 : 1e-8);
  }
}

// Once a second over 40 hours, with all that a model may have.
TEST(ControlC, KeepsAThousandthOfAMicrometreInFloatOver40Hours) {
  const Case c(everything, record_text(0.8, 1.2, 144'000));
  const auto expected = c.corrected();
  EXPECT_LT(distance(answers(c, Way::single, c.calls()), expected), 1e-3);
  EXPECT_LT(distance(answers(c, Way::c, c.calls()), expected), 1e-9);
}

TEST(ControlPlan, NamesWhatItLeavesOut) {
  const Case c(everything);
  EXPECT_THAT(c.plan.notes, testing::Contains("offset-jump: not exported, because this effect only "
                                              "removes a disturbance from one record"));
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr("[correction.range] has no ")));
  EXPECT_THAT(control_python(c.plan), HasSubstr("# Note: offset-jump: not exported"));
  EXPECT_THAT(control_csv(c.plan), HasSubstr("# Note: offset-jump: not exported"));
  const Case known(everything.substr(0, everything.find("[[correction]]", 5)) + every_range);
  EXPECT_THAT(known.plan.notes, Not(testing::Contains(HasSubstr("[correction.range]"))));
  EXPECT_EQ(known.plan.inputs[known.plan.speed].highest, 9000);
  for (const ControlInput& in : known.plan.inputs)
    if (in.column == "x_feed_m_min") {
      EXPECT_EQ(in.lowest, 0);  // sizes
      EXPECT_EQ(in.highest, 30);
    }
}

TEST(ControlPlan, FreeInitialStateBeginsFromRest) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\ninitial_state = \"free\"\n"
      "[[correction.channel]]\nname = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n");
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr("the program starts from rest")));
}

TEST(ControlState, OfAnotherModelIsRefused) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n";
  const std::string record = "time_s,front_temperature_C\n0,20\n100,30\n";
  const Case c(model, record),
      other(std::string(model).replace(model.find("600"), 3, "601"), record);
  (void)c.folder.write("a.py", control_python(c.plan));
  (void)c.folder.write("b.py", control_python(other.plan));
  EXPECT_EQ(
      c.folder.shell("python3 -c '\nimport a, b\nb.Correction().restore(b.Correction().state())"
                     "\ntry:\n  b.Correction().restore(a.Correction().state())\n"
                     "except ValueError as e: print(e)'"),
      "the state belongs to another model\n");
}

TEST(ControlState, OfAnotherFormatIsRefusedWithAdvice) {
  const Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
      "sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]\n",
      "time_s,front_temperature_C\n0,20\n100,30\n");
  (void)c.folder.write("a.py", control_python(c.plan));
  EXPECT_EQ(c.folder.shell("python3 -c '\nimport a\nstate = a.Correction().state()\n"
                           "state.pop(\"format\")\na.Correction().restore(state)\n"
                           "state[\"format\"] = 2\ntry:\n  a.Correction().restore(state)\n"
                           "except ValueError as e: print(e)'"),
            "the state has format 2, but this program reads only 1; start without the state\n");
}

TEST(ControlPython, RunsOverARecordByHand) {
  const Case c(everything);
  (void)c.folder.write("machine.py", control_python(c.plan));
  (void)c.folder.write("record.csv", record_text());
  std::istringstream out(c.folder.shell("python3 machine.py record.csv"));
  const auto expected = c.corrected();
  std::string line;
  std::getline(out, line);
  EXPECT_EQ(line, "time_s,displacement_z_um,displacement_y_um,offset_z_um,offset_y_um,status");
  for (std::size_t k = 0; k < expected.size(); ++k) {
    std::getline(out, line);
    const std::size_t comma = line.find(',');
    EXPECT_NEAR(std::stod(line.substr(comma + 1)), expected[k][0], 1e-9) << k;
  }
}

// A name may hold anything; it must stay a comment.
TEST(ControlText, HasNoNameThatEndsAComment) {
  const Case c(everything);
  for (const std::string& text :
       {control_python(c.plan), control_c(c.plan, "machine"), control_linuxcnc(c.plan)})
    EXPECT_THAT(text, Not(HasSubstr("Z *")));
  EXPECT_THAT(control_c(c.plan, "machine"), HasSubstr("/* offset_z_um, Z _/ of _machine__ 7 */"));
}

TEST(ControlCsv, HasEveryNumberWithItsUnit) {
  const Case c(everything);
  const std::string text = control_csv(c.plan);
  for (const char* row : {"displacement_z_um,,displacement,offset,3.25,um",
                          "displacement_z_um,spindle,section 1,gain,6.12,um/K",
                          "displacement_z_um,spindle,section 1,reference,base_temperature_C,",
                          "displacement_z_um,spindle,section 2,time_constant,900,s",
                          "displacement_z_um,screw,section 4,gain,0.8,um/m/min",
                          "displacement_z_um,losses,section 3,off_gain,1.7,1",
                          "displacement_z_um,line,element 1,time_constant slope,-3.7788,s/W",
                          "displacement_z_um,,kinematic 1,C,0.00053,1/rpm",
                          "displacement_y_um,tabled,element 2,gain at 90 W,15,um",
                          "displacement_y_um,sensor,section 1,direct,0.08,1"})
    EXPECT_THAT(text, HasSubstr(std::string("\n") + row + "\n"));
}

}  // namespace
}  // namespace raceway::control::control_test
