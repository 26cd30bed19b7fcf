#include "fit/calibrate.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/calibrate_conformity.h"
#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/text_table.h"
#include "fit/free_parameters.h"
#include "fit/quantity.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/results.h"

namespace raceway::cli {
namespace {

struct Flags {
  std::string model, data, output;
  bool json = false, force = false;
};

void print(const fit::Calibration& c) {
  TextTable table({{"parameter", "", true},
                   {"before", ""},
                   {"after", ""},
                   {"std error", ""},
                   {"unit", "", true},
                   {"", "", true}});
  for (const fit::FittedParameter& p : c.parameters) {
    const std::string remark = p.held                           ? "held: not identifiable"
                               : !p.identifiable                ? "not identifiable"
                               : p.at_bound != fit::Bound::none ? "at its bound"
                                                                : "";
    table.add({p.name, number(p.start), number(p.value, 5), number(p.std, 2),
               p.unit == "1" ? "-" : p.unit, remark});
  }
  fmt::print("{}", table.text(terminal_width()));
  for (Eigen::Index i = 0; i < c.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (!std::isnan(c.correlation(i, j)))
        fmt::print("correlation of {} and {}: {:.2f}\n",
                   c.parameters[static_cast<std::size_t>(j)].name,
                   c.parameters[static_cast<std::size_t>(i)].name, c.correlation(i, j));
  const fit::QuantityText q = fit::text_of(c.quantity);
  fmt::print("\nRMS error over {} rows: {} {} before, {} {} after\n", c.rows,
             number(c.rmse_before / q.factor), q.unit, number(c.rmse_after / q.factor), q.unit);
}

int run(const Flags& flags) {
  if (flags.output == "-")
    throw io::InputError("raceway calibrate: --output -: stdout shows the parameters; name a file");
  if (flags.data.empty())
    return calibrate_conformity(
        {.model = flags.model, .output = flags.output, .json = flags.json, .force = flags.force});
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (!flags.output.empty()) io::require_writable(flags.output, if_exists);
  const io::ModelFile file = open_model(flags.model, Subject::bearing_or_shaft);
  const fit::DataSet data = open_data(flags.data, file.model);
  fit::Calibration c = [&] {
    try {
      return fit::calibrate(file.model, data);
    } catch (const std::invalid_argument& e) {
      refuse_data(flags.model, data, e);
    }
  }();
  if (flags.json) {
    fmt::print("{}", io::calibration_json(c));
  } else if (c.converged()) {
    print(c);
  }
  tell(c.messages);
  if (!c.converged()) {
    say(fmt::format("raceway calibrate: {} after {} steps; {}", fit::name(c.status), c.iterations,
                    flags.output.empty() ? "no result" : flags.output + " is not written"));
    return not_converged;
  }
  if (!flags.output.empty()) {
    std::vector<io::KeyValue> changes;
    for (const fit::ModelParameter& p : fit::free_parameters(c.model))
      if (p.get(c.model) != p.get(file.model))
        for (const std::string& key : io::file_keys(p)) changes.push_back({key, p.get(c.model)});
    io::write_text(flags.output, io::with_values(file.text, changes), if_exists);
    say(flags.output + " written");
  }
  return done;
}

}  // namespace

Run setup_calibrate(CLI::App& command) {
  auto flags = std::make_shared<Flags>();
  command
      .add_option("MODEL", flags->model,
                  "model file (TOML); without DATA also a designation of the catalogue")
      ->required()
      ->type_name("");
  command
      .add_option("DATA", flags->data,
                  "measurements (CSV); without them the catalogue's rigidities")
      ->type_name("");
  command
      .add_option("-o,--output", flags->output,
                  "model file to write: MODEL with the new values, all else as it is")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command.footer(
      "What is fitted stands in the model: [calibration] free, by default f0 and z,\n"
      "of an [arrangement] its preload_N.\n\n"
      "Without DATA the groove conformity, which no maker prints, is fitted to the axial "
      "rigidities\n"
      "that the catalogue prints of the bearing.\n\n"
      "Example:\n  raceway calibrate my.toml rig.csv -o fitted.toml\n"
      "  raceway calibrate \"S 6014 C\" -o my.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
