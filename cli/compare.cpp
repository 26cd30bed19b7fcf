#include "fit/compare.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/text_table.h"
#include "io/error.h"
#include "io/results.h"

namespace raceway::cli {
namespace {

struct Flags {
  std::vector<std::string> files;  // models, then the data
  bool json = false;
};

std::string range_text(const fit::ErrorRange& r) {
  switch (r.variable) {
    case fit::Variable::speed:
      return fmt::format("speed {:.0f} to {:.0f} rpm", r.from / rpm, r.to / rpm);
    case fit::Variable::axial_load:
      return r.from == r.to ? fmt::format("axial load {:.6g} N", r.from)
                            : fmt::format("axial load {:.6g} to {:.6g} N", r.from, r.to);
    case fit::Variable::radial_load:
      return r.from == r.to ? fmt::format("radial load {:.6g} N", r.from)
                            : fmt::format("radial load {:.6g} to {:.6g} N", r.from, r.to);
    case fit::Variable::temperature:
      return fmt::format("temperature {:.1f} to {:.1f} C", celsius(r.from), celsius(r.to));
    case fit::Variable::run:
      return "run " + r.run;
  }
  return {};
}

std::string noise_text(const fit::Comparison& c) {
  if (std::isnan(c.noise.rms)) return "not known (no std_Nmm column, no repeated rows)";
  return fmt::format("{} Nmm ({})", number(c.noise.rms / N_mm, 3), fit::name(c.noise.source));
}

void print(const std::string& model, const std::string& data, const fit::Comparison& c) {
  fmt::print("{} against {}: {} rows, friction torque\n\n", model, data, c.rows);
  fmt::print("RMS error       {:>10} Nmm    mean error (bias) {:>10} Nmm\n", number(c.rmse / N_mm),
             number(c.bias / N_mm, 3));
  fmt::print("mean abs error  {:>10} Nmm    largest error     {:>10} Nmm\n", number(c.mae / N_mm),
             number(c.max_abs / N_mm));
  fmt::print("fit             {:>10} %\n", number(c.fit_percent, 3));
  fmt::print("noise of the data: {}\n", noise_text(c));
  if (!std::isnan(c.lack_of_fit.p_value))
    fmt::print("lack of fit: statistic {}, p {:.1e}\n", number(c.lack_of_fit.statistic, 3),
               c.lack_of_fit.p_value);
  TextTable where({{"where it fails", "", true}, {"rows", ""}, {"RMS", "Nmm"}, {"bias", "Nmm"}});
  for (std::size_t i = 0; i < std::min<std::size_t>(c.where.size(), 8); ++i) {
    const fit::ErrorRange& r = c.where[i];
    where.add({range_text(r), fmt::format("{}", r.rows), number(r.rmse / N_mm, 3),
               fmt::format("{:+.3g}", r.bias / N_mm)});
  }
  if (!c.where.empty()) fmt::print("\n{}", where.text(terminal_width()));
  TextTable worst({{"worst rows: line", "", true},
                   {"predicted", "Nmm"},
                   {"measured", "Nmm"},
                   {"difference", "Nmm"},
                   {"in sigma", ""}});
  for (const fit::RowError& r : c.worst)
    worst.add({fmt::format("{}", r.line), number(r.predicted / N_mm), number(r.measured / N_mm),
               fmt::format("{:+.3g}", r.residual / N_mm),
               std::isnan(r.sigmas) ? "-" : fmt::format("{:+.1f}", r.sigmas)});
  fmt::print("\n{}\n{}\n", worst.text(terminal_width()), c.statement);
}

void print_ladder(const std::vector<std::string>& models,
                  const std::vector<fit::Comparison>& comparisons) {
  TextTable ladder({{"model", "", true}, {"RMS", "Nmm"}, {"bias", "Nmm"}, {"fit", "%"}});
  for (std::size_t i = 0; i < models.size(); ++i)
    ladder.add({models[i], number(comparisons[i].rmse / N_mm),
                number(comparisons[i].bias / N_mm, 3), number(comparisons[i].fit_percent, 3)});
  fmt::print("{}noise of the data: {}\n", ladder.text(terminal_width()),
             noise_text(comparisons[0]));
}

int run(const Flags& flags) {
  const std::string& data_file = flags.files.back();
  const std::vector<std::string> models(flags.files.begin(), flags.files.end() - 1);
  std::vector<io::ModelFile> files;
  for (const std::string& m : models) files.push_back(open_model(m));
  std::vector<fit::Comparison> comparisons;
  // The rig of the first model fills in what the data do not carry.
  const fit::DataSet data = open_data(data_file, files[0].model.rig);
  for (std::size_t i = 0; i < models.size(); ++i) {
    try {
      comparisons.push_back(fit::compare(files[i].model, data));
    } catch (const std::invalid_argument& e) {
      throw io::InputError(models[i] + " against " + data_file + ": " + e.what());
    }
    if (const auto& missing = comparisons.back().rows_not_predicted; !missing.empty())
      tell({fmt::format("{}: {} rows have no equilibrium and are left out, the first in line {}",
                        models[i], missing.size(), missing.front())});
  }
  if (flags.json) {
    fmt::print("{}", io::comparison_json(models, comparisons, data));
  } else if (models.size() == 1) {
    print(models[0], data_file, comparisons[0]);
  } else {
    print_ladder(models, comparisons);
  }
  return done;
}

}  // namespace

Run setup_compare(CLI::App& command) {
  auto flags = std::make_shared<Flags>();
  command
      .add_option("MODEL... DATA", flags->files,
                  "one or more model files (TOML), then measurements (CSV)")
      ->required()
      ->expected(2, 1000);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command.footer(
      "Errors are prediction minus reading.\n\n"
      "Example:\n  raceway compare my.toml rig.csv");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
