#include "correction/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "correction/own_effect.h"
#include "record/median.h"
#include "record/series_channel.h"
#include "shaft/kinematic_law.h"

namespace raceway::correction {
namespace {

constexpr std::size_t most_kept = std::size_t{96} << 20U;  // bytes

/// Kinds of what is kept, the first number of a key.
constexpr double of_input = 0, of_lag = 1, of_law = 2, of_motor = 3, of_decay = 4, of_settling = 5,
                 of_formula = 6, of_window = 7;

Hold hold_of(record::Course course) {
  return course == record::Course::straight ? Hold::straight : Hold::held;
}

}  // namespace

double driving_size(double value, double exponent) {
  const double size = std::abs(value);
  return exponent == 1.0 || size == 0.0 ? size
                                        : size * std::pow(size / (1000.0 * rpm), exponent - 1.0);
}

Series::Series(const record::Record& record) : record_(record) {
  clock_.settings_hold = record.settings_hold;
  const std::span<const double> time = record.values(record::time);
  if (time.empty()) throw std::invalid_argument("a displacement over time needs a column time_s");
  const record::Channel* const setup = record::series_channel("setup_id");
  std::map<std::pair<int, double>, int> zeros;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const bool begins = k == 0 || record.run_of(k) != record.run_of(k - 1);
    const double step = begins ? 0.0 : time[k] - time[k - 1];
    if (!(step > 0.0) && !begins)
      throw std::invalid_argument(fmt::format(
          "time_s of {} is {:.10g} s, which is {} {:.10g} s in the row before: time must increase "
          "within a run",
          record.place(k), time[k], step == 0.0 ? "the same as" : "earlier than", time[k - 1]));
    clock_.steps.push_back(step);
    clock_.begins.push_back(begins);
    time_.push_back(begins ? 0.0 : time_.back() + step);
    whole_time_.push_back(k == 0 ? 0.0 : whole_time_.back() + step);
    const double clamped = record.has(*setup) ? record.value(*setup, k) : 0.0;
    zero_.push_back(
        zeros.emplace(std::pair{record.run_of(k), clamped}, static_cast<int>(zeros.size()))
            .first->second);
  }
  zeros_ = std::max(1, static_cast<int>(zeros.size()));
  for (const double n : record.values(record::speed)) speed_rpm_.push_back(std::abs(n) / rpm);
  const auto coolant = record.values(*record::series_channel("coolant_on"));
  coolant_.assign(coolant.begin(), coolant.end());
}

template <typename Make>
Series::Values Series::kept(Key key, const Make& make) const {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
  }
  auto made = std::make_shared<std::vector<double>>(rows());
  make(*made);
  const std::scoped_lock lock(mutex_);
  // Inputs are few and asked for always; of the rest none is worth more than another.
  if (kept_.size() * rows() * sizeof(double) > most_kept)
    std::erase_if(kept_, [](const auto& one) { return one.first.front() != of_input; });
  return kept_.emplace(std::move(key), std::move(made)).first->second;
}

double Series::id_of(const Input& input) const {
  std::string text;
  for (const record::Channel* c : input.columns) text += std::string(c->name) + " ";
  if (input.formula) text += "formula " + input.name;
  if (input.reference) text += "- " + std::string(input.reference->name);
  if (input.window)
    text += fmt::format(" at {} {} {}", input.window->column->name,
                        fmt::join(input.window->points, " "), input.window->of_input);
  if (input.exponent != 1.0)
    text += fmt::format("^{} {} {}", input.exponent, input.seen.lower, input.seen.upper);
  if (input.is_power()) {
    text += fmt::format("power {} {} {}", static_cast<const void*>(input.table.get()),
                        input.within.lower, input.within.upper);
    for (const TableCoordinate& c : {input.axial_load, input.radial_load, input.temperature})
      text += fmt::format(" {} {}", c.value, c.column ? c.column->name : "");
  }
  const std::scoped_lock lock(mutex_);
  const auto found = std::find(inputs_.begin(), inputs_.end(), text);
  const auto id = static_cast<double>(found - inputs_.begin());
  if (found == inputs_.end()) inputs_.push_back(std::move(text));
  return id;
}

std::vector<FrictionTable::Point> Series::points_of_table(const Input& input) const {
  if (speed_rpm_.empty()) throw std::invalid_argument("the input power_W needs a column speed_rpm");
  std::vector<FrictionTable::Point> points(
      rows(), {0.0, input.axial_load.value, input.radial_load.value, input.temperature.value});
  for (std::size_t k = 0; k < rows(); ++k) points[k].speed = speed_rpm_[k] * rpm;
  const auto read = [&](const TableCoordinate& of, double FrictionTable::Point::*into) {
    if (!of.column) return;
    const std::span<const double> values = record_.values(*of.column);
    if (values.empty())
      throw std::invalid_argument(
          fmt::format("the input power_W needs a column {}", of.column->name));
    for (std::size_t k = 0; k < rows(); ++k) points[k].*into = values[k];
  };
  read(input.axial_load, &FrictionTable::Point::axial_load);
  read(input.radial_load, &FrictionTable::Point::radial_load);
  read(input.temperature, &FrictionTable::Point::temperature);
  return points;
}

