#include "tests/hidden_effect/generator.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

namespace hidden_effect {
namespace {

constexpr std::array<Machine, 5> catalogue_machines{{
    {"7014", 20, 11.906, 90.0, 25.0, 0.52, 0.52, 43000.0, false, 32.0, 5.9},
    {"7010", 20, 8.731, 65.0, 15.0, 0.523, 0.523, 24000.0, false, 32.0, 5.9},
    {"7008", 18, 7.938, 54.0, 15.0, 0.52, 0.52, 17900.0, false, 22.0, 4.8},
    {"7020", 22, 15.081, 125.0, 25.0, 0.52, 0.52, 55000.0, true, 32.0, 5.9},
    {"7012", 22, 9.525, 77.5, 25.0, 0.53, 0.52, 31000.0, false, 46.0, 7.0},
}};

constexpr int rows_per_run = 10, rows_per_lab_run = 12;
constexpr double seconds_per_row = 600.0;

std::vector<Point> grid(std::span<const double> speeds, std::span<const double> loads,
                        std::span<const double> temperatures, int repeats, Random& random) {
  std::vector<Point> points;
  for (const double n : speeds)
    for (const double F : loads)
      for (const double T : temperatures)
        for (int i = 0; i < repeats; ++i) points.push_back({n, F, T + 0.4 * normal(random)});
  return points;
}

/// Oil that warms with speed and load and is not held.
void warm_up(std::vector<Point>& points, double top_speed, Random& random) {
  for (Point& p : points)
    p.temperature = 23.5 + 29.0 * std::pow(p.speed / top_speed, 0.75) + 1.2 * p.load / 1000.0 +
                    1.2 * normal(random);
}

/// Speeds of a 90 mm bearing at the same n d_m, loads at the same F/C0.
std::vector<double> scaled(std::vector<double> values, double factor, double step) {
  for (double& v : values) v = std::max(step, step * std::round(v * factor / step));
  return values;
}

/// The rows stand in the order of the plan.
bool ordered(Plan plan) {
  return plan == Plan::run_per_load || plan == Plan::run_ups || plan == Plan::in_order ||
         plan == Plan::cycling || plan == Plan::stairs || plan == Plan::one_stairs ||
         plan == Plan::up_and_down || plan == Plan::lab;
}

/// The rows that a logger writes at each point: speed and load as they were, oil that warms.
std::vector<Point> logged(const Logger& logger, std::span<const Point> points, Random& random) {
  constexpr double settling = 900.0;  // between the last row of a point and the first of the next
  std::vector<Point> rows;
  double start = 0.0;
  for (const Point& p : points) {
    for (int i = 0; i < logger.rows; ++i) {
      const double share = (i + 0.5) / logger.rows;
      rows.push_back({.speed = p.speed * (1.0 + 3e-4 * normal(random)),
                      .load = p.load + 2e-4 * p.load * normal(random),
                      .temperature = p.temperature + logger.warming * (share - 0.5),
                      .time = start + i});
    }
    start += logger.rows + settling;
  }
  return rows;
}

std::vector<Point> plan_points(const Setup& setup, bool test, Random& random) {
  const Machine& m = *setup.machine;
  const double by_size = 90.0 / m.pitch_diameter;
  // The small bearings of the given rigs carry the same loads; a larger one gets more.
  const double by_load = m.pitch_diameter > 100.0 ? 1.6 : 1.0;
  const auto speeds = [&](std::vector<double> n) { return scaled(std::move(n), by_size, 50.0); };
  const auto loads = [&](std::vector<double> F) { return scaled(std::move(F), by_load, 10.0); };
  const double top = 16000.0 * by_size;
  std::vector<Point> points;
  if (test) {
    points = grid(speeds({900, 2500, 5000, 9000, 14000}), loads({400, 900, 2000}),
                  std::array{30.0, 40.0, 50.0, 60.0}, 1, random);
    if (setup.plan == Plan::run_up || setup.plan == Plan::run_ups || setup.plan == Plan::in_order ||
        setup.plan == Plan::stairs || setup.plan == Plan::one_stairs ||
        setup.plan == Plan::up_and_down)
      warm_up(points, top, random);
  } else if (setup.plan == Plan::factorial) {
    points = grid(speeds({600, 1500, 3500, 7000, 11000, 16000}), loads({250, 600, 1400, 3000}),
                  std::array{25.0, 35.0, 45.0, 55.0, 65.0}, 1, random);
  } else if (setup.plan == Plan::run_up) {
    points = grid(speeds({600, 1200, 2000, 3200, 4500, 6000, 8000, 10500, 13000, 16000}),
                  loads({250, 600, 1400, 3000}), std::array{40.0}, 3, random);
    warm_up(points, top, random);
  } else if (setup.plan == Plan::sweep) {
    std::vector<double> n;
    for (int i = 0; i < 24; ++i) n.push_back(600.0 * std::pow(16000.0 / 600.0, i / 23.0));
    points = grid(speeds(n), loads({1400}), std::array{40.0}, 5, random);
  } else if (setup.plan == Plan::run_per_load) {
    // Load by load, within it speed by speed.
    for (const double F : loads({250, 600, 1400, 3000})) {
      const std::vector<Point> run =
          grid(speeds({600, 1500, 3500, 7000, 11000, 16000}), std::array{F},
               std::array{25.0, 35.0, 45.0, 55.0, 65.0}, 1, random);
      points.insert(points.end(), run.begin(), run.end());
    }
  } else if (setup.plan == Plan::run_ups || setup.plan == Plan::in_order) {
    std::vector<double> each = loads({250, 600, 1400, 3000});
    const bool runs = setup.plan == Plan::run_ups;
    const int repeats = runs ? 1 : 3;
    for (int run = 0; run < (runs ? 3 : 1); ++run) {
      if (runs) std::shuffle(each.begin(), each.end(), random);
      for (const double F : each) {
        const std::vector<Point> rising =
            grid(speeds({600, 1200, 2000, 3200, 4500, 6000, 8000, 10500, 13000, 16000}),
                 std::array{F}, std::array{40.0}, repeats, random);
        points.insert(points.end(), rising.begin(), rising.end());
      }
    }
    warm_up(points, top, random);
  } else if (setup.plan == Plan::stairs || setup.plan == Plan::one_stairs) {
    for (int pass = 0; pass < (setup.plan == Plan::stairs ? 2 : 1); ++pass)
      for (const double F : loads({250, 570, 1310, 3000})) {
        const std::vector<Point> rising =
            grid(speeds({600, 900, 1360, 2060, 3100, 4670, 7040, 10600, 16000}), std::array{F},
                 std::array{40.0}, 1, random);
        points.insert(points.end(), rising.begin(), rising.end());
      }
    warm_up(points, top, random);
  } else if (setup.plan == Plan::up_and_down) {
    for (const double F : loads({250, 570, 1310, 3000})) {
      std::vector<Point> both = grid(speeds({600, 900, 1360, 2060, 3100, 4670, 7040, 10600, 16000}),
                                     std::array{F}, std::array{40.0}, 2, random);
      std::vector<Point> falling;
      for (std::size_t i = 0; i < both.size(); ++i)
        (i % 2 == 0 ? points : falling).push_back(both[i]);
      points.insert(points.end(), falling.rbegin(), falling.rend());
    }
    warm_up(points, top, random);
  } else if (setup.plan == Plan::radial) {
    for (const double part : {0.0, 0.2, 0.4, 0.6, 0.8})
      for (Point p : grid(speeds({600, 1500, 3500, 7000, 11000, 16000}),
                          loads({250, 600, 1400, 3000}), std::array{40.0}, 1, random)) {
        p.radial = part * p.load;
        points.push_back(p);
      }
  } else if (setup.plan == Plan::lab) {
    std::vector<double> n;
    for (int i = 0; i < rows_per_lab_run; ++i)
      n.push_back(600.0 * std::pow(16000.0 / 600.0, i / (rows_per_lab_run - 1.0)));
    for (const double F : loads({250, 410, 670, 1100, 1820, 3000})) {
      const std::vector<Point> run = grid(speeds(n), std::array{F}, std::array{40.0}, 1, random);
      points.insert(points.end(), run.begin(), run.end());
    }
    warm_up(points, top, random);
  } else if (setup.plan == Plan::cycling) {
    const std::vector<double> n = speeds({600, 2000, 5000, 10000, 16000});
    const std::vector<double> F = loads({250, 600, 1400, 3000});
    for (std::size_t i = 0; i < 20000; ++i)
      points.push_back({n[i % n.size()], F[(i / n.size() / 50) % F.size()],
                        25.0 + 40.0 * static_cast<double>((i * 7919) % 20000) / 20000.0});
  } else {
    points = grid(speeds({600, 2000, 5000, 10000, 16000}), loads({250, 600, 1400, 3000}),
                  std::array{28.0, 44.0, 60.0}, 2, random);
  }
  if (!ordered(setup.plan) || test) std::shuffle(points.begin(), points.end(), random);
  if (setup.rows > 0 && !test) points.resize(static_cast<std::size_t>(setup.rows));
  // What stands in the file is what the rig had.
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].temperature = 0.01 * std::round(100.0 * points[i].temperature);
    points[i].time = seconds_per_row * static_cast<double>(i);
  }
  if (setup.logger.rows > 0 && !test) return logged(setup.logger, points, random);
  return points;
}

