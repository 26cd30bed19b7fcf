// What a control does about sensors that fail, clocks that jump, restarts, limits and touch-offs,
// in Python and C alike.
#include "tests/control/control_case.h"

namespace raceway::control::control_test {
namespace {

class Guarded : public Control {};
INSTANTIATE_TEST_SUITE_P(Ways, Guarded, testing::Values(Way::python, Way::c, Way::single), name_of);

/// 2 um/K at once and no lag, so that offsets are seen as they are; of two temperatures.
const std::string at_once =
    "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = \"front\"\n"
    "input = \"front_temperature_C\"\nfeedthrough_um_K = 2.0\n[[correction.channel]]\n"
    "name = \"room\"\ninput = \"room_temperature_C\"\nfeedthrough_um_K = 1.0\n[export]\n";
const std::string steps = at_once + "fastest_per_s = 0\n";
const std::string at_once_record =
    "time_s,front_temperature_C,room_temperature_C\n0,20,20\n1,20,20\n";

/// Calls "g" of both temperatures once a second from `begin` on.
std::string seconds(int begin, int count, const std::string& front, const std::string& room = "20",
                    bool enable = true) {
  std::string lines;
  for (int k = begin; k < begin + count; ++k)
    lines += fmt::format("g {} {} {} {}\n", k, enable ? 1 : 0, front, room);
  return lines;
}

std::vector<double> offsets_of(const std::vector<Answer>& answers) {
  std::vector<double> offsets;
  for (const Answer& a : answers) offsets.push_back(a.displacements.front());
  return offsets;
}

TEST_P(Guarded, MovesAnAxisAgainstTheDisplacementByItsSlewUpToItsLimit) {
  const Case c(steps + "limit_um = 20\nslew_um_s = 0.5\n", at_once_record);
  const auto got = run(c, seconds(0, 1, "20") + seconds(1, 60, "32"));
  for (int k = 0; k <= 60; ++k) {
    const std::size_t n = static_cast<std::size_t>(k);
    EXPECT_NEAR(got[n].displacements[0], -std::min(0.5 * k, 20.0), tolerance()) << k;
    // 24 um are asked for.
    EXPECT_EQ(got[n].flags & (limited | moving), k == 0   ? 0
                                                 : k < 40 ? limited | moving
                                                          : limited)
        << k;
  }
}

TEST_P(Guarded, HandsOutTheUnitAndTheSignOfTheControl) {
  const std::string calls = seconds(0, 1, "20") + seconds(1, 20, "22.53");
  const auto last = [&](const std::string& keys) {
    return run(Case(steps + keys, at_once_record), calls).back().displacements[0];
  };
  EXPECT_NEAR(last("unit = \"mm\"\n"), -0.00506, 1e-3 * tolerance());
  EXPECT_NEAR(last("sign = 1\n"), 5.06, 10 * tolerance());
  EXPECT_EQ(last("unit = \"counts\"\n"), -51);
  EXPECT_EQ(last("unit = \"counts\"\ncount_um = 0.5\nsign = { displacement_z_um = 1 }\n"), 10);
  EXPECT_EQ(last("unit = \"counts\"\nlimit_um = 4.98\n"), -49);  // -50 would be beyond it
}

TEST_P(Guarded, HoldsAFaultyInputThenFadesToTheLastSafeOffset) {
  const Case c(steps + "slew_um_s = 100\nhold_s = 10\nfade_s = 20\nstuck_s = 0\n", at_once_record);
  // The front sensor breaks while the room goes on; then it is back.
  const auto got = run(c, seconds(0, 2, "22") + seconds(2, 1, "22.5") + seconds(3, 5, "nan", "21") +
                              seconds(8, 72, "nan", "22") + seconds(80, 40, "22.5", "22"));
  const auto y = [&](int k) { return got[static_cast<std::size_t>(k)].displacements[0]; };
  EXPECT_NEAR(y(2), -1.0, tolerance());
  EXPECT_NEAR(y(5), -2.0, tolerance());                       // the other input still counts
  EXPECT_NEAR(y(12), -3.0, tolerance());                      // 10 s at fault
  EXPECT_NEAR(y(23), -3.0 + 2.0 * 11 / 20, 2 * tolerance());  // 21 s: fading to the -1 of before
  EXPECT_NEAR(y(40), -1.0, tolerance());
  EXPECT_NEAR(y(79), -1.0, tolerance());
  EXPECT_NEAR(y(80), -1.0 - 2.0 / 20, 2 * tolerance());
  EXPECT_NEAR(y(119), -3.0, tolerance());
  for (int k = 0; k < 120; ++k) {
    const int flags = got[static_cast<std::size_t>(k)].flags;
    EXPECT_EQ((flags & no_value) != 0, k >= 3 && k < 80) << k;
    EXPECT_EQ((flags & untrusted) != 0, k >= 13 && k < 99) << k;
  }
}

TEST_P(Guarded, GoesOnOrToZeroInAFaultWhereThatIsWanted) {
  const std::string calls =
      seconds(0, 2, "20") + seconds(2, 1, "21") + seconds(3, 100, "nan", "22");
  const std::string keys = "slew_um_s = 100\nhold_s = 10\nfade_s = 20\n";
  EXPECT_NEAR(run(Case(steps + keys + "on_fault = \"hold\"\n", at_once_record), calls)
                  .back()
                  .displacements[0],
              -4.0, tolerance());
  EXPECT_NEAR(run(Case(steps + keys + "on_fault = \"zero\"\n", at_once_record), calls)
                  .back()
                  .displacements[0],
              0.0, tolerance());
}

TEST_P(Guarded, KnowsValuesThatNoSensorCanHave) {
  const Case c(at_once +
                   "stuck_s = { room_temperature_C = 5 }\nfastest_per_s = 0.5\n"
                   "plausible = { front_temperature_C = [0, 60] }\n",
               at_once_record);
  std::string calls = seconds(0, 3, "20", "20");  // the room stands still from 0 s on
  calls += seconds(3, 1, "20", "20.1");           // and moves
  calls += seconds(4, 1, "-1", "20.2") + seconds(5, 1, "20", "20.3");  // implausible
  calls +=
      seconds(6, 1, "21.4", "20.4") + seconds(7, 1, "24", "20.5");  // 1.5 K may be, 2.6 K may not
  calls += seconds(8, 1, "24", "20.6") + seconds(9, 1, "24", "20.7") +
           seconds(10, 1, "24", "20.8") +
           seconds(11, 1, "24", "20.9");  // until it can have come there
  calls += seconds(12, 7, "24", "21");
  const auto got = run(c, calls);
  const auto faults = [&](int k) {
    return got[static_cast<std::size_t>(k)].flags & (no_value | implausible | jumped | stuck);
  };
  for (int k = 0; k < 19; ++k)
    EXPECT_EQ(faults(k), k == 4             ? implausible
                         : k >= 7 && k <= 9 ? jumped
                         : k >= 17          ? stuck
                                            : 0)
        << k;
}

TEST_P(Guarded, SmoothsCoarseSensorsForInstantParts) {
  const Case c(steps + "slew_um_s = 100\nsmoothing_s = { front_temperature_C = 30 }\n",
               at_once_record);
  const auto got = run(c, seconds(0, 1, "20") + seconds(1, 60, "21", "20.5"));
  const double first = 1.0 - (1.0 - std::exp(-1.0 / 30)) * 30;  // straight within the first second
  for (int k = 1; k <= 60; ++k) {
    const double smooth = 1.0 - (1.0 - first) * std::exp(-(k - 1) / 30.0);
    EXPECT_NEAR(got[static_cast<std::size_t>(k)].displacements[0], -2.0 * smooth - 0.5, tolerance())
        << k;
  }
}

TEST_P(Guarded, CountsFromATouchOffAndLeavesWhatIsApplied) {
  const std::string before = seconds(0, 1, "20") + seconds(1, 10, "22"),
                    after = "touch-off\nrestart\n" + seconds(11, 1, "22") + seconds(12, 10, "23");
  // Held back by the slew, the axis had not come to where it was wanted.
  const Case keep(steps + "slew_um_s = 0.3\n", at_once_record);
  const auto kept = offsets_of(run(keep, before + after));
  EXPECT_NEAR(kept[10], -3.0, tolerance());
  EXPECT_NEAR(kept[11], -3.0, tolerance());
  EXPECT_NEAR(kept[21], -5.0, tolerance());
  const auto cleared = offsets_of(run(
      Case(steps + "slew_um_s = 0.3\ntouch_off = \"clear\"\n", at_once_record), before + after));
  EXPECT_NEAR(cleared[11], -3.0, tolerance());
  EXPECT_NEAR(cleared[12], -2.7, tolerance());  // towards 0 - 2
  EXPECT_NEAR(cleared[21], -2.0, tolerance());
}

TEST_P(Guarded, GoesToZeroOrStandsWhereItIsNotEnabled) {
  const std::string calls = seconds(0, 1, "20") + seconds(1, 10, "22") +
                            seconds(11, 20, "23", "20", false) + seconds(31, 20, "23");
  const auto zero = run(Case(steps + "slew_um_s = 0.5\n", at_once_record), calls);
  EXPECT_NEAR(zero[10].displacements[0], -4.0, tolerance());
  EXPECT_NEAR(zero[12].displacements[0], -3.0, tolerance());
  EXPECT_NEAR(zero[30].displacements[0], 0.0, tolerance());
  EXPECT_NEAR(zero[31].displacements[0], -0.5, tolerance());
  EXPECT_NEAR(zero[50].displacements[0], -6.0, tolerance());
  for (int k = 0; k < 51; ++k)
    EXPECT_EQ((zero[static_cast<std::size_t>(k)].flags & disabled) != 0, k >= 11 && k < 31) << k;
  const auto stands = offsets_of(
      run(Case(steps + "slew_um_s = 0.5\ndisabled = \"freeze\"\n", at_once_record), calls));
  EXPECT_NEAR(stands[30], -4.0, tolerance());
  EXPECT_NEAR(stands[31], -4.5, tolerance());
}

TEST_P(Guarded, MovesNoFurtherAfterALateCallAndNotAtAllWhereTheClockWasSet) {
  const Case c(steps + "slew_um_s = 0.1\nlongest_gap_s = 5\nclock_jump_s = 100\n", at_once_record);
  const auto got =
      run(c,
          "g 0 1 20 20\ng 1 1 22 20\ng 61 1 22 20\ng 261 1 22 20\ng 262 1 22 20\ng 200 1 22 20\n"
          "g 201 1 22 20\n");
  const double offsets[] = {0, -0.1, -0.6, -0.6, -0.7, -0.7, -0.8};
  const int flags[] = {0, 0, late, clock_stood, 0, clock_stood, 0};
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(got[k].displacements[0], offsets[k], tolerance()) << k;
    EXPECT_EQ(got[k].flags & ~moving, flags[k]) << k;
  }
}

/// A section of the speed and one of a temperature, both of 1000 s.
const std::string lags =
    "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = \"table\"\n"
    "input = \"table_speed_rpm\"\nsections = [{ gain_um_rpm = 0.1, time_constant_s = 1000 }]\n"
    "[[correction.channel]]\nname = \"room\"\ninput = \"room_temperature_C\"\n"
    "sections = [{ gain_um_K = 2, time_constant_s = 1000 }]\n[export]\nslew_um_s = 1000\n"
    "fastest_per_s = 0\n";

TEST_P(Guarded, TakesAMachineThatWasOffForOneThatStood) {
  const std::string calls =
      "g 0 1 200 20\ng 1000 1 200 20\nrestart\ng 4000 1 0 25\ng 4001 1 0 25\ng 4002 1 0 25\n";
  const std::string record = "time_s,table_speed_rpm,room_temperature_C\n0,200,20\n1,200,20\n";
  const auto after = [&](const std::string& keys) {
    const auto got = run(Case(lags + keys, record), calls);
    EXPECT_EQ(got[2].flags & ~moving, restarted | was_off);
    EXPECT_EQ(got[2].displacements[0], got[1].displacements[0]);  // nothing moves in that call
    return -got[3].displacements[0];
  };
  const double warm = 20 * (1 - std::exp(-1.0));
  const double room = 10 * (1 - (1 - std::exp(-3.0)) / 3);  // straight over 3000 s
  const double second = std::exp(-0.001), ten = 10 * (1 - second);
  // The speed of before is not held while it was off.
  EXPECT_NEAR(after(""), (warm * std::exp(-3.0) + room) * second + ten, 2 * tolerance());
  EXPECT_NEAR(after("restart = \"resume\"\n"), warm * second + ten, 2 * tolerance());
  EXPECT_NEAR(after("restart = \"rest\"\n"), 0.0, 2 * tolerance());
}

TEST_P(Guarded, GoesOnFromWhatTheControlHasApplied) {
  const Case c(steps + "slew_um_s = 1\n", at_once_record);
  const std::string before = seconds(0, 1, "20") + seconds(1, 10, "23") + "restart\n";
  const auto kept = offsets_of(run(c, before + seconds(11, 2, "23")));
  EXPECT_NEAR(kept[12], -6.0, tolerance());
  const auto forgotten = offsets_of(run(c, before + "applied 0\n" + seconds(11, 2, "23")));
  EXPECT_NEAR(forgotten[11], 0.0, tolerance());
  EXPECT_NEAR(forgotten[12], -1.0, tolerance());
}

TEST_P(Guarded, HoldsSectionsBeyondTheRangeWhereThatIsWanted) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = "
      "\"room\"\n"
      "input = \"room_temperature_C\"\nsections = [{ gain_um_K = 2, time_constant_s = 10 }]\n"
      "[correction.range]\nroom_temperature_C = [18, 25]\n[export]\nlongest_gap_s = 1000\n"
      "fastest_per_s = 0\n";
  const std::string record = "time_s,room_temperature_C\n0,20\n1,20\n";
  const std::string calls = "g 0 1 20\ng 500 1 30\ng 1000 1 30\n";
  EXPECT_NEAR(run(Case(model, record), calls).back().displacements[0], -20, 1e-3);
  EXPECT_NEAR(run(Case(model + "beyond_range = \"hold\"\n", record), calls).back().displacements[0],
              -10, 1e-3);
}