std::vector<double> Series::power(const Input& input) const {
  std::vector<double> list;
  for (const FrictionTable::Point& at : points_of_table(input)) {
    const double power = at.speed * (*input.table)(at);
    list.push_back(power < input.within.lower   ? input.within.lower
                   : power > input.within.upper ? input.within.upper
                                                : power);
  }
  return list;
}

std::vector<double> Series::formula(const Input& input) const {
  const OwnEffect& effect = *input.formula;
  std::vector<std::span<const double>> columns;
  for (const record::Channel* c : effect.columns()) {
    columns.push_back(record_.values(*c));
    if (columns.back().empty())
      throw std::invalid_argument(
          fmt::format("column {} is missing; the formula of {} needs it", c->name, input.name));
  }
  const bool from_first = effect.follows_a_temperature();
  std::vector<double> list, row(columns.size()), scratch;
  double first = 0.0;
  for (std::size_t k = 0; k < rows(); ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      row[c] = effect.columns()[c]->in_unit(columns[c][k]);
    const double value = effect.value(row, input.formula_values, scratch);
    if (clock_.begins[k] && from_first) first = value;
    list.push_back(value - first);
  }
  return list;
}

Series::Key Series::key_of(const Input& input) const {
  Key key{input.formula ? of_formula : of_input, id_of(input)};
  key.insert(key.end(), input.formula_values.begin(), input.formula_values.end());
  return key;
}

std::size_t Series::rows_beyond_table(const Input& input) const {
  if (!input.is_power()) return 0;
  const std::vector<FrictionTable::Point> points = points_of_table(input);
  // At rest there is no power, whatever the torque.
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const auto& at) {
    return at.speed != 0.0 && !input.table->holds(at);
  }));
}

std::vector<double> Series::shares(const Window& window) const {
  const std::span<const double> values = record_.values(*window.column);
  if (values.empty())
    throw std::invalid_argument(
        fmt::format("column {} is missing; the model needs it", window.column->name));
  const bool by_amount = record::acts_by_amount(*window.column);
  std::vector<double> list;
  for (const double v : values) list.push_back(window(by_amount ? std::abs(v) : v));
  return list;
}

Series::Values Series::shown_share(const Input& input) const {
  if (!input.window || input.window->of_input) return nullptr;
  return kept({of_window, id_of(input)}, [&](std::vector<double>& out) {
    const std::vector<double> share = shares(*input.window);
    for (std::size_t k = 0; k < rows(); ++k) out[k] = share[clock_.seen_at(k)];
  });
}

double Series::sampling() const {
  std::vector<double> steps;
  for (std::size_t k = 0; k < rows(); ++k)
    if (!clock_.begins[k]) steps.push_back(clock_.steps[k]);
  return record::median(steps);
}

double Series::duration() const { return *std::max_element(time_.begin(), time_.end()); }

Series::Values Series::input(const Input& of) const {
  return kept(key_of(of), [&](std::vector<double>& all) {
    Input plain = of;
    plain.window.reset();
    if (of.window) {
      all = *input(plain);
      if (!of.window->of_input) return;
      const std::vector<double> share = shares(*of.window);
      for (std::size_t k = 0; k < rows(); ++k) all[k] *= share[k];
      return;
    }
    fill(of, all);
  });
}

void Series::fill(const Input& input, std::vector<double>& out) const {
  if (input.formula) {
    out = formula(input);
    return;
  }
  if (input.is_power()) {
    out = power(input);
    return;
  }
  const bool from_first = input.course() == record::Course::straight;
  const Interval from_rest{0.0, input.seen.upper};
  const auto size = [&](double v) {
    return continued([&](double n) { return driving_size(n, input.exponent); }, from_rest,
                     std::abs(v));
  };
  const auto acting = [&](const record::Channel& channel, double v) {
    return record::acts_by_amount(channel) ? size(v) : v;
  };
  const auto add = [&](const record::Channel& channel, double weight) {
    const std::span<const double> values = record_.values(channel);
    if (values.empty())
      throw std::invalid_argument(
          fmt::format("column {} is missing; the model needs it", channel.name));
    double first = 0.0;
    for (std::size_t k = 0; k < rows(); ++k) {
      if (clock_.begins[k]) first = from_first ? values[k] : 0.0;
      out[k] += weight * (from_first ? values[k] - first : acting(channel, values[k]));
    }
  };
  for (const record::Channel* c : input.columns)
    add(*c, 1.0 / static_cast<double>(input.columns.size()));
  if (input.reference) add(*input.reference, -1.0);
}

Series::Values Series::at_once(const Input& of) const {
  Values driving = input(of);
  const Values share = shown_share(of);
  const bool as_it_is = clock_.settings_hold != record::SettingsHold::from_row ||
                        of.course() == record::Course::straight;
  if (as_it_is && !share) return driving;
  auto seen = std::make_shared<std::vector<double>>(rows());
  for (std::size_t k = 0; k < rows(); ++k)
    (*seen)[k] = (share ? (*share)[k] : 1.0) * (*driving)[as_it_is ? k : clock_.seen_at(k)];
  return seen;
}

