#include "shaft/shaft_prediction.h"

#include <algorithm>
#include <cmath>

#include "model/balance.h"
#include "model/heat_split.h"
#include "shaft/set_friction.h"
#include "shaft/shaft_balance.h"

namespace raceway::shaft {
namespace {

using bearing::ArrangementEquilibrium;

/// The bearings of a shaft, and what it takes to balance them.
class ShaftModels {
 public:
  explicit ShaftModels(const Model& model)
      : model_(model),
        steps_(model),
        bearings_(model),
        friction_(bearings_.steps()),
        temperatures_(set_temperatures(*model.shaft)) {
    if (temperatures_)
      record_ = {.inner_ring_temperature = temperatures_->inner_ring,
                 .outer_ring_temperature = temperatures_->outer_ring};
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
    for (std::size_t i = 0; i < bearings_.bearings(); ++i) {
      add_friction(i, point, p);
      p.torque += p.friction[i].torque;
    }
    p.power_loss = p.torque * point.speed;
    return p;
  }

 private:
  double standstill(double external_load) {
    if (external_load != standstill_load_) {
      standstill_load_ = external_load;
      standstill_ = balance_.standstill(external_load, model_.solver);
    }
    return standstill_;
  }

  void add_friction(std::size_t i, const ShaftPoint& point, ShaftPrediction& p) {
    const bearing::BearingInSet& b = p.equilibrium.bearings[i];
    friction_.equilibrium = friction_.needs_balls || !b.lost();
    model::RowPredictor row = bearings_.row(i,
                                            {.mounted = balance_.arrangement(),
                                             .equilibrium = p.equilibrium,
                                             .bearings = condition_.bearings,
                                             .temperatures = temperatures_,
                                             .speed = point.speed,
                                             .temperature = point.temperature,
                                             .record = record_},
                                            friction_);
    const Model& alone = bearings_.model(i);
    (void)row.predict(alone, friction_);
    p.friction.push_back(row.prediction(alone));
    model::FrictionPrediction& friction = p.friction.back();
    friction.condition = condition_.bearings[i];
    const bool balanced = friction.equilibrium && friction.report.converged();
    const bearing::OperatingPoint at{
        .speed = point.speed, .axial_load = b.axial_load, .temperature = point.temperature};
    p.heat.push_back(balanced ? heat_split(alone, at, friction) : friction::HeatSplit());
  }

  const Model& model_;
  Steps steps_;
  SetFriction bearings_;
  Steps friction_;
  std::optional<bearing::SetTemperatures> temperatures_;
  effects::Record record_;
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
