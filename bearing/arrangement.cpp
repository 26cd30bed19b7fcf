#include "bearing/arrangement.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

#include "bearing/ball_equilibrium.h"
#include "bearing/contact_pressure.h"
#include "bearing/validation.h"

namespace raceway::bearing {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct ForceAndStiffness {
  double force = 0.0, stiffness = 0.0;
};

ForceAndStiffness at_rest(const Bearing& bearing, double displacement) {
  const BearingGeometry& g = bearing.geometry();
  const BallConstants c = ball_constants(bearing, 0.0, RaceControl::outer, false);
  const double distance = g.groove_centre_distance();
  const StaticBall ball = static_ball(c, {distance * std::sin(g.contact_angle) + displacement,
                                          distance * std::cos(g.contact_angle)});
  return {g.ball_count * ball.force.axial, g.ball_count * ball.f_a[0]};
}

ForceAndStiffness at_rest(std::span<const MountedBearing> set, double displacement) {
  ForceAndStiffness sum;
  for (const MountedBearing& m : set) {
    const ForceAndStiffness one = at_rest(*m.bearing, displacement + m.offset);
    sum.force += one.force;
    sum.stiffness += one.stiffness;
  }
  return sum;
}

/// The displacement at which the set comes free.
double free_displacement(std::span<const MountedBearing> set) {
  double offset = -infinite;
  for (const MountedBearing& m : set) offset = std::max(offset, m.offset);
  return -offset;
}

/// Root of a growing function with its derivative, from `lower`, where it is not above zero.
template <typename F>
double growing_root(const F& function, double lower, double scale) {
  double upper = lower + scale;
  for (int i = 0; i < 60 && function(upper).first < 0.0; ++i) upper = lower + 2.0 * (upper - lower);
  std::uintmax_t steps = 200;
  return boost::math::tools::newton_raphson_iterate(function, upper, lower, upper, 50, steps);
}

double displacement_under(std::span<const MountedBearing> set, double force) {
  const double lower = free_displacement(set);
  if (force <= 0.0) return lower;
  return growing_root(
      [&](double displacement) {
        const ForceAndStiffness f = at_rest(set, displacement);
        return std::pair(f.force - force, f.stiffness);
      },
      lower, 0.01 * set.front().bearing->geometry().groove_centre_distance());
}

void check(const std::vector<MountedBearing>& set, const char* name) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    std::ostringstream owner;
    owner << name << " bearing " << i + 1 << ": ";
    if (!set[i].bearing) throw std::invalid_argument(owner.str() + "is missing");
    // Deep-groove bearings have no side to be preloaded on.
    require_between(owner.str() + "contact_angle", set[i].bearing->geometry().contact_angle,
                    5 * degree, 65 * degree, degree, "deg");
    require_between(owner.str() + "offset", set[i].offset, -1 * mm, 1 * mm, um, "um");
  }
}

void check(const ArrangementDesign& d) {
  constexpr std::size_t most = 20;
  if (d.front.empty() || d.front.size() > most) {
    std::ostringstream text;
    text << "front = " << d.front.size() << ": must be from 1 to " << most << " bearings";
    throw std::invalid_argument(text.str());
  }
  const bool tandem = d.layout == Layout::tandem;
  if (tandem ? !d.rear.empty() : d.rear.empty() || d.rear.size() > most) {
    std::ostringstream text;
    text << "rear = " << d.rear.size();
    if (tandem) {
      text << ": must be 0, because a tandem arrangement has no second set";
    } else {
      text << ": must be from 1 to " << most << " bearings";
    }
    throw std::invalid_argument(text.str());
  }
  check(d.front, "front");
  check(d.rear, "rear");
  if (tandem && d.mounting == Mounting::rigid)
    throw std::invalid_argument(
        "mounting = rigid: not possible, because a tandem arrangement needs a spring");
  if (const auto* offset = std::get_if<PreloadOffset>(&d.preload)) {
    if (d.mounting == Mounting::spring)
      throw std::invalid_argument(
          "preload_offset: not possible with mounting = spring; give preload_force");
    require_between("preload_offset", offset->offset, 0.0, 1 * mm, um, "um");
  } else {
    require_between("preload_force", std::get<PreloadForce>(d.preload).force, 0.0, 1e8, 1.0, "N");
  }
  require_between("spring_rate", d.spring_rate, 0.0, 1e12, N_per_um, "N/um");
  require_between("other_mounting", d.other_mounting, 0.0, 1.0, 1.0, "");
  if (tandem && d.other_mounting != 0.0)
    throw std::invalid_argument(
        "other_mounting: not possible, because a tandem arrangement needs a spring");
  require_between("shaft_stiffness", d.shaft_stiffness, 1e3, infinite, N_per_um, "N/um");
  require_between("housing_stiffness", d.housing_stiffness, 1e3, infinite, N_per_um, "N/um");
  require_between("distance", d.distance, 0.0, 100.0, mm, "mm");
  require_between("shaft_expansion", d.shaft_expansion, 0.0, 50 * per_million_K, per_million_K,
                  "1e-6/K");
  require_between("housing_expansion", d.housing_expansion, 0.0, 50 * per_million_K, per_million_K,
                  "1e-6/K");
  require_between("mounting_temperature", d.mounting_temperature, 1.0, 800.0, 1.0, "K");
}

}  // namespace

