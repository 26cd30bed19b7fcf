#include "model/contact_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "friction/lubricant.h"

namespace raceway::model {
namespace {

using friction::BearingState;
using friction::contact::ContactResult;

constexpr std::size_t most_known = 8;
constexpr double farthest = 2e-3;        // that a tangent is good for [K]
constexpr double square_error = 2e-4;    // [K²]: distance of a secant's points times its reach
constexpr double slope_step = 0.1;       // [K]
constexpr double nearly_alike = 0.01;    // of a moment, so that slopes are in proportion
constexpr double farthest_alike = 1e-5;  // where they are not [K]

}  // namespace

bool ContactMemory::alike(const Known& known, const Balance& balls, const BearingState<double>& s,
                          std::span<const double> values) {
  return known.balls == balls && known.viscosity_40C == s.lubricant->viscosity_40C() &&
         known.viscosity_100C == s.lubricant->viscosity_100C() &&
         ContactResult::rescales(known.values, values);
}

ContactMemory::Parts ContactMemory::parts(const ContactResult& r) {
  const auto& [inner, outer] = std::pair(r.friction.inner, r.friction.outer);
  return {inner.sliding,    inner.rolling, inner.hysteresis, outer.sliding, outer.rolling,
          outer.hysteresis, r.drag};
}

ContactResult ContactMemory::moved(const Known& known, double rise,
                                   std::span<const double> values) {
  ContactResult r = known.result;
  if (rise != 0.0) {
    const Parts& slope = known.slope;
    auto &inner = r.friction.inner, &outer = r.friction.outer;
    inner.sliding += slope[0] * rise;
    inner.rolling += slope[1] * rise;
    inner.hysteresis += slope[2] * rise;
    outer.sliding += slope[3] * rise;
    outer.rolling += slope[4] * rise;
    outer.hysteresis += slope[5] * rise;
    r.drag += slope[6] * rise;
  }
  r.rescale(known.values, values);
  return r;
}

ContactMemory::Known& ContactMemory::remember(const Balance& balls, const BearingState<double>& s,
                                              std::span<const double> values,
                                              const ContactResult& result) {
  if (known_.size() == most_known) known_.pop_back();
  Known newest{
      .balls = balls,
      .viscosity_40C = s.lubricant->viscosity_40C(),
      .viscosity_100C = s.lubricant->viscosity_100C(),
      .temperature = s.temperature,
      .viscosity = s.kinematic_viscosity,
      .values = {values.begin(), values.end()},
      .result = result,
      .along_oil = s.kinematic_viscosity == s.lubricant->kinematic_viscosity(s.temperature)};
  return *known_.insert(known_.begin(), std::move(newest));
}

ContactResult ContactMemory::at(const Balance& balls, const BearingState<double>& s,
                                std::span<const double> values) {
  const Known* close = nullptr;
  for (const Known& known : known_) {
    if (!alike(known, balls, s, values)) continue;
    const double rise = s.temperature - known.temperature;
    if (rise == 0.0 && known.viscosity == s.kinematic_viscosity) return moved(known, 0.0, values);
    if (!close && known.along_oil && std::abs(rise) <= known.reach) close = &known;
  }
  if (close && s.kinematic_viscosity == s.lubricant->kinematic_viscosity(s.temperature))
    return moved(*close, s.temperature - close->temperature, values);
  return moved(remember(balls, s, values, friction::contact::contact_result(s, values)), 0.0,
               values);
}

/// The slope of the newest: a secant to the nearest of the same balance; that of another balance,
/// in proportion, where there is one; else by a difference.
void ContactMemory::find_slope(Known& newest, BearingState<double> s) {
  const Parts here = parts(newest.result);
  const Known *nearest = nullptr, *sloped = nullptr;
  double distance = 0.0;
  for (const Known& other : known_) {
    if (&other == &newest || !other.along_oil || !alike(other, newest.balls, s, newest.values)) {
      if (&other != &newest && !sloped && other.reach > 0.0 &&
          ContactResult::rescales(other.values, newest.values))
        sloped = &other;
      continue;
    }
    const double away = std::abs(other.temperature - newest.temperature);
    if (away > 1e-3 * farthest && (!nearest || away < distance)) {
      nearest = &other;
      distance = away;
    }
  }
  Parts there{};
  double step = slope_step;
  if (nearest) {
    step = nearest->temperature - newest.temperature;
    there = parts(moved(*nearest, 0.0, newest.values));
    newest.reach = std::min(farthest, square_error / distance);
  } else if (sloped) {
    // slope = part (slope/part) of the other one: neither factors nor the balance are in the ratio.
    const Parts other = parts(sloped->result);
    for (std::size_t k = 0; k < here.size(); ++k)
      newest.slope[k] = other[k] != 0.0 ? here[k] * (sloped->slope[k] / other[k]) : 0.0;
    const double ratio = newest.result.moment() / moved(*sloped, 0.0, newest.values).moment();
    newest.reach = std::abs(ratio - 1.0) < nearly_alike ? farthest : farthest_alike;
    return;
  } else {
    s.temperature += step;
    s.kinematic_viscosity = s.lubricant->kinematic_viscosity(s.temperature);
    there = parts(friction::contact::contact_result(s, newest.values));
    newest.reach = farthest;
  }
  for (std::size_t k = 0; k < here.size(); ++k) newest.slope[k] = (there[k] - here[k]) / step;
}

effects::MomentTangent ContactMemory::tangent(const Balance& balls, BearingState<double> s,
                                              std::span<const double> values) {
  s.kinematic_viscosity = s.lubricant->kinematic_viscosity(s.temperature);
  Known* found = nullptr;
  for (Known& known : known_)
    if (!found && known.along_oil && alike(known, balls, s, values) &&
        std::abs(s.temperature - known.temperature) <= known.reach)
      found = &known;
  if (!found) found = &remember(balls, s, values, friction::contact::contact_result(s, values));
  if (!(found->reach > 0.0)) find_slope(*found, s);
  last_temperature_ = found->temperature;
  const double moment = moved(*found, 0.0, values).moment();
  return {.temperature = found->temperature,
          .moment = moment,
          .slope = moved(*found, 1.0, values).moment() - moment,
          .reach = found->reach};
}

}  // namespace raceway::model
