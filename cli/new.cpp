#include <fmt/core.h>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "io/catalogue_file.h"
#include "io/model_file.h"
#include "io/output_file.h"

namespace raceway::cli {
namespace {

struct NewFlags {
  std::string bearing, output;
  bool force = false;
};

int run(const NewFlags& flags) {
  const std::string text =
      io::new_model_text(io::find_bearing(io::read_catalogues(), flags.bearing));
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
      .add_option("BEARING", flags->bearing, "designation in the catalogue, see raceway bearings")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", flags->output, "model file to write; stdout without it")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer("Example:\n  raceway new \"S 6014 C\" -o my.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
