// What `export` writes, run by Python and a C compiler, gives what the model gives here.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "correction/simulation.h"
#include "io/control_files.h"
#include "io/correction_file.h"
#include "io/error.h"
#include "io/series_file.h"
#include "record/series_channel.h"
#include "record/units.h"

namespace raceway::io {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

enum Flag {
  beyond_range = 1,
  no_value = 2,
  beyond_table = 4,
  beyond_element = 8,
  clock_stood = 16
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of its own, removed at its end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "raceway-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return file(name);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Runs a line of shell in it; what it wrote, and nothing if it failed.
  [[nodiscard]] std::string shell(const std::string& line) const {
    const int status =
        std::system(fmt::format("cd '{}' && {{ {}\n}} > out 2> err", path_.string(), line).c_str());
    EXPECT_EQ(status, 0) << line << "\n" << text_of(file("err")).substr(0, 3000);
    return status == 0 ? text_of(file("out")) : "";
  }

 private:
  fs::path path_;
};

const std::string rest_of_table =
    "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n"
    "0,400,20,90\n3000,400,20,210\n9000,400,20,420\n0,600,20,110\n3000,600,20,240\n"
    "9000,600,20,470\n0,400,45,60\n3000,400,45,150\n9000,400,45,330\n0,600,45,75\n"
    "3000,600,45,170\n9000,600,45,360\n";

/// All that a model may have, over two displacements.
const std::string everything = R"([[correction]]
name = "Z */ of \"machine\"\\ 7"
displacement = "displacement_z_um"
offset_um = 3.25
[[correction.channel]]
name = "spindle"
input = ["front_temperature_C", "rear-left_temperature_C"]
reference = "base_temperature_C"
sections = [{ gain_um_K = 5.1, time_constant_s = 5400 }, { gain_um_K = -3.3, time_constant_s = 900 }]
feedthrough_um_K = 0.7
scale = 1.2
[[correction.channel]]
name = "losses"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 470
temperature_C = "front_temperature_C"
sections = [{ gain_um_W = 0.18, time_constant_s = 4000 }]
[[correction.channel]]
name = "line"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 550
temperature_C = 37
gain = { slope_um_W = 0.04817, offset_um = 1.03617 }
time_constant = { slope_min_W = -0.06298, offset_min = 135.245 }
[[correction.channel]]
name = "screw"
input = ["x_feed_m_min", "y_feed_m_min"]
sections = [{ gain_um_m_min = 0.8, time_constant_s = 2500 }]
[correction.kinematic]
A = 1.28e-3
B = 0.697
C = 5.3e-4
[[correction.effect]]
id = "ambient-drift"
input = "room_temperature_C"
gain_um_K = -2.5
time_constant_s = 8000
[[correction.effect]]
id = "motor-heat"
gain_um = 6.0
time_constant_s = 1800
decay_speed_rpm = 2500
[[correction.effect]]
id = "cooling-switch"
channel = "losses"
gain_ratio = 1.7
time_constant_ratio = 0.6
[[correction.effect]]
id = "offset-jump"
size_um = 4.0
time_s = 3000
[[correction]]
displacement = "displacement_y_um"
[[correction.channel]]
name = "sensor"
input = "front_temperature_C"
sections = [{ gain_um_K = 4.0, time_constant_s = 3000 }]
[[correction.channel]]
name = "speedy"
input = "rear-left_temperature_C"
sections = [{ gain_um_K = 2.0, time_constant_s = 6000 }]
[[correction.channel]]
name = "lazy"
input = "table_speed_rpm"
exponent = 1.5
sections = [{ gain_um_rpm = -0.02, time_constant_s = 2000 }]
[[correction.channel]]
name = "power-law"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 500
temperature_C = 30
gain = { factor = 0.4, exponent = 0.8 }
time_constant = { factor = 90, exponent = -0.2 }
[[correction.channel]]
name = "tabled"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 500
temperature_C = 30
gain = { table = "K.csv" }
time_constant = { table = "T.csv" }
scale = -0.5
[[correction.effect]]
id = "sensor-lag"
channel = "sensor"
sensor_time_constant_s = 240
[[correction.effect]]
id = "speed-dependent-time-constant"
channel = "speedy"
s = 2.5
g = 0.6
[[correction.effect]]
id = "thermal-asymmetry"
channel = "lazy"
ratio = 2.2
[[correction.effect]]
id = "second-time-constant"
channel = "lazy"
gain_um_rpm = 0.01
time_constant_s = 300
[[correction.effect]]
id = "kinematic-displacement"
A = 2e-4
B = 0.5
C = 4e-4
)";