Arrangement::Arrangement(ArrangementDesign design) : design_(std::move(design)) {
  check(design_);
  bearings_ = design_.front;
  bearings_.insert(bearings_.end(), design_.rear.begin(), design_.rear.end());
  const double series = 1.0 / design_.shaft_stiffness + 1.0 / design_.housing_stiffness;
  if (design_.mounting == Mounting::rigid) {
    seat_ = {series, 1.0};
  } else {
    seat_ = {1.0, design_.spring_rate / (1.0 + design_.spring_rate * series)};
  }
  if (const auto* force = std::get_if<PreloadForce>(&design_.preload)) {
    preload_ = force->force;
    front_displacement_ = displacement_under(design_.front, preload_);
  } else {
    const double offset = std::get<PreloadOffset>(design_.preload).offset;
    const double lower = free_displacement(design_.front);
    const double rest = offset + lower + free_displacement(design_.rear);
    // At a force on the front set, what is left of the offset for the rear one.
    front_displacement_ = growing_root(
        [&](double displacement) {
          const ForceAndStiffness front = at_rest(design_.front, displacement);
          const double left = rest - displacement - series * front.force;
          const ForceAndStiffness rear = at_rest(design_.rear, left);
          return std::pair(front.force - rear.force,
                           front.stiffness + rear.stiffness * (1.0 + series * front.stiffness));
        },
        lower, std::max(offset, 1e-9));
    preload_ = at_rest(design_.front, front_displacement_).force;
  }
  if (design_.rear.empty()) return;
  rear_displacement_ = displacement_under(design_.rear, preload_);
  if (design_.other_mounting > 0.0) {
    const double stiffness = at_rest(design_.rear, rear_displacement_).stiffness;
    const Seat rigid{series * stiffness, stiffness};
    const bool springs = design_.mounting == Mounting::spring;
    const Seat from = springs ? seat_ : rigid, to = springs ? rigid : Seat{1.0, 0.0};
    const double m = design_.other_mounting;
    seat_ = {(1.0 - m) * from.softness + m * to.softness,
             (1.0 - m) * from.hardness + m * to.hardness};
  }
}

namespace {

/// True if the contacts of a set at rest take that force without dents.
bool endures(const std::vector<MountedBearing>& set, double force) {
  double carrying = 0.0;
  for (const MountedBearing& m : set)
    carrying += m.bearing->geometry().ball_count * std::sin(m.bearing->geometry().contact_angle);
  return std::all_of(set.begin(), set.end(), [&](const MountedBearing& m) {
    return m.bearing->contact(Race::inner).peak_pressure(force / carrying) <= static_limit_pressure;
  });
}

}  // namespace

LiftOff lift_off(const Arrangement& a) {
  const ArrangementDesign& d = a.design();
  const Arrangement::Seat seat = a.seat();
  LiftOff result;
  // In the front set's own direction y = d x: where it comes free.
  const double y = a.displacement(Side::front) - free_displacement(d.front);
  if (d.rear.empty()) {
    result.front = a.preload() + seat.hardness * y;
    return result;
  }
  const double rear = a.displacement(Side::rear), free = free_displacement(d.rear);
  const double loaded = growing_root(
      [&](double displacement) {
        const ForceAndStiffness f = at_rest(d.rear, displacement);
        return std::pair(
            seat.softness * (f.force - a.preload()) - seat.hardness * (y - (displacement - rear)),
            seat.softness * f.stiffness + seat.hardness);
      },
      free, std::max(y, rear - free));
  result.front = a.direction() * at_rest(d.rear, loaded).force;
  if (seat.hardness > 0.0) {
    const double back = -seat.softness * a.preload() / seat.hardness + free - rear;
    const double force = at_rest(d.front, a.displacement(Side::front) - back).force;
    if (endures(d.front, force)) result.rear = -a.direction() * force;
  }
  return result;
}

double axial_force_at_rest(const Bearing& bearing, double displacement) {
  return at_rest(bearing, displacement).force;
}

double displacement_at_rest(const Bearing& bearing, double force) {
  require_between("force", force, 0.0, 1e8, 1.0, "N");
  // Not owned: lives no longer than this call.
  const MountedBearing one{
      std::shared_ptr<const Bearing>(std::shared_ptr<const Bearing>(), &bearing)};
  return displacement_under({&one, 1}, force);
}

PreloadOffset matched_preload(const Bearing& front, double front_force, const Bearing& rear,
                              double rear_force) {
  return {displacement_at_rest(front, front_force) + displacement_at_rest(rear, rear_force)};
}

}  // namespace raceway::bearing
