#include "model/own_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "model/parameters.h"

namespace raceway::model {
namespace {

/// A number that may be wrong. If several parts of a spindle have it, the name of the part replaces
/// {} in its texts.
struct OwnDatum {
  std::string_view id, parameter, words, datum;
  double usual;           ///< usual error, in the unit of the parameter
  std::string_view unit;  ///< unit of this error, with a leading space
  bool of_spindle;
  std::string_view explained;                                   ///< where it stands
  std::vector<std::string> (*parts)(const Spindle&) = nullptr;  ///< names of the parts that have it
};

template <typename Parts>
std::vector<std::string> names_of(const Parts& parts) {
  std::vector<std::string> names;
  for (const auto& part : parts) names.push_back(part.name);
  return names;
}

constexpr double usual_inlet_error_K = 8.0;
constexpr std::string_view where_inlets_stand =
    "the inlet temperature of the coolant of a spindle, under [coolant]; a [[coolant.circuit]] "
    "with its own inlet temperature is tested as coolant-inlet:NAME";

// A bearing of 15 for 18 deg or 25 for 26.5 is another variant of its series; makers let the angle
// of one bearing differ by some 2 deg. Groove radii are 0.51 to 0.54 of the ball diameter and are
// on few data sheets. A thermometer is screwed into the next free bore; a chiller is set anew.
constexpr std::array all{
    OwnDatum{"contact-angle", "contact_angle_deg", "contact angle", "the bearing data", 4.0, " deg",
             false, "the contact angle of the bearings on a shaft, under [bearing]"},
    OwnDatum{"conformity", "conformity", "conformity of the grooves", "the bearing data", 0.02, "",
             false, "the conformity of the grooves of the bearings on a shaft, under [bearing]"},
    OwnDatum{"coolant-inlet", "inlet_temperature_C", "inlet",
             "the inlet temperature of the coolant", usual_inlet_error_K, " K", true,
             where_inlets_stand},
    OwnDatum{"coolant-inlet:{}", "{}.inlet_temperature_C", "inlet",
             "the inlet temperature of circuit {}", usual_inlet_error_K, " K", true,
             where_inlets_stand, [](const Spindle& s) { return names_of(s.circuits); }},
    OwnDatum{"sensor-place:{}", "sensor.{}.position_mm", "position",
             "the place of the thermometer {}", 25.0, " mm", true,
             "the position_mm of a [[sensor]] in a spindle; each sensor is tested separately, as "
             "sensor-place:NAME",
             [](const Spindle& s) { return names_of(s.sensors); }}};

constexpr std::string_view any_part = "{}";

/// The datum of an id, and the part in its name.
struct Found {
  const OwnDatum* datum = nullptr;
  std::string_view part{};
  [[nodiscard]] std::string text(std::string_view with) const {
    std::string result(with);
    if (const std::size_t at = result.find(any_part); at != result.npos)
      result.replace(at, any_part.size(), part);
    return result;
  }
};

Found find(std::string_view id) {
  for (const OwnDatum& d : all) {
    if (d.id == id) return {&d};
    const std::size_t at = d.id.find(any_part);
    if (at != d.id.npos && id.size() > at && id.starts_with(d.id.substr(0, at)))
      return {&d, id.substr(at)};
  }
  return {};
}

std::optional<fit::Parameter> parameter_of(const Model& model, const Found& found) {
  if (!found.datum || found.datum->of_spindle != model.spindle.has_value()) return std::nullopt;
  const std::string name = found.text(found.datum->parameter);
  for (fit::Parameter& p : parameters(model))
    if (p.name == name) return std::move(p);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> own_data(const Model& model) {
  std::vector<std::string> ids;
  const auto add = [&](const Found& found) {
    if (parameter_of(model, found)) ids.push_back(found.text(found.datum->id));
  };
  for (const OwnDatum& d : all) {
    if (!d.parts) {
      add({&d});
      continue;
    }
    if (!model.spindle) continue;
    for (const std::string& part : d.parts(*model.spindle)) add({&d, part});
  }
  return ids;
}

std::optional<fit::Candidate> own_datum(const Model& model, std::string_view id) {
  const Found found = find(id);
  if (!parameter_of(model, found)) return std::nullopt;
  fit::Candidate c{.id = std::string(id)};
  c.parameters.push_back(own_datum_parameter(model, id));
  c.datum = found.text(found.datum->datum);
  return c;
}

fit::Parameter own_datum_parameter(const Model& model, std::string_view id) {
  const Found found = find(id);
  std::optional<fit::Parameter> p = parameter_of(model, found);
  if (!p)
    throw std::invalid_argument(
        fmt::format("{}: the model has no number of this name that a measurement can correct", id));
  const double usual = found.datum->usual;
  p->name = fmt::format("{}.{}", id, p->name.substr(p->name.rfind('.') + 1));
  p->neutral = p->start;
  p->plausible_lower = std::max(p->lower, p->start - usual);
  p->plausible_upper = std::min(p->upper, p->start + usual);
  p->scale = 0.5 * usual;
  // Beyond what people get wrong a number of a spindle would only stand for something else.
  if (found.datum->of_spindle) {
    p->lower = p->plausible_lower;
    p->upper = p->plausible_upper;
  }
  return *std::move(p);
}

std::string own_datum_explained(std::string_view id) {
  const std::string_view plain = id.substr(0, id.find(':'));
  for (const OwnDatum& d : all)
    if (d.id.substr(0, d.id.find(':')) == plain)
      return fmt::format(
          "{}: not an effect, but a number of the model that may be wrong: {}. diagnose tests the "
          "number (usual error up to {:g}{}), and add corrects it.",
          plain, d.explained, d.usual, d.unit);
  return {};
}

std::string own_datum_text(const Model& model, std::string_view id, double value) {
  const Found found = find(id);
  const std::optional<fit::Parameter> p = parameter_of(model, found);
  if (!p) return {};
  return fmt::format("{} {:.4g}{} instead of the entered {:.4g}", found.datum->words, value,
                     p->unit == "1" ? "" : " " + p->unit, p->start);
}

}  // namespace raceway::model
