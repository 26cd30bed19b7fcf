#include "session/sensitivity.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "fit/problem.h"
#include "io/error.h"
#include "io/names.h"
#include "io/number_range.h"
#include "io/number_text.h"
#include "io/plausible.h"
#include "io/spindle_results.h"
#include "io/units.h"
#include "model/bearing_life.h"
#include "model/parameters.h"
#include "session/operating_point.h"
#include "session/solve_states.h"
#include "session/spindle_steady.h"
#include "session/table_columns.h"

namespace raceway::session {
namespace {

using io::LocalSensitivity;
using io::PredictionSensitivity;
using io::Sensitivity;
using io::VariedDatum;

constexpr double usual_share = 0.01;  // of a value
constexpr double usual_kelvin = 1.0;
constexpr double step_of_usual = 0.1;
constexpr std::size_t most_states = 10000, most_numbers = 100000000;

constexpr std::string_view life = "life_h", stiffness = "axial_stiffness_N_um",
                           hottest_ring = "hottest_ring_temperature_C";

bool in_celsius(std::string_view name) { return name.ends_with("_C"); }

/// A number of the question that may be varied too, where one value was asked.
struct Axis {
  std::string_view name, flag;
  std::vector<double> values;
  io::NumberRange range;
};

std::vector<Axis> axes_of(const SensitivityQuestion& q, bool shaft) {
  return {{"speed_rpm", "--speed", q.speeds_rpm, io::speed_range},
          {"axial_load_N", "--axial-load", q.axial_loads_N,
           shaft ? io::signed_load_range : io::load_range},
          {"radial_load_N", "--radial-load", q.radial_loads_N, io::load_range},
          {"temperature_C", "--temperature", q.temperatures_C, io::temperature_range}};
}

/// Numbers of one state; NaN: as the model says.
using State = std::array<double, 4>;

bearing::OperatingPoint point_of_state(const State& state, const model::Model& model) {
  return point_of(model, {.speed_rpm = state[0],
                          .axial_load_N = state[1],
                          .radial_load_N = state[2],
                          .temperature_C = state[3]});
}

std::vector<std::string> known_columns(const model::Model& model, bool steady) {
  std::vector<std::string> names;
  if (steady) {
    for (const io::RunColumn& c : io::run_columns(model, {}, {}))
      if (c.name != "speed_rpm") names.push_back(c.name);
    if (!model.spindle->network) {
      names.emplace_back(stiffness);
      names.emplace_back(hottest_ring);
    }
    return names;
  }
  names = state_columns(model);
  if (model.shaft)
    names.emplace_back(stiffness);
  else if (std::find(names.begin(), names.end(), life) == names.end())
    names.emplace_back(life);
  return names;
}

/// What is asked, ready to be evaluated with any data.
class Predictor {
 public:
  Predictor(const SensitivityQuestion& question, std::vector<std::string> wanted,
            const model::Model& model)
      : question_(question), wanted_(std::move(wanted)) {
    if (question.steady) return;
    const std::vector<std::string> table = state_columns(model);
    columns_ = table.size() - 1;  // the torque is none of them
    for (const std::string& name : wanted_) {
      const auto at = std::find(table.begin(), table.end(), name);
      places_.push_back(static_cast<std::size_t>(at - table.begin()));
      if (at != table.end())
        units_.push_back(io::column_unit(name));
      else
        units_.push_back(1.0);
    }
  }

  [[nodiscard]] const std::vector<std::string>& wanted() const { return wanted_; }

  /// State by state, in the units of the names; NaN where there is no value.
  [[nodiscard]] std::vector<double> operator()(const io::ModelFile& file,
                                               const std::vector<State>& states) const {
    return question_.steady ? steady(file, states) : at_once(file.model, states);
  }

