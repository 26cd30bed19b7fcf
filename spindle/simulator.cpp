#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fit/problem.h"
#include "spindle/expansion_rows.h"
#include "spindle/heat_flow.h"
#include "spindle/spindle.h"
#include "spindle/thermometer.h"

namespace raceway::spindle {
namespace {

/// First step after a change of inputs, shortest one, and longest one unless the model says [s].
constexpr double first_step = 10.0, shortest_step = 1e-3, longest_step = 600.0;
/// Error of a step, of the warmest body; where a run only shows where it leads to [K].
constexpr double step_tolerance = 0.01, tolerance_of_the_way = 1.0;
/// Room, machine and coolant may wander by this between two rows without a step boundary [K].
constexpr double wandering = 0.5;
constexpr int most_time_steps = 200000, most_steps_of_the_way = 3000;

bool near(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= wandering;
}
bool same(double a, double b) { return (std::isnan(a) && std::isnan(b)) || a == b; }

/// Whether inputs go on without a jump.
bool goes_on(const Inputs& a, const Inputs& b) {
  return a.speed == b.speed && a.coolant_on == b.coolant_on && a.axial_load == b.axial_load &&
         a.radial_load == b.radial_load && same(a.motor_heat, b.motor_heat) &&
         near(a.ambient_temperature, b.ambient_temperature) &&
         near(a.machine_temperature, b.machine_temperature) &&
         near(a.coolant_inlet, b.coolant_inlet);
}

/// Rows of a programme over time: each holds from the row before it.
class Programme {
 public:
  Programme(std::span<const ProfileRow> rows, double start) : rows_(rows), start_(start) {}

  [[nodiscard]] double begin_of(std::size_t row) const {
    return row == 0 ? start_ : rows_[row - 1].time;
  }
  /// The row after the last one that goes on from `row` without a jump.
  [[nodiscard]] std::size_t jump_after(std::size_t row) const {
    std::size_t next = row + 1;
    while (next < rows_.size() && goes_on(rows_[next - 1].inputs, rows_[next].inputs)) ++next;
    return next;
  }
  /// Inputs of a step, wandering temperatures as their mean over it. `row` holds at `from`.
  [[nodiscard]] Inputs mean(std::size_t row, double from, double to) const {
    Inputs inputs = rows_[row].inputs;
    double ambient = 0.0, machine = 0.0, inlet = 0.0, length = 0.0;
    for (std::size_t k = row; k < rows_.size() && begin_of(k) < to; ++k) {
      const double part = std::min(rows_[k].time, to) - std::max(begin_of(k), from);
      if (!(part > 0.0)) continue;
      length += part;
      ambient += part * rows_[k].inputs.ambient_temperature;
      machine += part * rows_[k].inputs.machine_temperature;
      inlet += part * rows_[k].inputs.coolant_inlet;
    }
    if (length > 0.0) {
      inputs.ambient_temperature = ambient / length;
      inputs.machine_temperature = machine / length;
      inputs.coolant_inlet = inlet / length;
    }
    return inputs;
  }

 private:
  std::span<const ProfileRow> rows_;
  double start_;
};

/// Cubic between two states with their rates.
Vector between(const Vector& from, const Vector& to, const Vector& rate_from, const Vector& rate_to,
               double dt, double t) {
  const double a = (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t), b = t * t * (3.0 - 2.0 * t);
  const double c = dt * t * (1.0 - t) * (1.0 - t), d = dt * t * t * (t - 1.0);
  return a * from + b * to + c * rate_from + d * rate_to;
}

}  // namespace

struct Simulator::Parts {
  model::Model model;
  effects::SpindleCondition condition;
  HeatFlow flow;
  State last;
  Eigen::Index felt = 0;
  // Felt numbers, the nose's way by expansion [m], sensors, the coolant where there is one.
  SparseMatrix watched;
  double nose_offset = 0.0;
  double tolerance = step_tolerance;  // of a step [K]
  int most_steps = most_time_steps;
  const std::atomic<bool>* cancelled = nullptr;

  Parts(const model::Model& m, const effects::SpindleCondition& c)
      : model(m), condition(c), flow(model, condition, model.spindle->cells) {
    watch();
  }

  void stop_if_cancelled() const {
    if (cancelled && cancelled->load()) throw fit::Cancelled();
  }

