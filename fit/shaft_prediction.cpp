#include "fit/shaft_prediction.h"

#include <cmath>
#include <stdexcept>

#include "fit/heat_split.h"

namespace raceway::fit {

namespace {

using bearing::Arrangement;
using bearing::ArrangementCondition;
using bearing::ArrangementEquilibrium;
using bearing::Bearing;

double given(double value, double fallback) { return std::isnan(value) ? fallback : value; }

/// Radial growth that changes the free contact angle as much as a shift does [m].
double equal_growth(const Bearing& b, const bearing::RingShift& s) {
  const double distance = b.geometry().groove_centre_distance();
  const double radial = distance * std::cos(b.geometry().contact_angle);
  const double length = distance + s.inner_length + s.outer_length;
  return (radial + s.radial) * distance / length - radial;
}

/// The models of the single bearings of a shaft, and what it takes to balance them.
class ShaftModels {
 public:
  explicit ShaftModels(const Model& model) : model_(model), arrangement_(shaft(model).arrangement) {
    const auto mounted = arrangement_.bearings();
    const ArrangementCondition heated = shaft_condition(model, {});
    for (std::size_t i = 0; i < mounted.size(); ++i) {
      Model one = model;
      one.shaft.reset();
      one.bearing = *mounted[i].bearing;
      if (!heated.shifts.empty()) {
        // Friction is predicted for the load in the set; the free contact angle is that of there.
        const auto warm = changed_bearing(
            one.bearing, {.radial_growth = equal_growth(one.bearing, heated.shifts[i])});
        if (warm) one.bearing = *warm;
      }
      models_.push_back(std::move(one));
    }
    if (const auto& t = model.shaft->temperatures)
      record_ = {.inner_ring_temperature = t->inner_ring, .outer_ring_temperature = t->outer_ring};
    for (const effects::Effect& e : model.effects)
      conditioned_ = conditioned_ || e.description->condition;
  }

  [[nodiscard]] ShaftPrediction predict(const ShaftPoint& point,
                                        const ArrangementEquilibrium* neighbour) {
    ShaftPrediction p = balance(point, neighbour);
    if (!p.equilibrium.report.converged()) return p;
    p.torque = 0.0;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      add_friction(i, point, p);
      p.torque += p.friction[i].torque;
    }
    p.power_loss = p.torque * point.speed;
    return p;
  }

  /// The position alone, without friction.
  [[nodiscard]] ShaftPrediction balance(const ShaftPoint& point,
                                        const ArrangementEquilibrium* neighbour) {
    ShaftPrediction p;
    ArrangementCondition condition = shaft_condition(model_, point);
    if (conditioned_ && !add_effects(point, condition)) {
      p.equilibrium.report.status = bearing::SolveStatus::no_equilibrium;
      return p;
    }
    p.equilibrium = solve_arrangement(arrangement_, condition, model_.solver, neighbour);
    if (p.equilibrium.report.converged())
      p.displacement = p.equilibrium.position - standstill(point.external_load);
    return p;
  }

 private:
  static const Shaft& shaft(const Model& model) {
    if (!model.shaft) throw std::invalid_argument("the model has no shaft");
    return *model.shaft;
  }

  /// Position at standstill under this load, as mounted; NaN where the load takes the sets apart.
  double standstill(double external_load) {
    if (external_load == 0.0) return 0.0;
    if (external_load != standstill_load_) {
      standstill_load_ = external_load;
      standstill_ =
          solve_arrangement(arrangement_, {.external_load = external_load}, model_.solver).position;
    }
    return standstill_;
  }

  /// What the effects change of the condition of every bearing. False where no bearing is left.
  bool add_effects(const ShaftPoint& point, ArrangementCondition& condition) {
    condition.shifts.resize(models_.size());
    std::vector<double> other_balls(models_.size());
    for (std::size_t i = 0; i < models_.size(); ++i) {
      const bool front = i < model_.shaft->arrangement.front_count();
      const auto count = front ? model_.shaft->arrangement.front_count()
                               : models_.size() - model_.shaft->arrangement.front_count();
      const FrictionPrediction entered = predict_friction(
          models_[i],
          {.speed = point.speed,
           .axial_load = model_.shaft->arrangement.preload() / static_cast<double>(count),
           .temperature = point.temperature},
          false, record_);
      if (entered.report.status == bearing::SolveStatus::not_finite) return false;
      const effects::Condition& c = entered.condition;
      condition.shifts[i].radial += c.radial_growth;
      other_balls[i] = c.other_balls;
    }
    return other_balls == other_balls_ || replace_balls(other_balls);
  }

  bool replace_balls(const std::vector<double>& shares) {
    bearing::ArrangementDesign design = model_.shaft->arrangement.design();
    std::size_t i = 0;
    for (auto* set : {&design.front, &design.rear})
      for (bearing::MountedBearing& m : *set) {
        m.bearing = changed_bearing(*m.bearing, {.other_balls = shares[i++]});
        if (!m.bearing) return false;
      }
    arrangement_ = Arrangement(std::move(design));
    other_balls_ = shares;
    standstill_load_ = unset;
    return true;
  }