 private:
  [[nodiscard]] std::vector<double> at_once(const model::Model& model,
                                            const std::vector<State>& states) const {
    std::vector<bearing::OperatingPoint> points;
    for (const State& s : states) points.push_back(point_of_state(s, model));
    std::vector<double> columns(points.size() * columns_, unset);
    std::vector<friction::TablePoint> solved(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      solved[i].columns = std::span(columns).subspan(i * columns_, columns_);
    fill_table_line(model, points, solved, Columns::of_states);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < wanted_.size(); ++k) {
        const double si = places_[k] == 0          ? solved[i].friction_moment
                          : places_[k] <= columns_ ? solved[i].columns[places_[k] - 1]
                          : wanted_[k] == life     ? life_of(model, points[i])
                                                   : stiffness_of(model, points[i]);
        values.push_back(si / units_[k]);
      }
    return values;
  }

  static double life_of(const model::Model& model, const bearing::OperatingPoint& point) {
    const model::FrictionPrediction p = model::predict_friction(model, point, true);
    if (!p.equilibrium || !p.equilibrium->report.converged()) return unset;
    constexpr double hour = 3600.0;
    return bearing_life(model.life, p.bearing ? *p.bearing : model.bearing, point, *p.equilibrium,
                        p.film.kinematic_viscosity)
               .reference /
           hour;
  }

  static double stiffness_of(const model::Model& model, const bearing::OperatingPoint& point) {
    const auto p = shaft::predict_shaft(model, shaft_points({&point, 1}));
    return p[0].equilibrium.report.converged() ? p[0].equilibrium.axial_stiffness / N_per_um
                                               : unset;
  }

  [[nodiscard]] std::vector<double> steady(const io::ModelFile& file,
                                           const std::vector<State>& states) const {
    spindle::Simulator simulator = simulator_of(file);
    simulator.stop_on(question_.cancelled);
    std::vector<double> values;
    for (const State& s : states) {
      const spindle::Inputs inputs{.speed = s[0] * rpm,
                                   .axial_load = file.model.shaft->external_load,
                                   .coolant_on = question_.coolant_on};
      spindle::Report report;
      const spindle::Moment m = simulator.steady(inputs, report);
      std::vector<io::RunColumn> known = io::run_columns(file.model, inputs, m);
      double hottest = unset;
      for (const spindle::BearingState& b : m.bearings)
        hottest = std::fmax(hottest, std::fmax(b.inner_ring_temperature, b.outer_ring_temperature));
      known.push_back({std::string(hottest_ring), celsius(hottest)});
      known.push_back({std::string(stiffness),
                       simulator.sets() ? simulator.sets()->axial_stiffness / N_per_um : unset});
      for (const std::string& name : wanted_) {
        const auto at = std::find_if(known.begin(), known.end(),
                                     [&](const io::RunColumn& c) { return c.name == name; });
        values.push_back(report.converged() && at != known.end() ? at->value : unset);
      }
    }
    return values;
  }

  const SensitivityQuestion& question_;
  std::vector<std::string> wanted_;
  std::size_t columns_ = 0;
  std::vector<std::size_t> places_;
  std::vector<double> units_;
};

/// Predictions of one set of data, or why the model does not take them.
struct Outcome {
  std::vector<double> values{};
  std::string refused{};
  [[nodiscard]] bool has_all() const {
    return refused.empty() &&
           std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  }
};

/// Message of an error without the place that a number of a file would have.
std::string without_place(const std::string& message, const std::string& source) {
  if (!message.starts_with(source + ":")) return message;
  const std::size_t space = message.find(' ', source.size());
  return space == message.npos ? message : message.substr(space + 1);
}

/// The numbers that may be varied, in the model and in the question.
class Data {
 public:
  Data(const io::ModelFile& file, const SensitivityQuestion& question, std::vector<State> states)
      : question_(question), of_model_(file), source_(file.source), states_(std::move(states)) {
    for (const io::ModelDatum& d : of_model_.data())
      all_.push_back({.name = d.name,
                      .value = d.value,
                      .origin = d.origin == io::ModelDatum::Origin::file         ? "file"
                                : d.origin == io::ModelDatum::Origin::by_default ? "default"
                                                                                 : "catalogue",
                      .whole = d.whole,
                      .has_elasticity = !in_celsius(d.name)});
    const std::vector<Axis> axes = axes_of(question, file.model.shaft.has_value());
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].values.size() == 1) {
        axes_.push_back(a);
        all_.push_back({.name = std::string(axes[a].name),
                        .value = axes[a].values.front(),
                        .origin = "asked",
                        .has_elasticity = !in_celsius(axes[a].name)});
      }
    for (const std::string& name : question.data) {
      const std::size_t before = asked_.size();
      for (std::size_t k = 0; k < all_.size(); ++k)
        if (all_[k].name.starts_with(name + ".")) asked_.push_back(k);
      if (asked_.size() == before) asked_.push_back(find(name));
    }
  }