  void watch() {
    const Eigen::Index nodes = flow.paths().size();
    std::vector<Eigen::Triplet<double>> entries;
    if (const BearingCoupling* const coupling = flow.coupling()) {
      felt = coupling->felt_count();
      const SparseMatrix& rows = coupling->felt_rows();
      for (int k = 0; k < rows.outerSize(); ++k)
        for (SparseMatrix::InnerIterator it(rows, k); it; ++it)
          entries.emplace_back(it.row(), it.col(), it.value());
      const Layout& layout = flow.system()->layout();
      const Vector nose = expansion_row(layout.mesh, Body::shaft, 0.0, layout.front_centre, nodes) +
                          expansion_row(layout.mesh, Body::housing, layout.front_centre,
                                        model.spindle->housing.flange, nodes);
      for (Eigen::Index k = 0; k < nodes; ++k)
        if (nose[k] != 0.0) entries.emplace_back(felt, k, nose[k]);
      nose_offset = -nose.sum() * model.shaft->arrangement.design().mounting_temperature;
    }
    Eigen::Index row = felt + 1;
    for (const Shares& shares : sensors()) {
      for (const Share& s : shares) entries.emplace_back(row, s.cell, s.share);
      ++row;
    }
    if (cooled()) entries.emplace_back(row++, flow.system()->coolant_node(), 1.0);
    watched.resize(row, nodes);
    watched.setFromTriplets(entries.begin(), entries.end());
  }

  [[nodiscard]] bool cooled() const { return flow.system() && flow.system()->coolant_node() >= 0; }

  /// Of a network: every node.
  [[nodiscard]] std::vector<Shares> sensors() const {
    std::vector<Shares> list;
    if (!flow.system()) {
      for (Eigen::Index k = 0; k < flow.paths().size(); ++k)
        list.push_back({{static_cast<int>(k), 1.0}});
      return list;
    }
    for (const model::ThermometerPlace& place : model.spindle->sensors) {
      if (place.part == model::ThermometerPlace::Part::coolant) {
        if (!cooled())
          throw std::invalid_argument("sensor " + place.name + ": the spindle has no coolant");
        list.push_back({{flow.system()->coolant_node(), 1.0}});
      } else {
        list.push_back(thermometer(flow.system()->layout().mesh, place));
      }
    }
    return list;
  }

  /// The drift of the machine, its mean over a while [K].
  [[nodiscard]] double machine_rise(double from, double to) const {
    const double rise = condition.structure_rise, tau = condition.structure_time;
    if (rise == 0.0) return 0.0;
    if (!(tau > 0.0)) return rise;
    if (!(to > from)) return rise * (1.0 - std::exp(-from / tau));
    return rise * (1.0 - tau / (to - from) * (std::exp(-from / tau) - std::exp(-to / tau)));
  }

  /// The node is the mean of inlet and outlet; along its channel the coolant warms evenly.
  void follow_coolant(const Inputs& inputs, double mean, Moment& m) const {
    const model::Coolant& c = *model.spindle->coolant;
    const double inlet =
        std::isnan(inputs.coolant_inlet) ? c.inlet_temperature : inputs.coolant_inlet;
    const bool flows = inputs.coolant_on && c.flow > 0.0;
    const auto at = [&](double share) {
      return flows ? inlet + 2.0 * share * (mean - inlet) : mean;
    };
    m.coolant_outlet = at(1.0);
    for (std::size_t k = 0; k < model.spindle->sensors.size(); ++k) {
      const model::ThermometerPlace& place = model.spindle->sensors[k];
      if (place.part != model::ThermometerPlace::Part::coolant) continue;
      const double share = (place.position - c.start) / (c.end - c.start);
      m.sensors[k] = at(std::isnan(share) ? 1.0 : std::clamp(share, 0.0, 1.0));
    }
  }

  /// The spindle where the watched numbers are `seen`; false where the sets have no balance.
  bool moment_at(double time, const Inputs& inputs, const Vector& seen,
                 const std::array<double, reservoirs>& out, Moment& m) {
    m.time = time;
    const Eigen::Index last_sensor = seen.size() - (cooled() ? 1 : 0);
    m.sensors.assign(seen.data() + felt + 1, seen.data() + last_sensor);
    if (cooled()) follow_coolant(inputs, seen[last_sensor], m);
    m.heat.air = out[0], m.heat.machine = out[1], m.heat.coolant = out[2];
    m.heat.drive = flow.driven_heat();
    m.heat.friction = 0.0;
    if (BearingCoupling* const coupling = flow.coupling()) {
      const Vector s = seen.head(felt) + felt_offset();
      Vector given(coupling->given_count());
      if (!coupling->evaluate(s, given)) return false;
      fill_sets(s, seen[felt] + nose_offset, m);
    }
    m.heat.stored = m.heat.friction + m.heat.drive - out[0] - out[1] - out[2];
    return true;
  }

