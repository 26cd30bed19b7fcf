#include "fit/prediction.h"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/solve_many.h"

namespace raceway::fit {

namespace {

constexpr std::size_t chunk = 256;        // points that a thread takes
constexpr double tilt_tolerance = 1e-10;  // [rad]

using effects::Condition;
using effects::Effect;

bool finite(const bearing::OperatingPoint& p) {
  return std::isfinite(p.speed) && std::isfinite(p.axial_load) && std::isfinite(p.radial_load) &&
         std::isfinite(p.radial_load_z) && std::isfinite(p.moment_y) && std::isfinite(p.moment_z) &&
         std::isfinite(p.temperature);
}

/// An angular contact bearing cannot be pulled: the extra load ends where the entered one is gone.
double with_extra(double axial_load, double extra) {
  return std::copysign(std::max(std::abs(axial_load) + extra, 0.0), axial_load);
}

bearing::Material blend(const bearing::Material& a, const bearing::Material& b, double share) {
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  return {.name = a.name,
          .elastic_modulus = between(a.elastic_modulus, b.elastic_modulus),
          .poisson_ratio = between(a.poisson_ratio, b.poisson_ratio),
          .density = between(a.density, b.density),
          .thermal_expansion = between(a.thermal_expansion, b.thermal_expansion)};
}

bearing::BearingEquilibrium solve_from(const bearing::Bearing& bearing,
                                       const bearing::OperatingPoint& point,
                                       const bearing::EquilibriumOptions& options,
                                       const bearing::BearingEquilibrium* neighbour) {
  return neighbour ? bearing::solve_bearing_equilibrium(bearing, point, options, *neighbour)
                   : bearing::solve_bearing_equilibrium(bearing, point, options);
}

/// Equilibrium at an imposed tilt about z: Newton's method for the two moments that hold it.
bearing::BearingEquilibrium solve_tilted(const bearing::Bearing& bearing,
                                         bearing::OperatingPoint point,
                                         bearing::EquilibriumOptions options, double tilt,
                                         const bearing::BearingEquilibrium* neighbour) {
  options.tilt = bearing::Tilt::free;
  point.moment_y = point.moment_z = 0.0;
  bearing::BearingEquilibrium e = solve_from(bearing, point, options, neighbour);
  for (int i = 0; i < 30 && e.report.converged(); ++i) {
    const Eigen::Vector2d missing(-e.displacement[3], tilt - e.displacement[4]);
    if (missing.lpNorm<Eigen::Infinity>() < tilt_tolerance) return e;
    // Forces stay: the tilt stiffness with the displacements eliminated.
    const Eigen::Matrix2d stiffness = e.stiffness.bottomRightCorner<2, 2>() -
                                      e.stiffness.bottomLeftCorner<2, 3>() *
                                          e.stiffness.topLeftCorner<3, 3>().partialPivLu().solve(
                                              e.stiffness.topRightCorner<3, 2>());
    const Eigen::Vector2d moment = stiffness * missing;
    point.moment_y += moment[0];
    point.moment_z += moment[1];
    e = solve_from(bearing, point, options, &e);
  }
  if (e.report.converged()) e.report.status = bearing::SolveStatus::iteration_limit;
  return e;
}

/// True if somebody has tried to solve it.
bool known(const bearing::SolveReport& report) {
  return report.status != bearing::SolveStatus::not_run &&
         report.status != bearing::SolveStatus::not_finite;
}

}  // namespace

std::shared_ptr<const bearing::Bearing> changed_bearing(const bearing::Bearing& entered,
                                                        const effects::Condition& c) {
  bearing::BearingGeometry g = entered.geometry();
  if (c.radial_growth != 0.0) {
    if (g.contact_angle > 0.0) {
      const double cosine =
          std::cos(g.contact_angle) + c.radial_growth / g.groove_centre_distance();
      if (!(cosine > 0.0 && cosine < 1.0)) return nullptr;
      g.contact_angle = std::acos(cosine);
    } else {
      g.radial_clearance -= 2.0 * c.radial_growth;
    }
  }
  bearing::Material balls = entered.balls();
  if (c.other_balls != 0.0)
    balls = blend(balls, balls.density > 5000.0 ? bearing::silicon_nitride() : bearing::steel(),
                  c.other_balls);
  try {
    return std::make_shared<const bearing::Bearing>(g, balls, entered.rings());
  } catch (const std::invalid_argument&) {
    return nullptr;  // outside what a bearing can be
  }
}

bool FrictionPrediction::predicted() const { return std::isfinite(torque); }

effects::Record record_of(const Row& row) {
  return {.time = row.time,
          .inner_ring_temperature = row.inner_ring_temperature,
          .outer_ring_temperature = row.outer_ring_temperature,
          .run = row.run};
}

bool needs_equilibrium(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const Effect& effect) { return effect.description->needs_equilibrium; });
}