  [[nodiscard]] const std::vector<VariedDatum>& all() const { return all_; }
  [[nodiscard]] std::vector<VariedDatum>& all() { return all_; }

  /// The one of the question before one of the model.
  [[nodiscard]] std::size_t find(const std::string& name) const {
    for (std::size_t k = of_model_.data().size(); k < all_.size(); ++k)
      if (all_[k].name == name) return k;
    return of_model_.find(name);
  }

  /// Whether it is among those that the question names: all where it names none.
  [[nodiscard]] bool is_asked(std::size_t k) const {
    return asked_.empty() || std::find(asked_.begin(), asked_.end(), k) != asked_.end();
  }

  [[nodiscard]] Outcome predict(const Predictor& predictor,
                                std::span<const std::pair<std::size_t, double>> changes) const {
    if (question_.cancelled && *question_.cancelled) throw fit::Cancelled();
    std::vector<std::pair<std::size_t, double>> of_file;
    std::vector<State> states = states_;
    for (const auto& [k, value] : changes) {
      if (k < of_model_.data().size()) {
        of_file.emplace_back(k, value);
        continue;
      }
      const std::size_t axis = axes_[k - of_model_.data().size()];
      if (axis < 3 && value < 0.0 && all_[k].value >= 0.0)
        return {.refused = fmt::format("{} = {:.6g}: must not be negative", all_[k].name, value)};
      for (State& s : states) s[axis] = value;
    }
    try {
      io::ModelFile file = of_model_.with(of_file);
      if (question_.amend) question_.amend(file);
      return {.values = predictor(file, states)};
    } catch (const io::InputError& e) {
      return {.refused = without_place(e.what(), source_)};
    } catch (const std::invalid_argument& e) {
      return {.refused = e.what()};
    }
  }

 private:
  const SensitivityQuestion& question_;
  io::ModelData of_model_;
  std::string source_;
  std::vector<State> states_;
  std::vector<VariedDatum> all_;
  std::vector<std::size_t> asked_;
  std::vector<std::size_t> axes_;  // of the data behind those of the model
};

/// Calls `work(i)` for all of them on all cores, and tells how far it is.
template <typename Work>
void for_all(std::size_t count, const SensitivityQuestion& question, double from, double to,
             const Work& work) {
  std::mutex mutex;
  std::size_t ended = 0;
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        work(i);
        if (!question.progress) return;
        const std::lock_guard lock(mutex);
        question.progress(from +
                          (to - from) * static_cast<double>(++ended) / static_cast<double>(count));
      },
      tbb::simple_partitioner{});
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return x == y || (std::isnan(x) && std::isnan(y));
         });
}

/// The predictions around one datum.
struct Around {
  double step = unset;  // 0: not varied
  // At value + step, - step, + step/2, - step/2, + spread, - spread.
  std::array<Outcome, 6> at;
};

