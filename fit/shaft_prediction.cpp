#include "fit/shaft_prediction.h"

#include <cmath>
#include <stdexcept>

#include "fit/heat_split.h"
#include "fit/shaft_balance.h"
#include "fit/shaft_response.h"

namespace raceway::fit {

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
    const Arrangement& arrangement = model.shaft->arrangement;
    for (const bearing::MountedBearing& m : arrangement.bearings()) {
      Model one = model;
      one.shaft.reset();
      one.bearing = *m.bearing;
      if (temperatures_) {
        // Friction is predicted for the load in the set; the free contact angle is that of there.
        const bearing::RingShift expansion =
            thermal_shift(one.bearing, *temperatures_, arrangement.design().mounting_temperature);
        const auto warm =
            changed_bearing(one.bearing, {.radial_growth = equal_growth(one.bearing, expansion)});
        if (warm) one.bearing = *warm;
      }
      models_.push_back(std::move(one));
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
    p.equilibrium =
        solve_arrangement(balance_.arrangement(), condition_.sets, model_.solver, neighbour);
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
    RowPredictor bearing(models_[i], friction_, alone, record_, nullptr, condition_.bearings[i]);
    (void)bearing.predict(models_[i], friction_);
    p.friction.push_back(bearing.prediction(models_[i]));
    const FrictionPrediction& friction = p.friction.back();
    const bool balanced = friction.equilibrium && friction.report.converged();
    p.heat.push_back(balanced ? heat_split(models_[i], alone, *friction.equilibrium, friction)
                              : friction::HeatSplit());
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