Steps::Steps(const Model& model, bool with_equilibrium)
    : equilibrium(with_equilibrium || needs_equilibrium(model)),
      needs_balls(needs_equilibrium(model)) {
  for (std::size_t k = 0; k < model.effects.size(); ++k) {
    const effects::Description& d = *model.effects[k].description;
    if (d.condition) condition.push_back(k);
    if (d.lubricant) lubricant.push_back(k);
    if (d.has_moment()) moment.push_back(k);
    if (d.reading) reading.push_back(k);
    if (d.displacement) displacement.push_back(k);
  }
  // Descriptions of the catalogue stand in one array, in its order.
  std::stable_sort(lubricant.begin(), lubricant.end(), [&](std::size_t a, std::size_t b) {
    return std::less<>()(model.effects[a].description, model.effects[b].description);
  });
}

Condition condition_of(const Model& model, const Steps& steps,
                       const friction::BearingState<double>& entered,
                       const bearing::OperatingPoint& point, const effects::Record& record,
                       const Condition& given) {
  Condition condition = given;
  if (steps.condition.empty()) return condition;
  const effects::BaseLaw law{model.law, model.law_values};
  const friction::BaseMoments<double> base = law.moments(entered);
  const effects::ConditionInputs inputs{.bearing = *entered.bearing,
                                        .point = point,
                                        .record = record,
                                        .power = (base.load + base.viscous) * point.speed};
  for (const std::size_t k : steps.condition)
    model.effects[k].description->condition(inputs, model.effects[k].values, condition);
  return condition;
}

Stage first_stage(const Model& model, const Steps& steps, int effect) {
  if (effect < 0) {
    // Effects on condition and lubricant may look at the power of the base law.
    if (!steps.condition.empty()) return Stage::condition;
    return steps.lubricant.empty() ? Stage::base : Stage::lubricant;
  }
  const effects::Description& d = *model.effects[static_cast<std::size_t>(effect)].description;
  if (d.condition) return Stage::condition;
  if (d.lubricant) return Stage::lubricant;
  return d.has_moment() ? Stage::moment : Stage::reading;
}

RowPredictor::RowPredictor(const Model& model, const Steps& steps,
                           const bearing::OperatingPoint& point, const effects::Record& record,
                           Balance entered, const Condition& given)
    : point_(point),
      record_(record),
      given_(given),
      entered_viscosity_(model.lubricant.kinematic_viscosity(point.temperature)),
      radial_load_(std::hypot(point.radial_load, point.radial_load_z)) {
  now_.units.assign(steps.moment.size(), unset);
  if (!entered) return;
  now_.report = entered->report;
  now_.equilibrium = std::move(entered);
}

friction::BearingState<double> RowPredictor::state(const Model& model, const Way& way) const {
  return {.bearing = &model.bearing,
          .equilibrium = way.equilibrium.get(),
          .race_control = model.solver.race_control,
          .speed = point_.speed,
          .axial_load = with_extra(point_.axial_load, way.condition.extra_axial_load),
          .radial_load = radial_load_,
          .temperature = point_.temperature,
          .kinematic_viscosity = way.film.kinematic_viscosity};
}

bool RowPredictor::find_condition(const Model& model, const Steps& steps,
                                  Condition& condition) const {
  if (!finite(point_)) return false;
  Way before;
  before.film.kinematic_viscosity = entered_viscosity_;
  condition = condition_of(model, steps, state(model, before), point_, record_, given_);
  return condition.finite();
}

std::optional<bearing::BearingCase> RowPredictor::question(const Model& model, Way& way) const {
  way.bearing = nullptr;
  way.equilibrium = nullptr;
  way.report = {};
  if (way.condition.changes_bearing()) {
    way.bearing = changed_bearing(model.bearing, way.condition);
    if (!way.bearing) {
      way.report.status = bearing::SolveStatus::no_equilibrium;
      return {};
    }
  }
  bearing::BearingCase asked{way.bearing ? way.bearing.get() : &model.bearing, point_};
  asked.point.axial_load = with_extra(point_.axial_load, way.condition.extra_axial_load);
  return asked;
}

