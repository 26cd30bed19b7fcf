#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "cli/commands.h"
#include "cli/number_flag.h"
#include "cli/output_flags.h"
#include "cli/shared_flags.h"
#include "session/new_model.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct NewFlags : OutputFlags {
  session::NewModel wanted;
  std::string record;
  session::Reading reading;
};

/// True if a flag describes a bearing.
bool names_a_bearing(const session::NewModel& wanted) {
  const files::BearingOutline& o = wanted.outline;
  return !wanted.bearing.empty() || wanted.spindle || !wanted.law.empty() || !wanted.oil.empty() ||
         o.ball_count > 0 || o.ball_material != "steel" || std::isfinite(o.bore) ||
         std::isfinite(o.outer_diameter) || std::isfinite(wanted.contact_angle);
}

std::string text_of(const NewFlags& flags) {
  if (!flags.record.empty()) {
    if (names_a_bearing(flags.wanted))
      throw text::InputError(
          "raceway new: --record writes a correction, which has no bearing: remove BEARING, "
          "--spindle and their flags",
          {.key = "--record"});
    return session::new_correction_text(messages(), flags.record, flags.reading);
  }
  if (!flags.reading.columns.empty() || !flags.reading.beside.empty())
    throw text::InputError("raceway new: --columns and --beside need --record",
                           {.key = "--record"});
  session::NewModel wanted = flags.wanted;
  if (wanted.bearing.empty() && !wanted.spindle)
    throw text::InputError(
        "raceway new: BEARING is missing: give a designation such as \"S 6014 C\", --spindle for a "
        "spindle, or --record for a correction",
        {.key = "BEARING"});
  if (wanted.bearing.empty()) wanted.bearing = "S 6014 C";
  return session::new_model_text(messages(), wanted);
}

int run(const NewFlags& flags) {
  flags.put(text_of(flags));
  return done;
}

}  // namespace

Run setup_new(CLI::App& command) {
  auto flags = std::make_shared<NewFlags>();
  command
      .add_option("BEARING", flags->wanted.bearing,
                  "designation, such as \"7014 C\"; raceway bearings lists the catalogue; the "
                  "program estimates the data of other bearings")
      ->type_name("");
  command.add_flag(
      "--spindle", flags->wanted.spindle,
      "write a complete spindle with three of these bearings (default bearing: S 6014 C)");
  command
      .add_option("--record", flags->record,
                  "write a correction instead, for the displacements of this record over time "
                  "(CSV), with one channel for each temperature, at most four channels")
      ->type_name("RECORD");
  command
      .add_option("--columns", flags->reading.columns,
                  "map from columns of RECORD to columns of raceway (TOML, table [columns]), if "
                  "their names are different")
      ->type_name("FILE");
  declare_beside(command, flags->reading);
  add_length(command, "--bore", flags->wanted.outline.bore, {1, 5000, "mm"},
             "bore of a bearing that is not in the catalogue, in mm or with a unit (2.7559in)");
  add_length(command, "--outer-diameter", flags->wanted.outline.outer_diameter, {2, 10000, "mm"},
             "outer diameter of a bearing that is not in the catalogue");
  command
      .add_option("--balls", flags->wanted.outline.ball_count, "number of balls, if you know it")
      ->check(CLI::Range(3, 200))
      ->type_name("NUMBER");
  add_number(command, "--contact-angle", flags->wanted.contact_angle, {0.1, 65, "deg"},
             "contact angle [deg]; default: from the end of the designation (C, E, AC), else 15");
  command
      .add_option("--ball-material", flags->wanted.outline.ball_material,
                  "material of the balls or rollers: steel or silicon-nitride (hybrid bearing)")
      ->check(CLI::IsMember({"steel", "silicon-nitride"}))
      ->type_name("NAME");
  command
      .add_option("--oil", flags->wanted.oil,
                  "ISO VG grade of a mineral oil with viscosity index 100, such as \"VG 32\"; "
                  "default: a thin spindle oil, which you should replace")
      ->type_name("GRADE");
  command
      .add_option("--law", flags->wanted.law,
                  "friction law: palmgren, skf or contact; default: contact, but palmgren for "
                  "spindles and roller bearings. contact is not available for roller bearings")
      ->check(CLI::IsMember({"palmgren", "skf", "contact"}))
      ->type_name("NAME");
  flags->declare_output(command, "model file to write; default: stdout");
  flags->declare_force(command);
  command.footer(
      "Example:\n  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway new \"7014 AC\" --oil \"VG 32\" --law palmgren -o rig.toml\n"
      "  raceway new \"7014 C\" --balls 20 --ball-material silicon-nitride -o my.toml\n"
      "  raceway new \"N1012 KTN/SP\" -o rollers.toml\n"
      "  raceway new mine --bore 70 --outer-diameter 110 -o my.toml\n"
      "  raceway new --spindle -o spindle.toml\n"
      "  raceway new --record drift.csv -o drift.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