  [[nodiscard]] Vector felt_offset() const {
    return flow.coupling()->felt(Vector::Zero(flow.paths().size()));
  }

  void fill_sets(const Vector& s, double nose, Moment& m) {
    const WarmSets& sets = flow.coupling()->sets();
    m.set_position = sets.sets().position - sets.rest();
    m.kinematic_displacement = sets.cold_sets().position - sets.rest();
    // A sum over all cells leaves its rounding: below a femtometre there is nothing.
    m.displacement = m.set_position + (std::abs(nose) < 1e-15 ? 0.0 : nose);
    m.elongation = s[felt - 1] * um;
    m.front_force = sets.sets().front_force;
    m.rear_force = sets.sets().rear_force;
    m.bearings.clear();
    for (std::size_t k = 0; k < sets.bearings(); ++k) {
      const auto at = static_cast<Eigen::Index>(4 * k);
      const BearingHeat& heat = sets.heat()[k];
      m.bearings.push_back({.inner_ring_temperature = s[at],
                            .outer_ring_temperature = s[at + 1],
                            .force = heat.force,
                            .power = heat.power()});
      m.heat.friction += heat.power();
    }
  }

  void begin(const State* start, std::span<const ProfileRow> profile) {
    last = State{};
    if (start) {
      if (start->temperatures.size() != static_cast<std::size_t>(flow.paths().size()))
        throw std::invalid_argument("state: it is of another spindle, or of other cells");
      last = *start;
      flow.start(Eigen::Map<const Vector>(start->temperatures.data(), flow.paths().size()));
      return;
    }
    const Inputs inputs = profile.empty() ? Inputs{} : profile.front().inputs;
    flow.start(flow.system() ? flow.system()->ambient(inputs) : model.spindle->ambient.temperature);
  }

  /// A run that only shows where it leads to; what it may take is as before also where it is
  /// cancelled.
  template <typename Simulate>
  Run follow_the_way(const Simulate& simulate) {
    struct AsBefore {
      Parts& parts;
      ~AsBefore() { parts.tolerance = step_tolerance, parts.most_steps = most_time_steps; }
    } const as_before{*this};
    tolerance = tolerance_of_the_way, most_steps = most_steps_of_the_way;
    return simulate();
  }

  void remember(double time) {
    last.structure_time += time - last.time;
    last.time = time;
    const Vector& t = flow.temperatures();
    last.temperatures.assign(t.data(), t.data() + t.size());
  }
};

namespace {

/// Step sizes: short after a jump, then as the error allows.
class StepSizes {
 public:
  StepSizes(double longest, double tolerance, std::span<const double> given)
      : longest_(longest), tolerance_(tolerance), given_(given) {}

  void jump() { next_ = std::min(first_step, longest_); }
  void shrink() { next_ *= 0.3; }
  [[nodiscard]] bool too_short() const { return next_ < shortest_step; }
  [[nodiscard]] bool held() const { return !given_.empty(); }
  /// The step from `time` on, none beyond `end` and no stump left before it.
  [[nodiscard]] double take(double time, double end) {
    while (place_ < given_.size() && given_[place_] <= time * (1.0 + 1e-14)) ++place_;
    if (place_ < given_.size()) return std::min(given_[place_], end) - time;
    const double left = end - time;
    if (next_ >= left) return left;
    return next_ > 0.5 * left ? 0.5 * left : next_;
  }
  [[nodiscard]] bool accept(double dt, double error) {
    const double factor = 0.85 * std::cbrt(tolerance_ / std::max(error, 1e-6 * tolerance_));
    if (!held() && error > 2.0 * tolerance_ && dt > 10.0 * shortest_step) {
      next_ = dt * std::clamp(factor, 0.2, 0.7);
      return false;
    }
    next_ = std::min(dt * std::clamp(factor, 0.3, 2.5), longest_);
    return true;
  }