/// Slope of f through f(0) and f(h), f(h/2) on one side, of second order.
double one_sided_slope(double f0, double whole, double half, double h) {
  return (4.0 * half - whole - 3.0 * f0) / h;
}

/// Smaller differences are not told from the ends of iterations.
constexpr double least_told = 1e-4;  // of the largest change of a prediction

void look_at_steps(const VariedDatum& datum, const Around& around, std::size_t i, double f0,
                   LocalSensitivity& local) {
  const auto value = [&](std::size_t which) {
    const Outcome& one = around.at[which];
    return one.refused.empty() ? one.values[i] : unset;
  };
  const double h = around.step, up = value(0), down = value(1), up_2 = value(2), down_2 = value(3);
  local.high = datum.spread > 0.0 ? value(4) : f0;
  local.low = datum.spread > 0.0 ? value(5) : f0;
  if (datum.whole) {
    local.one_sided = std::isnan(up) || std::isnan(down);
    local.derivative = std::isnan(up)     ? (f0 - down) / h
                       : std::isnan(down) ? (up - f0) / h
                                          : (up - down) / (2.0 * h);
    return;
  }
  if (std::isnan(up) || std::isnan(up_2) || std::isnan(down) || std::isnan(down_2)) {
    local.one_sided = true;
    const bool above = std::isfinite(up) && std::isfinite(up_2);
    const double side = above ? h : -h, whole = above ? up : down, half = above ? up_2 : down_2;
    local.derivative = one_sided_slope(f0, whole, half, side);
    // Of a smooth prediction its curvature, which the extrapolation takes off.
    local.derivative_error = std::fabs(local.derivative - (half - f0) / (0.5 * side));
    return;
  }
  const double coarse = (up - down) / (2.0 * h), fine = (up_2 - down_2) / h;
  local.derivative = (4.0 * fine - coarse) / 3.0;
  local.derivative_error = std::fabs(local.derivative - fine);
}

/// Where slopes to both sides differ, and do so as much with half the step, the prediction has a
/// kink.
void look_for_kinks(const VariedDatum& datum, const Around& around, std::size_t i, double f0,
                    double largest, LocalSensitivity& local) {
  if (datum.whole || !std::isfinite(local.derivative)) return;
  const double h = around.step, size = datum.spread > 0.0 ? datum.spread : h;
  const double told = std::fmax(0.02 * std::fabs(local.derivative) * size, least_told * largest);
  local.steps_disagree = local.derivative_error * size > told;
  if (local.one_sided) return;
  const auto value = [&](std::size_t which) { return around.at[which].values[i]; };
  const double bend = std::fabs(value(0) - 2.0 * f0 + value(1)) / h;
  const double bend_2 = std::fabs(value(2) - 2.0 * f0 + value(3)) / (0.5 * h);
  local.kink = bend_2 * size > told && bend_2 > 0.7 * bend;
}

double usual_spread(const VariedDatum& datum, std::string& from) {
  if (datum.whole) {
    from = "1";
    return 1.0;
  }
  if (in_celsius(datum.name)) {
    from = "1 K";
    return usual_kelvin;
  }
  from = "1 %";
  return usual_share * std::fabs(datum.value);
}

/// Standard errors of fitted numbers, as far as the model carries them.
void take_standard_errors(const model::Model& model, Data& data) {
  if (!model.covariance) return;
  const std::vector<record::Parameter> known = model::parameters(model);
  for (std::size_t k = 0; k < model.covariance->names.size(); ++k)
    for (const record::Parameter& p : known) {
      if (p.name != model.covariance->names[k]) continue;
      for (const std::string& address : p.addresses) {
        const bool of_effect = address.starts_with("effect.");
        for (VariedDatum& d : data.all()) {
          if (d.name != (of_effect ? p.name : address)) continue;
          d.spread = std::sqrt(3.0) * model.covariance->std(k);
          d.spread_from = "standard error";
        }
      }
    }
}