/// Run of a row, from its place in the plan.
int run_of(Plan plan, std::size_t row) {
  if (plan == Plan::stairs || plan == Plan::one_stairs) return static_cast<int>(row) / 9;
  if (plan == Plan::up_and_down) return static_cast<int>(row) / 18;
  if (plan == Plan::in_order || plan == Plan::cycling) return 0;
  return static_cast<int>(row) / (plan == Plan::run_per_load ? 30
                                  : plan == Plan::lab        ? rows_per_lab_run
                                                             : rows_per_run);
}

double rms(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<double> torques(const Bearing& bearing, const BaseLaw& law,
                            std::span<const Point> points, std::span<const Hidden> hidden) {
  std::vector<double> out;
  out.reserve(points.size());
  for (const Point& p : points) out.push_back(torque(bearing, law, p, hidden));
  return out;
}

/// The size that changes the torque by the wished share, or the largest that leaves every torque at
/// 40 % of what it was.
double size_for(const Bearing& bearing, const BaseLaw& law, std::span<const Point> points,
                const Wish& wish, const Effect& effect, double sign) {
  const std::vector<double> base = torques(bearing, law, points, {});
  const double scale = rms(base);
  const auto gap = [&](double log_size) {
    const Hidden one[] = {{&effect, {sign * std::exp(log_size), effect.shape}}};
    std::vector<double> change = torques(bearing, law, points, one);
    bool absurd = false;  // a torque that no rig would read
    for (std::size_t i = 0; i < change.size(); ++i) {
      absurd = absurd || change[i] < 0.4 * base[i];
      change[i] -= base[i];
    }
    return (absurd ? 1e3 : rms(change) / scale) - wish.share;
  };
  const double top = std::log(effect.largest);
  if (gap(top) <= 0.0) return sign * std::exp(top);
  double lower = top;
  do lower -= 3.0;
  while (gap(lower) > 0.0 && lower > top - 90.0);
  std::uintmax_t steps = 60;
  const auto [a, b] = boost::math::tools::toms748_solve(
      gap, lower, lower + 3.0, boost::math::tools::eps_tolerance<double>(30), steps);
  return sign * std::exp(0.5 * (a + b));
}

/// Scatter of the rows of a logger, correlated within a point, and of the points.
void add_noise_of_logger(const Logger& logger, Random& random, std::vector<Reading>& rows) {
  const double kept = logger.correlation > 0.0 ? std::exp(-1.0 / logger.correlation) : 0.0;
  double memory = 0.0, offset = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Reading& r = rows[i];
    const bool first = i % static_cast<std::size_t>(logger.rows) == 0;
    if (first) offset = logger.point_scatter * normal(random);
    memory = first ? normal(random) : kept * memory + std::sqrt(1.0 - kept * kept) * normal(random);
    r.sigma = std::hypot(logger.point_scatter, logger.row_scatter) * r.torque;
    r.measured = r.torque * (1.0 + offset + logger.row_scatter * memory);
  }
}

