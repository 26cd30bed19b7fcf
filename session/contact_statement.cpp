#include "session/contact_statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bearing/arrangement_equilibrium.h"
#include "model/bearing_life.h"

namespace raceway::session {
namespace {

/// From where on a film is said to be full, and below which the asperities carry much [1]; the
/// usual limits of lubrication practice.
constexpr double full_film = 3.0, mixed_film = 1.0;

std::string_view regime(double film_ratio) {
  if (film_ratio >= full_film) return "full film";
  return film_ratio >= mixed_film ? "mixed friction" : "boundary friction";
}

}  // namespace

std::string judgement(const friction::contact::ContactResult& r) {
  const std::array parts{std::pair{r.rolling(), "rolling resistance of the oil"},
                         std::pair{r.sliding(), "sliding in the contacts"},
                         std::pair{r.hysteresis(), "hysteresis of the steel"},
                         std::pair{r.drag, "drag of the balls in the oil"}};
  const auto& largest = *std::max_element(
      parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return fmt::format(
      "{} (smallest lambda {:.3g}); largest part of the friction torque: {}, {:.0f} %",
      regime(r.friction.smallest_film_ratio), r.friction.smallest_film_ratio, largest.second,
      100.0 * largest.first / r.moment());
}

std::string balls_statement(const model::Model& model, const bearing::OperatingPoint& point) {
  const bearing::Material steel = bearing::steel();
  if (model.law != friction::FrictionLaw::contact || model.shaft ||
      (model.bearing.balls().density == steel.density &&
       model.bearing.balls().elastic_modulus == steel.elastic_modulus))
    return {};
  model::Model other = model;
  other.bearing = bearing::Bearing(model.bearing.geometry(), steel, model.bearing.rings());
  const model::FrictionPrediction own = predict_friction(model, point),
                                  with_steel = predict_friction(other, point);
  if (!own.predicted() || !with_steel.predicted()) return {};
  const auto largest = [](const model::FrictionPrediction& p,
                          double bearing::BallEquilibrium::*of) {
    double value = 0.0;
    for (const bearing::BallEquilibrium& ball : p.equilibrium->balls.distinct())
      value = std::fmax(value, ball.*of);
    return value;
  };
  using Ball = bearing::BallEquilibrium;
  return fmt::format(
      "with {} balls the torque is {:.2f} times the torque with steel balls at {:.6g} rpm and "
      "{:.6g} N axial load: centrifugal force of a ball {:.3g} instead of {:.3g} N, load at the "
      "outer race {:.3g} instead of {:.3g} N, elastic modulus {:.0f} instead of {:.0f} GPa "
      "(docs/laws.md)",
      model.bearing.balls().name, own.torque / with_steel.torque, point.speed / rpm,
      point.axial_load, largest(own, &Ball::centrifugal_force),
      largest(with_steel, &Ball::centrifugal_force), largest(own, &Ball::outer_load),
      largest(with_steel, &Ball::outer_load), model.bearing.balls().elastic_modulus / GPa,
      steel.elastic_modulus / GPa);
}

std::vector<std::string> notes_on_state(const model::Model& model, const bearing::Bearing& bearing,
                                        const bearing::OperatingPoint& point,
                                        const model::FrictionPrediction& prediction) {
  std::vector<std::string> notes;
  double centrifugal = 0.0;
  for (const bearing::BallEquilibrium& ball : prediction.equilibrium->balls.distinct())
    centrifugal = std::max(centrifugal, ball.centrifugal_force);
  const double least = minimum_load(bearing, centrifugal);
  const double axial = std::abs(point.axial_load) + prediction.condition.extra_axial_load;
  if (axial < least)
    notes.push_back(fmt::format(
        "the axial load of {:.4g} N is below the minimum load of {:.4g} N, at which the inner "
        "contact loads equal the centrifugal force (at the nominal contact angle): balls may skid",
        axial, least));
  if (const auto& c = prediction.contacts; c && c->holding_over_traction > 1.0)
    notes.push_back(fmt::format(
        "the gyroscopic moment requires a friction force of {:.3g} times the contact load. This is "
        "{:.3g} times the friction force that film and asperities can provide, so the balls slip; "
        "race_control = \"balanced\" calculates the equilibrium of the slipping balls "
        "(docs/race-control.md)",
        c->holding_coefficient, c->holding_over_traction));
  const model::BearingLife life = bearing_life(model, point, prediction);
  if (life.hybrid)
    notes.push_back(
        fmt::format("ISO 281 defines no a_ISO for {} balls, so the modified life is not "
                    "calculated; L10r uses the formula for steel and the loads of these balls",
                    bearing.balls().name));
  return notes;
}

}  // namespace raceway::session
