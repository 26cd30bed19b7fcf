#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "fit/problem.h"
#include "model/corrected_data.h"
#include "spindle/detail/time_steps.h"
#include "spindle/expansion_rows.h"
#include "spindle/film.h"
#include "spindle/heat_flow.h"
#include "spindle/spindle.h"
#include "spindle/stress.h"
#include "spindle/thermometer.h"

namespace raceway::spindle {
namespace {

/// Error of a step, of the warmest body; where a run only shows where it leads to [K].
constexpr double step_tolerance = 0.01, tolerance_of_the_way = 1.0;
constexpr int most_time_steps = 200000, most_steps_of_the_way = 3000;
/// Drift time of the machine from which nothing is left to drift [s]; time constants are at most
/// 100 h. It is finite because a state may be written to a file.
constexpr double drift_has_ended = 1e9;

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
  // Felt numbers, the nose's way by expansion [m], sensors, each coolant circuit.
  SparseMatrix watched;
  double nose_offset = 0.0;
  double tolerance = step_tolerance;  // of a step [K]
  int most_steps = most_time_steps;
  const std::atomic<bool>* cancelled = nullptr;

  Parts(const model::Model& m, const effects::SpindleCondition& c)
      : model(model::with_corrected_data(m)),
        condition(c),
        flow(model, condition, model.spindle->cells) {
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
    for (const ThermalSystem::Circuit& c : circuits()) entries.emplace_back(row++, c.node, 1.0);
    watched.resize(row, nodes);
    watched.setFromTriplets(entries.begin(), entries.end());
  }

  [[nodiscard]] std::span<const ThermalSystem::Circuit> circuits() const {
    return flow.system() ? flow.system()->circuits() : std::span<const ThermalSystem::Circuit>{};
  }

  /// The circuit in which a thermometer sits: the first one at the outlet or outside all channels.
  [[nodiscard]] std::size_t circuit_at(double position) const {
    for (std::size_t k = 0; k < circuits().size(); ++k)
      if (position >= circuits()[k].channel.start && position <= circuits()[k].channel.end)
        return k;
    return 0;
  }

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
        if (circuits().empty())
          throw std::invalid_argument("sensor " + place.name + ": the spindle has no coolant");
        list.push_back({{circuits()[circuit_at(place.position)].node, 1.0}});
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
  void follow_coolant(const Inputs& inputs, std::span<const double> means, Moment& m) const {
    m.circuits.clear();
    for (std::size_t k = 0; k < means.size(); ++k) {
      const model::Coolant& c = circuits()[k].channel;
      const double mean = means[k], inlet = flow.system()->inlet(circuits()[k], inputs);
      const bool flows = inputs.coolant_on && c.flow > 0.0;
      m.circuits.push_back(
          {.inlet = inlet,
           .outlet = flows ? inlet + 2.0 * (mean - inlet) : mean,
           .heat = coolant_conductance(c, mean, inputs.coolant_on) * (mean - inlet)});
    }
    if (means.empty()) return;
    m.coolant_outlet = m.circuits.front().outlet;
    for (std::size_t k = 0; k < model.spindle->sensors.size(); ++k) {
      const model::ThermometerPlace& place = model.spindle->sensors[k];
      if (place.part != model::ThermometerPlace::Part::coolant) continue;
      const std::size_t circuit = circuit_at(place.position);
      const model::Coolant& c = circuits()[circuit].channel;
      const CircuitState& now = m.circuits[circuit];
      const double share = (place.position - c.start) / (c.end - c.start);
      m.sensors[k] = !inputs.coolant_on || !(c.flow > 0.0) || std::isnan(share)
                         ? now.outlet
                         : now.inlet + std::clamp(share, 0.0, 1.0) * (now.outlet - now.inlet);
    }
  }

  /// The spindle where the watched numbers are `seen`; false where the sets have no balance.
  bool moment_at(double time, const Inputs& inputs, const Vector& seen,
                 const std::array<double, reservoirs>& out, Moment& m) {
    m.time = time;
    const Eigen::Index last_sensor = seen.size() - std::ssize(circuits());
    m.sensors.assign(seen.data() + felt + 1, seen.data() + last_sensor);
    follow_coolant(inputs, std::span(seen.data() + last_sensor, circuits().size()), m);
    m.heat.air = out[0], m.heat.machine = out[1], m.heat.coolant = out[2];
    m.heat.drive = flow.driven_heat();
    if (flow.system()) m.sources = flow.system()->source_heat();
    m.heat.friction = m.heat.friction_band = 0.0;
    if (BearingCoupling* const coupling = flow.coupling()) {
      const Vector s = seen.head(felt) + coupling->felt_offset();
      Vector given(coupling->given_count());
      if (!coupling->evaluate(s, given)) return false;
      fill_sets(s, seen[felt] + nose_offset, m);
    }
    m.heat.stored = m.heat.friction + m.heat.drive - out[0] - out[1] - out[2];
    return true;
  }