/// Scatter of a row, of the torque, where it grows with the speed.
double level_at(const NoiseDetail& d, double speed, double lowest, double highest) {
  if (d.at_lowest <= 0.0) return d.level;
  if (d.straight)
    return d.at_lowest + (d.level - d.at_lowest) * (speed - lowest) / (highest - lowest);
  return d.at_lowest *
         std::pow(d.level / d.at_lowest, std::log(speed / lowest) / std::log(highest / lowest));
}

void add_noise(const Setup& setup, Random& random, std::vector<Reading>& rows) {
  if (setup.logger.rows > 0) return add_noise_of_logger(setup.logger, random, rows);
  std::vector<double> all;
  for (const Reading& r : rows) all.push_back(r.torque);
  const NoiseDetail& d = setup.detail;
  const double level = d.level, floor = level * rms(all);
  double offset = 0.0, memory = normal(random);
  double lowest = rows.front().point.speed, highest = lowest;
  for (const Reading& r : rows) {
    lowest = std::min(lowest, r.point.speed);
    highest = std::max(highest, r.point.speed);
  }
  for (Reading& r : rows) {
    const double size = std::abs(r.torque), own = level_at(d, r.point.speed, lowest, highest);
    r.sigma = own * size;
    if (&r == rows.data() || (&r)[-1].run != r.run) offset = normal(random);
    double unit = normal(random);
    if (setup.noise == Noise::run_offsets) {
      unit += offset * d.offset / own;
    } else if (setup.noise == Noise::autoregressive) {
      memory = d.correlation * memory + std::sqrt(1.0 - d.correlation * d.correlation) * unit;
      unit = memory;
    } else if (setup.noise == Noise::absolute) {
      r.sigma = std::hypot(0.5 * level * size, floor);
    } else if (setup.noise == Noise::outliers) {
      std::uniform_real_distribution<double> uniform;
      if (uniform(random) < d.outlier_share)
        unit = (6.0 + 9.0 * uniform(random)) * (!d.one_sided && uniform(random) < 0.5 ? -1.0 : 1.0);
    }
    r.measured = r.torque + r.sigma * unit;
  }
}

