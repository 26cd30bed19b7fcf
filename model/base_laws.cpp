#include "model/base_laws.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "friction/roller_friction.h"
#include "model/needs.h"
#include "model/parameters.h"

namespace raceway::model {
namespace {

using friction::FrictionLaw;

/// Published values; of the film what the oil has.
std::vector<double> usual_values(const Model& model, FrictionLaw law) {
  const friction::contact::ContactData& data = model.contact;
  std::vector<double> values;
  for (const friction::Parameter& p : friction::parameters(law))
    values.push_back(law == FrictionLaw::roller_palmgren && p.name == "f0"
                         ? friction::usual_roller_f0(model.supply)
                     : !friction::of_the_lubricant(p) ? p.initial
                     : std::isnan(data.limiting_traction)
                         ? oil_defaults(data.oil.type).limiting_traction
                         : data.limiting_traction);
  return values;
}

bool contains(FrictionLaw law, const effects::Description& effect) {
  const bool skf = law == FrictionLaw::skf || law == FrictionLaw::roller_skf;
  return skf && std::find(effect.needs.begin(), effect.needs.end(), effects::Need::palmgren_law) !=
                    effect.needs.end();
}

/// The datum of the bearing that a law needs and does not find, in words.
std::string lacking_datum(const ModelBearing& bearing, FrictionLaw law) {
  if (const bearing::RollerBearing* const rollers = bearing.rollers()) {
    const bearing::RollerGeometry& g = rollers->geometry();
    const bool rings = !std::isnan(g.bore) && !std::isnan(g.outer_diameter);
    return law == FrictionLaw::roller_skf && !rings
               ? "bore_mm and outer_diameter_mm under [bearing]"
               : "";
  }
  const bearing::BearingGeometry& g = bearing.geometry();
  if (friction::has_palmgren_load(law) && std::isnan(g.static_load_rating))
    return "static_load_rating_N under [bearing]";
  if (law == FrictionLaw::skf && !(g.contact_angle > 0.0))
    return "a contact angle above 0, because the constants of the skf law are for angular contact "
           "ball bearings";
  return {};
}

}  // namespace

std::string lacks_for_law(const Model& model, FrictionLaw law) {
  if (law == FrictionLaw::table && !model.table) return "file under [friction]";
  if (std::string datum = lacking_datum(model.bearing, law); !datum.empty()) return datum;
  const Model changed = with_law(model, law);
  for (const effects::Effect& e : model.effects) {
    const effects::Description& d = *e.description;
    // An exponent that was found for one law says nothing of another.
    if (d.base_law || contains(law, d) || !refused_by_law(d, changed).empty())
      return "a model without " + std::string(d.id) +
             ", because this effect is only possible with the present base law";
  }
  return {};
}

Model with_law(Model model, FrictionLaw law) {
  model.law_values = usual_values(model, law);
  model.law = law;
  // The laws of rollers all count the load that the model says.
  if (!friction::of_rollers(law)) model.f1_load = friction::F1Load::P0;
  std::vector<std::string> free = default_free(law);
  for (std::string& name : model.free)
    if (name.find('.') != name.npos) free.push_back(std::move(name));
  model.free = std::move(free);
  model.covariance.reset();
  if (law != FrictionLaw::contact && std::exchange(model.balanced_balls, false))
    model.solver.race_control = bearing::RaceControl::outer;
  return model;
}

}  // namespace raceway::model