  void fill_sets(const Vector& s, double nose, Moment& m) {
    const BearingCoupling& bearings = *flow.coupling();
    const WarmSets& sets = bearings.sets();
    m.set_position = sets.position() - bearings.rest();
    m.kinematic_displacement = sets.cold_sets().position - sets.rest();
    // A sum over all cells leaves its rounding: below a femtometre there is nothing.
    m.displacement = m.set_position + (std::abs(nose) < 1e-15 ? 0.0 : nose);
    m.elongation = s[felt - 1] * um;
    m.front_force = sets.front_force();
    m.rear_force = sets.rear_force();
    m.bearings.clear();
    for (std::size_t k = 0; k < bearings.bearings(); ++k) {
      m.bearings.push_back(bearings.state(k, s));
      m.heat.friction += m.bearings.back().power;
      m.heat.friction_band += m.bearings.back().power_band;
    }
  }

  void begin(const State* start, std::span<const ProfileRow> profile) {
    last = State{};
    if (start) {
      if (start->temperatures.size() != static_cast<std::size_t>(flow.paths().size()))
        throw std::invalid_argument(
            "state: the saved state belongs to another spindle or another mesh");
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

/// One run through the rows of a programme.
class Simulator::Passage {
 public:
  Passage(Parts& parts, std::span<const ProfileRow> profile, std::span<const double> step_ends,
          std::span<const double> keep)
      : p_(parts),
        flow_(parts.flow),
        profile_(profile),
        keep_(keep),
        programme_(profile, parts.last.time),
        sizes_(std::isnan(parts.model.spindle->step) ? StepSizes::longest_unless_given
                                                     : parts.model.spindle->step,
               parts.tolerance, step_ends),
        time_(parts.last.time) {
    run_.report.energy_error = 0.0;
  }

  Run run() {
    Status status = Status::converged;
    for (std::size_t row = 0; row < profile_.size() && status == Status::converged;) {
      const std::size_t after = programme_.jump_after(row);
      Section section{.row = row, .after = after, .end = profile_[after - 1].time};
      status = pass(section);
      row = after;
    }
    run_.report.status = status;
    if (status != Status::converged) run_.report.message = words(status);
    p_.remember(time_);
    run_.end = p_.last;
    return std::move(run_);
  }

 private:
  /// Rows without a jump between them.
  struct Section {
    std::size_t row, after;
    double end;  // [s]
    std::size_t written = row, holding = row;
    Vector before{};       // temperatures at the beginning of the last step
    double last_dt = 0.0;  // 0 where there is no last step
  };

  Status pass(Section& s) {
    if (!flow_.set_inputs(profile_[s.row].inputs)) return Status::no_equilibrium;
    sizes_.jump();
    if (!(s.end > time_)) {  // rows at the very beginning have nothing before them
      const Vector seen = p_.watched * flow_.temperatures();
      const auto out = flow_.paths().outflow(flow_.temperatures());
      if (!write(
              s, s.end, [&](double) { return seen; }, [&](double) { return out; }))
        return Status::no_equilibrium;
    }
    Status status = Status::converged;
    while (time_ < s.end && status == Status::converged) status = step(s);
    return status;
  }

  /// One step, or one attempt.
  Status step(Section& s) {
    Report& report = run_.report;
    p_.stop_if_cancelled();
    if (report.steps + report.rejected > p_.most_steps) return Status::step_limit;
    while (s.holding + 1 < s.after && profile_[s.holding].time <= time_) ++s.holding;
    const double dt = sizes_.take(time_, s.end);
    const double drift = p_.last.structure_time + (time_ - p_.last.time);
    const Inputs inputs = programme_.mean(s.holding, time_, time_ + dt);
    const Vector from = flow_.temperatures();
    Vector films = from;
    if (s.last_dt > 0.0) films += 0.5 * std::min(dt / s.last_dt, 1.0) * (from - s.before);
    const HeatFlow::Step taken =
        flow_.advance(inputs, p_.machine_rise(drift, drift + dt), dt, films, !sizes_.held());
    if (taken.status != Status::converged) {
      ++report.rejected;
      sizes_.shrink();
      if (sizes_.held() || sizes_.too_short()) return taken.status;
      s.last_dt = 0.0;
      return again(s);
    }
    if (!sizes_.accept(dt, taken.error)) {
      ++report.rejected;
      flow_.start(from);
      return again(s);
    }
    ++report.steps;
    report.energy_error = std::max(report.energy_error, taken.energy_error);
    const double began = time_;
    time_ = s.end - (time_ + dt) < 1e-9 * dt ? s.end : time_ + dt;
    run_.step_ends.push_back(time_);
    while (run_.kept.size() < keep_.size() && keep_[run_.kept.size()] <= time_) {
      p_.remember(time_);
      run_.kept.push_back(p_.last);
    }
    if (flow_.coupling()) follow_force(flow_.coupling()->sets().front_force(), time_);
    if (!write_within(s, taken, from, began, dt)) return Status::no_equilibrium;
    if (flow_.coupling() &&
        flow_.felt().head(flow_.felt().size() - 1).maxCoeff() > HeatFlow::hottest_ring)
      return Status::thermal_runaway;
    s.before = from;
    s.last_dt = dt;
    return Status::converged;
  }

  Status again(const Section& s) {
    return flow_.set_inputs(profile_[s.row].inputs) ? Status::converged : Status::no_equilibrium;
  }

  /// Writes the rows within a step; false where the sets have no balance at one of them.
  bool write_within(Section& s, const HeatFlow::Step& taken, const Vector& from, double began,
                    double dt) {
    const Vector seen = p_.watched * from, seen_after = p_.watched * flow_.temperatures();
    const Vector rate = p_.watched * taken.rate_before, rate_after = p_.watched * taken.rate_after;
    return write(
        s, time_,
        [&](double at) {
          return between(seen, seen_after, rate, rate_after, dt, (at - began) / dt);
        },
        [&](double at) {
          std::array<double, reservoirs> out{};
          const double t = (at - began) / dt;
          for (std::size_t r = 0; r < reservoirs; ++r)
            out[r] = (1.0 - t) * taken.out_before[r] + t * taken.out_after[r];
          return out;
        });
  }
  template <typename Seen, typename Out>
  bool write(Section& s, double until, const Seen& seen_at, const Out& out_at) {
    for (; s.written < s.after && profile_[s.written].time <= until; ++s.written) {
      Moment m;
      const double at = profile_[s.written].time;
      if (!p_.moment_at(at, profile_[s.written].inputs, seen_at(at), out_at(at), m)) return false;
      run_.moments.push_back(std::move(m));
      follow_force(run_.moments.back().front_force, at);
    }
    return true;
  }

  void follow_force(double force, double at) {
    if (!(force > run_.highest_front_force)) return;
    run_.highest_front_force = force;
    run_.time_of_highest_force = at;
  }

  Parts& p_;
  HeatFlow& flow_;
  std::span<const ProfileRow> profile_;
  std::span<const double> keep_;
  Programme programme_;
  StepSizes sizes_;
  double time_;  // [s]
  Run run_;
};

Simulator::Simulator(const model::Model& model)
    : Simulator(model, effects::spindle_condition(model.effects)) {}
Simulator::Simulator(const model::Model& model, const effects::SpindleCondition& condition) {
  if (!model.spindle) throw std::invalid_argument("the model is not a spindle");
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
  parts_->begin(start, profile);
  return Passage(*parts_, profile, step_ends, keep).run();
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
  p.last.structure_time = drift_has_ended;
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

const bearing::Arrangement* Simulator::arrangement() const {
  const BearingCoupling* const c = parts_->flow.coupling();
  return c ? &c->sets().arrangement() : nullptr;
}

const LoadedShaft* Simulator::shaft() const {
  const BearingCoupling* const c = parts_->flow.coupling();
  return c ? c->shaft() : nullptr;
}

std::size_t Simulator::cells() const {
  return static_cast<std::size_t>(parts_->flow.paths().size());
}

std::vector<SeatsOfBearing> Simulator::seats() const {
  const ThermalSystem* const system = parts_->flow.system();
  return system ? system->seats() : std::vector<SeatsOfBearing>();
}

std::vector<SurfaceState> Simulator::surfaces() const {
  const HeatFlow& flow = parts_->flow;
  return flow.system() ? flow.system()->surfaces(flow.temperatures()) : std::vector<SurfaceState>{};
}

std::vector<ShaftPlace> Simulator::along_shaft(const Moment& moment) const {
  std::vector<ShaftPlace> list;
  const ThermalSystem* const system = parts_->flow.system();
  if (!system || !parts_->flow.coupling()) return list;
  const Layout& layout = system->layout();
  const model::Model& model = parts_->model;
  const Vector rise =
      parts_->flow.temperatures().array() - model.shaft->arrangement.design().mounting_temperature;
  const auto longer = [&](Body body, double from, double to) {
    return expansion_row(layout.mesh, body, from, to, rise.size()).dot(rise);
  };
  std::set<double> places;
  for (const Cell& c : layout.mesh.cells)
    if (c.body == Body::shaft) places.insert({c.start, c.end});
  const double front = moment.set_position +
                       longer(Body::housing, layout.front_centre, model.spindle->housing.flange);
  for (const double place : places)
    list.push_back({place, front + longer(Body::shaft, place, layout.front_centre)});
  return list;
}

std::vector<SectionStress> Simulator::stresses(double speed) const {
  const HeatFlow& flow = parts_->flow;
  if (!flow.system() || !flow.coupling()) return {};
  Vector heat = Vector::Zero(flow.paths().size());
  flow.coupling()->add_given(flow.given(), heat);
  return spindle::stresses(*flow.system(), flow.temperatures(), heat, speed);
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