std::vector<Reading> readings(const Rig& rig, const Bearing& bearing, std::span<const Point> points,
                              int first_run) {
  std::vector<Reading> rows;
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.push_back(
        {.point = points[i],
         .run = first_run + run_of(rig.setup.plan, i),
         .torque = torque_of_rig(bearing, rig.setup.law, rig.setup.mistake, points[i], rig.hidden),
         .sigma = 0.0,
         .measured = 0.0,
         .seen = points[i].temperature});
  misread_torques(rig.setup.mistake, rig.setup.seed, rows);
  return rows;
}

template <typename... Value>
std::string text(const char* format, Value... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

std::string quoted_list(std::span<const std::string_view> words) {
  std::string out = "[";
  for (const std::string_view w : words)
    out += (out.size() > 1 ? ", \"" : "\"") + std::string(w) + "\"";
  return out + "]";
}

}  // namespace

std::string_view name(Plan plan) {
  constexpr std::string_view names[] = {
      "factorial", "run-up",  "sweep",  "replicated", "run per load", "run-ups", "in order",
      "radial",    "cycling", "stairs", "one stairs", "up and down",  "lab"};
  return names[static_cast<int>(plan)];
}

std::string_view name(Noise noise) {
  constexpr std::string_view names[] = {"independent", "run offsets", "autoregressive", "absolute",
                                        "outliers"};
  return names[static_cast<int>(noise)];
}

std::span<const Machine> machines() { return catalogue_machines; }

std::vector<std::string_view> Rig::accepted(std::size_t hidden_index) const {
  const Effect& e = *hidden[hidden_index].effect;
  std::vector<std::string_view> ids;
  if (e.family.empty()) return ids;
  ids.push_back(e.family);
  ids.insert(ids.end(), e.aliases.begin(), e.aliases.end());
  return ids;
}

std::vector<std::string_view> Rig::accepted() const {
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < hidden.size(); ++i)
    for (const std::string_view id : accepted(i)) ids.push_back(id);
  return ids;
}