 private:
  double longest_, tolerance_, next_ = first_step;
  std::span<const double> given_;
  std::size_t place_ = 0;
};

}  // namespace

Simulator::Simulator(const model::Model& model)
    : Simulator(model, effects::spindle_condition(model.effects)) {}
Simulator::Simulator(const model::Model& model, const effects::SpindleCondition& condition) {
  if (!model.spindle) throw std::invalid_argument("the model is no spindle");
  parts_ = std::make_unique<Parts>(model, condition);
}
Simulator::Simulator(const Simulator& other)
    : parts_(std::make_unique<Parts>(other.parts_->model, other.parts_->condition)) {
  parts_->cancelled = other.parts_->cancelled;
}
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator::~Simulator() = default;

void Simulator::stop_on(const std::atomic<bool>* cancelled) { parts_->cancelled = cancelled; }

Run Simulator::simulate(std::span<const ProfileRow> profile, const State* start,
                        std::span<const double> step_ends, std::span<const double> keep) {
  Parts& p = *parts_;
  HeatFlow& flow = p.flow;
  Run run;
  Report& report = run.report;
  p.begin(start, profile);
  const Programme programme(profile, p.last.time);
  StepSizes sizes(std::isnan(p.model.spindle->step) ? longest_step : p.model.spindle->step,
                  p.tolerance, step_ends);
  double time = p.last.time;
  report.energy_error = 0.0;
  const auto end_with = [&](Status status) {
    report.status = status;
    if (status != Status::converged) report.message = words(status);
    p.remember(time);
    run.end = p.last;
    return std::move(run);
  };
  const auto follow_force = [&](double force, double at) {
    if (force > run.highest_front_force) {
      run.highest_front_force = force;
      run.time_of_highest_force = at;
    }
  };
  for (std::size_t row = 0; row < profile.size();) {
    const std::size_t after = programme.jump_after(row);
    const double end = profile[after - 1].time;
    if (!flow.set_inputs(profile[row].inputs)) return end_with(Status::no_equilibrium);
    sizes.jump();
    Vector films = flow.temperatures(), before = films;
    double last_dt = 0.0;
    std::size_t written = row;
    // Rows at the very beginning have nothing before them.
    const auto write = [&](double until, const auto& seen_at, const auto& out_at) {
      for (; written < after && profile[written].time <= until; ++written) {
        Moment m;
        const double at = profile[written].time;
        if (!p.moment_at(at, profile[written].inputs, seen_at(at), out_at(at), m)) return false;
        run.moments.push_back(std::move(m));
        follow_force(run.moments.back().front_force, at);
      }
      return true;
    };
    if (!(end > time)) {
      const Vector seen = p.watched * flow.temperatures();
      const auto out = flow.paths().outflow(flow.temperatures());
      if (!write(
              end, [&](double) { return seen; }, [&](double) { return out; }))
        return end_with(Status::no_equilibrium);
    }
    std::size_t holding = row;
    while (time < end) {
      p.stop_if_cancelled();
      if (report.steps + report.rejected > p.most_steps) return end_with(Status::step_limit);
      while (holding + 1 < after && profile[holding].time <= time) ++holding;
      const double dt = sizes.take(time, end);
      const double drift = p.last.structure_time + (time - p.last.time);
      const Inputs inputs = programme.mean(holding, time, time + dt);
      const Vector from = flow.temperatures();
      films = from;
      if (last_dt > 0.0) films += 0.5 * std::min(dt / last_dt, 1.0) * (from - before);
      const HeatFlow::Step step =
          flow.advance(inputs, p.machine_rise(drift, drift + dt), dt, films);
      if (step.status != Status::converged) {
        ++report.rejected;
        sizes.shrink();
        if (sizes.held() || sizes.too_short()) return end_with(step.status);
        if (!flow.set_inputs(profile[row].inputs)) return end_with(Status::no_equilibrium);
        last_dt = 0.0;
        continue;
      }
      ++report.steps;
      if (!sizes.accept(dt, step.error)) {
        ++report.rejected, --report.steps;
        flow.start(from);
        if (!flow.set_inputs(profile[row].inputs)) return end_with(Status::no_equilibrium);
        continue;
      }
      report.energy_error = std::max(report.energy_error, step.energy_error);
      const Vector seen = p.watched * from, seen_after = p.watched * flow.temperatures();
      const Vector rate = p.watched * step.rate_before, rate_after = p.watched * step.rate_after;
      const double began = time;
      time = end - (time + dt) < 1e-9 * dt ? end : time + dt;
      run.step_ends.push_back(time);
      while (run.kept.size() < keep.size() && keep[run.kept.size()] <= time) {
        p.remember(time);
        run.kept.push_back(p.last);
      }
      if (flow.coupling()) follow_force(flow.coupling()->sets().sets().front_force, time);
      const bool written_all = write(
          time,
          [&](double at) {
            return between(seen, seen_after, rate, rate_after, dt, (at - began) / dt);
          },
          [&](double at) {
            std::array<double, reservoirs> out{};
            const double t = (at - began) / dt;
            for (std::size_t r = 0; r < reservoirs; ++r)
              out[r] = (1.0 - t) * step.out_before[r] + t * step.out_after[r];
            return out;
          });
      if (!written_all) return end_with(Status::no_equilibrium);
      if (flow.coupling() &&
          flow.felt().head(flow.felt().size() - 1).maxCoeff() > HeatFlow::hottest_ring)
        return end_with(Status::thermal_runaway);
      before = from;
      last_dt = dt;
    }
    row = after;
  }
  return end_with(Status::converged);
}

Moment Simulator::steady(const Inputs& inputs, Report& report) {
  Parts& p = *parts_;
  HeatFlow& flow = p.flow;
  Moment m;
  report = Report{};
  p.stop_if_cancelled();
  flow.start(flow.system() ? flow.system()->ambient(inputs) : p.model.spindle->ambient.temperature);
  const double rise = p.condition.structure_rise;
  if (!flow.set_inputs(inputs)) {
    report.status = Status::no_equilibrium;
  } else {
    report.status = flow.settle(inputs, rise, report.steps);
    if (!report.converged()) {
      // From far away Newton's method finds no way, or a hot one: through time it does, or time
      // shows why not.
      std::vector<ProfileRow> hours;
      for (int k = 1; k <= 40; ++k) hours.push_back({.time = 3600.0 * k, .inputs = inputs});
      report.status = p.follow_the_way([&] { return simulate(hours); }).report.status;
      if (report.converged() && flow.set_inputs(inputs))
        report.status = flow.settle(inputs, rise, report.steps);
    }
  }
  if (report.converged()) {
    const Vector seen = p.watched * flow.temperatures();
    const auto out = flow.paths().outflow(flow.temperatures());
    if (!p.moment_at(std::numeric_limits<double>::infinity(), inputs, seen, out, m))
      report.status = Status::no_equilibrium;
    const double turnover = std::max(1e-9, std::abs(m.heat.friction) + std::abs(m.heat.drive));
    report.energy_error = std::abs(m.heat.stored) / turnover;
  }
  if (!report.converged()) {
    report.message = words(report.status);
    return Moment{};
  }
  p.last.time = 0.0;
  p.remember(0.0);
  return m;
}

const State& Simulator::state() const { return parts_->last; }

const bearing::ArrangementEquilibrium* Simulator::sets() const {
  const BearingCoupling* const c = parts_->flow.coupling();
  return c ? &c->sets().sets() : nullptr;
}

const bearing::ArrangementCondition* Simulator::sets_condition() const {
  const BearingCoupling* const c = parts_->flow.coupling();
  return c ? &c->sets().asked() : nullptr;
}

std::size_t Simulator::cells() const {
  return static_cast<std::size_t>(parts_->flow.paths().size());
}

std::vector<FieldCell> Simulator::field(const State& state) const {
  std::vector<FieldCell> list;
  const ThermalSystem* const system = parts_->flow.system();
  if (!system || state.temperatures.size() != cells()) return list;
  const Mesh& mesh = system->layout().mesh;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const Cell& c = mesh.cells[k];
    const bool ring = c.body != Body::shaft && c.body != Body::housing;
    list.push_back({.part = c.body == Body::shaft ? "shaft"
                            : ring                ? "ring"
                                                  : "housing",
                    .start = c.start,
                    .end = c.end,
                    .inner_radius = c.inner_radius,
                    .outer_radius = c.outer_radius,
                    .temperature = state.temperatures[k]});
  }
  return list;
}

}  // namespace raceway::spindle
