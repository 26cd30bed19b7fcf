#include "bearing/equilibrium_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/lost_contacts.h"
#include "bearing/thrust_start.h"

namespace raceway::bearing {
namespace {

// What each way may cost; together less than EquilibriumOptions::max_iterations. Steps are spent
// where a path crawls towards a fold, or where no pattern of lost balls fits.
constexpr int steps_of_load_path = 300;
constexpr int steps_of_speed_path = 400;
constexpr int steps_of_inner_speed_path = 100;  // it ends where the first ball is lost
constexpr int steps_of_axial_path = 150;
constexpr double small_axial_share = 0.1;  // of the radial load: above it other paths find all
constexpr int steps_of_contacts = 300;
constexpr int steps_of_drops = 200;
constexpr int steps_of_search = 300;
constexpr int steps_of_scan = 600;

class Search {
 public:
  explicit Search(RingSystem& system) : system_(system) {}

  SolveStatus find(const OperatingPoint& point, const BearingEquilibrium* neighbour,
                   RingState& state) {
    if (cannot_balance(system_, point)) return SolveStatus::no_equilibrium;
    if (neighbour && neighbour->report.converged() &&
        neighbour->balls.size() == static_cast<std::size_t>(system_.geometry().ball_count)) {
      state = state_of(*neighbour);
      if (system_.newton(state)) return SolveStatus::converged;
    }
    if (point.axial_load > 0.0 && start_from_thrust(point.axial_load, state) &&
        system_.newton(state))
      return SolveStatus::converged;
    const bool contacts_open = system_.options().race_control == RaceControl::inner &&
                               system_.options().rotations.empty() && !system_.at_rest() &&
                               point.axial_load > 0.0;
    ContactSearch contacts(system_);
    if (contacts_open) {
      system_.allow(steps_of_contacts);
      if (contacts.settle(state)) return SolveStatus::converged;
    }
    system_.allow(steps_of_load_path);
    if (point.axial_load > 0.0 && follow_load(point, state)) return SolveStatus::converged;
    system_.set_point(point);
    system_.allow(contacts_open ? steps_of_inner_speed_path : steps_of_speed_path);
    if (follow_speed(point, state)) return SolveStatus::converged;
    if (point.axial_load > 0.0 &&
        point.axial_load < small_axial_share * std::hypot(point.radial_load, point.radial_load_z)) {
      system_.allow(steps_of_axial_path);
      if (follow_axial(point, state)) return SolveStatus::converged;
    }
    system_.set_point(point);
    if (contacts_open) {
      const RingState last = expanded(state);
      system_.allow(steps_of_drops);
      if (drop_least_loaded(point.axial_load, last, state)) return SolveStatus::converged;
      system_.allow(steps_of_search);
      if (contacts.widen(state)) return SolveStatus::converged;
      system_.allow(steps_of_scan);
      if (contacts.scan(state)) return SolveStatus::converged;
    }
    if (system_.iterations() >= system_.options().max_iterations)
      return SolveStatus::iteration_limit;
    // Under pure thrust a singular stiffness is a ring that touches no ball any more.
    return system_.symmetry() == Symmetry::thrust && system_.failure() == SolveStatus::singular
               ? SolveStatus::no_equilibrium
               : system_.failure();
  }

 private:
  /// Every ball where pure thrust would put it.
  bool start_from_thrust(double axial_load, RingState& state) const {
    ThrustStart<double> start;
    if (!thrust_start(race_control(), constants(), system_.free_groove_centre(),
                      axial_load / system_.geometry().ball_count, start))
      return false;
    state.ring.setZero();
    state.ring[0] = start.axial_displacement;
    state.balls.assign(system_.balls_used(), start.ball_centre);
    return true;
  }

  /// From pure thrust at full speed, radial load and moment growing in proportion.
  bool follow_load(const OperatingPoint& target, RingState& state) {
    if (system_.symmetry() == Symmetry::thrust) return false;
    if (!start_from_thrust(target.axial_load, state)) return false;
    return follow(
        [&](double s) {
          OperatingPoint p = target;
          p.radial_load *= s;
          p.radial_load_z *= s;
          p.moment_y *= s;
          p.moment_z *= s;
          return p;
        },
        1e-3, state);
  }