/// Steps of a lag whose time constant changes from row to row, exact while it holds.
void Series::answer(const std::vector<double>& input, record::Course course, double time_constant,
                    const Answer& by, std::vector<double>& state) const {
  const Hold hold = hold_of(course);
  const double from_sensor = by.sensor_time_constant / time_constant;
  const auto factor = [&](double n) { return 1.0 / (1.0 + by.speed_factor * n / 10000.0); };
  double speed = unset, f = 1.0, gain_factor = 1.0;
  std::vector<double>& x = state;
  for (std::size_t k = 0; k < rows(); ++k) {
    if (clock_.begins[k]) {
      x[k] = 0.0;
      continue;
    }
    const std::size_t set = clock_.held_until(k);
    if (!speed_rpm_.empty() && speed_rpm_[set] != speed) {
      speed = speed_rpm_[set];
      f = continued(factor, by.speed, speed);
      gain_factor =
          continued([&](double n) { return std::pow(factor(n), by.gain_power); }, by.speed, speed);
    }
    const bool off = !coolant_.empty() && coolant_[set] < 0.5;
    const double gain = gain_factor * (off ? by.off_gain : 1.0);
    const double before = gain * input[hold == Hold::straight ? k - 1 : set];
    const double after = hold == Hold::straight ? gain * input[k] : before;
    double tau = time_constant * f * (off ? by.off_time_constant : 1.0);
    if (0.5 * (before + after) < x[k - 1]) tau *= by.falling;
    const LagStep step = lag_step(clock_.steps[k] / tau, hold);
    x[k] = step.decay * x[k - 1] + step.old_weight * before + step.new_weight * after;
  }
  if (from_sensor > 0.0)
    for (std::size_t k = 0; k < rows(); ++k) x[k] += from_sensor * (input[k] - x[k]);
}

Series::Values Series::lag(const Input& of, double time_constant, const Answer& by) const {
  Key key{of_lag,          id_of(of),
          time_constant,   by.sensor_time_constant,
          by.off_gain,     by.off_time_constant,
          by.speed_factor, by.gain_power,
          by.falling,      by.speed.lower,
          by.speed.upper};
  key.insert(key.end(), of.formula_values.begin(), of.formula_values.end());
  return kept(std::move(key), [&](std::vector<double>& out) {
    const Values driving = input(of);
    if (by.is_plain())
      lag_response(clock_, *driving, hold_of(of.course()), time_constant, 0.0, out);
    else
      answer(*driving, of.course(), time_constant, by, out);
    if (const Values share = shown_share(of))
      for (std::size_t k = 0; k < out.size(); ++k) out[k] *= (*share)[k];
  });
}

Series::Values Series::kinematic(double B, double C, const Interval& seen) const {
  const auto law = [&](double n) { return shaft::kinematic_displacement_um(n, 1.0, B, C); };
  const Interval from_rest{0.0, seen.upper};
  return kept({of_law, B, C, seen.upper}, [&](std::vector<double>& out) {
    if (speed_rpm_.empty())
      throw std::invalid_argument("the kinematic displacement needs a column speed_rpm");
    double last = -1.0, value = 0.0;
    for (std::size_t k = 0; k < rows(); ++k) {
      if (const double speed = speed_rpm_[clock_.seen_at(k)]; speed != last) {
        last = speed;
        value = continued(law, from_rest, last);
      }
      out[k] = value;
    }
  });
}

Series::Values Series::motor(double decay_speed_rpm, double time_constant,
                             const Interval& seen) const {
  const auto law = [&](double n) { return std::exp(-n / decay_speed_rpm); };
  return kept({of_motor, decay_speed_rpm, time_constant, seen.lower, seen.upper},
              [&](std::vector<double>& out) {
                if (speed_rpm_.empty())
                  throw std::invalid_argument("motor-heat needs a column speed_rpm");
                std::vector<double> heat;
                for (const double n : speed_rpm_)
                  heat.push_back(n > 0.0 ? continued(law, seen, n) : 0.0);
                lag_response(clock_, heat, Hold::held, time_constant, 0.0, out);
              });
}

Series::Values Series::decay(double time_constant) const {
  return kept({of_decay, time_constant}, [&](std::vector<double>& out) {
    bool first = true;
    for (std::size_t k = 0; k < rows(); ++k) {
      first = first && (k == 0 || !clock_.begins[k]);
      out[k] = first ? std::exp(-time_[k] / time_constant) : 0.0;
    }
  });
}

Series::Values Series::settling(double time_constant) const {
  return kept({of_settling, time_constant}, [&](std::vector<double>& out) {
    for (std::size_t k = 0; k < rows(); ++k) out[k] = -std::expm1(-whole_time_[k] / time_constant);
  });
}

}  // namespace raceway::correction