constexpr const char* every_range = R"([correction.range]
front_temperature_C = [10, 60]
rear-left_temperature_C = [10, 60]
base_temperature_C = [10, 60]
room_temperature_C = [10, 60]
speed_rpm = [0, 9000]
x_feed_m_min = [-30, 20]
y_feed_m_min = [0, 30]
table_speed_rpm = [0, 600]
)";

/// Speeds, feeds and coolant that switch, temperatures that follow, on an uneven clock with a gap
/// of two hours and a run that begins anew.
std::string record_text(double shortest_step = 7.0, double longest_step = 70.0) {
  std::string text =
      "time_s,run_id,speed_rpm,front_temperature_C,rear-left_temperature_C,base_temperature_C,"
      "room_temperature_C,x_feed_m_min,y_feed_m_min,table_speed_rpm,coolant_on\n";
  double t = 0.0;
  for (int k = 0; k < 900; ++k) {
    if (k > 0) t += shortest_step + (longest_step - shortest_step) * (0.5 + 0.5 * std::sin(k * k));
    if (k == 300) t += 7200.0;
    const double h = t / 3600.0;
    const int block = (k / 60) % 5;
    const double speed =
        std::vector{0.0, 3000.0, 8000.0, -4500.0, 1200.0}[static_cast<std::size_t>(block)];
    text +=
        fmt::format("{:.3f},{},{},{:.2f},{:.2f},{:.3f},{:.3f},{},{},{},{}\n", t, k < 600 ? 1 : 2,
                    speed, 24 + 9 * std::sin(h) + 4 * std::cos(3.1 * h), 25 + 6 * std::sin(0.7 * h),
                    21 + 0.4 * h, 20 + 2 * std::sin(0.3 * h), k % 90 < 30 ? 0.0 : 12.5,
                    block == 2 ? 8.0 : 0.0, 100 * (k / 50 % 4), k % 130 < 80 ? 1 : 0);
  }
  return text;
}

/// A model, a record, and what `correct` makes of them.
struct Case {
  Folder folder{};
  CorrectionFile file{};
  record::Record data{};
  ControlPlan plan{};

  explicit Case(const std::string& model, const std::string& record = record_text()) {
    (void)folder.write("friction.csv", rest_of_table);
    (void)folder.write("K.csv", "power_W,gain_um\n0,1\n40,9\n90,15\n200,20\n");
    (void)folder.write("T.csv", "power_W,time_constant_min\n0,120\n100,70\n250,40\n");
    file = read_correction(folder.write("model.toml", model));
    std::vector<const record::Channel*> wanted, needed;
    for (const auto& m : file.models) {
      wanted.push_back(m.displacement);
      for (const record::Channel* c : correction::inputs_of(m)) needed.push_back(c);
    }
    data = parse_series(record, "record.csv", wanted, needed);
    plan = control_plan(file.models, file.source);
  }

  /// Of every displacement at every row [um].
  [[nodiscard]] std::vector<std::vector<double>> corrected() const {
    const correction::Series series(data);
    std::vector<std::vector<double>> all(data.rows());
    for (correction::Model m : file.models) {
      std::erase_if(m.effects, [](const auto& e) { return e.id == "offset-jump"; });
      std::vector<double> y(data.rows());
      correction::simulate(m, series, y);
      for (std::size_t k = 0; k < y.size(); ++k) all[k].push_back(y[k] / um);
    }
    return all;
  }