  /// From standstill under full load, speed squared growing in proportion.
  bool follow_speed(const OperatingPoint& target, RingState& state) {
    OperatingPoint rest = target;
    rest.speed = 0.0;
    system_.set_point(rest);
    if (!start_at_rest(rest, state)) return false;
    return follow(
        [&](double s) {
          OperatingPoint p = target;
          p.speed *= std::sqrt(s);
          return p;
        },
        0.1, state);
  }

  /// Natural contacts, from states in which the balls that carried least where the path in speed
  /// ended have lost the race, and the others share the thrust.
  bool drop_least_loaded(double axial_load, const RingState& last, RingState& state) {
    const auto n = system_.balls_used();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < n; ++k) {
      const Plane a = system_.groove_centre(last.ring, k), x = last.balls[k];
      order.emplace_back(std::hypot(a.axial - x.axial, a.radial - x.radial), k);
    }
    std::sort(order.begin(), order.end());
    double carrying = system_.geometry().ball_count;
    for (std::size_t lost = 1; lost < n && !system_.exhausted(); ++lost) {
      carrying -= system_.weight(order[lost - 1].second);
      ThrustStart<double> start;
      if (!thrust_start(race_control(), constants(), system_.free_groove_centre(),
                        axial_load / carrying, start))
        continue;
      for (const bool keep_ring : {true, false}) {
        state = last;
        if (!keep_ring) state.ring.setZero();
        state.ring[0] = start.axial_displacement;
        for (std::size_t j = 0; j < n; ++j)
          state.balls[order[j].second] = j < lost ? system_.thrown_ball() : start.ball_centre;
        if (system_.newton(state)) return true;
      }
    }
    return false;
  }

  bool start_at_rest(const OperatingPoint& rest, RingState& state) {
    if (rest.axial_load > 0.0 && start_from_thrust(rest.axial_load, state) && system_.newton(state))
      return true;
    // Further in where the first start presses so few balls that the ring could pivot about them.
    for (const double depth : {1.0, 4.0, 16.0}) {
      start_from_shift(depth, state);
      if (system_.newton(state)) return true;
      if (rest.axial_load > 0.0) break;
    }
    if (rest.axial_load > 0.0) return follow_load(rest, state);
    return follow_moment(rest, state) || follow_relief(rest, state);
  }

  /// Without axial load: from a multiple of the load, which presses more balls, down to it.
  bool follow_relief(const OperatingPoint& target, RingState& state) {
    for (const double multiple : {8.0, 64.0, 512.0}) {
      const auto path = [&](double s) {
        const double share = std::pow(multiple, 1.0 - s);
        OperatingPoint p = target;
        for (double OperatingPoint::*load :
             {&OperatingPoint::radial_load, &OperatingPoint::radial_load_z,
              &OperatingPoint::moment_y, &OperatingPoint::moment_z})
          p.*load *= share;
        return p;
      };
      system_.set_point(path(0.0));
      start_from_shift(1.0, state);
      if (system_.newton(state) && follow(path, 0.1, state)) return true;
    }
    return false;
  }

  /// From the same load without its axial part, which then grows: little of it leaves the ring
  /// where a radial load alone puts it.
  bool follow_axial(const OperatingPoint& target, RingState& state) {
    OperatingPoint aside = target;
    aside.axial_load = 0.0;
    if (aside.radial_load == 0.0 && aside.radial_load_z == 0.0) return false;
    if (!follow_speed(aside, state)) return false;
    return follow(
        [&](double s) {
          OperatingPoint p = target;
          p.axial_load *= s;
          return p;
        },
        0.01, state);
  }

  /// The ring moved and tilted along the load until the ball pressed most carries a few times its
  /// part. Without axial load from where grooves of angular contact stand opposite each other:
  /// there all balls carry in pairs, as the sum of axial forces demands.
  void start_from_shift(double depth, RingState& state) const {
    const double approach =
        depth * std::pow(5.0 * load_per_ball() /
                             std::min(constants().inner_stiffness, constants().outer_stiffness),
                         2.0 / 3.0);
    const double length = constants().inner_radius + constants().outer_radius + 2.0 * approach;
    state.balls.assign(system_.balls_used(), {0.0, constants().outer_radius});
    Vector5 base = Vector5::Zero();
    if (load()[0] == 0.0) base[0] = -system_.free_groove_centre().axial;
    const Vector5 along = load().normalized();
    const auto presses = [&](double shift) {
      state.ring = base + shift * along;
      for (std::size_t k = 0; k < state.balls.size(); ++k) {
        const Plane a = system_.groove_centre(state.ring, k);
        if (a.radial > 0.0 && std::hypot(a.axial, a.radial) >= length) return true;
      }
      return false;
    };
    double low = 0.0, high = approach;
    for (int i = 0; i < 60 && !presses(high); ++i) {
      low = high;
      high *= 2.0;
    }
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      (presses(middle) ? high : low) = middle;
    }
    state.ring = base + high * along;
  }

