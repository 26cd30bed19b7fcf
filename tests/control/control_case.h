#pragma once
// A model, what the programs that are exported of it answer to a script of calls, and what
// `correct` makes of the same record.
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
#include <utility>
#include <vector>

#include "control/formats.h"
#include "correction/simulation.h"
#include "files/correction_file.h"
#include "files/series_file.h"
#include "record/series_channel.h"
#include "record/units.h"
#include "tests/places.h"
#include "text/error.h"

namespace raceway::control::control_test {

namespace fs = std::filesystem;

// As both programs have them.
enum Flag {
  beyond_range = 1,
  no_value = 2,
  beyond_table = 4,
  beyond_element = 8,
  clock_stood = 16,
  not_started = 32,
  implausible = 128,
  jumped = 256,
  stuck = 512,
  late = 1024,
  limited = 2048,
  untrusted = 4096,
  moving = 8192,
  disabled = 16384,
  restarted = 32768,
  was_off = 65536,
  wrong_interval = 131072
};

inline std::string text_of(const fs::path& path) {
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

/// A part of the models here.
inline std::string part(const std::string& name) {
  return text_of(fs::path(tests::source_dir()) / "tests/control/models" / name);
}
/// All that a model may have, over two displacements.
inline const std::string everything = part("axis_z.toml") + part("axis_y.toml");
inline const std::string every_range = part("range.toml");

/// Speeds, feeds and coolant that switch, temperatures that follow, on an uneven clock with a gap
/// of two hours and, of 900 rows, a run that begins anew.
inline std::string record_text(double shortest_step = 7.0, double longest_step = 70.0,
                               int rows = 900) {
  std::string text =
      "time_s,run_id,speed_rpm,front_temperature_C,rear-left_temperature_C,base_temperature_C,"
      "room_temperature_C,x_feed_m_min,y_feed_m_min,table_speed_rpm,coolant_on\n";
  double t = 0.0;
  for (int k = 0; k < rows; ++k) {
    if (k > 0)
      t += shortest_step + (longest_step - shortest_step) * (0.5 + 0.5 * std::sin(1.0 * k * k));
    if (k == 300) t += 7200.0;
    const double h = t / 3600.0;
    const int block = (k / 60) % 5;
    const double speed =
        std::vector{0.0, 3000.0, 8000.0, -4500.0, 1200.0}[static_cast<std::size_t>(block)];
    text += fmt::format("{:.3f},{},{},{:.2f},{:.2f},{:.3f},{:.3f},{},{},{},{}\n", t,
                        k < 600 || rows > 900 ? 1 : 2, speed,
                        24 + 9 * std::sin(h) + 4 * std::cos(3.1 * h), 25 + 6 * std::sin(0.7 * h),
                        21 + 0.4 * h, 20 + 2 * std::sin(0.3 * h), k % 90 < 30 ? 0.0 : 12.5,
                        block == 2 ? 8.0 : 0.0, 100 * (k / 50 % 4), k % 130 < 80 ? 1 : 0);
  }
  return text;
}

/// A model, a record, and what `correct` makes of them.
struct Case {
  Folder folder{};
  files::CorrectionFile file{};
  record::Record data{};
  ControlPlan plan{};

  explicit Case(const std::string& model, const std::string& record = record_text(),
                const std::vector<std::pair<std::string, std::string>>& tables = {}) {
    for (const char* table : {"friction.csv", "K.csv", "T.csv", "K_F.csv"})
      (void)folder.write(table, part(table));
    for (const auto& [name, text] : tables) (void)folder.write(name, text);
    file = files::read_correction(folder.write("model.toml", model));
    std::vector<const record::Channel*> wanted, needed;
    for (const auto& m : file.models) {
      wanted.push_back(m.displacement);
      for (const record::Channel* c : correction::inputs_of(m)) needed.push_back(c);
    }
    data = files::read_series({"record.csv", record}, wanted, needed);
    plan = control_plan(file.models, file.control, file.source);
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

/// The ways in which a plan runs. Lines of a script: "u TIME INPUTS" asks for displacements as
/// `correct` has them, "g TIME ENABLE INPUTS" for offsets; "reset", "touch-off", "applied OFFSETS",
/// and "restart": the state is saved, all else forgotten, the state read.
enum class Way { python, c, single };

inline std::vector<Answer> answers(const Case& c, Way way, const std::string& script) {
  const std::string sources = tests::source_dir() + "/tests/control/";
  const std::string strict =
      "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -I. ";
  (void)c.folder.write("script", script);
  std::string line;
  if (way == Way::python) {
    (void)c.folder.write("machine.py", control_python(c.plan));
    line = "python3 '" + sources + "driver.py' machine.py < script";
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
inline double distance(const std::vector<Answer>& got,
                       const std::vector<std::vector<double>>& expected) {
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

inline std::string name_of(const testing::TestParamInfo<Way>& way) {
  constexpr std::array names{"Python", "C", "SinglePrecision"};
  return names[static_cast<std::size_t>(way.param)];
}

}  // namespace raceway::control::control_test
