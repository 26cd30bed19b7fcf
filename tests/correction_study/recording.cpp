#include "tests/correction_study/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace correction_study {
namespace {

constexpr double temperature_noise = 0.02;  // [K]
constexpr double least_stray = 2.5;         // [um], more than noise ever is

double to_lattice(double value, double quantum) { return quantum * std::round(value / quantum); }

/// Columns of a recording, in the order of their making.
class Writer {
 public:
  Writer(const Setup& setup, const std::vector<PlannedRow>& plan, const Course& course,
         Random& random)
      : setup_(setup), plan_(plan), course_(course), random_(random) {}

  template <typename Value>
  void add(const std::string& name, int decimals, const Value& value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < plan_.size(); ++i) values.push_back(value(i));
    out_.push_back({name, std::move(values), decimals});
  }
  void temperature(const std::string& name, Body body, double quantum) {
    add(name + "_temperature_C", quantum < 1.0 ? 2 : 1, [&](std::size_t i) {
      return to_lattice(course_.temperatures[i][body] + temperature_noise * random_.normal(),
                        quantum);
    });
  }
  /// Of a room that is a little otherwise at every place.
  void ambient(const Machine& machine) {
    for (int k = 0; k < setup_.columns.ambient; ++k) {
      const Waves place{{{0.08, random_.between(7000.0, 15000.0), random_.between(0.0, 6.0)}}};
      const double off = random_.between(-0.4, 0.4);
      const std::string name =
          setup_.columns.ambient == 1 ? "ambient" : fmt::format("ambient_{}", k + 1);
      add(name + "_temperature_C", 2, [&](std::size_t i) {
        const double t = plan_[i].time;
        return to_lattice(
            machine.room_temperature(t) + place.at(t) + off + temperature_noise * random_.normal(),
            0.1);
      });
    }
  }
  std::vector<Recording::Column> take() { return std::move(out_); }

 private:
  const Setup& setup_;
  const std::vector<PlannedRow>& plan_;
  const Course& course_;
  Random& random_;
  std::vector<Recording::Column> out_;
};

/// What is wrong with the sensors while a record is taken.
void spoil(const Setup& setup, const Machine& machine, const std::vector<PlannedRow>& plan,
           std::vector<Recording::Column>& columns) {
  const auto of = [&](const std::string& sensor) -> std::vector<double>& {
    return std::find_if(
               columns.begin(), columns.end(),
               [&](const Recording::Column& c) { return c.name == sensor + "_temperature_C"; })
        ->values;
  };
  if (!setup.exchanged_with.empty()) of("front_bearing").swap(of(setup.exchanged_with));
  std::vector<double>& front = of("front_bearing");
  for (std::size_t i = 0; i < plan.size(); ++i)
    if (plan[i].time >= setup.loose_from && plan[i].time < setup.loose_to) {
      const double room = machine.room_temperature(plan[i].time);
      front[i] = to_lattice(room + setup.loose_sees * (front[i] - room), 0.1);
    }
}

}  // namespace

const std::vector<double>& Recording::column(const std::string& name) const {
  for (const Column& c : columns)
    if (c.name == name) return c.values;
  throw std::logic_error("no column " + name);
}

bool Recording::has(const std::string& name) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& c) { return c.name == name; });
}

std::string Recording::csv() const {
  fmt::memory_buffer out;
  for (const Column& c : columns)
    fmt::format_to(std::back_inserter(out), "{}{}", c.name, &c == &columns.back() ? "\n" : ",");
  for (std::size_t i = 0; i < clean.size(); ++i)
    for (const Column& c : columns) {
      if (!std::isnan(c.values[i]))
        fmt::format_to(std::back_inserter(out), "{:.{}f}", c.values[i], c.decimals);
      out.push_back(&c == &columns.back() ? '\n' : ',');
    }
  return fmt::to_string(out);
}

