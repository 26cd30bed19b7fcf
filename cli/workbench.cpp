#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/output_flags.h"
#include "files/catalogue_file.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/text_encoding.h"

namespace raceway::cli {
namespace {

using nlohmann::json;

struct WorkbenchFlags : OutputFlags {
  WorkbenchFlags() { output = "raceway-workbench.html"; }

  std::vector<std::string> files;
  std::string columns;
};

std::string utf8(const std::string& file) {
  const std::string text = text::read_text(file);
  return text::is_utf8(text) ? text : text::utf8_from_latin1(text);
}

json named(const std::string& file) {
  const std::string name = file.substr(file.find_last_of('/') + 1);
  return {{"name", text::is_utf8(name) ? name : text::utf8_from_latin1(name)},
          {"text", utf8(file)}};
}

/// JSON that the page opens with, for the inside of a <script>: no tag in it can end the element.
std::string loaded(const WorkbenchFlags& flags) {
  json all = {{"data", json::array()}};
  for (const std::string& file : flags.files) {
    if (!file.ends_with(".toml")) {
      all["data"].push_back(named(file));
      continue;
    }
    if (all.contains("model"))
      throw text::InputError(
          "raceway workbench: " + all["model"]["name"].get<std::string>() + " and " + file +
              ": the page can open only one model; name one file that ends with .toml",
          {.file = file});
    all["model"] = named(file);
  }
  if (!flags.columns.empty()) all["map"] = utf8(flags.columns);
  std::string text = all.dump();
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"loaded\">" + text + "</script>";
}

int run(const WorkbenchFlags& flags) {
  text::require_writable(flags.output, flags.if_exists());
  const std::string source = files::data_file("workbench.html");
  if (source.empty())
    throw text::InputError(
        "raceway workbench: this installation has no workbench page "
        "(share/raceway/workbench.html); build the page with cmake --preset wasm and cmake --build "
        "--preset wasm");
  std::string page = text::read_text(source);
  constexpr std::string_view place = "<!--@LOADED@-->";
  const std::size_t at = page.rfind(place);
  if (at == page.npos)
    throw text::InputError(source + ": is not a workbench page of this version", {.file = source});
  page.replace(at, place.size(), loaded(flags));
  text::write_text(flags.output, page, flags.if_exists());
  say(flags.output + " written; open this page in a browser");
  return done;
}

}  // namespace

Run setup_workbench(CLI::App& command) {
  auto flags = std::make_shared<WorkbenchFlags>();
  command
      .add_option(
          "FILES", flags->files,
          "files that the page opens: a model file (.toml) and measurements (CSV), both optional")
      ->type_name("")
      ->expected(-1);
  command
      .add_option(
          "--columns", flags->columns,
          "map from columns of the measurements to columns of raceway (TOML, table [columns])")
      ->type_name("FILE");
  flags->declare_output(command, "page to write; default raceway-workbench.html in this folder");
  flags->declare_force(command, "replace the page if it exists");
  command.footer(
      "The page contains the program. Open it in any browser with a double click. It needs\n"
      "no installation and no network, and sends no data.\n\n"
      "Example:\n  raceway workbench my.toml rig.csv -o page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
