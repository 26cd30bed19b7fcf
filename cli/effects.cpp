#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.h"
#include "cli/text_table.h"
#include "effects/catalogue.h"
#include "io/error.h"
#include "io/names.h"
#include "io/results.h"
#include "model/own_data.h"

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
void paragraph(const std::string& heading, std::string_view words) {
  const std::size_t margin = 14, width = std::max<std::size_t>(terminal_width(), 50);
  std::string line = fmt::format("{:<{}}", heading, margin);
  bool empty = true;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string_view word = words.substr(begin, end - begin);
    if (!empty && line.size() + 1 + word.size() > width) {
      fmt::print("{}\n", line);
      line.assign(margin, ' ');
      empty = true;
    }
    if (!empty) line += ' ';
    line += word;
    empty = false;
    begin = end + 1;
  }
  fmt::print("{}\n", line);
}

/// What an effect changes of what is measured.
std::string_view measured(bool torque, bool displacement) {
  return torque ? displacement ? "both" : "torque" : "displacement";
}

std::string_view step_explained(const Description& d) {
  if (d.entry) return "entry: what was entered or read, corrected before anything acts on it";
  if (d.condition)
    return d.for_rig ? "condition: what the bearing really sees, before its equilibrium"
                     : "condition: what the sets on the shaft really see, before their balance";
  if (d.lubricant) return "lubricant: viscosity and film at the contacts, before the base law";
  if (d.has_moment()) return "moment: added to the moments of the base law";
  return d.reads(record::friction_torque)
             ? "reading: what the rig makes of the torque of its bearings"
             : "reading: what is read of the position of the shaft";
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
    return "on a rig: " + text + "; on a shaft: nothing beside the displacement";
  if (!text.empty()) return text;
  return d.for_rig ? "nothing beside the torque" : "nothing beside the displacement";
}

void print_list() {
  TextTable table({{"effect", "", true},
                   {"acts at", "", true},
                   {"changes", "", true},
                   {"what it is", "", true}});
  for (const Description& d : effects::catalogue())
    table.add({std::string(d.id), std::string(d.step()),
               std::string(measured(d.moves(Form::rig),
                                    effects::find(d.id, Form::shaft)->moves(Form::shaft))),
               std::string(d.title)});
  fmt::print("{}", table.text(std::max<std::size_t>(terminal_width(), 120)));
  fmt::print("\nraceway effects ID explains one of them.\n");
}

void print_page(const Description& d) {
  fmt::print("{}: {}\n\n", d.id, d.title);
  paragraph("changes", d.for_rig && d.for_shaft
                           ? d.moves(Form::shaft)
                                 ? "friction torque of a bearing on a rig, displacement of a shaft"
                                 : "friction torque"
                       : d.for_rig ? "friction torque of a bearing on a rig"
                                   : "displacement of a shaft with an [arrangement]");
  paragraph("mechanism", d.mechanism);
  paragraph("formula", d.formula);
  paragraph("source", d.source);
  paragraph("acts at", step_explained(d));
  paragraph("needs", needs_of(d));
  if (!d.supplies.empty())
    paragraph("lubricated", fmt::format("by {}; no candidate where [lubricant] supply is another",
                                        effects::text(d.supplies)));
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
  fmt::print("{}", table.text(std::max<std::size_t>(terminal_width(), 100)));
  if (d.size_power != 0.0)
    fmt::print("usual: at a pitch diameter of {:g} mm; it goes with the power {:g} of it\n",
               effects::size_of_ranges / mm, d.size_power);
  fmt::print("\nin a model file:\n\n  [[effect]]\n  id = \"{}\"\n", d.id);
  for (const effects::Parameter& p : d.parameters)
    fmt::print("  {} = {}\n", p.name, plain(p.initial));
}

int show(const std::string& id, bool json) {
  if (id.empty()) {
    if (json)
      fmt::print("{}", io::effects_json(effects::all_forms()));
    else
      print_list();
    return done;
  }
  std::vector<Description> forms;
  for (const Description& d : effects::all_forms())
    if (d.id == id) forms.push_back(d);
  if (const std::string own = model::own_datum_explained(id); !own.empty() && !json) {
    fmt::print("{}\n", own);
    return done;
  }
  if (forms.empty()) {
    std::vector<std::string> ids;
    for (const Description& known : effects::catalogue()) ids.emplace_back(known.id);
    throw io::InputError(fmt::format("raceway effects: {}: no such effect{}", id,
                                     io::suggestion(id, ids).empty()
                                         ? "; raceway effects lists them"
                                         : io::suggestion(id, ids)));
  }
  if (json) {
    fmt::print("{}", forms.size() == 1 ? io::effect_json(forms[0]) : io::effects_json(forms));
    return done;
  }
  for (const Description& d : forms) {
    if (&d != &forms.front()) fmt::print("\n");
    print_page(d);
  }
  return done;
}

}  // namespace

Run setup_effects(CLI::App& command) {
  auto id = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command.add_option("ID", *id, "explain this effect; without it, the list")->type_name("");
  command.add_flag("--json", *json, "one JSON document instead of text");
  command.footer("Example:\n  raceway effects thermal-preload");
  return [=] { return show(*id, *json); };
}

}  // namespace raceway::cli
