#include <fmt/format.h>

#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/output_flags.h"
#include "session/correction_input.h"

namespace raceway::cli {
namespace {

struct JoinFlags : OutputFlags {
  std::vector<std::string> models;
};

int run(const JoinFlags& flags) {
  if (flags.output != "-") text::require_writable(flags.output, flags.if_exists());
  const files::CorrectionFile sum =
      session::join(messages(), {flags.models.begin(), flags.models.end()},
                    flags.to_file() ? flags.output : std::string());
  flags.put(sum.text, fmt::format(", {} channels", sum.models.front().channels.size()));
  return done;
}

}  // namespace

Run setup_join(CLI::App& command) {
  auto flags = std::make_shared<JoinFlags>();
  command
      .add_option("MODELS", flags->models,
                  "files with [correction] of the same displacement, as written by step-response "
                  "and identify, for example for spindle, axis and room")
      ->required()
      ->type_name("");
  flags->declare_output(command, "file to write (TOML); - for stdout")->required();
  flags->declare_force(command);
  command.footer("Example:\n  raceway join spindle_part.toml machine_part.toml -o machine.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
