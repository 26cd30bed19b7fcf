#include "model/corrected_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway::model {
namespace {

/// Of the two numbers of an oil card the ones that changed, in words.
std::string oil_text(const effects::Entry& before, const effects::Entry& after) {
  std::string text;
  const auto add = [&](double entered, double corrected, int temperature) {
    if (entered == corrected) return;
    text += fmt::format("{}{:.3g} mm2/s at {} C instead of the entered {:.4g}",
                        text.empty() ? "" : ", ", corrected / mm2_per_s, temperature,
                        entered / mm2_per_s);
  };
  add(before.viscosity_40C, after.viscosity_40C, 40);
  add(before.viscosity_100C, after.viscosity_100C, 100);
  return text;
}

}  // namespace

effects::Entry entry_of(const Model& model, double temperature) {
  return {.viscosity_40C = model.lubricant.viscosity_40C(),
          .viscosity_100C = model.lubricant.viscosity_100C(),
          .temperature = temperature,
          .room = model.rig.room_temperature};
}

Model with_corrected_data(Model model) {
  std::vector<effects::Effect> left;
  effects::Entry card = entry_of(model, unset);
  for (effects::Effect& e : model.effects) {
    effects::Entry after = card;
    if (e.description->entry) e.description->entry(after, e.values);
    if (after.viscosity_40C == card.viscosity_40C && after.viscosity_100C == card.viscosity_100C) {
      left.push_back(std::move(e));
      continue;
    }
    card = after;
    std::erase_if(model.free, [&](const std::string& name) {
      return name.starts_with(std::string(e.description->id) + ".");
    });
  }
  model.lubricant = friction::Lubricant(card.viscosity_40C, card.viscosity_100C);
  model.effects = std::move(left);
  return model;
}

std::string correction_text(const Model& model, const effects::Effect& effect) {
  if (effect.description->correction) return effect.description->correction(effect.values);
  if (!effect.description->entry) return {};
  const double warm = kelvin(60);
  const effects::Entry before = entry_of(model, warm);
  effects::Entry after = before;
  effect.description->entry(after, effect.values);
  if (std::string oil = oil_text(before, after); !oil.empty()) return oil;
  if (std::isnan(after.temperature)) return {};
  if (effect.description->parameters.front().unit == "K")
    return fmt::format("the lubricant film is {:.2g} K {} than the recorded temperature",
                       std::abs(after.temperature - warm),
                       after.temperature > warm ? "warmer" : "colder");
  return fmt::format(
      "the sensor shows {:.0f} % of the temperature rise of the lubricant film above {:.1f} C",
      100.0 * effect.values.front(), celsius(before.room));
}

}  // namespace raceway::model