void RowPredictor::solve(const Model& model, Way& way) const {
  // Started from the way's own last balance.
  const Balance last = way.equilibrium;
  const bearing::BearingEquilibrium* start =
      last && last->report.converged() ? last.get() : nullptr;
  const auto asked = question(model, way);
  if (!asked) return;
  way.equilibrium = std::make_shared<const bearing::BearingEquilibrium>(
      way.condition.tilt != 0.0
          ? solve_tilted(*asked->bearing, asked->point, model.solver, way.condition.tilt, start)
          : solve_from(*asked->bearing, asked->point, model.solver, start));
  way.report = way.equilibrium->report;
}

std::optional<bearing::BearingCase> RowPredictor::ask(const Model& model, const Steps& steps) {
  Condition condition;
  if (!steps.equilibrium || !find_condition(model, steps, condition) || condition.tilt != 0.0)
    return {};
  if (condition == now_.condition && known(now_.report)) return {};
  now_.condition = condition;
  return question(model, now_);
}

void RowPredictor::answer(bearing::BearingEquilibrium&& equilibrium) {
  now_.report = equilibrium.report;
  now_.equilibrium = std::make_shared<const bearing::BearingEquilibrium>(std::move(equilibrium));
}

void RowPredictor::run(const Model& model, const Steps& steps, Stage stage, Way& way) const {
  const effects::BaseLaw law{model.law, model.law_values};
  if (stage <= Stage::moment) way.torque = unset;
  way.reading = unset;
  if (stage == Stage::condition) {
    Condition condition;
    if (!find_condition(model, steps, condition)) {
      way.report.status = bearing::SolveStatus::not_finite;
      return;
    }
    const bool solved = condition == way.condition && known(way.report);
    way.condition = condition;
    if (steps.equilibrium && !solved) solve(model, way);
  }
  if (steps.needs_balls && !way.report.converged()) return;

  friction::BearingState<double> s = state(model, way);
  if (stage <= Stage::lubricant) {
    way.film = {.kinematic_viscosity = entered_viscosity_};
    if (!steps.lubricant.empty()) {
      s.kinematic_viscosity = entered_viscosity_;
      const effects::LubricantInputs inputs{.lubricant = model.lubricant, .state = s, .base = law};
      for (const std::size_t k : steps.lubricant)
        model.effects[k].description->lubricant(inputs, model.effects[k].values, way.film);
    }
    s.kinematic_viscosity = way.film.kinematic_viscosity;
  }
  if (stage <= Stage::base) {
    way.base = law.moments(s);
    way.base.viscous *= way.film.viscous_share;
  }
  if (stage <= Stage::moment) {
    // Laws of ball loads look at the bearing as it is, base laws at the one in the catalogue.
    if (way.bearing) s.bearing = way.bearing.get();
    const effects::MomentInputs inputs{.state = s, .base = way.base, .record = record_};
    double sum = way.base.load + way.base.viscous;
    for (std::size_t m = 0; m < steps.moment.size(); ++m) {
      const Effect& effect = model.effects[steps.moment[m]];
      if (!effect.description->unit_moment) {
        sum += effect.moment(inputs);
        continue;
      }
      if (stage <= Stage::lubricant) way.units[m] = effect.description->unit_moment(inputs);
      sum += effect.values[0] * way.units[m];
    }
    way.torque = sum;
  }
  const double rig = rig_torque(model.rig, way.torque);
  way.reading = rig;
  const effects::ReadingInputs inputs{.torque = rig, .point = point_, .record = record_};
  for (const std::size_t k : steps.reading)
    way.reading += model.effects[k].description->reading(inputs, model.effects[k].values);
}

double RowPredictor::predict(const Model& model, const Steps& steps, Stage from) {
  // Where there was no prediction, nothing is known to start from.
  run(model, steps, std::isfinite(now_.reading) ? from : Stage::condition, now_);
  return now_.reading;
}

double RowPredictor::vary(const Model& model, const Steps& steps, Stage stage) const {
  varied_ = now_;
  run(model, steps, stage, varied_);
  return varied_.reading;
}

