#include "session/assumptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "files/model_data.h"
#include "record/units.h"
#include "session/sensitivity.h"
#include "text/error.h"

namespace raceway::session {

using results::Assumption;
using results::Assumptions;

namespace {

constexpr std::size_t most_named = 5;

/// How far an assumed number is usually off. Judgements, not measurements: surfaces, fits, films
/// and grease differ by these from spindle to spindle; steel and iron by their tables.
struct UsualSpread {
  std::string_view name;
  std::string_view text;  ///< as the spreads of `sensitivity`
};
constexpr std::array usual_spreads{UsualSpread{"bearing.inner_conformity", "0.01"},
                                   UsualSpread{"bearing.outer_conformity", "0.01"},
                                   UsualSpread{"bearing.lubricant_conductance_W_K", "50%"},
                                   UsualSpread{"friction.f0", "50%"},
                                   UsualSpread{"friction.z", "50%"},
                                   UsualSpread{"friction.y", "10%"},
                                   UsualSpread{"friction.rolling_factor", "40%"},
                                   UsualSpread{"friction.K_rs", "50%"},
                                   UsualSpread{"arrangement.preload_N", "20%"},
                                   UsualSpread{"ambient.temperature_C", "2"},
                                   UsualSpread{"ambient.emissivity", "0.1"},
                                   UsualSpread{"ambient.convection_factor", "30%"},
                                   UsualSpread{"shaft.conductivity_W_mK", "10%"},
                                   UsualSpread{"shaft.thermal_expansion_1e6_K", "5%"},
                                   UsualSpread{"shaft.elastic_modulus_GPa", "3%"},
                                   UsualSpread{"housing.conductivity_W_mK", "10%"},
                                   UsualSpread{"housing.thermal_expansion_1e6_K", "10%"},
                                   UsualSpread{"housing.elastic_modulus_GPa", "15%"},
                                   UsualSpread{"housing.flange_length_mm", "20%"},
                                   UsualSpread{"housing.flange_conductance_W_K", "50%"},
                                   UsualSpread{"seat.inner_interference_um", "3"},
                                   UsualSpread{"seat.outer_clearance_um", "3"},
                                   UsualSpread{"seat.roughness_um", "50%"},
                                   UsualSpread{"seat.slope", "50%"},
                                   UsualSpread{"seat.hardness_GPa", "30%"},
                                   UsualSpread{"seat.shoulder_conductance_W_m2K", "50%"},
                                   UsualSpread{"seat.collar_conductance_W_m2K", "50%"}};
constexpr std::string_view other_spread = "10%";

std::string_view spread_of_default(std::string_view name) {
  const auto known = std::find_if(usual_spreads.begin(), usual_spreads.end(),
                                  [&](const UsualSpread& one) { return one.name == name; });
  return known == usual_spreads.end() ? other_spread : known->text;
}

/// The larger change of the displacement [m]; without bounds where an allowed value leaves no
/// state.
double change(const Assumption& a, double displacement) {
  const auto moved = [&](double to, bool allowed) {
    if (!std::isfinite(to)) return allowed ? std::numeric_limits<double>::infinity() : 0.0;
    return std::abs(to - displacement);
  };
  return std::max(moved(a.low, a.low_allowed), moved(a.high, a.high_allowed));
}

bool is_allowed(const files::ModelData& data, const std::string& name, double value) {
  try {
    const std::pair<std::size_t, double> change{data.find(name), value};
    (void)data.with({&change, 1});
    return true;
  } catch (const text::InputError&) {
    return false;
  }
}

/// Drops all messages: they were printed with the answer.
struct Silent final : Messages {
  void hear(const record::Note&) override {}
};

}  // namespace

Assumptions influential_assumptions(const files::ModelFile& file, const spindle::Inputs& inputs,
                                    const std::atomic<bool>* cancelled) {
  Assumptions found{.speed = inputs.speed};
  if (!file.model.spindle || file.model.spindle->network) return found;
  SensitivityQuestion question{.predictions = {"axial_displacement_um"},
                               .speeds_rpm = {inputs.speed / rpm},
                               .steady = true,
                               .inputs = inputs,
                               .cancelled = cancelled};
  const files::ModelData all(file);
  for (const files::ModelDatum& d : all.data()) {
    // A load of nothing is no assumption, and how many bearings a rig has no number of a spindle.
    // Dimensions are read from a drawing: a guess among them stands for the shaft to be entered.
    const bool marked = d.marked && d.name.find("_mm") == d.name.npos;
    const bool assumed = d.origin == files::ModelDatum::Origin::by_default || marked;
    if (!assumed || d.whole || d.value == 0.0 || d.name.starts_with("rig.")) continue;
    question.data.push_back(d.name);
    question.spreads.push_back({d.name, std::string(spread_of_default(d.name))});
  }
  if (question.data.empty()) return found;
  Silent silent;
  const results::Sensitivity s = sensitivity(silent, file, question);
  found.assumed = s.data.size();
  if (s.predictions.empty() || !std::isfinite(s.predictions.front().value)) return found;
  const results::PredictionSensitivity& nose = s.predictions.front();
  found.displacement = nose.value * um;
  for (std::size_t k = 0; k < s.data.size(); ++k) {
    found.most.push_back({.name = s.data[k].name,
                          .value = s.data[k].value,
                          .spread = s.data[k].spread,
                          .low = nose.local[k].low * um,
                          .high = nose.local[k].high * um});
    Assumption& a = found.most.back();
    a.low_allowed = std::isfinite(a.low) || is_allowed(all, a.name, a.value - a.spread);
    a.high_allowed = std::isfinite(a.high) || is_allowed(all, a.name, a.value + a.spread);
  }
  std::stable_sort(found.most.begin(), found.most.end(), [&](const auto& a, const auto& b) {
    return change(a, found.displacement) > change(b, found.displacement);
  });
  if (found.most.size() > most_named) found.most.resize(most_named);
  return found;
}

}  // namespace raceway::session