Rig make_rig(const Setup& setup) {
  Random random(0x9e3779b97f4a7c15ULL * (setup.seed + 1));
  Rig rig{.setup = setup,
          .bearing = Bearing(*setup.machine),
          .hidden = {},
          .shares = {},
          .train = {},
          .test = {},
          .second_record = 0};
  const std::vector<Point> train = plan_points(setup, false, random);
  const std::vector<Point> test = plan_points(setup, true, random);
  for (const Wish& wish : setup.hidden) {
    const Effect& e = effect(wish.id);
    const double sign = e.negative && (random() & 1U) != 0 ? -1.0 : 1.0;
    rig.hidden.push_back({&e, {size_for(rig.bearing, setup.law, train, wish, e, sign), e.shape}});
  }
  const std::vector<double> base = torques(rig.bearing, setup.law, train, {});
  for (const Hidden& h : rig.hidden) {
    std::vector<double> change = torques(rig.bearing, setup.law, train, {&h, 1});
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= base[i];
    rig.shares.push_back(rms(change) / rms(base));
  }
  rig.train = readings(rig, rig.bearing, train, 0);
  if (setup.mistake.second_oil) {
    rig.second_record = rig.train.size();
    const std::vector<Point> again = plan_points(setup, false, random);
    for (const Reading& r :
         readings(rig, bearing_of_second_record(setup), again, rig.train.back().run + 1))
      rig.train.push_back(r);
  }
  rig.test = readings(rig, rig.bearing, test, 0);
  add_noise(setup, random, rig.train);
  read_temperatures(setup.mistake, setup.logger.rows > 0, random, rig.train);
  Setup plain = setup;
  plain.noise = Noise::independent;
  plain.logger = {};
  add_noise(plain, random, rig.test);
  return rig;
}

/// VG 68 where VG 32 is entered.
Bearing bearing_of_second_record(const Setup& setup) {
  Machine machine = *setup.machine;
  machine.viscosity_40 *= 68.0 / 32.0;
  machine.viscosity_100 *= 8.7 / 5.9;
  return Bearing(machine);
}

std::vector<Reading> measure(const Rig& rig, std::span<const Point> points, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> timed(points.begin(), points.end());
  for (std::size_t i = 0; i < timed.size(); ++i)
    timed[i].time = rig.train.back().point.time + seconds_per_row * static_cast<double>(i + 1);
  std::vector<Reading> rows = readings(rig, rig.bearing, timed, rig.train.back().run + 1);
  Setup plain = rig.setup;
  plain.noise = Noise::independent;
  plain.logger = {};
  add_noise(plain, random, rows);
  read_temperatures(rig.setup.mistake, false, random, rows);
  return rows;
}

std::vector<double> free_values(const BaseLaw& law) {
  if (law.contacts) return {law.rolling_factor};
  return {law.f0, law.z};
}

std::string model_text(const Rig& rig) {
  const Machine& m = *rig.setup.machine;
  const Mistake& wrong = rig.setup.mistake;
  const double at_40 = wrong.viscosity_40 > 0.0 ? wrong.viscosity_40 : m.viscosity_40;
  const double at_100 = wrong.viscosity_100 > 0.0 ? wrong.viscosity_100 : m.viscosity_100;
  const Believed believed = rig.setup.believed != Believed::as_it_is ? rig.setup.believed
                            : rig.setup.law.contacts                 ? Believed::contacts
                                                                     : Believed::palmgren;
  const bool contacts = believed == Believed::contacts, skf = believed == Believed::skf;
  return std::string("# What the user believes about this rig: the bearing, its lubricant, ") +
         (contacts ? "the friction of its contacts"
          : skf    ? "SKF's formulas"
                   : "Palmgren friction with catalogue factors") +
         ".\n[bearing]\nname = \"" + std::string(m.name) + "\"\n" +
         text("ball_count = %d\n", m.balls) +
         text("ball_diameter_mm = %.10g\npitch_diameter_mm = %.10g\n", m.ball_diameter,
              m.pitch_diameter) +
         text("contact_angle_deg = %.10g\ninner_conformity = %.10g\nouter_conformity = %.10g\n",
              m.contact_angle, m.inner_conformity, m.outer_conformity) +
         text("static_load_rating_N = %.10g\n", m.load_rating) + "ball_material = \"" +
         (m.ceramic_balls ? "silicon-nitride" : "steel") +
         "\"\nring_material = \"steel\"\n\n[lubricant]\n" +
         text("viscosity_40C_mm2_s = %.10g\nviscosity_100C_mm2_s = %.10g\n", at_40, at_100) +
         (contacts ? "\n[friction]\nlaw = \"contact\"\n\n[calibration]\nfree = "
                     "[\"rolling_factor\"]\n"
          : skf    ? "\n[friction]\nlaw = \"skf\"\n\n[calibration]\nfree = [\"mu_EHL\", "
                     "\"K_rs\"]\n"
                   : "\n[friction]\nf0 = 2.0\nz = 0.0008\ny = 0.33\n"
                     "f1_load = \"F_b\"  # these rigs are made with z (F_b/C0)^y\n\n"
                     "[calibration]\nfree = [\"f0\", \"z\"]\n") +
         (wrong.pair_preload > 0.0 ? "\n[rig]\nbearings = 2\n" : "");
}

