#include "model/own_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "model/parameters.h"

namespace raceway::model {
namespace {

struct OwnDatum {
  std::string_view id, parameter, words, datum;
  double usual;  ///< error of it that is met, either way, in the unit of the parameter
};

// A bearing of 15 for 18 deg or 25 for 26.5 is another variant of its series; makers let the angle
// of one bearing differ by some 2 deg. Groove radii are 0.51 to 0.54 of the ball diameter and are
// on few data sheets.
constexpr std::array all{
    OwnDatum{"contact-angle", "contact_angle_deg", "contact angle", "the bearing card", 4.0},
    OwnDatum{"conformity", "conformity", "conformity of the grooves", "the bearing card", 0.02}};

const OwnDatum* find(std::string_view id) {
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](const OwnDatum& d) { return d.id == id; });
  return found == all.end() ? nullptr : found;
}

std::optional<fit::Parameter> parameter_of(const Model& model, const OwnDatum& datum) {
  for (fit::Parameter& p : parameters(model))
    if (p.name == datum.parameter) return std::move(p);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> own_data(const Model& model) {
  std::vector<std::string> ids;
  for (const OwnDatum& d : all)
    if (parameter_of(model, d)) ids.emplace_back(d.id);
  return ids;
}

std::optional<fit::Candidate> own_datum(const Model& model, std::string_view id) {
  const OwnDatum* const datum = find(id);
  if (!datum || !parameter_of(model, *datum)) return std::nullopt;
  fit::Candidate c{.id = std::string(id)};
  c.parameters.push_back(own_datum_parameter(model, id));
  c.datum = datum->datum;
  return c;
}

fit::Parameter own_datum_parameter(const Model& model, std::string_view id) {
  const OwnDatum* const datum = find(id);
  std::optional<fit::Parameter> p = datum ? parameter_of(model, *datum) : std::nullopt;
  if (!p) throw std::invalid_argument(fmt::format("{}: the model has no such number", id));
  p->name = fmt::format("{}.{}", id, datum->parameter);
  p->neutral = p->start;
  p->plausible_lower = std::max(p->lower, p->start - datum->usual);
  p->plausible_upper = std::min(p->upper, p->start + datum->usual);
  p->scale = 0.5 * datum->usual;
  return *std::move(p);
}

std::string own_datum_explained(std::string_view id) {
  const OwnDatum* const datum = find(id);
  if (!datum) return {};
  return fmt::format(
      "{}: no effect but a number of the model that may be wrong, the {} of the bearings on a "
      "shaft. diagnose tries it, usually wrong by {:g} at most; add puts it right under [bearing].",
      datum->id, datum->words, datum->usual);
}

std::string own_datum_text(const Model& model, std::string_view id, double value) {
  const OwnDatum* const datum = find(id);
  if (!datum) return {};
  const std::optional<fit::Parameter> p = parameter_of(model, *datum);
  if (!p) return {};
  return fmt::format("{} {:.4g}{} where {:.4g} is entered", datum->words, value,
                     p->unit == "1" ? "" : " " + p->unit, p->start);
}

}  // namespace raceway::model
