#include "model/row_predictor.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>
#include <utility>

#include "friction/contact/many_contacts.h"
#include "model/changed_bearing.h"
#include "model/corrected_data.h"
#include "model/tilted_equilibrium.h"

namespace raceway::model {
namespace {

using effects::Condition;
using effects::Effect;

constexpr std::size_t chunk = 256;        // rows that a thread takes
constexpr std::size_t most_balances = 4;  // a point, both sides of a difference, and one more

bool finite(const bearing::OperatingPoint& p) {
  return std::isfinite(p.speed) && std::isfinite(p.axial_load) && std::isfinite(p.radial_load) &&
         std::isfinite(p.radial_load_z) && std::isfinite(p.moment_y) && std::isfinite(p.moment_z) &&
         std::isfinite(p.temperature);
}

/// An angular contact bearing cannot be pulled: the extra load ends where the entered one is gone.
double with_extra(double axial_load, double extra) {
  return std::copysign(std::max(std::abs(axial_load) + extra, 0.0), axial_load);
}

/// True if somebody has tried to solve it.
bool known_report(const bearing::SolveReport& report) {
  return report.status != bearing::SolveStatus::not_run &&
         report.status != bearing::SolveStatus::not_finite;
}

}  // namespace

RowPredictor::RowPredictor(const Model& model, const Steps& steps,
                           const bearing::OperatingPoint& point, const effects::Record& record,
                           Balance known, const Condition& given,
                           std::shared_ptr<const bearing::Bearing> bearing, Rollers rollers)
    : point_(point),
      record_(record),
      given_(given),
      radial_load_(std::hypot(point.radial_load, point.radial_load_z)),
      temperature_(point.temperature),
      viscosity_(model.lubricant.kinematic_viscosity(point.temperature)),
      rollers_(std::move(rollers)) {
  units_.assign(steps.moment.size(), unset);
  if (rollers_) report_ = rollers_->report;
  if (!known) return;
  condition_ = given;
  correct(model, steps);
  turning_ = ball_turning(model, oil(model), temperature_);
  bearing_ = std::move(bearing);
  report_ = known->report;
  if (given == Condition{} && !bearing_) {
    entered_ = known;
    entered_turning_ = turning_;
  }
  equilibrium_ = std::move(known);
  remember();
}

void RowPredictor::correct(const Model& model, const Steps& steps) {
  if (steps.entry.empty()) return;
  effects::Entry entry = entry_of(model, point_.temperature);
  for (const std::size_t k : steps.entry)
    model.effects[k].description->entry(entry, model.effects[k].values);
  temperature_ = entry.temperature;
  oil_.emplace(entry.viscosity_40C, entry.viscosity_100C);
  viscosity_ = oil_->kinematic_viscosity(temperature_);
}

friction::BearingState<double> RowPredictor::state(const Model& model) const {
  return {.bearing = model.bearing.ball_bearing(),
          .equilibrium = equilibrium_.get(),
          .race_control = model.solver.race_control,
          .f1_load = model.f1_load,
          .lubricant = &oil(model),
          .contact = &model.contact,
          .table = model.table.get(),
          .speed = point_.speed,
          .axial_load = with_extra(point_.axial_load, condition_.extra_axial_load),
          .radial_load = radial_load_,
          .temperature = temperature_,
          .kinematic_viscosity = film_.kinematic_viscosity,
          .rollers = model.bearing.rollers(),
          .roller_equilibrium = rollers_.get()};
}

/// Power of the base law at the entered load, where an effect looks at it [W]; a law of the
/// contacts gets the balls of that load first.
double RowPredictor::entered_power(const Model& model, const Steps& steps,
                                   friction::BearingState<double> entered) {
  if (!uses_power(model, steps)) return unset;
  if (model.law != friction::FrictionLaw::contact)
    return model::entered_power(model, entered, point_);
  const BallTurning turning = ball_turning(model, oil(model), temperature_);
  if (!entered_ || turning != entered_turning_) {
    bearing::OperatingPoint point = point_;
    point.temperature = temperature_;
    entered_ = std::make_shared<const bearing::BearingEquilibrium>(
        solve_balls(model, model.bearing, point, model.solver, oil(model)));
    entered_turning_ = turning;
  }
  entered.equilibrium = entered_.get();
  const friction::BaseMoments<double> base =
      known_contacts_.at(entered_, entered, model.law_values).moments();
  return (base.load + base.viscous) * point_.speed;
}

bool RowPredictor::find_condition(const Model& model, const Steps& steps, Condition& condition) {
  if (!finite(point_) || !std::isfinite(viscosity_)) return false;
  friction::BearingState<double> entered = state(model);
  entered.equilibrium = nullptr;
  entered.axial_load = with_extra(point_.axial_load, 0.0);
  entered.kinematic_viscosity = viscosity_;
  condition = condition_of(model, steps, entered, point_, record_, given_,
                           entered_power(model, steps, entered));
  return condition.finite();
}

std::optional<bearing::BearingCase> RowPredictor::question(const Model& model) {
  bearing_ = nullptr;
  equilibrium_ = nullptr;
  report_ = {};
  if (condition_.changes_bearing()) {
    bearing_ = changed_bearing(model.bearing, condition_);
    if (!bearing_) {
      report_.status = bearing::SolveStatus::no_equilibrium;
      return {};
    }
  }
  bearing::BearingCase asked{bearing_ ? bearing_.get() : model.bearing.ball_bearing(), point_};
  asked.point.axial_load = with_extra(point_.axial_load, condition_.extra_axial_load);
  asked.point.temperature = temperature_;
  return asked;
}

void RowPredictor::solve(const Model& model) {
  // Started from the row's own last balance.
  const Balance last = equilibrium_;
  const bearing::BearingEquilibrium* start =
      last && last->report.converged() ? last.get() : nullptr;
  const auto asked = question(model);
  if (condition_.tilt == 0.0) held_ = {};
  if (!asked) return;
  equilibrium_ = std::make_shared<const bearing::BearingEquilibrium>(
      condition_.tilt != 0.0
          ? solve_tilted(model, *asked->bearing, asked->point, condition_.tilt, oil(model), start,
                         held_)
          : solve_balls(model, *asked->bearing, asked->point, model.solver, oil(model), start));
  report_ = equilibrium_->report;
  remember();
}

/// The rollers at the load as entered, on which no effect acts.
void RowPredictor::solve_rollers(const Model& model) {
  if (rollers_) return;
  rollers_ = std::make_shared<const bearing::RollerEquilibrium>(
      solve_roller_bearing(*model.bearing.rollers(), point_, {.tilt = model.solver.tilt}));
  report_ = rollers_->report;
}

/// Takes up what was solved under that condition, if it is known.
bool RowPredictor::recall(const Model& model, const Condition& condition) {
  const BallTurning turning = ball_turning(model, oil(model), temperature_);
  if (condition == condition_ && turning == turning_ && known_report(report_)) return true;
  const auto known = std::find_if(
      known_balances_.begin(), known_balances_.end(),
      [&](const KnownBalance& b) { return b.condition == condition && b.turning == turning; });
  condition_ = condition;
  turning_ = turning;
  if (known == known_balances_.end()) return false;
  bearing_ = known->bearing;
  equilibrium_ = known->balls;
  report_ = known->report;
  held_ = known->held;
  return true;
}

void RowPredictor::remember() {
  if (known_balances_.size() == most_balances) known_balances_.pop_back();
  known_balances_.insert(known_balances_.begin(),
                         {condition_, turning_, bearing_, equilibrium_, report_, held_});
}

std::optional<bearing::BearingCase> RowPredictor::ask(const Model& model, const Steps& steps) {
  Condition condition;
  correct(model, steps);
  if (model.balanced_balls || !steps.equilibrium || !find_condition(model, steps, condition) ||
      condition.tilt != 0.0)
    return {};
  if (recall(model, condition)) return {};
  return question(model);
}

void RowPredictor::answer(bearing::BearingEquilibrium&& equilibrium) {
  report_ = equilibrium.report;
  held_ = {};
  equilibrium_ = std::make_shared<const bearing::BearingEquilibrium>(std::move(equilibrium));
  remember();
}

void RowPredictor::balance(const Model& model, const Steps& steps) {
  correct(model, steps);
  (void)find_balance(model, steps);
}

bool RowPredictor::find_balance(const Model& model, const Steps& steps) {
  Condition condition;
  if (!find_condition(model, steps, condition)) {
    report_.status = bearing::SolveStatus::not_finite;
    return false;
  }
  if (model.bearing.rollers()) {
    if (steps.equilibrium) solve_rollers(model);
    return true;
  }
  if (!recall(model, condition) && steps.equilibrium) solve(model);
  return true;
}

/// A film that warms itself, where the row knows its contacts from before.
bool RowPredictor::warm_by_tangents(const Model& model, const Effect& effect,
                                    const effects::LubricantInputs& in) {
  if (model.law != friction::FrictionLaw::contact || !predicted_ ||
      !effect.description->lubricant_by_tangents)
    return false;
  friction::BearingState<double> about = in.state;
  const auto tangent_about = [&](double temperature) {
    about.temperature = temperature;
    return known_contacts_.tangent(equilibrium_, about, model.law_values);
  };
  return effect.description->lubricant_by_tangents(
      in, effect.values, known_contacts_.last_temperature(), std::ref(tangent_about), film_);
}

void RowPredictor::find_film(const Model& model, const Steps& steps,
                             friction::BearingState<double>& s) {
  film_ = {.kinematic_viscosity = viscosity_, .temperature = temperature_};
  s.kinematic_viscosity = viscosity_;
  const effects::BaseLaw law{model.law, model.law_values};
  const effects::LubricantInputs inputs{.lubricant = oil(model), .state = s, .base = law};
  for (const std::size_t k : steps.lubricant)
    if (!warm_by_tangents(model, model.effects[k], inputs))
      model.effects[k].description->lubricant(inputs, model.effects[k].values, film_);
  s.kinematic_viscosity = film_.kinematic_viscosity;
}

void RowPredictor::find_base(const Model& model, friction::BearingState<double> s) {
  s.temperature = film_.temperature;
  if (model.law == friction::FrictionLaw::contact) {
    contacts_ = known_contacts_.at(equilibrium_, s, model.law_values);
    contacts_->thin(film_.viscous_share);
    base_ = contacts_->moments();
    return;
  }
  base_ = effects::BaseLaw{model.law, model.law_values}.moments(s);
  base_.viscous *= film_.viscous_share;
}

void RowPredictor::add_moments(const Model& model, const Steps& steps, Stage from,
                               const friction::BearingState<double>& s) {
  const effects::MomentInputs inputs{.state = s, .base = base_, .record = record_};
  torque_ = base_.load + base_.viscous;
  for (std::size_t m = 0; m < steps.moment.size(); ++m) {
    const Effect& effect = model.effects[steps.moment[m]];
    const double share = share_of_bearing(*effect.description, model.rig);
    if (!effect.description->unit_moment) {
      torque_ += share * effect.moment(inputs);
      continue;
    }
    if (from <= Stage::lubricant) units_[m] = share * effect.description->unit_moment(inputs);
    torque_ += effect.values[0] * units_[m];
  }
}

void RowPredictor::read(const Model& model, const Steps& steps) {
  const double rig = rig_torque(model.rig, torque_);
  reading_ = rig;
  const effects::ReadingInputs inputs{.value = rig, .point = point_, .record = record_};
  for (const std::size_t k : steps.reading)
    reading_ += model.effects[k].description->reading(inputs, model.effects[k].values);
}

double RowPredictor::predict(const Model& model, const Steps& steps, Stage from) {
  // Where there was no prediction, nothing is known to start from.
  if (!std::isfinite(reading_)) from = Stage::entry;
  if (from <= Stage::moment) torque_ = unset;
  reading_ = unset;
  if (from == Stage::entry) correct(model, steps);
  if (from <= Stage::base) {
    base_ = {unset, unset};
    contacts_.reset();
  }
  if (from <= Stage::condition && !find_balance(model, steps)) return reading_;
  if (steps.needs_balls && !report_.converged()) return reading_;

  friction::BearingState<double> s = state(model);
  // Formulas look at the bearing as entered, contacts at the one that there is.
  if (bearing_ && model.law == friction::FrictionLaw::contact) s.bearing = bearing_.get();
  if (from <= Stage::lubricant) find_film(model, steps, s);
  if (from <= Stage::base) find_base(model, s);
  if (from <= Stage::moment) {
    // Laws of ball loads look at the bearing as it is, base laws at the one entered.
    if (bearing_) s.bearing = bearing_.get();
    add_moments(model, steps, from, s);
  }
  read(model, steps);
  predicted_ = true;
  return reading_;
}

std::optional<friction::BearingState<double>> RowPredictor::ask_contacts(const Model& model,
                                                                         const Steps& steps) {
  // What the condition makes of a bearing, or an effect of its film, is this row's own.
  if (model.law != friction::FrictionLaw::contact || model.balanced_balls ||
      !steps.lubricant.empty())
    return {};
  correct(model, steps);
  if (!find_balance(model, steps) || !report_.converged() || bearing_) return {};
  friction::BearingState<double> s = state(model);
  find_film(model, steps, s);
  return s;
}

void RowPredictor::answer_contacts(const Model& model,
                                   const friction::contact::ContactResult& contacts) {
  friction::BearingState<double> s = state(model);
  s.temperature = film_.temperature;
  known_contacts_.know(equilibrium_, s, model.law_values, contacts);
}

FrictionPrediction RowPredictor::prediction(const Model& model) const {
  FrictionPrediction p;
  p.condition = condition_;
  p.bearing = bearing_;
  if (report_.converged()) p.equilibrium = equilibrium_;
  p.rollers = rollers_;
  p.report = report_;
  p.effects.assign(model.effects.size(), unset);
  // With base moments it is an effect that has no number.
  if (std::isnan(reading_) && std::isnan(torque_) && std::isnan(base_.load)) {
    if (report_.status == bearing::SolveStatus::not_run)
      p.report.status = bearing::SolveStatus::not_finite;
    return p;
  }
  p.load = base_.load;
  p.viscous = base_.viscous;
  p.contacts = contacts_;
  p.torque = torque_;
  p.power_loss = torque_ * point_.speed;
  p.reading = reading_;
  p.film = film_;
  friction::BearingState<double> s = state(model);
  if (bearing_) s.bearing = bearing_.get();
  const effects::MomentInputs inputs{.state = s, .base = base_, .record = record_};
  for (std::size_t k = 0; k < model.effects.size(); ++k)
    p.effects[k] = share_of_bearing(*model.effects[k].description, model.rig) *
                   model.effects[k].moment(inputs);
  return p;
}

void solve_balances(const Model& model, const Steps& steps, std::span<RowPredictor> rows) {
  if (!steps.equilibrium) return;
  if (model.balanced_balls || model.bearing.rollers())
    return tbb::parallel_for(std::size_t{0}, rows.size(),
                             [&](std::size_t i) { rows[i].balance(model, steps); });
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

void solve_contacts(const Model& model, const Steps& steps, std::span<RowPredictor> rows) {
  if (model.law != friction::FrictionLaw::contact) return;
  std::vector<friction::BearingState<double>> asked;
  std::vector<std::size_t> asking;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const auto state = rows[i].ask_contacts(model, steps)) {
      asked.push_back(*state);
      asking.push_back(i);
    }
  if (asked.empty()) return;
  std::vector<friction::contact::ContactResult> found(asked.size());
  contact_results(asked, model.law_values, found);
  for (std::size_t n = 0; n < asked.size(); ++n) rows[asking[n]].answer_contacts(model, found[n]);
}

void predict_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows,
                 std::span<double> readings, Stage from) {
  if (from <= Stage::condition) solve_balances(model, steps, rows);
  const auto predict = [&](std::size_t k) {
    const std::size_t end = std::min((k + 1) * chunk, rows.size());
    for (std::size_t i = k * chunk; i < end; ++i) readings[i] = rows[i].predict(model, steps, from);
  };
  if (rows.size() <= chunk) return predict(0);
  tbb::parallel_for(std::size_t{0}, (rows.size() + chunk - 1) / chunk, predict);
}

namespace {

/// What `of` says of a row for each of the points, in balance as entered.
template <typename Of>
auto entered(const Model& model, std::span<const bearing::OperatingPoint> points, const Of& of) {
  Model plain = model;
  plain.effects.clear();
  const Steps steps(plain, true);
  std::vector<RowPredictor> rows;
  rows.reserve(points.size());
  for (const bearing::OperatingPoint& point : points)
    rows.emplace_back(plain, steps, point, effects::Record{});
  solve_balances(plain, steps, rows);
  std::vector<std::decay_t<decltype(of(rows.front()))>> balances;
  balances.reserve(rows.size());
  for (const RowPredictor& row : rows) balances.push_back(of(row));
  return balances;
}

}  // namespace

std::vector<Balance> entered_balances(const Model& model,
                                      std::span<const bearing::OperatingPoint> points) {
  return entered(model, points, [](const RowPredictor& row) { return row.equilibrium(); });
}

std::vector<RowPredictor::Rollers> entered_rollers(
    const Model& model, std::span<const bearing::OperatingPoint> points) {
  return entered(model, points, [](const RowPredictor& row) { return row.rollers(); });
}

}  // namespace raceway::model