  /// "u TIME INPUTS": a call, which answers a line of displacements and flags.
  [[nodiscard]] std::string call(std::size_t row) const {
    std::string line = fmt::format("u {:.17g}", data.value(record::time, row));
    for (const ControlInput& in : plan.inputs) {
      const record::Channel& c = *record::series_channel(in.column);
      line += fmt::format(" {:.12g}", c.in_unit(data.value(c, row)));
    }
    return line + "\n";
  }
  /// Of the whole record; "reset" where a run begins.
  [[nodiscard]] std::string calls(std::size_t from = 0, std::size_t to = 1u << 30U) const {
    std::string lines;
    for (std::size_t k = from; k < std::min(to, data.rows()); ++k) {
      if (k > 0 && data.run_of(k) != data.run_of(k - 1)) lines += "reset\n";
      lines += call(k);
    }
    return lines;
  }
};

struct Answer {
  std::vector<double> displacements{};
  int flags = 0;
};

/// The ways in which a plan runs. Lines of a script: "u", see Case::call(), "reset", "zero", and
/// "restart": the state is saved, all else forgotten, the state read.
enum class Way { python, c, single, linuxcnc };

std::vector<Answer> answers(const Case& c, Way way, const std::string& script) {
  const std::string sources = std::string(RACEWAY_SOURCE_DIR) + "/tests/io/control/";
  const std::string strict =
      "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -I. ";
  (void)c.folder.write("script", script);
  std::string line;
  if (way == Way::python) {
    (void)c.folder.write("machine.py", control_python(c.plan));
    line = "python3 '" + sources + "driver.py' machine.py < script";
  } else if (way == Way::linuxcnc) {
    (void)c.folder.write("machine.comp", control_linuxcnc(c.plan, "machine"));
    line = "python3 '" + sources +
           "hal.py' machine.comp > machine_comp.c && "
           "cc -std=c99 -O2 -Wall -Wextra -Werror machine_comp.c -o machine -lm && rm -f state && "
           "./machine state < script";
  } else {
    (void)c.folder.write("machine.h", control_c(c.plan, "machine"));
    line = strict + (way == Way::single ? "-DMACHINE_SINGLE " : "") + "'" + sources +
           "driver.c' -o machine -lm && ./machine < script";
  }
  std::vector<Answer> all;
  std::istringstream out(c.folder.shell(line));
  for (std::string text; std::getline(out, text);) {
    std::istringstream words(text);
    Answer a;
    for (std::size_t k = 0; k < c.plan.axes.size(); ++k) {
      double y = NAN;
      words >> y;
      a.displacements.push_back(y);
    }
    words >> a.flags;
    EXPECT_FALSE(words.fail()) << text;
    all.push_back(a);
  }
  return all;
}

/// Largest distance of any displacement [um].
double distance(const std::vector<Answer>& got, const std::vector<std::vector<double>>& expected) {
  EXPECT_EQ(got.size(), expected.size());
  if (got.size() != expected.size()) return NAN;
  double largest = 0.0;
  for (std::size_t k = 0; k < got.size(); ++k)
    for (std::size_t i = 0; i < expected[k].size(); ++i)
      // NaN is far away.
      if (const double d = std::abs(got[k].displacements[i] - expected[k][i]); !(d <= largest))
        largest = d;
  return largest;
}

class Control : public testing::TestWithParam<Way> {
 protected:
  /// Against `correct` [um]; a clock in floating seconds since 1970 has its own digits.
  static double tolerance() { return GetParam() == Way::single ? 1e-3 : 1e-9; }
  static std::vector<Answer> run(const Case& c, const std::string& script) {
    return answers(c, GetParam(), script);
  }
};

std::string name_of(const testing::TestParamInfo<Way>& way) {
  constexpr std::array names{"Python", "C", "SinglePrecision", "LinuxCNC"};
  return names[static_cast<std::size_t>(way.param)];
}