std::string measurement_text(const Rig& rig, std::span<const Reading> rows) {
  const Mistake& m = rig.setup.mistake;
  std::string out = m.runs_left_out ? "" : "run_id,";
  out += m.clock_left_out ? "" : "time_s,";
  out += "speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm";
  out += m.std_declared ? ",std_Nmm\n" : "\n";
  for (const Reading& r : rows) {
    if (!m.runs_left_out) out += text("%d,", r.run);
    if (!m.clock_left_out) out += text("%.0f,", r.point.time);
    out +=
        text("%.10g,%.10g,%.10g,%.2f,%.6f", r.point.speed,
             r.point.load / (m.in_kilograms ? 9.80665 : 1.0), r.point.radial, r.seen, r.measured);
    out += m.std_declared ? text(",%.6f\n", r.sigma) : "\n";
  }
  return out;
}

std::string truth_text(const Rig& rig) {
  const auto by_id = [&](auto value) {
    std::string out = "{";
    for (std::size_t i = 0; i < rig.hidden.size(); ++i)
      out += (i > 0 ? ", \"" : "\"") + std::string(rig.hidden[i].effect->id) +
             text("\": %.10g", value(i));
    return out + "}";
  };
  const auto numbers = [](const std::vector<Reading>& rows, double Reading::*member) {
    std::string out = "[";
    for (const Reading& r : rows) out += (out.size() > 1 ? ", " : "") + text("%.6g", r.*member);
    return out + "]";
  };
  const auto part = [&](const std::vector<Reading>& rows) {
    return "{\"torque\": " + numbers(rows, &Reading::torque) +
           ", \"sigma\": " + numbers(rows, &Reading::sigma) + "}";
  };
  const std::vector<std::string_view> ids = rig.accepted();
  std::vector<std::string_view> verdicts;
  if (rig.hidden.empty())
    verdicts = {"nothing-missing"};
  else if (ids.empty())
    verdicts = {"not-in-catalogue", "effect-like"};
  else if (rig.hidden.size() > 1)
    verdicts = {"several-effects"};
  else
    verdicts = {"effect", "ambiguous", "effect-like"};
  const BaseLaw& law = rig.setup.law;
  return "{\"hidden\": " + by_id([&](std::size_t i) { return rig.setup.hidden[i].share; }) +
         ",\n \"accept\": " + quoted_list(ids) + ",\n \"verdicts\": " + quoted_list(verdicts) +
         ",\n \"size\": " + by_id([&](std::size_t i) { return rig.hidden[i].values.size; }) +
         (law.contacts ? text(",\n \"friction\": {\"rolling_factor\": %.10g}", law.rolling_factor)
                       : text(",\n \"friction\": {\"f0\": %.10g, \"z\": %.10g, \"y\": %.10g}",
                              law.f0, law.z, law.y)) +
         ",\n \"train\": " + part(rig.train) + ",\n \"test\": " + part(rig.test) + "}\n";
}

}  // namespace hidden_effect
