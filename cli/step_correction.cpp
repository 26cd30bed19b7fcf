#include "cli/step_correction.h"

#include <fmt/core.h>

#include <stdexcept>
#include <vector>

#include "cli/messages.h"
#include "cli/run_files.h"
#include "files/correction_file.h"
#include "results/step_correction.h"
#include "session/step_parts.h"
#include "text/error.h"

namespace raceway::cli {

void StepCorrectionFlags::declare(CLI::App& command) {
  command
      .add_option("--correction", file,
                  "correction model to write; its tables are written to the same folder")
      ->type_name("FILE");
  command
      .add_option("--law", law,
                  "dependence of gain K and time constant T on the friction power: curve (table of "
                  "values; default), power (power law) or line (straight line)")
      ->check(CLI::IsMember({"curve", "power", "line"}))
      ->type_name("LAW");
  command
      .add_option("--lags", lags,
                  "number of delay elements in the correction: one, two or auto (default)")
      ->check(CLI::IsMember({"one", "two", "auto"}))
      ->type_name("NUMBER");
  command
      .add_option("--programme", programme,
                  "CSV with time_s, speed_rpm and loads, for a comparison of the correction with "
                  "the simulation")
      ->type_name("FILE");
  for (const char* const of_correction : {"--law", "--lags"})
    command.get_option(of_correction)->needs("--correction");
}

void StepCorrectionFlags::check(bool has_model) const {
  if (!programme.empty() && (file.empty() || !has_model))
    throw text::InputError(
        "raceway step-response: --programme needs --correction FILE, because it compares the "
        "correction with the simulation of MODEL",
        {.key = "--programme"});
  if (file == "-")
    throw text::InputError(
        "raceway step-response: --correction -: not possible, because it also writes tables; name "
        "a file",
        {.key = "--correction"});
}

void StepCorrectionFlags::require_writable(text::IfExists if_exists,
                                           const std::vector<std::string>& load_channels) const {
  if (file.empty()) return;
  const std::vector<std::string> tables = results::step_correction_tables(file, load_channels);
  check_outputs(tables);
  text::require_writable(file, if_exists);
  for (const std::string& table : tables) text::require_writable(table, if_exists);
}

void StepCorrectionFlags::write(const session::SpindleSteps& steps, bool replace) const {
  if (file.empty()) return;
  try {
    const results::StepCorrection written = results::step_correction(
        session::correction_of_steps(
            messages(), steps, {.law = law, .lags = lags, .wording = session::Wording::flags}),
        file);
    results::write_step_correction(written, file, replace);
    std::string tables;
    for (const auto& [name, text] : written.tables) tables += (tables.empty() ? "" : ", ") + name;
    say(fmt::format("{} written, with its tables {}", file, tables));
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("raceway step-response: --correction: {}", e.what()),
                           {.key = "--correction"});
  }
}

std::optional<results::Superposition> StepCorrectionFlags::superposition(
    const session::SpindleSteps& steps) const {
  if (programme.empty()) return std::nullopt;
  const files::CorrectionFile written = files::read_correction(file);
  results::Superposition s =
      session::superposition_of_steps(messages(), steps, written.models.front(), programme);
  if (s.report.converged())
    say(fmt::format("difference between correction and simulation over {}: {}", programme,
                    results::superposition_text(s)));
  else
    warn(fmt::format("{}: the simulation ended early: {}", programme, s.report.message));
  return s;
}

}  // namespace raceway::cli