INSTANTIATE_TEST_SUITE_P(Ways, Control,
                         testing::Values(Way::python, Way::c, Way::single, Way::linuxcnc), name_of);

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

TEST_P(Control, CountsFromATouchOff) {
  const Case c(everything);
  const auto plain = run(c, c.calls(0, 200));
  const auto zeroed = run(c, c.calls(0, 100) + "zero\nrestart\n" + c.calls(100, 200));
  ASSERT_EQ(zeroed.size(), plain.size());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(zeroed[199].displacements[i],
                plain[199].displacements[i] - plain[99].displacements[i], tolerance());
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

// The published transfer function of one pole, and one of two: sections at their own sampling.
TEST_P(Control, TurnsPolynomialsIntoSections) {
  const std::string model =
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = "
      "10\n[[correction.channel]]\n"
      "name = \"published\"\ninput = \"front_temperature_C\"\nnumerator = [4.30702, -4.28923]\n"
      "denominator = [1, -0.9984]\nscale = 0.9\n[[correction.channel]]\nname = \"two\"\n"
      "input = \"room_temperature_C\"\nnumerator = [0, 0.02, -0.018]\n"
      "denominator = [1, -1.98, 0.9801]\n";  // (1 - 0.99/z)^2: refused below
  const std::string apart =
      std::string(model).replace(model.find("-1.98, 0.9801"), 13, "-1.985, 0.98505");
  std::string record = "time_s,front_temperature_C,room_temperature_C\n";
  for (int k = 0; k < 1000; ++k)
    record += fmt::format("{},{:.2f},{:.2f}\n", 10 * k, 22 + 8 * std::sin(k / 90.0),
                          20 + std::sin(k / 200.0));
  const Case c(apart, record);
  EXPECT_EQ(c.plan.axes[0].sections.size(), 3u);
  EXPECT_LT(distance(run(c, c.calls()), c.corrected()), tolerance());
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr("its polynomials became 2 sections")));
  try {
    (void)Case(model, record);
    FAIL() << "a double pole is no sum of sections";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("channel two: its polynomials cannot run beside sections: "));
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

TEST(ControlPlan, NamesWhatItLeavesOut) {
  const Case c(everything);
  EXPECT_THAT(c.plan.notes,
              testing::Contains("offset-jump: is of the readings of one record, and is left out"));
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr("[correction.range] has no ")));
  EXPECT_THAT(control_python(c.plan), HasSubstr("# Note: offset-jump: is of the readings"));
  EXPECT_THAT(control_csv(c.plan), HasSubstr("# Note: offset-jump: is of the readings"));
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
  EXPECT_THAT(c.plan.notes, testing::Contains(HasSubstr("a control begins from rest")));
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
      "the state is of another model\n");
}

TEST(ControlPython, RunsOverARecordByHand) {
  const Case c(everything);
  (void)c.folder.write("machine.py", control_python(c.plan));
  (void)c.folder.write("record.csv", record_text());
  std::istringstream out(c.folder.shell("python3 machine.py record.csv"));
  const auto expected = c.corrected();
  std::string line;
  std::getline(out, line);
  EXPECT_EQ(line, "time_s,displacement_z_um,displacement_y_um,status");
  for (std::size_t k = 0; k < expected.size(); ++k) {
    std::getline(out, line);
    const std::size_t comma = line.find(',');
    EXPECT_NEAR(std::stod(line.substr(comma + 1)), expected[k][0], 1e-9) << k;
  }
}

// A name may hold anything; it must stay a comment.
TEST(ControlText, HasNoNameThatEndsAComment) {
  const Case c(everything);
  for (const std::string& text : {control_python(c.plan), control_c(c.plan, "machine"),
                                  control_linuxcnc(c.plan, "machine"), control_csv(c.plan)})
    EXPECT_THAT(text, Not(HasSubstr("Z *")));
  EXPECT_THAT(control_c(c.plan, "machine"), HasSubstr("/* Z _/ of _machine__ 7 */"));
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
}  // namespace raceway::io
