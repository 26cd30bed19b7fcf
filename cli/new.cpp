#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "session/new_model.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct NewFlags {
  session::NewModel wanted;
  std::string output;
  bool force = false;
};

int run(const NewFlags& flags) {
  const std::string text = session::new_model_text(messages(), flags.wanted);
  if (flags.output.empty() || flags.output == "-") {
    fmt::print("{}", text);
  } else {
    text::write_text(flags.output, text,
                     flags.force ? text::IfExists::replace : text::IfExists::refuse);
    say(flags.output + " written");
  }
  return done;
}

}  // namespace

Run setup_new(CLI::App& command) {
  auto flags = std::make_shared<NewFlags>();
  command
      .add_option("BEARING", flags->wanted.bearing,
                  "designation, of the catalogue (raceway bearings) or not")
      ->required()
      ->type_name("");
  add_length(command, "--bore", flags->wanted.outline.bore, {1, 5000, "mm"},
             "of one that is not in the catalogue, in mm or with its unit (2.7559in)");
  add_length(command, "--outer-diameter", flags->wanted.outline.outer_diameter, {2, 10000, "mm"},
             "of the same");
  command
      .add_option("--balls", flags->wanted.outline.ball_count, "how many it has, if it is known")
      ->check(CLI::Range(3, 200))
      ->type_name("NUMBER");
  add_number(command, "--contact-angle", flags->wanted.contact_angle, {0.1, 65, "deg"},
             "[deg]; default: by the end of the designation (C, E, AC), else 15");
  command
      .add_option("--ball-material", flags->wanted.outline.ball_material,
                  "steel or silicon-nitride (a hybrid bearing), balls or rollers")
      ->check(CLI::IsMember({"steel", "silicon-nitride"}))
      ->type_name("NAME");
  command
      .add_option("--law", flags->wanted.law,
                  "palmgren, skf or contact (default; rollers have the other two)")
      ->check(CLI::IsMember({"palmgren", "skf", "contact"}))
      ->type_name("NAME");
  command.add_option("-o,--output", flags->output, "model file to write; stdout without it")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer(
      "Example:\n  raceway new \"S 6014 C\" -o my.toml\n"
      "  raceway new \"7014 C\" --balls 20 --ball-material silicon-nitride -o my.toml\n"
      "  raceway new \"N1012 KTN/SP\" -o rollers.toml\n"
      "  raceway new mine --bore 70 --outer-diameter 110 -o my.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