std::vector<State> states_of(const std::vector<Axis>& axes) {
  std::vector<State> states{{unset, unset, unset, unset}};
  // The speed runs fastest.
  for (std::size_t a = axes.size(); a-- > 0;) {
    if (axes[a].values.empty()) continue;
    std::vector<State> more;
    for (const State& s : states)
      for (const double value : axes[a].values) {
        more.push_back(s);
        more.back()[a] = value;
      }
    states = std::move(more);
    if (states.size() > most_states)
      throw io::InputError(fmt::format("more than {} states were asked for", most_states));
  }
  return states;
}

void require_question(const io::ModelFile& file, const SensitivityQuestion& q) {
  const auto named_as = [&](const Axis& axis) {
    return std::string(q.wording == Wording::flags ? axis.flag : axis.name);
  };
  if (q.steady) require_spindle(file);
  const bool shaft = file.model.shaft.has_value();
  for (const Axis& axis : axes_of(q, shaft)) {
    if (axis.name == "speed_rpm" && axis.values.empty())
      throw io::InputError(named_as(axis) + " is missing", {.key = named_as(axis)});
    for (const double value : axis.values) io::require_range(value, axis.range, named_as(axis));
    if (axis.values.empty()) continue;
    if (q.steady && axis.name != "speed_rpm")
      throw io::InputError(
          fmt::format("{}: the steady state of a spindle has loads and temperatures of its model",
                      named_as(axis)),
          {.file = file.source, .key = named_as(axis)});
    if (shaft && axis.name == "radial_load_N")
      throw io::InputError(
          fmt::format("{}: {} has an [arrangement]: a shaft takes axial loads alone",
                      named_as(axis), file.source),
          {.file = file.source, .key = named_as(axis)});
  }
  if (!shaft && q.axial_loads_N.empty() && std::isnan(file.model.rig.axial_load)) {
    const std::string name = named(q.wording, "--axial-load", "axial_load_N");
    throw io::InputError(
        fmt::format("{} is missing, and {} has no axial_load_N under [rig]", name, file.source),
        {.file = file.source, .key = name});
  }
}

std::vector<std::string> wanted_columns(const model::Model& model, const SensitivityQuestion& q) {
  const auto words = sensitivity_words(model, q.steady);
  const std::vector<std::string> columns = known_columns(model, q.steady);
  std::vector<std::string> asked = q.predictions, wanted;
  if (asked.empty()) asked.emplace_back(model.shaft ? "displacement" : "torque");
  for (const std::string& one : asked) {
    const auto word =
        std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == one; });
    const std::string& name = word == words.end() ? one : word->second;
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) {
      std::vector<std::string> all;
      for (const auto& [short_name, column] : words) all.push_back(short_name);
      all.insert(all.end(), columns.begin(), columns.end());
      throw io::InputError(
          fmt::format("{}: no such prediction; there are {}", one, io::listed(all)), {.key = one});
    }
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
  }
  return wanted;
}

/// What samples leave open of one prediction.
std::vector<std::string> cannot_tell(const Sensitivity& s, const fit::SobolIndices& found) {
  std::vector<std::string> lines;
  if (2 * found.complete < s.samples)
    return {fmt::format("only {} of {} samples have a value: these indices are of that part alone",
                        found.complete, s.samples)};
  std::vector<std::size_t> order(found.inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return found.inputs[a].total > found.inputs[b].total;
  });
  if (order.empty() || std::isnan(found.inputs[order[0]].total)) return lines;
  const auto name = [&](std::size_t i) { return s.data[s.sampled[i]].name; };
  double widest = 0.0;
  for (const fit::SobolIndex& one : found.inputs)
    widest = std::fmax(widest, std::fmax(one.first_error, one.total_error));
  if (order.size() > 1) {
    const fit::SobolIndex &a = found.inputs[order[0]], &b = found.inputs[order[1]];
    if (a.total - a.total_error < b.total + b.total_error)
      lines.push_back(fmt::format("these samples cannot tell whether {} or {} matters more",
                                  name(order[0]), name(order[1])));
  }
  if (widest > 0.1)
    lines.push_back(fmt::format(
        "intervals are up to +-{:.2g} wide: four times the samples halve them", widest));
  return lines;
}