Recording record(const Setup& setup, bool later, std::uint64_t seed) {
  Random random(seed);
  const std::vector<PlannedRow>& plan = later ? setup.test : setup.train;
  const Machine machine = later ? setup.machine_later() : setup.machine;
  const Course course = follow(machine, plan);
  Recording out;
  out.clean = course.displacement;
  const Columns& has = setup.columns;
  Writer w(setup, plan, course, random);
  w.add("time_s", 2, [&](std::size_t i) { return plan[i].time; });
  w.add("speed_rpm", 0, [&](std::size_t i) { return plan[i].setting.speed; });
  w.temperature("front_bearing", front_sensor, setup.quantum);
  if (has.rear) w.temperature("rear_bearing", rear_sensor, 0.1);
  if (has.motor) w.temperature("motor", motor_sensor, 0.1);
  if (has.headstock) w.temperature("headstock", headstock, 0.1);
  if (has.base) w.temperature("base", bed, 0.1);
  if (has.column) w.temperature("column", column, 0.1);
  w.ambient(machine);
  for (std::size_t axis = 0; has.feeds && axis < 3; ++axis)
    w.add(std::string(1, "xyz"[axis]) + "_feed_m_min", 2,
          [&](std::size_t i) { return 0.01 * std::round(100.0 * plan[i].setting.feed[axis]); });
  if (has.coolant)
    w.add("coolant_on", 0, [&](std::size_t i) { return plan[i].setting.coolant_on ? 1.0 : 0.0; });
  w.add("displacement_z_um", 2, [&](std::size_t i) {
    double measured = course.displacement[i] + setup.noise * random.normal();
    if (setup.strays > 0.0 && !later && random.chance(setup.strays))
      measured -= random.between(2.0 * least_stray, 40.0);
    return plan[i].read ? 0.01 * std::round(100.0 * measured)
                        : std::numeric_limits<double>::quiet_NaN();
  });
  if (plan.back().run > 1) w.add("run_id", 0, [&](std::size_t i) { return plan[i].run; });
  out.columns = w.take();
  if (!later) spoil(setup, machine, plan, out.columns);
  return out;
}

std::vector<double> hidden_part(const Setup& setup, bool later) {
  const std::vector<PlannedRow>& plan = later ? setup.test : setup.train;
  std::vector<double> part =
      follow(later ? setup.machine_later() : setup.machine, plan).displacement;
  const std::vector<double> plain = follow(setup.plain, plan).displacement;
  std::transform(part.begin(), part.end(), plain.begin(), part.begin(), std::minus());
  return part;
}

double table_torque(const Setup& setup, double speed_rpm, double temperature) {
  TorqueLaw law = setup.plain.friction;
  law.exponent = setup.table_exponent;
  return setup.table_scale * law.torque(speed_rpm, setup.plain.load, temperature);
}

Signals signals(const Setup& setup, const Recording& recording) {
  Signals s;
  s.time = recording.column("time_s");
  s.displacement = recording.column("displacement_z_um");
  // What a chip falsifies is no part of what a model can reach.
  for (std::size_t i = 0; setup.strays > 0.0 && i < s.displacement.size(); ++i)
    if (s.displacement[i] < recording.clean[i] - least_stray)
      s.displacement[i] = recording.clean[i];
  s.speed = recording.column("speed_rpm");
  s.run.assign(s.time.size(), 1);
  if (recording.has("run_id"))
    std::transform(recording.column("run_id").begin(), recording.column("run_id").end(),
                   s.run.begin(), [](double run) { return static_cast<int>(run); });
  s.spindle = recording.column("front_bearing_temperature_C");
  for (std::size_t i = 0; setup.base.power && i < s.time.size(); ++i)
    s.spindle[i] =
        table_torque(setup, s.speed[i], s.spindle[i]) * s.speed[i] * std::numbers::pi / 30.0;
  s.ambient.assign(s.time.size(), 0.0);
  for (const Recording::Column& c : recording.columns)
    for (std::size_t i = 0; c.name.starts_with("ambient") && i < s.time.size(); ++i)
      s.ambient[i] += c.values[i] / setup.columns.ambient;
  if (setup.columns.motor) s.motor = recording.column("motor_temperature_C");
  if (setup.columns.column) s.column = recording.column("column_temperature_C");
  for (std::size_t axis = 0; setup.columns.feeds && axis < 3; ++axis)
    for (const double f : recording.column(std::string(1, "xyz"[axis]) + "_feed_m_min"))
      s.feed[axis].push_back(std::abs(f));
  if (setup.columns.coolant) s.coolant = recording.column("coolant_on");
  return s;
}

std::string friction_table(const Setup& setup) {
  std::string out =
      "# torque of all bearings of the spindle, from another one of its kind\n"
      "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  std::vector<double> speeds{0.0, 100.0, 200.0, 300.0, 400.0};
  for (double n = 500.0; n <= 12000.0; n += 500.0) speeds.push_back(n);
  for (const double n : speeds)
    for (const double T : {15.0, 25.0, 35.0, 45.0, 55.0})
      out += fmt::format("{:.0f},{:.0f},{:.0f},{:.2f}\n", n, setup.plain.load, T,
                         1000.0 * table_torque(setup, n, T));
  return out;
}

}  // namespace correction_study
