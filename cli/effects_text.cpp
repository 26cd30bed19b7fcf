#include "cli/effects_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/text_table.h"
#include "effects/catalogue.h"

namespace raceway::cli {
namespace {

using effects::Description;
using effects::Form;

std::string unit_of(const effects::Parameter& p) {
  return p.unit == "1" ? "-" : std::string(p.unit);
}

/// A number as short as it can be said.
std::string plain(double value) { return fmt::format("{:.6g}", value); }

/// Words filled into lines, behind a heading in the left margin.
void paragraph(std::string heading, std::string_view words) {
  constexpr std::size_t margin = 14;
  const std::size_t width = std::max<std::size_t>(terminal_width(), 50);
  for (const std::string& line : filled(words, width - margin)) {
    fmt::print("{:<{}}{}\n", heading, margin, line);
    heading.clear();
  }
}

std::string_view step_explained(const Description& d) {
  if (d.entry) return "entry: corrects an entered or measured value before the calculation";
  if (d.condition)
    return d.for_rig ? "condition: changes the load or geometry of the bearing before its "
                       "equilibrium is calculated"
                     : "condition: changes the loads or geometry of the bearing sets before their "
                       "equilibrium is calculated";
  if (d.lubricant)
    return "lubricant: changes viscosity and film at the contacts, before the base law";
  if (d.has_moment()) return "moment: added to the moments of the base law";
  if (d.spindle)
    return "spindle: changes conductances and heat, before the temperatures are calculated";
  return d.reads(record::friction_torque) ? "reading: changes the torque reading of the rig"
                                          : "reading: changes the reading of the shaft position";
}

std::string needs_of(const Description& d) {
  std::string text;
  const auto add = [&](std::string_view need) {
    text += text.empty() ? "" : "; ";
    text += need;
  };
  for (const effects::Need need : d.needs) add(effects::text(need));
  for (const record::Channel* channel : d.channels) add(effects::text(*channel));
  if (!text.empty() && d.for_rig && d.moves(Form::shaft))
    return "on a rig: " + text + "; on a shaft: only the displacement";
  if (!text.empty()) return text;
  if (d.spindle) return "only temperatures or displacement";
  return d.for_rig ? "only the torque" : "only the displacement";
}

}  // namespace

void print_effect_list(std::span<const Description> list) {
  TextTable table({{"effect", "", true}, {"what it is", "", true, true}});
  std::string_view before;
  for (const Description& d : list) {
    if (d.id != before) table.add({std::string(d.id), std::string(d.title)});
    before = d.id;
  }
  fmt::print("{}", table.text(terminal_width()));
}

void print_effect_list(std::span<const correction::EffectCard> cards) {
  TextTable table({{"effect on a record over time", "", true}, {"what it is", "", true, true}});
  for (const correction::EffectCard& card : cards)
    table.add({std::string(card.id), std::string(card.title)});
  fmt::print("\n{}", table.text(terminal_width()));
}

void print_effect_card(const correction::EffectCard& card) {
  fmt::print("{}: {}\n\n", card.id, card.title);
  paragraph("changes", "displacement of a machine over time, in a model with [correction]");
  paragraph("formula", card.form);
  paragraph("needs", card.needs);
  paragraph("looks like", card.confused);
  if (card.of_reading)
    paragraph("applies",
              "only to the record of the fit; the program does not use the effect for other "
              "records or in a control");
  if (card.evidence) paragraph("found", "from the record itself; the effect has no parameter");
  if (card.numbers.empty()) return;
  fmt::print("\n");
  TextTable table({{"parameter", "", true},
                   {"lower", ""},
                   {"upper", ""},
                   {"no effect at", ""},
                   {"unit", "", true}});
  const auto bound = [](double value) {
    return std::isfinite(value) ? plain(value) : std::string("-");
  };
  for (const record::NumberCard& n : card.numbers)
    table.add({std::string(n.name), bound(n.lower), bound(n.upper), bound(n.neutral),
               n.unit == "1"      ? "-"
               : n.unit == "um/u" ? "um per unit of the input"
                                  : std::string(n.unit)});
  fmt::print("{}", table.text(terminal_width()));
}

void print_effect_card(const Description& d) {
  fmt::print("{}: {}\n\n", d.id, d.title);
  std::string changed =
      d.of_spindles_alone() ? ""
      : d.for_rig && d.for_shaft
          ? d.moves(Form::shaft) ? "friction torque, displacement of a shaft" : "friction torque"
      : d.for_rig ? "friction torque of a bearing on a rig"
      : d.reads(record::axial_displacement)
          ? "displacement of a shaft with an [arrangement]"
          : "displacement and friction torque of a shaft with an [arrangement]";
  if (d.moves(Form::spindle))
    changed += changed.empty() ? "temperatures and displacement of a spindle (a model with [shaft] "
                                 "and [housing])"
                               : "; temperatures and displacement of a spindle";
  paragraph("changes", changed);
  paragraph("mechanism", d.mechanism);
  paragraph("formula", d.formula);
  paragraph("source", d.source);
  paragraph("acts at", step_explained(d));
  paragraph("needs", needs_of(d));
  if (!d.supplies.empty())
    paragraph("lubricated",
              fmt::format("by {}; the effect is not tested with another [lubricant] supply",
                          effects::text(d.supplies)));
  if (!d.within_contacts.empty())
    paragraph("not with", fmt::format("law = \"contact\", which already includes this effect as {}",
                                      d.within_contacts));
  std::string others;
  for (const std::string_view other : d.confused_with)
    others += (others.empty() ? "" : ", ") + std::string(other);
  paragraph("looks like", others);
  fmt::print("\n");
  TextTable table({{"parameter", "", true},
                   {"start", ""},
                   {"lower", ""},
                   {"upper", ""},
                   {"usual", ""},
                   {"no effect at", ""},
                   {"unit", "", true}});
  for (const effects::Parameter& p : d.parameters)
    table.add({std::string(p.name), plain(p.initial), plain(p.lower), plain(p.upper),
               fmt::format("{} to {}", plain(p.plausible_lower), plain(p.plausible_upper)),
               std::isnan(p.neutral) ? "-" : plain(p.neutral), unit_of(p)});
  fmt::print("{}", table.text(terminal_width()));
  if (d.size_power != 0.0)
    fmt::print(
        "usual: values at a pitch diameter of {:g} mm; for other bearings, they are proportional "
        "to the pitch diameter to the power {:g}\n",
        effects::size_of_ranges / mm, d.size_power);
  fmt::print("\nin a model file:\n\n  [[effect]]\n  id = \"{}\"\n", d.id);
  for (const effects::Parameter& p : d.parameters)
    fmt::print("  {} = {}\n", p.name, plain(p.initial));
}

}  // namespace raceway::cli
