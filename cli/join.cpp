#include <fmt/format.h>

#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/shared_flags.h"
#include "session/correction_input.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct JoinFlags {
  std::vector<std::string> models;
  std::string output;
  bool force = false;
};

int run(const JoinFlags& flags) {
  const auto if_exists = on_existing(flags.force);
  const bool on_stdout = flags.output == "-";
  if (!on_stdout) text::require_writable(flags.output, if_exists);
  const files::CorrectionFile sum =
      session::join(messages(), {flags.models.begin(), flags.models.end()},
                    on_stdout ? std::string() : flags.output);
  if (on_stdout) {
    fmt::print("{}", sum.text);
    return done;
  }
  text::write_text(flags.output, sum.text, if_exists);
  say(fmt::format("{} written, {} channels", flags.output, sum.models.front().channels.size()));
  return done;
}

}  // namespace

Run setup_join(CLI::App& command) {
  auto flags = std::make_shared<JoinFlags>();
  command
      .add_option("MODELS", flags->models,
                  "files with [correction] of one displacement, as step-response and\n"
                  "identify write them: a spindle, an axis, the room")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", flags->output, "file to write (TOML); - for stdout")
      ->required()
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer("Example:\n  raceway join spindle_part.toml machine_part.toml -o machine.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
