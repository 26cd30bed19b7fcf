#include "bearing/arrangement_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/ball_report.h"
#include "bearing/ring_balance.h"
#include "bearing/shaft_system.h"
#include "bearing/validation.h"

namespace raceway::bearing {
namespace {

void check(const Arrangement& arrangement, const ArrangementCondition& c,
           const EquilibriumOptions& options) {
  require_between("speed", c.speed, 0.0, 1e6 * rpm, rpm, "rpm");
  require_between("external_load", c.external_load, -1e8, 1e8, 1.0, "N");
  require_between("elongation", c.elongation, -10 * mm, 10 * mm, um, "um");
  if (!c.shifts.empty() && c.shifts.size() != arrangement.bearings().size())
    throw std::invalid_argument("shifts: give one shift for each bearing, or no shifts");
  if (!options.rotations.empty() && options.rotations.size() != arrangement.bearings().size())
    throw std::invalid_argument("rotations: give one rotation for each bearing, or no rotations");
  for (const RingShift& s : c.shifts)
    for (const double value : {s.axial, s.radial, s.inner_length, s.outer_length})
      require_between("shift", value, -1 * mm, 1 * mm, um, "um");
}

/// The mounted state, every ball in the middle of its grooves' load line.
ShaftState mounted(const Arrangement& arrangement) {
  return {.shaft = 0.0,
          .rear = arrangement.displacement(Side::rear),
          .balls = std::vector<Plane>(arrangement.bearings().size())};
}

/// Balls of a state at rest where they lie; those that lie loose are thrown outwards.
void place_balls(const ShaftSystem& system, ShaftState& state) {
  for (std::size_t i = 0; i < system.size(); ++i) {
    const StaticBall b = static_ball(system.constants(i), system.groove_centre(state, i));
    state.balls[i] = b.load > 0.0 ? b.ball_centre : system.thrown_ball(i);
  }
}

/// Speed squared and then loads and shifts grow from the mounted state to the condition, with steps
/// as long as Newton allows.
bool follow(ShaftSystem& system, const ArrangementCondition& condition, bool loads_first,
            ShaftState& state) {
  constexpr double shortest = 1e-5;
  double s = 0.0, step = loads_first ? 1.0 : 0.1;
  bool placed = false;
  while (s < 1.0) {
    const double next = std::min(1.0, s + step);
    system.set_condition(condition, next, loads_first ? 1.0 : next);
    ShaftState trial = state;
    if (!placed) place_balls(system, trial);
    const int before = system.iterations();
    if (system.newton(trial)) {
      state = std::move(trial);
      placed = true;
      s = next;
      step *= system.iterations() - before <= 6 ? 2.5 : 1.3;
    } else {
      step *= 0.3;
      if (step < shortest || system.exhausted()) return false;
    }
  }
  return true;
}

bool find(ShaftSystem& system, const Arrangement& arrangement,
          const ArrangementCondition& condition, ShaftState& state) {
  state = mounted(arrangement);
  system.set_condition(condition, 0.0);
  const bool rests = system.newton(state);
  if (condition.speed == 0.0) return rests;
  if (!rests) state = mounted(arrangement);
  if (follow(system, condition, true, state)) return true;
  if (system.exhausted()) return false;
  state = mounted(arrangement);
  return follow(system, condition, false, state);
}

ShaftState state_of(const ArrangementEquilibrium& e, const Arrangement& arrangement,
                    const ShaftSystem& system) {
  ShaftState state = mounted(arrangement);
  state.shaft = arrangement.direction() * e.position;
  state.rear = e.rear_displacement;
  for (std::size_t i = 0; i < system.size(); ++i) {
    const BallEquilibrium& b = e.bearings[i].ball;
    const BallConstants& c = system.constants(i);
    if (!(b.outer_load > 0.0)) {
      state.balls[i] = system.thrown_ball(i);
      continue;
    }
    const double root = std::cbrt(b.outer_load / c.outer_stiffness);
    const double length = c.outer_radius + root * root;
    state.balls[i] = {length * std::sin(b.outer_contact_angle),
                      length * std::cos(b.outer_contact_angle)};
  }
  return state;
}

BearingInSet bearing_in_set(const ShaftSystem& system, const Bearing& bearing,
                            const ShaftState& state, std::size_t i) {
  const BearingShare& share = system.solution().bearings[i];
  const Plane a = system.groove_centre(state, i);
  BearingInSet b;
  b.axial_load = share.force;
  b.displacement = system.displacement(state, i);
  b.axial_stiffness = share.stiffness;
  const Plane x = state.balls[i];
  const double diameter = bearing.geometry().ball_diameter;
  b.ball = ball_equilibrium(system.at_rest() ? ball_report<true>(share.ball, a, x, diameter)
                                             : ball_report<false>(share.ball, a, x, diameter),
                            0.0);
  b.inner_pressure = bearing.contact(Race::inner).peak_pressure(share.ball.inner_load);
  b.outer_pressure = bearing.contact(Race::outer).peak_pressure(share.ball.outer_load);
  b.minimum_load = minimum_load(bearing, share.ball.centrifugal);
  if (const GivenRotation* given = system.rotation(i)) b.rotation = *given;
  return b;
}

/// Sums the forces again from the reported angles and loads of the balls.
double recovered_load_error(const ArrangementEquilibrium& e, const Arrangement& arrangement,
                            double load) {
  double front = 0.0, rear = 0.0;
  for (std::size_t i = 0; i < e.bearings.size(); ++i) {
    const BallEquilibrium& b = e.bearings[i].ball;
    if (!(b.inner_load > 0.0)) continue;
    (arrangement.side(i) == Side::front ? front : rear) +=
        arrangement.bearings()[i].bearing->geometry().ball_count *
        (b.inner_load * std::sin(b.inner_contact_angle) +
         b.inner_friction * std::cos(b.inner_contact_angle));
  }
  if (arrangement.design().rear.empty()) rear = e.rear_force;
  return std::abs(front - rear + load) / std::max({front, rear, std::abs(load), 1.0});
}

ArrangementEquilibrium solve(const Arrangement& arrangement, const ArrangementCondition& condition,
                             ShaftSystem& system, const ArrangementEquilibrium* neighbour) {
  ArrangementEquilibrium e;
  ShaftState state;
  bool found = false;
  system.restart();
  if (neighbour && neighbour->report.converged() &&
      neighbour->bearings.size() == arrangement.bearings().size()) {
    system.set_condition(condition);
    state = state_of(*neighbour, arrangement, system);
    found = system.newton(state);
  }
  if (!found) found = find(system, arrangement, condition, state);
  e.report.iterations = system.iterations();
  if (!found) {
    e.report.status = system.exhausted() ? SolveStatus::iteration_limit : system.failure();
    return e;
  }
  // Nothing holds a shaft whose sets are both free.
  if (!(system.stiffness() > 0.0)) {
    e.report.status = SolveStatus::singular;
    return e;
  }
  e.position = arrangement.direction() * state.shaft;
  e.rear_displacement = state.rear;
  e.front_force = system.solution().front.force;
  e.rear_force = system.rear_force(state);
  e.axial_stiffness = system.stiffness();
  e.bearings.reserve(system.size());
  bool pulls = false;
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (i > 0 && system.alike(state, i))
      e.bearings.push_back(e.bearings.back());
    else
      e.bearings.push_back(bearing_in_set(system, *arrangement.bearings()[i].bearing, state, i));
    pulls = pulls || e.bearings.back().axial_load < 0.0;
  }
  e.report.residual = system.solution().residual;
  e.report.recovered_load_error = recovered_load_error(e, arrangement, system.load());
  e.report.status = SolveStatus::converged;
  if (!pulls && e.report.recovered_load_error <= largest_load_error) return e;
  ArrangementEquilibrium refused;
  refused.report = e.report;
  refused.report.status = SolveStatus::no_equilibrium;
  return refused;
}

}  // namespace

