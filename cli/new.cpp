#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "io/bearing_estimate.h"
#include "io/catalogue_file.h"
#include "io/error.h"
#include "io/model_file.h"
#include "io/output_file.h"

namespace raceway::cli {
namespace {

struct NewFlags {
  std::string bearing, output;
  io::BearingOutline outline;
  double contact_angle = unset;  // [deg]
  std::string law = "contact";
  bool force = false;
};

friction::FrictionLaw wanted_law(const NewFlags& flags) {
  using friction::FrictionLaw;
  for (const FrictionLaw law : {FrictionLaw::palmgren, FrictionLaw::skf})
    if (flags.law == friction::name(law)) return law;
  return FrictionLaw::contact;
}

/// What the flags say of a bearing; of one in the catalogue they must say nothing.
io::BearingOutline outline(const NewFlags& flags, const std::vector<io::CatalogueBearing>& rows) {
  io::BearingOutline result = io::outline_of(flags.bearing, rows);
  if (!std::isnan(flags.outline.bore)) result.bore = flags.outline.bore;
  if (!std::isnan(flags.outline.outer_diameter))
    result.outer_diameter = flags.outline.outer_diameter;
  if (!std::isnan(flags.contact_angle)) result.contact_angle = flags.contact_angle * degree;
  result.ball_count = flags.outline.ball_count;
  result.ball_material = flags.outline.ball_material;
  return result;
}

std::string model_text(const NewFlags& flags) {
  const auto rows = io::read_catalogues();
  const io::BearingOutline& given = flags.outline;
  const bool described = !std::isnan(given.bore) || !std::isnan(given.outer_diameter) ||
                         !std::isnan(flags.contact_angle) || given.ball_count > 0;
  if (const io::CatalogueBearing* const row = io::known_bearing(rows, flags.bearing)) {
    if (described)
      throw io::InputError(
          fmt::format("raceway new: {} is in the catalogue, with its inner geometry; --bore, "
                      "--outer-diameter, --balls and --contact-angle are for one that is not",
                      row->full_name()),
          {.key = "BEARING"});
    if (given.ball_material == "steel") return io::new_model_text(*row, wanted_law(flags));
    io::CatalogueBearing hybrid = *row;
    if (!std::isnan(row->static_load_rating_silicon_nitride))
      hybrid.geometry.static_load_rating = row->static_load_rating_silicon_nitride;
    return io::model_text(hybrid, {.title = fmt::format("Model of a hybrid {} on a rig. Every "
                                                        "default is written out: change what you "
                                                        "know better.",
                                                        row->full_name()),
                                   .ball_material = given.ball_material,
                                   .of_key = {},
                                   .law = wanted_law(flags)});
  }
  const io::BearingOutline known = outline(flags, rows);
  // A misspelt name of the catalogue is answered with the nearest ones.
  if (!described && std::isnan(known.bore)) {
    try {
      (void)io::find_bearing(rows, flags.bearing);
    } catch (const io::InputError& e) {
      throw io::InputError(std::string(e.what()) +
                               "\nwith --bore and --outer-diameter, and --balls if it is known, "
                               "the inner geometry of "
                               "one that is not is estimated",
                           e.place);
    }
  }
  const io::EstimatedBearing bearing = io::estimated_bearing(known, rows);
  tell({fmt::format(
      "{} is not in the catalogue: {:.6g} x {:.6g} mm, {:.4g} deg{}; what is estimated "
      "is marked in the model",
      flags.bearing, known.bore / mm, known.outer_diameter / mm,
      bearing.outline.contact_angle / degree,
      std::isnan(given.bore) ? " by its designation" : "")});
  return io::estimated_model_text(bearing, wanted_law(flags));
}

int run(const NewFlags& flags) {
  const std::string text = model_text(flags);
  if (flags.output.empty() || flags.output == "-") {
    fmt::print("{}", text);
  } else {
    io::write_text(flags.output, text, flags.force ? io::IfExists::replace : io::IfExists::refuse);
    say(flags.output + " written");
  }
  return done;
}

}  // namespace

Run setup_new(CLI::App& command) {
  auto flags = std::make_shared<NewFlags>();
  command
      .add_option("BEARING", flags->bearing,
                  "designation, of the catalogue (raceway bearings) or not")
      ->required()
      ->type_name("");
  add_length(command, "--bore", flags->outline.bore, {1, 5000, "mm"},
             "of one that is not in the catalogue, in mm or with its unit (2.7559in)");
  add_length(command, "--outer-diameter", flags->outline.outer_diameter, {2, 10000, "mm"},
             "of the same");
  command.add_option("--balls", flags->outline.ball_count, "how many it has, if it is known")
      ->check(CLI::Range(3, 200))
      ->type_name("NUMBER");
  add_number(command, "--contact-angle", flags->contact_angle, {0.1, 65, "deg"},
             "[deg]; default: by the end of the designation (C, E, AC), else 15");
  command
      .add_option("--ball-material", flags->outline.ball_material,
                  "steel or silicon-nitride (a hybrid bearing)")
      ->check(CLI::IsMember({"steel", "silicon-nitride"}))
      ->type_name("NAME");
  command
      .add_option("--law", flags->law,
                  "palmgren, skf or contact (default), which takes in balls and rings")
      ->check(CLI::IsMember({"palmgren", "skf", "contact"}))
      ->type_name("NAME");
  command.add_option("-o,--output", flags->output, "model file to write; stdout without it")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer(
      "Example:\n  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway new \"7014 C\" --balls 20 --ball-material silicon-nitride -o my.toml\n"
      "  raceway new mine --bore 70 --outer-diameter 110 -o my.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
