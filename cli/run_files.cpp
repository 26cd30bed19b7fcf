#include "cli/run_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "text/error.h"
#include "text/printable.h"

namespace raceway::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> written_flags{"output",     "report",    "plot", "save",
                                                        "correction", "end-state", "field"};
constexpr std::array<std::string_view, 2> improve_their_model{"calibrate", "add"};

struct Files {
  std::vector<std::string> inputs, outputs;
  std::string own_model;  ///< may be replaced by --output; empty where none may
};

Files& files_of_run() {
  static Files files;
  return files;
}

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What lies on a disk: a terminal, a pipe or /dev/null is nothing that could be lost.
bool is_file(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// By whatever links and spellings; also where there is no file yet.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error))
    return is_file(a) && fs::equivalent(a, b, error) && !error;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, error), error);
  const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && whole_a == whole_b;
}

/// `own_model`: an input that may be replaced, or none.
void require_no_input(const std::string& output, const std::string& own_model) {
  const Files& files = files_of_run();
  if (!own_model.empty() && same_file(output, own_model)) return;
  for (const std::string& input : files.inputs)
    if (same_file(output, input))
      throw text::InputError(
          output +
          ": this run reads this file, so it cannot write to the same file; name another file" +
          (input == output || input.starts_with("/dev/")
               ? ""
               : " (" + input + " is another name of this file)"));
}

}  // namespace

void check_files(const CLI::App& command) {
  Files& files = files_of_run();
  files = {};
  std::vector<std::pair<std::string, std::string>> outputs;  // flag, file
  // MODEL is the first argument of every command that has one.
  bool model_is_next = is_one_of(command.get_name(), improve_their_model);
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() == 0) continue;
    const std::string& name = option->get_single_name();
    for (const std::string& value : option->results()) {
      // It is printed with the results.
      if (const auto code = text::control_character(value))
        throw text::InputError(value + ": contains the control character " + *code);
      if (is_one_of(name, written_flags)) {
        if (!value.empty() && value != "-") outputs.emplace_back("--" + name, value);
        continue;
      }
      if (std::exchange(model_is_next, model_is_next && !option->get_positional()) &&
          option->get_positional())
        files.own_model = value;
      if (is_file(value)) files.inputs.push_back(value);
    }
  }
  if (is_file("/dev/stdin")) files.inputs.emplace_back("/dev/stdin");
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const auto& [flag, file] = outputs[k];
    files.outputs.push_back(file);
    require_no_input(file, flag == "--output" ? files.own_model : "");
    for (std::size_t j = 0; j < k; ++j)
      if (same_file(outputs[j].second, file))
        throw text::InputError(file + ": is named by " + outputs[j].first + " and by " + flag +
                               "; name two files");
  }
}

void add_input(const std::string& file) {
  Files& files = files_of_run();
  if (!is_file(file)) return;
  files.inputs.push_back(file);
  for (const std::string& output : files.outputs) require_no_input(output, files.own_model);
}

void check_outputs(const std::vector<std::string>& outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    require_no_input(outputs[k], files_of_run().own_model);
    for (std::size_t j = 0; j < k; ++j)
      if (same_file(outputs[j], outputs[k]))
        throw text::InputError(outputs[k] +
                               ": two records would be written to this file; rename one record");
    for (const std::string& named : files_of_run().outputs)
      if (same_file(named, outputs[k]))
        throw text::InputError(
            named + ": this run already writes a file with this name; choose another name");
  }
}

}  // namespace raceway::cli
