#include "tests/correction_study/setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace correction_study {
namespace {

const std::vector<Class>& all_classes() {
  static const std::vector<Class> all{
      {"nothing-missing"},
      {"ambient-drift", {"ambient-drift"}},
      {"motor-heat", {"motor-heat"}},
      {"second-time-constant", {"second-time-constant"}},
      {"feed-axis-heat", {"feed-axis-heat"}},
      {"cooling-switch", {"cooling-switch"}},
      {"sensor-lag", {"sensor-lag"}},
      {"kinematic-displacement", {"kinematic-displacement"}},
      {"speed-dependent-time-constant", {"speed-dependent-time-constant"}},
      {"thermal-asymmetry", {"thermal-asymmetry"}},
      {"offset-jump", {"offset-jump"}},
      {"sensor-quantisation", {"sensor-quantisation"}},
      {"slow-drift", {"slow-drift"}},
      {"motor-heat+ambient-drift", {"motor-heat", "ambient-drift"}},
      {"feed-axis-heat+ambient-drift", {"feed-axis-heat", "ambient-drift"}},
      {"kinematic-displacement+ambient-drift", {"kinematic-displacement", "ambient-drift"}},
      {"motor-heat+feed-axis-heat", {"motor-heat", "feed-axis-heat"}},
      {"hydraulics", {"hydraulics"}, true},
      {"door", {"door"}, true},
      {"chips", {"chips"}, true},
      {"humidity", {"humidity"}, true},
      {"stick-slip", {"stick-slip"}, true},
      // Nothing missing, as below; at the end, so that the others keep their place.
      {"stray-readings"},
      {"exchanged-columns", {"exchanged-columns"}},
      {"loose-sensor", {"loose-sensor"}},
      {"input", {"input"}},  // the column is heated, and its temperature recorded
  };
  return all;
}

bool hides(const Class& c, std::string_view id) {
  return std::find(c.hidden.begin(), c.hidden.end(), id) != c.hidden.end();
}

/// A room as quiet as `amplitude` [K] says.
Waves room(double amplitude, Random& random) {
  const auto wave = [&](double share, double period) {
    return Waves::Wave{amplitude * random.about(share), period,
                       random.between(0.0, 2.0 * std::numbers::pi)};
  };
  return {{wave(1.0, 24.0 * hour), wave(0.4, random.about(9.0 * hour)),
           wave(0.2, random.about(4.0 * hour)), wave(0.07, random.about(1.6 * hour))}};
}

Intervals intervals(double span, double every, double lasting, double scatter, Random& random) {
  Intervals out;
  for (double t = random.between(0.2, 1.0) * every; t < span; t += random.about(every, scatter))
    out.on.push_back({t, t + random.about(lasting, scatter)});
  return out;
}

/// A spindle with jacket in a headstock on a column. Conductances and capacities as the sizes of
/// such bodies give them, a quarter up or down.
Machine draw_machine(Random& random) {
  Machine m;
  m.capacity = {1200.0, 1000.0, 4500.0, 7000.0, 14000.0, 8000.0, 130e3, 450e3, 1.1e6,
                15e3,   9000.0, 9000.0, 9000.0, 2000.0,  20.0,   20.0,  20.0};
  m.to_air = {0.1, 0.1, 1.5, 0.5, 2.0, 0.3,  9.0,  35.0, 60.0,
              1.0, 2.5, 2.5, 2.5, 0.1, 1e-4, 1e-4, 1e-4};
  m.expansion = {0.05, 0.02, 2.2, 0.1, 1.4, 1.2, 4.0, 2.5, -1.5,
                 0.0,  0.0,  0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  m.joints = {
      {front_bearing, shaft, 8.0},  {rear_bearing, shaft, 6.0}, {front_bearing, housing, 9.0},
      {rear_bearing, housing, 8.0}, {motor, housing, 12.0},     {motor, shaft, 2.0},
      {quill, housing, 0.5},        {housing, headstock, 16.0}, {headstock, column, 22.0},
      {column, bed, 35.0},          {screw_x, bed, 4.0},        {screw_y, column, 4.0},
      {screw_z, column, 4.0}};
  for (double& c : m.capacity) c = random.about(c);
  for (double& g : m.to_air) g = random.about(g);
  for (double& a : m.expansion) a = random.about(a, 0.35);
  for (Machine::Joint& j : m.joints) j.conductance = random.about(j.conductance);
  m.expansion[column] *= random.sign();
  // A sensor of 20 J/K stands in a bore.
  for (const auto& [sensor, body] :
       {std::pair{front_sensor, front_bearing}, {rear_sensor, rear_bearing}, {motor_sensor, motor}})
    m.joints.push_back({sensor, body, m.capacity[sensor] / random.between(10.0, 25.0)});
  m.friction.of_load = random.about(m.friction.of_load);
  m.friction.of_drag = random.about(m.friction.of_drag);
  m.friction.exponent = random.between(0.52, 0.68);
  m.load = 100.0 * random.whole(3, 8);
  m.front_share = random.between(0.55, 0.68);
  m.room_mean = random.between(20.0, 23.0);
  m.chilled_to = m.room_mean + random.between(-0.3, 0.3);
  m.jacket = random.about(m.jacket);
  m.front_to_quill = random.about(m.front_to_quill);
  // A little of everything, so that no model is more than close.
  m.rotor_to_air = random.between(0.2, 1.2);
  m.motor_low = random.between(15.0, 70.0);
  m.motor_iron = random.between(15.0, 70.0);
  m.kinematic = random.between(-0.3, 0.3);
  return m;
}

/// Only one body moves the tool, a fifth is left to the others.
void let_dominate(Machine& m, Body body, double expansion) {
  for (double& a : m.expansion) a *= 0.12;
  m.expansion[body] = expansion;
}

double& conductance(Machine& m, Body a, Body b) {
  const auto is = [&](const Machine::Joint& j) { return j.a == a && j.b == b; };
  return std::find_if(m.joints.begin(), m.joints.end(), is)->conductance;
}

/// What of the plain machine an effect needs, so that it is one effect: no other body does the
/// same.
void shape_machine(const Class& wished, Setup& s, Random& random) {
  Machine& m = s.plain;
  if (hides(wished, "second-time-constant")) {
    // A quick body beside a slow one.
    let_dominate(m, quill, random.about(3.0));
    m.capacity[quill] = m.front_to_quill * random.between(300.0, 600.0);
    m.capacity[headstock] = random.about(320e3);
  } else if (hides(wished, "sensor-lag")) {
    let_dominate(m, quill, random.about(5.0));
    m.capacity[quill] = m.front_to_quill * random.between(1800.0, 3500.0);
  } else if (hides(wished, "thermal-asymmetry")) {
    let_dominate(m, quill, random.about(5.0));
    m.capacity[quill] = m.front_to_quill * random.between(900.0, 2000.0);
    conductance(m, quill, housing) = 0.05;
    m.to_air[quill] = 0.02;
  } else if (hides(wished, "speed-dependent-time-constant")) {
    // Nearly all heat leaves by the shaft, which fans itself.
    let_dominate(m, shaft, random.about(4.0));
    m.capacity[shaft] = random.about(12000.0);
    m.to_air[shaft] = random.about(4.0);
    m.front_to_quill = 0.3;
    for (const Body bearing : {front_bearing, rear_bearing}) {
      conductance(m, bearing, shaft) = random.about(18.0);
      conductance(m, bearing, housing) = 0.8;
    }
  } else if (hides(wished, "cooling-switch")) {
    let_dominate(m, housing, random.about(4.0));
    m.capacity[housing] = random.about(30000.0);
    m.to_air[housing] = random.about(5.0);
    conductance(m, housing, headstock) = random.about(3.0);
    m.motor_jacket = 4.0;
  } else if (hides(wished, "sensor-quantisation")) {
    m.expansion[front_bearing] = random.between(5.0, 9.0);
  }
}

/// Puts on what is hidden, `size` times its usual amount.
void hide(std::string_view id, double size, Setup& s, Random& random) {
  Machine& m = s.machine;
  const double last = s.train.back().time, end = std::max(last, s.test.back().time);
  if (id == "ambient-drift") {
    m.room = room(random.between(2.0, 3.5) * size, random);
  } else if (id == "motor-heat") {
    m.motor_low = random.between(500.0, 900.0) * size;
    m.motor_fade = random.between(1500.0, 4000.0);
    m.motor_iron = random.between(40.0, 120.0);
    m.expansion[motor] = s.plain.expansion[motor] = random.sign() * random.between(1.5, 3.0);
  } else if (id == "second-time-constant") {
    m.expansion[headstock] = random.between(6.0, 9.0) * size;
  } else if (id == "feed-axis-heat") {
    const auto axis = static_cast<std::size_t>(random.whole(0, 2));
    const double expansion = random.sign() * random.between(0.8, 2.0);
    m.screw_heat[axis] = random.between(6.0, 12.0) * size;
    m.expansion[screw_x + axis] = s.plain.expansion[screw_x + axis] = expansion;
  } else if (id == "cooling-switch") {
    m.jacket = random.about(22.0) * size;
    s.plain.pump_off = 1.0;
  } else if (id == "sensor-lag") {
    conductance(m, front_sensor, front_bearing) =
        m.capacity[front_sensor] / std::min(1500.0, random.between(400.0, 800.0) * size);
  } else if (id == "kinematic-displacement") {
    m.kinematic = random.sign() * random.between(7.0, 14.0) * size;
    m.kinematic_bend = random.between(800.0, 2500.0);
  } else if (id == "speed-dependent-time-constant") {
    m.rotor_to_air = random.between(10.0, 16.0) * size;
  } else if (id == "thermal-asymmetry") {
    const double ratio = 1.0 / std::min(4.5, random.between(2.2, 3.0) * size);
    m.back_flow = random.chance(0.7) ? ratio : 1.0 / ratio;
  } else if (id == "offset-jump") {
    for (const double t : calm_times(s.train, random.whole(1, 3), 700.0, random))
      m.jumps.push_back({t, random.sign() * random.between(6.0, 12.0) * size});
  } else if (id == "sensor-quantisation") {
    s.quantum = size < 0.8 ? 0.5 : size < 1.3 ? 1.0 : 2.0;
  } else if (id == "slow-drift") {
    m.to_air[mount] = s.plain.to_air[mount] = m.capacity[mount] / (random.between(0.2, 1.0) * last);
    m.expansion[mount] = s.plain.expansion[mount] = random.sign() * random.between(0.5, 0.9);
    m.warm_mount = random.between(13.0, 20.0) * size;
  } else if (id == "exchanged-columns") {
    std::vector<std::string_view> others;
    if (s.columns.rear) others.emplace_back("rear_bearing");
    if (s.columns.motor) others.emplace_back("motor");
    if (s.columns.headstock) others.emplace_back("headstock");
    s.exchanged_with =
        others.at(static_cast<std::size_t>(random.whole(0, static_cast<int>(others.size()) - 1)));
  } else if (id == "loose-sensor") {
    for (const double t : calm_times(s.train, 1, 700.0, random)) s.loose_from = t;
    s.loose_to = s.loose_from > 0.0 ? s.loose_from + random.between(3.0, 6.0) * hour : 0.0;
    s.loose_sees = std::max(0.1, random.between(0.3, 0.7) / size);
  } else if (id == "hydraulics" || id == "input") {
    m.aggregate = intervals(end, random.between(2.5, 5.0) * hour, random.between(0.8, 1.6) * hour,
                            0.03, random);
    m.aggregate_power = random.between(500.0, 900.0) * size;
  } else if (id == "door") {
    m.door = intervals(end, random.between(1.5, 3.5) * hour, random.between(0.2, 0.5) * hour, 0.1,
                       random);
    m.draught = random.between(50.0, 90.0) * size;
  } else if (id == "chips") {
    m.chips = intervals(end, 2.2 * hour, 0.5 * hour, 0.85, random);
    m.chips_power = random.between(200.0, 400.0) * size;
  } else if (id == "humidity") {
    for (const double period : {9.0, 6.3, 4.1, 3.2})
      m.humidity.waves.push_back({random.between(2.0, 4.0) * size, random.about(period) * hour,
                                  random.between(0.0, 2.0 * std::numbers::pi)});
  } else if (id == "stick-slip") {
    m.stick = random.between(8.0, 14.0) * size;
  } else {
    throw std::logic_error("nothing is known of " + std::string(id));
  }
}

Base draw_base(const Class& wished, Random& random) {
  const int kind = random.whole(0, 2);
  const auto any = [&](auto... ids) { return (hides(wished, ids) || ...); };
  if (any("second-time-constant", "sensor-lag", "thermal-asymmetry")) return {.sections = 1};
  if (any("speed-dependent-time-constant", "cooling-switch")) return {.power = true, .sections = 1};
  if (any("sensor-quantisation")) return {.feedthrough = true};
  if (is_wrong_data(wished)) return {.ambient = kind == 1};
  if (kind == 0) return {.power = true};
  return {.ambient = kind == 1 && !any("ambient-drift")};
}

void draw_plans(const Class& wished, Setup& s, Random& random) {
  constexpr std::array all{Profile::heat_cool, Profile::stairs, Profile::spectrum_30,
                           Profile::spectrum_60, Profile::spectrum_120};
  const auto any = [&](auto... ids) { return (hides(wished, ids) || ...); };
  const bool dense = any("kinematic-displacement", "offset-jump", "sensor-quantisation",
                         "sensor-lag", "loose-sensor");
  const bool one_run = dense || any("slow-drift");
  PlanWish& wish = s.train_wish;
  wish.hours = random.whole(24, 30);
  wish.profile = random.one_of(all);
  wish.top_speed = 1000.0 * random.whole(8, 12);
  wish.sampling = dense ? 30.0 : random.chance(0.3) ? 60.0 : 30.0;
  wish.uneven = random.chance(0.35);
  wish.stops = random.chance(0.25) && !dense;
  wish.runs = random.chance(0.2) && !one_run ? 2 : 1;
  wish.feeds = random.chance(0.25) || any("feed-axis-heat");
  wish.coolant_switches = any("cooling-switch");
  s.test_wish = wish;
  s.test_wish.runs = 1;
  s.test_wish.hours = random.whole(22, 32);
  do {
    s.test_wish.profile = random.one_of(all);
  } while (s.test_wish.profile == wish.profile);
  s.columns.feeds = wish.feeds;
  s.columns.coolant = wish.coolant_switches;
  s.train = make_plan(s.train_wish, random);
  s.test = make_plan(s.test_wish, random);
}

}  // namespace

std::span<const Class> classes() { return all_classes(); }

const Class& find_class(std::string_view id) {
  std::string known;
  for (const Class& c : all_classes()) {
    if (c.id == id) return c;
    known += " " + std::string(c.id);
  }
  throw std::invalid_argument("no class \"" + std::string(id) + "\"; there are" + known);
}

bool is_wrong_data(const Class& wished) {
  return hides(wished, "exchanged-columns") || hides(wished, "loose-sensor");
}

Machine Setup::machine_later() const {
  Machine later = machine;
  later.jumps.clear();
  later.warm_mount = 0.0;
  return later;
}

Setup draw_setup(const Class& wished, std::uint64_t seed, double size) {
  Random random(seed);
  Setup s{.plain = draw_machine(random), .base = draw_base(wished, random)};
  s.plain.room = room(s.base.ambient ? random.between(0.6, 1.2) : random.between(0.1, 0.3), random);
  shape_machine(wished, s, random);
  s.columns.rear = random.chance(0.4);
  s.columns.motor = random.chance(0.3) || (hides(wished, "motor-heat") && random.chance(0.6));
  s.columns.headstock = random.chance(0.3) || wished.id == "exchanged-columns";
  s.columns.base = random.chance(0.4);
  s.columns.column = wished.id == "input";
  s.columns.ambient = random.chance(0.3) ? 2 : 1;
  s.noise = random.between(0.1, 0.3);
  s.noise_declared = random.chance(0.7);
  s.table_scale = random.between(0.95, 1.05);
  s.table_exponent = s.plain.friction.exponent + random.between(-0.015, 0.015);
  draw_plans(wished, s, random);
  if (wished.id == "stray-readings") s.strays = 0.02;
  s.machine = s.plain;
  for (const std::string_view id : wished.hidden) hide(id, size, s, random);
  return s;
}

}  // namespace correction_study
