#include "shaft/shaft_balance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/changed_bearing.h"

namespace raceway::shaft {
namespace {

using bearing::Arrangement;
using bearing::ArrangementDesign;
using bearing::MountedBearing;
using effects::Condition;

double given(double value, double fallback) { return std::isnan(value) ? fallback : value; }

double axial_distance(const bearing::Bearing& b) {
  return b.geometry().groove_centre_distance() * std::sin(b.geometry().contact_angle);
}

double furthest(const std::vector<MountedBearing>& set) {
  double offset = set.empty() ? 0.0 : set.front().offset;
  for (const MountedBearing& m : set) offset = std::max(offset, m.offset);
  return offset;
}

/// Puts balls and fits of the conditions into the bearings. The faces stay where they are: rings
/// that have lost contact angle are pressed further. False where no bearing is left.
bool change_bearings(const std::vector<Condition>& conditions, ArrangementDesign& design) {
  const double before = furthest(design.front) + furthest(design.rear);
  std::size_t i = 0;
  for (auto* set : {&design.front, &design.rear}) {
    const std::vector<MountedBearing> entered = *set;
    for (std::size_t k = 0; k < set->size(); ++k, ++i) {
      if (!conditions[i].changes_bearing()) continue;
      MountedBearing& m = (*set)[k];
      // Equal bearings stay one, so that the sets are solved once for them.
      if (k > 0 && entered[k].bearing == entered[k - 1].bearing &&
          conditions[i] == conditions[i - 1]) {
        m.bearing = (*set)[k - 1].bearing;
      } else {
        m.bearing = model::changed_bearing(*entered[k].bearing, conditions[i]);
      }
      if (!m.bearing) return false;
      m.offset += axial_distance(*entered[k].bearing) - axial_distance(*m.bearing);
    }
  }
  if (auto* offset = std::get_if<bearing::PreloadOffset>(&design.preload))
    offset->offset += furthest(design.front) + furthest(design.rear) - before;
  return true;
}

/// One bearing of the sets without balls in balance, as base laws look at it.
friction::BearingState<double> entered_state(const Model& model, const bearing::Bearing& bearing,
                                             const bearing::OperatingPoint& point) {
  friction::BearingState<double> state = model::bearing_state(model, point, nullptr);
  state.bearing = &bearing;
  return state;
}

}  // namespace

bool ShaftBalance::mount(const Model& model, const Steps& steps) {
  const Arrangement& entered = model.shaft->arrangement;
  ArrangementDesign design = entered.design();
  if (!std::isnan(preload_)) design.preload = bearing::PreloadForce{preload_};
  // At standstill, everything at the temperature of mounting.
  const bearing::OperatingPoint rest{
      .speed = 0.0, .axial_load = 0.0, .temperature = design.mounting_temperature};
  const effects::Record record{.time = 0.0,
                               .inner_ring_temperature = rest.temperature,
                               .outer_ring_temperature = rest.temperature};
  std::vector<Condition> mounted;
  mounted.reserve(entered.bearings().size());
  for (const MountedBearing& m : entered.bearings())
    mounted.push_back(
        condition_of(model, steps, entered_state(model, *m.bearing, rest), rest, record));
  if (auto* force = std::get_if<bearing::PreloadForce>(&design.preload))
    force->force *= 1.0 + mounted.front().preload_error;
  if (version_ > 0 && design == entered_ && mounted == at_rest_) return arrangement_.has_value();

  ++version_;
  entered_ = design;
  at_rest_ = std::move(mounted);
  arrangement_.reset();
  try {
    design.other_mounting += at_rest_.front().other_mounting;
    if (change_bearings(at_rest_, design)) arrangement_.emplace(std::move(design));
  } catch (const std::invalid_argument&) {  // no arrangement has these values
  }
  return arrangement_.has_value();
}

bool ShaftBalance::find_condition(const Model& model, const Steps& steps,
                                  const bearing::OperatingPoint& point,
                                  const effects::Record& record,
                                  const std::optional<bearing::SetTemperatures>& temperatures,
                                  ShaftCondition& condition) const {
  bearing::ArrangementCondition& sets = condition.sets;
  const std::size_t count = arrangement_->bearings().size();
  sets.speed = point.speed;
  sets.external_load = point.axial_load;
  sets.elongation = 0.0;
  sets.shifts.assign(temperatures || !steps.condition.empty() ? count : 0, {});
  if (temperatures) add_expansion(*arrangement_, *temperatures, sets);
  condition.bearings.assign(count, {});
  if (steps.condition.empty()) return true;
  // Effects look at the bearings as entered, under their share of the preload.
  const auto bearings = model.shaft->arrangement.bearings();
  const std::size_t front = arrangement_->front_count();
  for (std::size_t i = 0; i < count; ++i) {
    const bool like_last = i > 0 && i != front && bearings[i].bearing == bearings[i - 1].bearing;
    if (like_last) {
      condition.bearings[i] = condition.bearings[i - 1];
    } else {
      bearing::OperatingPoint alone = point;
      alone.axial_load =
          arrangement_->preload() / static_cast<double>(i < front ? front : count - front);
      condition.bearings[i] = condition_of(
          model, steps, entered_state(model, *bearings[i].bearing, alone), alone, record);
    }
    if (!condition.bearings[i].finite()) return false;
    sets.shifts[i].radial += condition.bearings[i].radial_growth - at_rest_[i].radial_growth;
  }
  return true;
}

double ShaftBalance::standstill(double external_load,
                                const bearing::EquilibriumOptions& options) const {
  if (external_load == 0.0) return 0.0;
  return solve_arrangement(*arrangement_, {.external_load = external_load}, options).position;
}

bearing::Arrangement mounted_arrangement(const Model& model) {
  ShaftBalance balance;
  return balance.mount(model, Steps(model)) ? balance.arrangement() : model.shaft->arrangement;
}

std::optional<bearing::SetTemperatures> set_temperatures(const Shaft& shaft, double inner_ring,
                                                         double outer_ring) {
  const bool measured = !std::isnan(inner_ring) || !std::isnan(outer_ring);
  if (!measured && !shaft.temperatures) return std::nullopt;
  const double mounted = shaft.arrangement.design().mounting_temperature;
  bearing::SetTemperatures t = shaft.temperatures.value_or(bearing::SetTemperatures());
  t.inner_ring = given(inner_ring, given(t.inner_ring, mounted));
  t.outer_ring = given(outer_ring, given(t.outer_ring, mounted));
  t.shaft = given(t.shaft, measured ? t.inner_ring : mounted);
  t.housing = given(t.housing, measured ? t.outer_ring : mounted);
  return t;
}

}  // namespace raceway::shaft