  /// Without axial load: from the radial load alone, the moment growing in proportion.
  bool follow_moment(const OperatingPoint& target, RingState& state) {
    const bool radial = target.radial_load != 0.0 || target.radial_load_z != 0.0;
    const bool moment = target.moment_y != 0.0 || target.moment_z != 0.0;
    if (!radial || !moment || system_.options().tilt == Tilt::locked) return false;
    OperatingPoint start = target;
    start.moment_y = start.moment_z = 0.0;
    system_.set_point(start);
    start_from_shift(1.0, state);
    if (!system_.newton(state)) return false;
    return follow(
        [&](double s) {
          OperatingPoint p = target;
          p.moment_y *= s;
          p.moment_z *= s;
          return p;
        },
        0.1, state);
  }

  /// Follows the solution along path(s) to s = 1 with steps as long as Newton allows.
  template <typename Path>
  bool follow(const Path& path, double step, RingState& state) {
    constexpr double shortest = 1e-5;
    double s = 0.0;
    while (s < 1.0) {
      if (system_.exhausted()) return false;
      const double next = std::min(1.0, s + step);
      system_.set_point(path(next));
      RingState trial = expanded(state);
      const int before = system_.iterations();
      if (system_.newton(trial)) {
        state = std::move(trial);
        s = next;
        step *= system_.iterations() - before <= 6 ? 2.5 : 1.3;
      } else {
        step *= 0.3;
        if (step < shortest) return false;
      }
    }
    return true;
  }

  /// The same state for as many balls as the present symmetry asks for.
  RingState expanded(const RingState& from) const {
    RingState to = from;
    const auto n = system_.balls_used();
    if (to.balls.size() == 1) to.balls.assign(n, from.balls[0]);
    to.balls.resize(n);
    if (system_.at_rest()) return to;
    // A ball that lay loose at rest is thrown against the outer race.
    for (Plane& x : to.balls)
      if (std::hypot(x.axial, x.radial) <= constants().outer_radius) x = system_.thrown_ball();
    return to;
  }

  RingState state_of(const BearingEquilibrium& e) const {
    RingState state;
    state.ring = e.displacement;
    state.ring.tail<2>() *= system_.lever();
    if (system_.options().tilt == Tilt::locked) state.ring.tail<2>().setZero();
    if (system_.symmetry() != Symmetry::none) state.ring[2] = state.ring[3] = 0.0;
    if (system_.symmetry() == Symmetry::thrust) state.ring[1] = state.ring[4] = 0.0;
    for (std::size_t k = 0; k < system_.balls_used(); ++k) {
      const BallEquilibrium& b = e.balls[k];
      const double length = constants().outer_radius +
                            std::pow(b.outer_load / constants().outer_stiffness, 2.0 / 3.0);
      const double angle = std::isnan(b.outer_contact_angle) ? 0.0 : b.outer_contact_angle;
      state.balls.push_back({length * std::sin(angle), length * std::cos(angle)});
    }
    return state;
  }

  const BallConstantsOf<double>& constants() const { return system_.constants(); }
  RaceControl race_control() const { return system_.options().race_control; }
  Vector5 load() const { return system_.load(); }
  double load_per_ball() const { return system_.load_scale() / system_.geometry().ball_count; }

  RingSystem& system_;
};

}  // namespace

bool cannot_balance(const RingSystem& system, const OperatingPoint& point) {
  return system.load_scale() == 0.0 ||
         (system.geometry().contact_angle > 0.0 && point.axial_load < 0.0);
}

SolveStatus find_equilibrium(RingSystem& system, const OperatingPoint& point,
                             const BearingEquilibrium* neighbour, RingState& state) {
  return Search(system).find(point, neighbour, state);
}

}  // namespace raceway::bearing