  void add_friction(std::size_t i, const ShaftPoint& point, ShaftPrediction& p) const {
    const bearing::BearingInSet& b = p.equilibrium.bearings[i];
    const bearing::OperatingPoint alone{
        .speed = point.speed, .axial_load = b.axial_load, .temperature = point.temperature};
    p.friction.push_back(predict_friction(models_[i], alone, !b.lost(), record_));
    const FrictionPrediction& friction = p.friction.back();
    const bool balanced = friction.equilibrium && friction.report.converged();
    p.heat.push_back(balanced ? heat_split(models_[i], alone, *friction.equilibrium, friction)
                              : friction::HeatSplit());
  }

  const Model& model_;
  Arrangement arrangement_;
  std::vector<Model> models_;
  effects::Record record_;
  std::vector<double> other_balls_;
  bool conditioned_ = false;
  double standstill_load_ = unset, standstill_ = unset;
};

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Whether one arrangement at one temperature serves both rows.
bool same_setting(const Row& a, const Row& b) {
  return same(a.preload, b.preload) && same(a.inner_ring_temperature, b.inner_ring_temperature) &&
         same(a.outer_ring_temperature, b.outer_ring_temperature);
}

std::optional<bearing::SetTemperatures> temperatures_of(const Shaft& shaft, const Row& row) {
  if (std::isnan(row.inner_ring_temperature) && std::isnan(row.outer_ring_temperature))
    return shaft.temperatures;
  const double mounted = shaft.arrangement.design().mounting_temperature;
  bearing::SetTemperatures t = shaft.temperatures.value_or(bearing::SetTemperatures());
  t.inner_ring = given(row.inner_ring_temperature, given(t.inner_ring, mounted));
  t.outer_ring = given(row.outer_ring_temperature, given(t.outer_ring, mounted));
  t.shaft = given(t.shaft, t.inner_ring);
  t.housing = given(t.housing, t.outer_ring);
  return t;
}

/// The arrangement with another force of preload; nothing where there is none with that force.
std::optional<Arrangement> with_preload(const Arrangement& arrangement, double force) {
  bearing::ArrangementDesign design = arrangement.design();
  design.preload = bearing::PreloadForce{force};
  try {
    return Arrangement(std::move(design));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

ArrangementCondition shaft_condition(const Model& model, const ShaftPoint& point) {
  const Shaft& shaft = *model.shaft;
  ArrangementCondition condition{.speed = point.speed, .external_load = point.external_load};
  if (!shaft.temperatures) return condition;
  const double mounted = shaft.arrangement.design().mounting_temperature;
  bearing::SetTemperatures t = *shaft.temperatures;
  for (double* value : {&t.inner_ring, &t.outer_ring, &t.shaft, &t.housing})
    *value = given(*value, mounted);
  add_expansion(shaft.arrangement, t, condition);
  return condition;
}

std::vector<ShaftPrediction> predict_shaft(const Model& model, std::span<const ShaftPoint> points) {
  ShaftModels models(model);
  std::vector<ShaftPrediction> predictions;
  predictions.reserve(points.size());
  const ArrangementEquilibrium* neighbour = nullptr;
  for (const ShaftPoint& point : points) {
    predictions.push_back(models.predict(point, neighbour));
    if (predictions.back().equilibrium.report.converged())
      neighbour = &predictions.back().equilibrium;
  }
  return predictions;
}

std::vector<double> predict_displacement(const Model& model, std::span<const Row> rows) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
  std::vector<double> displacements(rows.size(), unset);
  Model set = model;
  double preload = unset;  // of the rows, that `set` has now; NaN: that of the model
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    while (end < rows.size() && same_setting(rows[first], rows[end])) ++end;
    if (!same(rows[first].preload, preload)) {
      const auto other = std::isnan(rows[first].preload)
                             ? model.shaft->arrangement
                             : with_preload(model.shaft->arrangement, rows[first].preload);
      if (!other) continue;
      set.shaft->arrangement = *other;
      preload = rows[first].preload;
    }
    set.shaft->temperatures = temperatures_of(*model.shaft, rows[first]);
    ShaftModels models(set);
    ArrangementEquilibrium last;
    for (std::size_t i = first; i < end; ++i) {
      ShaftPrediction p = models.balance({.speed = rows[i].point.speed,
                                          .external_load = rows[i].point.axial_load,
                                          .temperature = rows[i].point.temperature},
                                         last.report.converged() ? &last : nullptr);
      displacements[i] = p.displacement;
      if (p.equilibrium.report.converged()) last = std::move(p.equilibrium);
    }
  }
  return displacements;
}

std::vector<double> predict_readings(const Model& model, const DataSet& data) {
  require_measured_subject(model, data);
  if (model.shaft) return predict_displacement(model, data.rows);
  std::vector<double> readings;
  readings.reserve(data.rows.size());
  for (const FrictionPrediction& p : predict_rows(model, data)) readings.push_back(p.reading);
  return readings;
}

void require_measured_subject(const Model& model, const DataSet& data) {
  const bool torque = data.quantity == Quantity::friction_torque;
  if (model.shaft && torque)
    throw std::invalid_argument(
        data.source +
        ": holds friction torque, but the model has an [arrangement]: axial_displacement_um is "
        "needed, or a model of a single bearing on a rig");
  if (!model.shaft && !torque)
    throw std::invalid_argument(data.source +
                                ": holds axial displacement, which needs a model with an "
                                "[arrangement]; of a single bearing measured friction torque is "
                                "needed");
}

}  // namespace raceway::fit
