#include "shaft/shaft_prediction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "model/balance.h"
#include "model/heat_split.h"
#include "model/row_predictor.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {
namespace {

using bearing::Arrangement;
using bearing::ArrangementEquilibrium;
using bearing::Bearing;

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
  explicit ShaftModels(const Model& model)
      : model_(model),
        steps_(model),
        friction_(model),
        temperatures_(set_temperatures(shaft(model))) {
    friction_.condition.clear();  // the balance of the sets finds the conditions
    if (temperatures_)
      record_ = {.inner_ring_temperature = temperatures_->inner_ring,
                 .outer_ring_temperature = temperatures_->outer_ring};
    for (const bearing::MountedBearing& m : model.shaft->arrangement.bearings()) {
      models_.push_back(model);
      models_.back().shaft.reset();
      models_.back().bearing = *m.bearing;
    }
    (void)balance_.mount(model, steps_);
  }

  [[nodiscard]] ShaftPrediction predict(const ShaftPoint& point,
                                        const ArrangementEquilibrium* neighbour) {
    ShaftPrediction p;
    const bearing::OperatingPoint asked{
        .speed = point.speed, .axial_load = point.external_load, .temperature = point.temperature};
    if (!balance_.mounted()) {
      p.equilibrium.report.status = bearing::SolveStatus::no_equilibrium;
      return p;
    }
    if (!balance_.find_condition(model_, steps_, asked, record_, temperatures_, condition_)) {
      p.equilibrium.report.status = bearing::SolveStatus::not_finite;  // an effect lacks its input
      return p;
    }
    p.equilibrium = solve_sets(model_, balance_.arrangement(), condition_.sets,
                               {&point.temperature, 1}, neighbour);
    if (!p.equilibrium.report.converged()) return p;
    p.displacement = p.equilibrium.position - standstill(point.external_load);
    p.torque = 0.0;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      add_friction(i, point, p);
      p.torque += p.friction[i].torque;
    }
    p.power_loss = p.torque * point.speed;
    return p;
  }

 private:
  static const Shaft& shaft(const Model& model) {
    if (!model.shaft) throw std::invalid_argument("the model has no shaft");
    return *model.shaft;
  }

  double standstill(double external_load) {
    if (external_load != standstill_load_) {
      standstill_load_ = external_load;
      standstill_ = balance_.standstill(external_load, model_.solver);
    }
    return standstill_;
  }

  void add_friction(std::size_t i, const ShaftPoint& point, ShaftPrediction& p) {
    const bearing::BearingInSet& b = p.equilibrium.bearings[i];
    const bearing::OperatingPoint alone{
        .speed = point.speed, .axial_load = b.axial_load, .temperature = point.temperature};
    friction_.equilibrium = friction_.needs_balls || !b.lost();
    p.friction.push_back(condition_.bearings[i].tilt == 0.0 ? in_the_set(i, alone, p.equilibrium)
                                                            : tilted(i, alone));
    const model::FrictionPrediction& friction = p.friction.back();
    const bool balanced = friction.equilibrium && friction.report.converged();
    p.heat.push_back(balanced ? heat_split(models_[i], alone, friction) : friction::HeatSplit());
  }

  /// Friction of the balls as they stand in the set.
  [[nodiscard]] model::FrictionPrediction in_the_set(std::size_t i,
                                                     const bearing::OperatingPoint& alone,
                                                     const ArrangementEquilibrium& sets) const {
    model::Balance balls;
    if (friction_.equilibrium)
      balls = std::make_shared<const bearing::BearingEquilibrium>(
          sets.bearing(i, balance_.arrangement()));
    const auto& mounted = balance_.arrangement().bearings()[i].bearing;
    const bool as_entered = mounted == model_.shaft->arrangement.bearings()[i].bearing;
    model::RowPredictor row(models_[i], friction_, alone, record_, std::move(balls),
                            condition_.bearings[i], as_entered ? nullptr : mounted);
    (void)row.predict(models_[i], friction_);
    return row.prediction(models_[i]);
  }

  /// Friction of a bearing solved by itself, since a set has no tilt.
  [[nodiscard]] model::FrictionPrediction tilted(std::size_t i,
                                                 const bearing::OperatingPoint& alone) const {
    effects::Condition condition = condition_.bearings[i];
    if (temperatures_)
      condition.radial_growth +=
          equal_growth(models_[i].bearing,
                       thermal_shift(models_[i].bearing, *temperatures_,
                                     model_.shaft->arrangement.design().mounting_temperature));
    model::RowPredictor row(models_[i], friction_, alone, record_, nullptr, condition);
    (void)row.predict(models_[i], friction_);
    model::FrictionPrediction prediction = row.prediction(models_[i]);
    prediction.condition = condition_.bearings[i];
    return prediction;
  }

  const Model& model_;
  Steps steps_, friction_;
  std::optional<bearing::SetTemperatures> temperatures_;
  effects::Record record_;
  std::vector<Model> models_;
  ShaftBalance balance_;
  ShaftCondition condition_;
  double standstill_load_ = 0.0, standstill_ = 0.0;
};

}  // namespace

bearing::SolveStatus ShaftPrediction::status() const {
  if (!equilibrium.report.converged()) return equilibrium.report.status;
  const bool all =
      std::isfinite(displacement) && std::isfinite(torque) && std::isfinite(power_loss) &&
      std::all_of(friction.begin(), friction.end(), [](const model::FrictionPrediction& f) {
        return f.status() == bearing::SolveStatus::converged;
      });
  return all ? bearing::SolveStatus::converged : bearing::SolveStatus::not_finite;
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

}  // namespace raceway::shaft