RingShift thermal_shift(const Bearing& bearing, const SetTemperatures& t,
                        double mounting_temperature) {
  const BearingGeometry& g = bearing.geometry();
  const double balls = std::isnan(t.balls) ? 0.5 * (t.inner_ring + t.outer_ring) : t.balls;
  const double inner = bearing.rings().thermal_expansion * (t.inner_ring - mounting_temperature);
  const double outer = bearing.rings().thermal_expansion * (t.outer_ring - mounting_temperature);
  const double ball = bearing.balls().thermal_expansion * (balls - mounting_temperature);
  const double outer_radius = 0.5 * g.pitch_diameter - (g.outer_conformity - 0.5) *
                                                           g.ball_diameter *
                                                           std::cos(g.contact_angle);
  return {.axial = 0.5 * (inner + outer) * g.groove_centre_distance() * std::sin(g.contact_angle),
          .radial = inner * g.inner_groove_centre_radius() - outer * outer_radius,
          .inner_length = (inner * g.inner_conformity - 0.5 * ball) * g.ball_diameter,
          .outer_length = (outer * g.outer_conformity - 0.5 * ball) * g.ball_diameter};
}

void add_expansion(const Arrangement& arrangement, const SetTemperatures& t,
                   ArrangementCondition& condition) {
  const auto check = [](const char* name, double value) {
    require_between(name, value, 50.0, 800.0, 1.0, "K");
  };
  check("inner_ring", t.inner_ring);
  check("outer_ring", t.outer_ring);
  check("shaft", t.shaft);
  check("housing", t.housing);
  if (!std::isnan(t.balls)) check("balls", t.balls);
  const ArrangementDesign& d = arrangement.design();
  condition.shifts.resize(arrangement.bearings().size());
  for (std::size_t i = 0; i < condition.shifts.size(); ++i) {
    const RingShift s =
        thermal_shift(*arrangement.bearings()[i].bearing, t, d.mounting_temperature);
    condition.shifts[i].axial += s.axial;
    condition.shifts[i].radial += s.radial;
    condition.shifts[i].inner_length += s.inner_length;
    condition.shifts[i].outer_length += s.outer_length;
  }
  condition.elongation += d.distance * (d.shaft_expansion * (t.shaft - d.mounting_temperature) -
                                        d.housing_expansion * (t.housing - d.mounting_temperature));
}