void sample(const Data& data, const Predictor& predictor, const SensitivityQuestion& q,
            const std::vector<std::size_t>& places, Sensitivity& s) {
  const fit::SobolDesign design(s.sampled.size(), q.samples, q.seed);
  s.evaluations = design.evaluations();
  const std::size_t outputs = s.predictions.size();
  std::vector<double> values(outputs * s.evaluations, unset);
  const auto data_at = [&](std::size_t e) {
    std::vector<double> point(design.inputs());
    design.point(e, point);
    for (std::size_t i = 0; i < point.size(); ++i) {
      const VariedDatum& d = s.data[s.sampled[i]];
      point[i] = d.whole ? std::floor(d.value - d.spread + point[i] * (2.0 * d.spread + 1.0))
                         : d.value + (2.0 * point[i] - 1.0) * d.spread;
    }
    return point;
  };
  std::mutex mutex;
  std::size_t first = s.evaluations;
  for_all(s.evaluations, q, 0.1, 1.0, [&](std::size_t e) {
    const std::vector<double> point = data_at(e);
    std::vector<std::pair<std::size_t, double>> changes;
    for (std::size_t i = 0; i < point.size(); ++i)
      changes.emplace_back(places[s.sampled[i]], point[i]);
    const Outcome one = data.predict(predictor, changes);
    for (std::size_t p = 0; p < one.values.size(); ++p)
      values[p * s.evaluations + e] = one.values[p];
    if (one.has_all()) return;
    const std::lock_guard lock(mutex);
    ++s.failed;
    if (e > first) return;
    first = e;
    s.why_failed = one.refused.empty() ? "no balance was found" : one.refused;
  });
  if (s.failed > 0) s.first_failed = data_at(first);
  for (std::size_t p = 0; p < outputs; ++p) {
    s.predictions[p].global = fit::sobol_indices(
        design, std::span(values).subspan(p * s.evaluations, s.evaluations), q.seed);
    s.predictions[p].cannot_tell = cannot_tell(s, *s.predictions[p].global);
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> sensitivity_words(const model::Model& model,
                                                                   bool steady) {
  if (steady && model.spindle && model.spindle->network) return {{"heat", "friction_power_W"}};
  if (steady)
    return {{"displacement", "axial_displacement_um"},
            {"heat", "friction_power_W"},
            {"preload", "front_force_N"},
            {"stiffness", std::string(stiffness)},
            {"temperature", std::string(hottest_ring)}};
  std::vector<std::pair<std::string, std::string>> words{{"torque", "friction_torque_Nmm"},
                                                         {"heat", "power_loss_W"},
                                                         {"displacement", "axial_displacement_um"},
                                                         {"stiffness", std::string(stiffness)}};
  if (model.shaft) {
    words.emplace_back("preload", "front_force_N");
    // That of the bearing at the tool.
    for (const std::string& name : state_columns(model))
      if (name.ends_with("_inner_contact_angle_deg")) {
        words.emplace_back("contact-angle", name);
        break;
      }
  } else {
    words.emplace_back("contact-angle", "inner_contact_angle_max_deg");
    words.emplace_back("pressure", "inner_contact_pressure_MPa");
    words.emplace_back("life", std::string(life));
  }
  return words;
}

Sensitivity sensitivity(Messages& messages, const io::ModelFile& file,
                        const SensitivityQuestion& q) {
  require_question(file, q);
  const model::Model& model = file.model;
  const Predictor predictor(q, wanted_columns(model, q), model);
  const std::vector<Axis> axes = axes_of(q, model.shaft.has_value());
  for (const double value : q.temperatures_C)
    if (const std::string doubt = io::looks_like_kelvin("temperature_C", value); !doubt.empty())
      messages.note(doubt);
  const std::vector<State> states = states_of(axes);
  Data data(file, q, states);
  Sensitivity s{.source = file.source, .model = model.name, .samples = q.samples, .seed = q.seed};
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (!axes[a].values.empty()) s.inputs.emplace_back(axes[a].name);
  for (const State& state : states) {
    s.states.emplace_back();
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (!axes[a].values.empty()) s.states.back().push_back(state[a]);
  }

  take_standard_errors(model, data);
  for (const io::SpreadText& text : q.spreads) {
    VariedDatum& datum = data.all()[data.find(text.name)];
    datum.spread = io::spread_of(text, datum.value);
    datum.spread_from = "given";
    if (datum.whole && datum.spread != std::floor(datum.spread))
      throw io::InputError(fmt::format("spread of {} = {}: must be a whole number: it is a count",
                                       text.name, text.text),
                           {.key = text.name});
  }

  const Outcome here = data.predict(predictor, {});
  if (!here.refused.empty()) throw io::InputError(file.source + ": " + here.refused);
  const std::size_t outputs = here.values.size(), columns = predictor.wanted().size();
  std::vector<Around> around(data.all().size());
  for (std::size_t k = 0; k < around.size(); ++k) {
    VariedDatum& datum = data.all()[k];
    std::string from;
    double usual = usual_spread(datum, from);
    if (std::isnan(datum.spread)) {
      datum.spread = usual;
      datum.spread_from = from;
    }
    if (usual == 0.0) usual = datum.spread;
    around[k].step = datum.whole ? 1.0 : q.steady ? usual : step_of_usual * usual;
    if (!data.is_asked(k))
      around[k].step = 0.0;
    else if (around[k].step == 0.0)
      s.not_varied.emplace_back(datum.name, "zero, of which 1 % is none; a spread varies it");
  }
  constexpr std::array<double, 4> shares{1.0, -1.0, 0.5, -0.5};
  for_all(around.size() * 6, q, 0.0, q.samples > 0 ? 0.1 : 1.0, [&](std::size_t i) {
    const std::size_t k = i / 6, which = i % 6;
    const VariedDatum& datum = data.all()[k];
    Around& one = around[k];
    const double by = which < 4    ? shares[which] * one.step
                      : which == 4 ? datum.spread
                                   : -datum.spread;
    if (one.step == 0.0 || (which >= 4 && datum.spread == 0.0) ||
        (datum.whole && (which == 2 || which == 3)))
      return;
    const std::pair<std::size_t, double> change{k, datum.value + by};
    one.at[which] = data.predict(predictor, {&change, 1});
  });

  std::vector<std::size_t> places;  // in all data, of those that enter
  std::vector<std::string> refused_spreads;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Around& one = around[k];
    if (one.step == 0.0) continue;
    bool enters = false;
    std::string refused, spread_refused;
    for (std::size_t which = 0; which < one.at.size(); ++which) {
      const Outcome& outcome = one.at[which];
      if (!outcome.refused.empty())
        (which >= 4 ? spread_refused : refused) = outcome.refused;
      else if (!outcome.values.empty())
        enters = enters || !same(outcome.values, here.values);
    }
    // A slope needs both steps of one side.
    const auto has = [&](std::size_t which) { return !one.at[which].values.empty(); };
    const bool taken =
        data.all()[k].whole ? has(0) || has(1) : (has(0) && has(2)) || (has(1) && has(3));
    const VariedDatum& datum = data.all()[k];
    if (!taken) {
      s.not_varied.emplace_back(datum.name, refused);
      continue;
    }
    if (!enters) {
      s.does_not_enter.push_back(datum.name);
      continue;
    }
    const bool given = datum.spread_from == "given";
    if (!spread_refused.empty() && q.samples > 0 && given)
      throw io::InputError(
          fmt::format("spread of {} = {:.6g} ({}): leaves what a model may have: {}", datum.name,
                      datum.spread, datum.spread_from, spread_refused),
          {.key = datum.name});
    if (!spread_refused.empty() && q.samples > 0)
      s.not_sampled.emplace_back(datum.name, spread_refused);
    else if (datum.spread > 0.0)
      s.sampled.push_back(places.size());
    places.push_back(k);
    s.data.push_back(datum);
  }

  for (std::size_t i = 0; i < outputs; ++i) {
    PredictionSensitivity p{
        .name = predictor.wanted()[i % columns], .state = i / columns, .value = here.values[i]};
    double largest = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      LocalSensitivity local;
      const VariedDatum& datum = s.data[k];
      // An outcome that was not asked for has no values: a count has no second step.
      Around one = around[places[k]];
      for (Outcome& o : one.at)
        if (o.values.empty()) o.values.assign(outputs, unset);
      look_at_steps(datum, one, i, p.value, local);
      local.change = local.derivative * datum.spread;
      if (datum.has_elasticity) local.elasticity = local.derivative * datum.value / p.value;
      if (std::isfinite(local.change)) {
        largest = std::fmax(largest, std::fabs(local.change));
        squares += local.change * local.change;
      }
      p.local.push_back(local);
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
      LocalSensitivity& local = p.local[k];
      if (squares > 0.0) local.share = local.change * local.change / squares;
      look_for_kinks(s.data[k], around[places[k]], i, p.value, largest, local);
    }
    p.order.resize(places.size());
    std::iota(p.order.begin(), p.order.end(), std::size_t{0});
    std::stable_sort(p.order.begin(), p.order.end(), [&](std::size_t a, std::size_t b) {
      const double x = std::fabs(p.local[a].change), y = std::fabs(p.local[b].change);
      return std::isnan(x) != std::isnan(y) ? std::isnan(y) : x > y;
    });
    s.predictions.push_back(std::move(p));
  }

  if (q.samples == 0) {
    s.sampled.clear();
    return s;
  }
  if (s.sampled.empty())
    throw io::InputError("no datum with a spread enters: there is nothing to sample");
  if ((s.sampled.size() + 2) * outputs > most_numbers / q.samples)
    throw io::InputError(fmt::format(
        "{} samples of {} data and {} predictions are more than {:.0g} numbers: take fewer",
        q.samples, s.sampled.size(), outputs, static_cast<double>(most_numbers)));
  try {
    sample(data, predictor, q, places, s);
  } catch (const std::invalid_argument& e) {
    throw io::InputError(e.what(), {.key = "samples"});
  }
  return s;
}

std::string words_of_state(const Sensitivity& s, std::size_t state) {
  std::string words;
  for (std::size_t k = 0; k < s.inputs.size(); ++k)
    words += fmt::format("{}{} {:.6g}", k == 0 ? "" : ", ", s.inputs[k], s.states[state][k]);
  return words;
}

std::vector<std::string> sensitivity_warnings(const Sensitivity& s) {
  std::vector<std::string> lines;
  for (const PredictionSensitivity& p : s.predictions)
    if (!std::isfinite(p.value))
      lines.push_back(fmt::format("{} has no value at {}", p.name, words_of_state(s, p.state)));
  if (s.failed > 0)
    lines.push_back(fmt::format(
        "{} of {} evaluations lack a prediction, and their samples take no part in it: "
        "{}, the first where {}",
        s.failed, s.evaluations, s.why_failed, [&] {
          std::vector<std::string> at;
          for (std::size_t k = 0; k < s.first_failed.size(); ++k)
            at.push_back(fmt::format("{} = {:.6g}", s.data[s.sampled[k]].name, s.first_failed[k]));
          return io::listed(at);
        }()));
  return lines;
}

}  // namespace raceway::session
