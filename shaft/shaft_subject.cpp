#include "shaft/shaft_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fit/grid.h"
#include "model/own_data.h"
#include "shaft/displacement_rows.h"

namespace raceway::shaft {
namespace {

// Most of the noise of a displacement is that of the sensor whatever it reads.
constexpr double displacement_floor = 1.0;

constexpr std::string_view inspection_sheet =
    "contact angle and groove radii of the bearings, from their inspection sheet";

/// Displacement at the rows of a record [m].
class ShaftPredictor : public fit::Predictor {
 public:
  ShaftPredictor(const Model& model, const fit::Record& record,
                 std::vector<model::ParameterPlace> places)
      : model_(model), rows_(model_, record), places_(std::move(places)) {}

  void readings(std::span<const double> values, std::span<double> out) override {
    try {
      for (std::size_t k = 0; k < places_.size(); ++k) places_[k].set(model_, values[k]);
      rows_.predict(model_, out);
    } catch (const std::invalid_argument&) {
      if (places_.empty()) throw;  // it is the model as it is that cannot be
      std::fill(out.begin(), out.end(), unset);
    }
  }

 private:
  Model model_;
  DisplacementRows rows_;
  std::vector<model::ParameterPlace> places_;
};

/// Lowest and highest value; not finite where there is none.
std::pair<double, double> range_of(std::span<const double> values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values) {
    low = std::fmin(low, v);
    high = std::fmax(high, v);
  }
  return {low, high};
}

}  // namespace

ShaftSubject::ShaftSubject(const model::Model& model) : ModelSubject(model) {
  if (!model.shaft) throw std::invalid_argument("the model has no shaft");
}

ShaftSubject::ShaftSubject(const model::Model& model, std::vector<std::string> waiting)
    : ModelSubject(model, std::move(waiting)) {}

std::unique_ptr<model::ModelSubject> ShaftSubject::make(model::Model model,
                                                        std::vector<std::string> waiting) const {
  return std::unique_ptr<ModelSubject>(new ShaftSubject(model, std::move(waiting)));
}

std::vector<fit::Measured> ShaftSubject::measured() const {
  return {with_tolerance({.channel = &record::axial_displacement, .floor = displacement_floor})};
}

void ShaftSubject::require(const fit::Record& record) const {
  if (!record.has(record::axial_displacement))
    throw std::invalid_argument(record.source + ": has no column of axial displacement");
}

std::unique_ptr<fit::Predictor> ShaftSubject::predictor(const fit::Record& record,
                                                        const std::vector<std::string>& names,
                                                        const std::shared_ptr<const void>&) const {
  return std::make_unique<ShaftPredictor>(active(), record, places(names));
}

fit::Saturation ShaftSubject::saturation(const fit::Record& record) const {
  fit::Saturation s = ModelSubject::saturation(record);
  s.levels.clear();
  for (const record::Channel* channel : {&record::speed, &record::axial_load, &record::preload})
    if (record.complete(*channel)) s.levels.push_back(channel);
  s.levels_before_candidates = false;
  s.proportional = false;
  return s;
}

std::vector<fit::Factor> ShaftSubject::factors(const fit::Record& record) const {
  std::vector<fit::Factor> list{{"speed", {}}, {"preload", {}}, {"viscosity", {}}};
  for (const model::Row& row : model::rows_of(record)) {
    list[0].values.push_back(row.point.speed);
    list[1].values.push_back(std::isfinite(row.preload) ? row.preload : 0.0);
    list[2].values.push_back(model().lubricant.kinematic_viscosity(row.point.temperature));
  }
  return list;
}

std::string ShaftSubject::doubt(const fit::Record& record,
                                std::span<const double> predicted) const {
  const std::span<const double> measured = record.values(record::axial_displacement);
  double product = 0.0, square = 0.0, readings = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!std::isfinite(predicted[i]) || !std::isfinite(measured[i])) continue;
    product += predicted[i] * measured[i];
    square += predicted[i] * predicted[i];
    readings += measured[i] * measured[i];
  }
  const double alike = product / std::sqrt(square * readings), factor = product / square;
  if (alike < -0.7)
    return "the readings have the opposite sign of the prediction: check the layout, and the sign "
           "of axial_displacement_um (positive towards the tool)";
  if (alike > 0.7 && (factor < 0.005 || factor > 200.0))
    return fmt::format(
        "the readings are about {:.2g} times the prediction: is axial_displacement_um in um?",
        factor);
  return "";
}