double minimum_load(const Bearing& bearing, double centrifugal_force) {
  return bearing.geometry().ball_count * centrifugal_force *
         std::tan(bearing.geometry().contact_angle);
}

BearingEquilibrium ArrangementEquilibrium::bearing(std::size_t i,
                                                   const Arrangement& arrangement) const {
  const BearingInSet& in_set = bearings.at(i);
  const int count = arrangement.bearings()[i].bearing->geometry().ball_count;
  BearingEquilibrium e;
  e.displacement.setZero();
  e.displacement[0] = in_set.displacement;
  e.stiffness(0, 0) = in_set.axial_stiffness;
  e.report = report;
  e.balls.reset(count, Symmetry::thrust)[0] = in_set.ball;
  if (in_set.rotation) e.rotations = {*in_set.rotation};
  return e;
}

std::vector<GivenRotation> ArrangementEquilibrium::rotations() const {
  std::vector<GivenRotation> all;
  for (const BearingInSet& b : bearings)
    if (b.rotation) all.push_back(*b.rotation);
  return all;
}

EquilibriumOptions options_of_bearing(const EquilibriumOptions& options, std::size_t i) {
  EquilibriumOptions own = options;
  if (!options.rotations.empty()) own.rotations = options.rotations.subspan(i, 1);
  return own;
}

ArrangementEquilibrium solve_arrangement(const Arrangement& arrangement,
                                         const ArrangementCondition& condition,
                                         const EquilibriumOptions& options,
                                         const ArrangementEquilibrium* neighbour) {
  check(arrangement, condition, options);
  ShaftSystem system(arrangement, options);
  return solve(arrangement, condition, system, neighbour);
}

void solve_arrangement(const Arrangement& arrangement,
                       std::span<const ArrangementCondition> conditions,
                       std::span<ArrangementEquilibrium> results,
                       const EquilibriumOptions& options) {
  if (conditions.size() != results.size())
    throw std::invalid_argument(
        "solve_arrangement: the number of results must equal the number of conditions");
  ShaftSystem system(arrangement, options);
  const ArrangementEquilibrium* neighbour = nullptr;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    check(arrangement, conditions[i], options);
    results[i] = solve(arrangement, conditions[i], system, neighbour);
    if (results[i].report.converged()) neighbour = &results[i];
  }
}

}  // namespace raceway::bearing
