#include <fmt/format.h>

#include <vector>

#include "cli/commands.h"
#include "cli/csv_style.h"
#include "cli/messages.h"
#include "cli/table_memory.h"
#include "files/table_file.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct MergeFlags {
  std::vector<std::string> slabs;
  std::string output;
  CsvStyle csv;
  bool force = false;
};

int run(const MergeFlags& flags) {
  const auto if_exists = flags.force ? text::IfExists::replace : text::IfExists::refuse;
  flags.csv.require_writable(flags.output, if_exists);
  require_memory_to_merge(flags.slabs);
  std::vector<files::SlabText> slabs;
  for (const std::string& name : flags.slabs)
    slabs.push_back({text::input_name(name), text::read_text(name)});
  const std::string text = files::merged_table_text(slabs);
  slabs.clear();
  flags.csv.put(flags.output, text, if_exists, fmt::format(" from {} slabs", flags.slabs.size()));
  return done;
}

}  // namespace

Run setup_merge(CLI::App& command) {
  auto flags = std::make_shared<MergeFlags>();
  command.add_option("SLABS", flags->slabs, "files that raceway table --slab wrote, in any order")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", flags->output, "CSV file to write; - for stdout")
      ->required()
      ->type_name("FILE");
  flags->csv.declare(command);
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.footer("Example:\n  raceway merge slab-*.csv -o stribeck.csv");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