/// Preloads that may be tried: those of the record, or the one there is and others that a spindle
/// of that preload stands. NaN is the model's own.
std::vector<double> ShaftSubject::preload_levels(const fit::Record& record) const {
  const auto [low, high] = range_of(record.values(record::preload));
  if (high > 1.05 * low) return fit::grid(low, high, 3);
  const bool recorded = std::isfinite(low);
  const double one = recorded ? low : model().shaft->arrangement.preload();
  if (!(one > 0.0)) return {unset};
  return {recorded ? one : unset, 0.5 * one, 2.0 * one};
}

std::vector<fit::Axis> ShaftSubject::axes(const fit::Record& record) const {
  std::vector<fit::Axis> list;
  const auto add = [&](const record::Channel& channel, int count, bool told) {
    const auto [low, high] = range_of(record.values(channel));
    if (std::isfinite(high - low)) list.push_back({&channel, fit::grid(low, high, count), told});
  };
  add(record::speed, 7, true);
  add(record::axial_load, 5, record.varies(record::axial_load));
  add(record::temperature, 4, false);
  list.push_back({&record::preload, preload_levels(record), true});
  return list;
}

std::string ShaftSubject::words(std::span<const fit::Setting> point) const {
  const auto value = [&](const record::Channel& channel) {
    for (const fit::Setting& s : point)
      if (*s.channel == channel) return channel.in_unit(s.value);
    return unset;
  };
  std::string text = fmt::format("{:.0f} rpm", value(record::speed));
  if (const double load = value(record::axial_load); std::isfinite(load))
    text += fmt::format(", {:.0f} N external load", load);
  if (const double preload = value(record::preload); std::isfinite(preload))
    text += fmt::format(" at a preload of {:.0f} N", preload);
  return text;
}

std::vector<std::string> ShaftSubject::records_needed(
    const fit::Record& record, const std::vector<std::vector<std::string>>& rivals,
    const std::vector<std::string>& not_testable) const {
  const auto warm = [&](const std::string& id) {
    const effects::Description* const d = description(id);
    return d && d->follows_heat;
  };
  const auto by_heat = [&](const std::vector<std::string>& members) {
    return std::any_of(members.begin(), members.end(), warm);
  };
  const bool untested = std::any_of(not_testable.begin(), not_testable.end(), warm);
  std::vector<std::string> list;
  const auto add_data = [&] {
    for (const std::string& id : model::own_data(model()))
      for (const std::vector<std::string>& members : rivals)
        if (list.empty() || list.back() != inspection_sheet)
          if (std::find(members.begin(), members.end(), id) != members.end())
            list.emplace_back(inspection_sheet);
    return list;
  };
  if ((!untested && std::none_of(rivals.begin(), rivals.end(), by_heat)) ||
      std::all_of(rivals.begin(), rivals.end(), by_heat))
    return add_data();
  if (!record.complete(record::inner_ring_temperature) ||
      !record.complete(record::outer_ring_temperature))
    list.emplace_back(
        "ring temperatures (inner_ring_temperature_C, outer_ring_temperature_C), for the thermal "
        "expansion");
  list.emplace_back(
      "the same speeds up and down, each soon after the change of speed and again when the shaft "
      "is warm, to separate effects of heat from effects of speed");
  return add_data();
}

model::Expected ShaftSubject::expected() const {
  const std::string rings =
      "the ring temperature under [arrangement] for all rows, or the mounting temperature if "
      "[arrangement] has no value";
  model::Expected e;
  e.defaults = {
      {&record::speed, unset, ""},
      {&record::axial_load, model().shaft->external_load, "external_load_N of [arrangement]"},
      {&record::radial_load, model().rig.radial_load, "[rig]"},
      {&record::temperature, model().rig.temperature, "[rig]"}};
  e.partners = {{&record::inner_ring_temperature, &record::outer_ring_temperature, rings},
                {&record::outer_ring_temperature, &record::inner_ring_temperature, rings}};
  e.measured = {&record::axial_displacement, &record::friction_torque};
  e.signed_inputs = {&record::axial_load};
  e.unused = {
      {&record::radial_load,
       "radial_load_N is not used: for sets on a shaft the program uses only the axial load"}};
  e.coast_down = model().rig.coasts_down();
  e.minimum_speed = model().rig.minimum_speed;
  return e;
}

}  // namespace raceway::shaft
