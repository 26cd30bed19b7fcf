#include "tests/spindle_study/rig.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tests/correction_study/random.h"
#include "tests/spindle_study/base_spindle.h"

namespace spindle_study {
namespace {

using correction_study::Random;

constexpr double hour = 3600.0, mm = 1e-3, um = 1e-6;
constexpr double noise_K = 0.1, noise_m = 0.3 * um;  // of readings
constexpr double floor_K = 0.5, floor_m = 1.0 * um;  // of a model of this kind

std::uint64_t of_text(std::string_view text) {
  std::uint64_t h = 1469598103934665603ULL;
  for (char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return h;
}

/// Positions and lengths grow alike; bearings and diameters stay.
Spindle random_spindle(Random& random) {
  Spindle s = base_spindle();
  const double between = random.between(0.75, 1.25), tail = random.between(0.7, 1.3);
  const bool two_front = random.chance(0.7), two_rear = !two_front || random.chance(0.25);
  const double width = s.bearing_width;
  const double nose = random.between(0.04, 0.06);
  double x = nose + 0.5 * width;
  s.front = {x};
  if (two_front) s.front.push_back(x += width + random.between(5.0, 15.0) * mm);
  const double front_end = x + 0.5 * width;
  const double middle = 0.18 * between;
  x = front_end + middle + 0.5 * width;
  s.rear = {x};
  if (two_rear) s.rear.push_back(x += width + 10.0 * mm);
  const double rear_end = x + 0.5 * width;
  s.shaft_bore = random.chance(0.3) ? 0.03 : 0.036;
  s.shaft = {{nose, 0.104},
             {front_end - nose, 0.07},
             {middle, random.between(0.078, 0.084)},
             {rear_end - front_end - middle, 0.07},
             {0.075 * tail, 0.06}};
  s.housing_start = nose - 10.0 * mm;
  s.housing_length = rear_end + 15.0 * mm - s.housing_start;
  s.housing_diameter = random.between(0.17, 0.2);
  s.flange = front_end + random.between(15.0, 40.0) * mm;
  s.flange_conductance = random.between(3.0, 8.0);
  s.preload = std::round(random.between(200.0, 450.0) / 10.0) * 10.0;
  s.interference = random.between(4.0, 8.0) * um;
  s.clearance = random.between(2.0, 6.0) * um;
  s.f0 = random.between(0.5, 0.8);
  s.cooled = random.chance(0.6);
  s.helix.flow = random.between(1.5, 4.0) * 1e-3 / 60.0;
  s.helix.diameter = s.housing_diameter - 0.04;
  s.helix.start = nose + 0.5 * width;
  s.helix.end = rear_end;
  return s;
}

void place_thermometers(Spindle& s, Random& random) {
  using Part = Thermometer::Part;
  const double seat = 0.5 * s.bearing_outer;
  s.thermometers = {{"front_bearing", Part::housing, s.front.front(), seat + 2.0 * mm},
                    {"rear_bearing", Part::housing, s.rear.back(), seat + 2.0 * mm},
                    {"housing", Part::housing, 0.5 * (s.front.back() + s.rear.front()),
                     0.5 * s.housing_diameter - 1.0 * mm},
                    {"flange", Part::housing, s.flange, 0.5 * s.housing_diameter - 4.0 * mm},
                    {"shaft_end", Part::shaft, s.shaft_length() - 10.0 * mm,
                     0.5 * s.shaft.back().diameter - 1.0 * mm}};
  if (random.chance(0.5))
    s.thermometers.push_back({"front_outer_ring", Part::ring, s.front.front(), seat - 2.0 * mm});
}

/// Speeds of a quarter of an hour to two hours, some at rest; the room drifts over the day.
std::vector<Row> make_plan(double hours, bool cooled, Random& random) {
  std::vector<Row> rows;
  const double drift = random.between(-1.5, 1.5), phase = random.between(0.0, 2.0 * pi);
  const double switched = random.chance(0.3) ? random.between(0.3, 0.7) * hours : -10.0;
  double until = 0.0, speed = 0.0;
  for (double minute = 1.0; minute <= hours * 60.0 + 0.5; minute += 1.0) {
    if (minute > until) {
      until = minute + std::floor(random.between(30.0, 120.0)) - 1.0;
      speed = !rows.empty() && random.chance(0.2) ? 0.0
                                                  : 500.0 * random.whole(4, cooled ? 18 : 14) * rpm;
    }
    const double time = minute * 60.0;
    const double hour_now = time / hour;
    rows.push_back(
        {.inputs = {.time = time,
                    .speed = speed,
                    .ambient = 293.15 + drift * (std::sin(2.0 * pi * hour_now / 12.0 + phase) -
                                                 std::sin(phase)),
                    .coolant_on = cooled && std::fabs(hour_now - switched) > 0.5}});
  }
  return rows;
}

void simulate(const Spindle& spindle, const Hidden& hidden, std::vector<Row>& rows,
              double* balance = nullptr, std::size_t* cells = nullptr) {
  Simulator simulator(spindle, hidden);
  for (Row& row : rows) {
    simulator.advance(row.inputs);
    row.truth = simulator.reading();
  }
  if (balance) *balance = simulator.balance_error();
  if (cells) *cells = simulator.cells();
}

/// Sensors and displacement of all rows, each by its noise and the floor of models.
std::vector<double> weighed(const std::vector<Row>& rows) {
  const double by_K = 1.0 / std::hypot(noise_K, floor_K), by_m = 1.0 / std::hypot(noise_m, floor_m);
  std::vector<double> v;
  for (const Row& row : rows) {
    v.push_back(row.truth.displacement * by_m);
    for (double t : row.truth.thermometers) v.push_back(t * by_K);
  }
  return v;
}

/// What an f0 refitted (in first order) leaves of `with` against `without`, rms.
double signal(const std::vector<double>& with, const std::vector<double>& without,
              const std::vector<double>& other_f0) {
  double xx = 1e-12, xy = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < with.size(); ++k) {
    const double y = with[k] - without[k], x = other_f0[k] - without[k];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  return std::sqrt(std::max(0.0, yy - xy * xy / xx) / static_cast<double>(with.size()));
}

struct Wish {
  Hidden hidden;
  double size = nan;
};

/// What is hidden, `strength` times its first size.
Wish hide(std::string_view kind, const Spindle& s, double draw, double strength) {
  Wish w;
  const auto factor = [&](double low, double high) {  // below or above one
    return std::pow(draw < 0.5 ? low : high, strength * (0.6 + 0.4 * std::fabs(2.0 * draw - 1.0)));
  };
  Hidden& h = w.hidden;
  if (kind == "coolant") {
    w.size = h.sleeve = (15.0 + 25.0 * draw) * strength;
    h.sleeve_radius = 0.25 * (s.bearing_outer + s.housing_diameter);
  } else if (kind == "seat-conductance") {
    w.size = h.outer_seat = std::pow(0.12 + 0.2 * draw, strength);
  } else if (kind == "motor-heat") {
    w.size = h.motor = (100.0 + 200.0 * draw) * strength;
  } else if (kind == "drive-heat") {
    w.size = h.drive = (60.0 + 100.0 * draw) * strength;
  } else if (kind == "convection-factor") {
    w.size = h.convection = factor(0.35, 2.5);
  } else if (kind == "bearing-conductance") {
    w.size = h.bearing_conductance = factor(0.3, 3.5);
  } else if (kind == "structure-temperature") {
    w.size = h.structure_rise = (draw < 0.5 ? -1.0 : 1.0) * (3.0 + 4.0 * draw) * strength;
    h.structure_time = (1.0 + 3.0 * draw) * hour;
  } else if (kind == "flange-conductance") {
    w.size = h.flange = factor(0.3, 3.5);
  } else if (kind == "seal-heat") {
    w.size = h.seal = (50.0 + 80.0 * draw) * strength;
  } else if (kind == "churning") {
    w.size = h.churning = (0.05 + 0.08 * draw) * strength;
  } else if (kind == "outside") {
    w.size = h.stray = (60.0 + 100.0 * draw) * strength;
    h.stray_from = (2.0 + draw) * hour;
    h.stray_to = h.stray_from + (1.0 + draw) * hour;
  }
  return w;
}

/// Makes the spindle another one than its user believes it to be: where a number was entered wrong.
/// Returns what is wrong with it in the unit of its file, and the name that is right.
std::pair<double, std::string> differ(std::string_view kind, Spindle& s, Random& random) {
  if (kind == "sensor-place") {
    // A bore that was free, next to the one on the drawing.
    std::vector<Thermometer*> movable;
    for (Thermometer& t : s.thermometers)
      if (t.part != Thermometer::Part::ring) movable.push_back(&t);
    Thermometer& t =
        *movable[static_cast<std::size_t>(random.whole(0, static_cast<int>(movable.size()) - 1))];
    const double way = t.name == "shaft_end" || random.chance(0.5) ? -12.0 : 12.0;
    t.position += way * mm;
    return {way, "sensor-place:" + t.name};
  }
  if (kind == "oil-card") {
    const double factor =
        random.chance(0.5) ? random.between(0.75, 0.88) : random.between(1.14, 1.3);
    s.oil.at_100 *= factor;
    return {factor, "viscosity-slope"};
  }
  if (kind == "coolant-inlet") {
    const double warmer = (random.chance(0.5) ? 1.0 : -1.0) * random.between(2.0, 6.0);
    s.helix.inlet += warmer;
    return {warmer, "coolant-inlet"};
  }
  return {nan, ""};
}

void read(std::vector<Row>& rows, Random& random) {
  for (Row& row : rows) {
    row.ambient_read = row.inputs.ambient + 0.05 * random.normal();
    row.displacement_read = row.truth.displacement + noise_m * random.normal();
    for (double t : row.truth.thermometers)
      row.thermometers_read.push_back(t + noise_K * random.normal());
  }
}

}  // namespace

std::span<const Class> classes() {
  using Names = std::vector<std::string>;
  static const Names effect{"effect", "ambiguous"};
  static const Names heats{"motor-heat", "drive-heat"};
  static const std::vector<Class> all{
      {"nothing", {}, {"nothing-missing"}},
      {"coolant", {"coolant"}, effect},
      {"seat-conductance", {"seat-conductance"}, effect},
      {"motor-heat", heats, effect},
      {"drive-heat", heats, effect},
      {"convection-factor", {"convection-factor"}, effect},
      {"bearing-conductance", {"bearing-conductance"}, effect},
      {"preload-growth", {"preload-growth"}, effect},
      {"structure-temperature", {"structure-temperature"}, effect},
      {"flange-conductance", {"flange-conductance"}, effect},
      {"seal-heat", {"seal-heat"}, effect},
      {"churning", {"churning", "windage", "rig-viscous-drag", "lubricant-drag"}, effect},
      {"outside", {}, {"not-in-catalogue", "effect-like"}, true},
      // Numbers of the file that are wrong; the name that is right is the spindle's own.
      {"sensor-place", {}, effect, false, true},
      {"oil-card", {}, effect, false, true},
      {"coolant-inlet", {}, effect, false, true}};
  return all;
}

const Class& find_class(std::string_view id) {
  std::string names;
  for (const Class& c : classes()) {
    if (c.id == id) return c;
    names += " " + std::string(c.id);
  }
  throw std::invalid_argument("no class " + std::string(id) + "; there are:" + names);
}

Rig make_rig(const Class& of, std::uint64_t seed, const Hours& hours) {
  constexpr double enough = 0.5;  // signal, rms in units of noise and model floor
  Random random(seed * 0x9e3779b97f4a7c15ULL + of_text(of.id));
  Rig rig{.id = std::string(of.id) + "-" + std::to_string(seed),
          .kind = std::string(of.id),
          .accept = of.accept,
          .verdicts = of.verdicts};
  rig.truth = random_spindle(random);
  if (of.id == "coolant") rig.truth.cooled = false;
  if (of.id == "convection-factor" || of.id == "flange-conductance") rig.truth.cooled = false;
  if (of.id == "coolant-inlet") rig.truth.cooled = true;
  place_thermometers(rig.truth, random);
  rig.believed = rig.truth;
  rig.believed.f0 = std::round(rig.truth.f0 * random.between(0.85, 1.15) * 1000.0) / 1000.0;
  if (of.id == "preload-growth") rig.believed.preload_feedback = false;
  if (of.data) {
    const auto [size, right] = differ(of.id, rig.truth, random);
    rig.size = size;
    rig.accept = {right};
  }
  rig.train = make_plan(hours.train, rig.truth.cooled, random);
  rig.test = make_plan(hours.test, rig.truth.cooled, random);
  const double draw = random.between(0.0, 1.0);

  std::vector<Row> without = rig.train, other = rig.train;
  Spindle plain = rig.believed;
  plain.f0 = rig.truth.f0;
  simulate(plain, {}, without);
  plain.f0 *= 1.05;
  simulate(plain, {}, other);
  const std::vector<double> plain_signal = weighed(without), other_signal = weighed(other);
  for (double strength : {1.0, 1.4, 2.0}) {
    const Wish wish = hide(of.id, rig.truth, draw, strength);
    rig.hidden = wish.hidden;
    if (!of.data) rig.size = wish.size;
    simulate(rig.truth, rig.hidden, rig.train, &rig.balance, &rig.cells);
    rig.signal = signal(weighed(rig.train), plain_signal, other_signal);
    if (of.id == "nothing" || of.id == "preload-growth" || of.data || rig.signal > enough) break;
  }
  if (of.id != "nothing" && rig.signal < enough) rig.verdicts.push_back("nothing-missing");
  simulate(rig.truth, rig.hidden, rig.test);
  read(rig.train, random);
  read(rig.test, random);
  return rig;
}

}  // namespace spindle_study