TEST_P(Guarded, WaitsForAllInputsAndMovesNothingUntilThen) {
  const Case c(steps + "slew_um_s = 100\n", at_once_record);
  const auto got = run(c, seconds(0, 3, "nan") + seconds(3, 1, "25") + seconds(4, 1, "26"));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(got[k].displacements[0], 0.0);
    EXPECT_EQ(got[k].flags, no_value | not_started);
  }
  EXPECT_EQ(got[3].flags, 0);
  EXPECT_NEAR(got[3].displacements[0], 0.0, tolerance());  // temperatures count from there
  EXPECT_NEAR(got[4].displacements[0], -2.0, tolerance());
}

std::string refusal_of(const std::string& keys) {
  try {
    (void)Case(steps + keys, at_once_record);
  } catch (const text::InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ExportSection, RefusesInOneMessage) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal_of("limit = 3\n"),
              HasSubstr("unknown key in [export]; did you mean limit_um"));
  EXPECT_THAT(refusal_of("limit_um = 0\n"), HasSubstr("limit_um = 0 um: must be from 0.001 to"));
  EXPECT_THAT(refusal_of("sign = 0.5\n"), HasSubstr("sign = 0.5: must be 1 or -1"));
  EXPECT_THAT(refusal_of("unit = \"inch\"\n"), HasSubstr("must be um, mm or counts"));
  EXPECT_THAT(refusal_of("slew_um_s = { displacement_y_um = 1 }\n"),
              HasSubstr("displacement_y_um is none of the displacements: displacement_z_um"));
  EXPECT_THAT(refusal_of("stuck_s = { rear_temperature_C = 1 }\n"),
              HasSubstr("rear_temperature_C is none of the inputs"));
  EXPECT_THAT(refusal_of("plausible = { front_temperature_C = [5, 5] }\n"),
              HasSubstr("must be [lowest, highest]"));
  EXPECT_THAT(refusal_of("clock_jump_s = 5\n"), HasSubstr("must be at least longest_gap_s = 10 s"));
  EXPECT_THAT(refusal_of("restart = \"no\"\n"), HasSubstr("must be decay, resume or rest"));
  EXPECT_EQ(refusal_of("slew_um_s = { displacement_z_um = 1 }\nplausible = [-20, 90]\n"), "");
}

}  // namespace
}  // namespace raceway::control::control_test