FrictionPrediction RowPredictor::prediction(const Model& model) const {
  FrictionPrediction p;
  p.condition = now_.condition;
  p.bearing = now_.bearing;
  if (now_.report.converged()) p.equilibrium = now_.equilibrium;
  p.report = now_.report;
  p.effects.assign(model.effects.size(), unset);
  if (std::isnan(now_.reading) && std::isnan(now_.torque)) {
    if (now_.report.status == bearing::SolveStatus::not_run)
      p.report.status = bearing::SolveStatus::not_finite;
    return p;
  }
  p.load = now_.base.load;
  p.viscous = now_.base.viscous;
  p.torque = now_.torque;
  p.power_loss = now_.torque * point_.speed;
  p.reading = now_.reading;
  p.kinematic_viscosity = now_.film.kinematic_viscosity;
  friction::BearingState<double> s = state(model, now_);
  if (now_.bearing) s.bearing = now_.bearing.get();
  const effects::MomentInputs inputs{.state = s, .base = now_.base, .record = record_};
  for (std::size_t k = 0; k < model.effects.size(); ++k)
    p.effects[k] = model.effects[k].moment(inputs);
  return p;
}

FrictionPrediction predict_friction(const Model& model, const bearing::OperatingPoint& point,
                                    bool with_equilibrium, const effects::Record& record) {
  const Steps steps(model, with_equilibrium);
  RowPredictor row(model, steps, point, record);
  (void)row.predict(model, steps);
  return row.prediction(model);
}

namespace {

/// Solves the balances that the rows ask for side by side.
void answer_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows) {
  if (!steps.equilibrium) return;
  std::vector<bearing::BearingCase> asked;
  std::vector<std::size_t> asking;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const auto question = rows[i].ask(model, steps)) {
      asked.push_back(*question);
      asking.push_back(i);
    }
  if (asked.empty()) return;
  std::vector<bearing::BearingEquilibrium> solved(asked.size());
  bearing::solve_many(asked, solved, model.solver);
  for (std::size_t n = 0; n < asked.size(); ++n) rows[asking[n]].answer(std::move(solved[n]));
}

}  // namespace

void predict_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows,
                 std::span<double> readings, Stage from) {
  if (from == Stage::condition) answer_all(model, steps, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) readings[i] = rows[i].predict(model, steps, from);
}

std::vector<Balance> entered_balances(const Model& model, const DataSet& data) {
  Model plain = model;
  plain.effects.clear();
  const Steps steps(plain, true);
  std::vector<RowPredictor> rows;
  rows.reserve(data.rows.size());
  for (const Row& row : data.rows) rows.emplace_back(plain, steps, row.point, record_of(row));
  answer_all(plain, steps, rows);
  std::vector<Balance> balances;
  for (const RowPredictor& row : rows) balances.push_back(row.equilibrium());
  return balances;
}

void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium,
                   std::span<const effects::Record> records) {
  if (points.size() != predictions.size())
    throw std::invalid_argument("predict_sweep: as many predictions as points are needed");
  if (!records.empty() && records.size() != points.size())
    throw std::invalid_argument("predict_sweep: as many records as points are needed, or none");
  const Steps steps(model, with_equilibrium);
  const std::size_t chunks = (points.size() + chunk - 1) / chunk;
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t k) {
    const std::size_t first = k * chunk, count = std::min(chunk, points.size() - first);
    std::vector<RowPredictor> rows;
    rows.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      rows.emplace_back(model, steps, points[first + i],
                        records.empty() ? effects::Record{} : records[first + i]);
    answer_all(model, steps, rows);
    for (std::size_t i = 0; i < count; ++i) {
      (void)rows[i].predict(model, steps);
      predictions[first + i] = rows[i].prediction(model);
    }
  });
}

std::vector<FrictionPrediction> predict_rows(const Model& model, const DataSet& data) {
  std::vector<bearing::OperatingPoint> points;
  std::vector<effects::Record> records;
  points.reserve(data.rows.size());
  records.reserve(data.rows.size());
  for (const Row& row : data.rows) {
    points.push_back(row.point);
    records.push_back(record_of(row));
  }
  std::vector<FrictionPrediction> predictions(points.size());
  predict_sweep(model, points, predictions, false, records);
  return predictions;
}

double rig_torque(const Rig& rig, double bearing_torque) { return rig.bearings * bearing_torque; }

friction::BearingState<double> bearing_state(const Model& model,
                                             const bearing::OperatingPoint& point,
                                             const bearing::BearingEquilibrium* equilibrium) {
  friction::BearingState<double> state;
  state.bearing = &model.bearing;
  state.equilibrium = equilibrium;
  state.race_control = model.solver.race_control;
  state.speed = point.speed;
  state.axial_load = point.axial_load;
  state.radial_load = std::hypot(point.radial_load, point.radial_load_z);
  state.temperature = point.temperature;
  state.kinematic_viscosity = model.lubricant.kinematic_viscosity(point.temperature);
  return state;
}

}  // namespace raceway::fit
