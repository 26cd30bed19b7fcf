#include "model/ignored_data.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/steps.h"

namespace raceway::model {
namespace {

/// True if the key, such as `bore_mm`, is of one of these data.
bool is_of(std::string_view key, std::span<const std::string_view> data) {
  return std::any_of(data.begin(), data.end(), [&](std::string_view datum) {
    return key.starts_with(datum) && (key.size() == datum.size() || key[datum.size()] == '_');
  });
}

/// What no other law and no effect looks at.
constexpr std::array<std::string_view, 8> of_contacts_alone{"type",
                                                            "pressure_viscosity",
                                                            "density_15C",
                                                            "conductivity_W_mK",
                                                            "limiting_traction",
                                                            "eyring_stress",
                                                            "race_roughness",
                                                            "ball_roughness"};

}  // namespace

std::vector<std::string> ignored_by_friction(const Model& model,
                                             std::span<const std::string> keys) {
  std::vector<std::string> ignored;
  // A measured torque asks for none of them.
  if (model.law == friction::FrictionLaw::contact || model.law == friction::FrictionLaw::table)
    return ignored;
  for (const std::string& key : keys) {
    if (is_of(key, of_contacts_alone)) {
      ignored.push_back(key);
      continue;
    }
    if (needs_equilibrium(model)) continue;
    const bool by_effect =
        std::any_of(model.effects.begin(), model.effects.end(), [&](const effects::Effect& effect) {
          return is_of(key, effect.description->bearing_data);
        });
    if (!by_effect && !is_of(key, friction::bearing_data(model.law))) ignored.push_back(key);
  }
  return ignored;
}

std::vector<std::string> taken_in(friction::FrictionLaw law, std::span<const std::string> keys) {
  std::vector<std::string> taken;
  for (const std::string& key : keys)
    if (is_of(key, friction::bearing_data(law))) taken.push_back(key);
  return taken;
}

}  // namespace raceway::model
