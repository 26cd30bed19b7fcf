#include "fit/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/report_flag.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"
#include "fit/calibrate.h"
#include "fit/quantity.h"
#include "io/error.h"
#include "io/report.h"
#include "io/results.h"

namespace raceway::cli {
namespace {

struct Flags {
  std::vector<std::string> files;  // models, then the data
  std::vector<std::string> refit;  // parameters fitted to the data before comparing
  bool json = false, force = false;
  ReportFlag report;
};

/// Differences show the decimals of the error they belong to: rounding noise reads 0.
std::string difference(double value, const fit::Comparison& c, bool sign = true) {
  const double unit = fit::text_of(c.quantity).factor;
  return beside(value / unit, c.rmse / unit, 3, sign);
}

std::string range_text(const fit::ErrorRange& r) {
  if (r.variable == fit::Variable::run) return r.run.empty() ? "no run_id" : "run " + r.run;
  std::string_view what, unit = "N";
  double from = r.from, to = r.to;
  switch (r.variable) {
    case fit::Variable::speed:
      what = "speed", unit = "rpm", from /= rpm, to /= rpm;
      break;
    case fit::Variable::axial_load:
      what = "axial load";
      break;
    case fit::Variable::radial_load:
      what = "radial load";
      break;
    case fit::Variable::preload:
      what = "preload";
      break;
    default:
      what = "temperature", unit = "C", from = celsius(from), to = celsius(to);
  }
  const std::string low = fmt::format("{:.4g}", from), high = fmt::format("{:.4g}", to);
  return low == high ? fmt::format("{} {} {}", what, low, unit)
                     : fmt::format("{} {} to {} {}", what, low, high, unit);
}

std::string noise_text(const fit::Comparison& c) {
  const fit::QuantityText q = fit::text_of(c.quantity);
  if (std::isnan(c.noise.rms))
    return fmt::format("not known (no column std_{}, no repeated rows)", q.key_unit);
  return fmt::format("{} {} ({})", number(c.noise.rms / q.factor, 3), q.unit,
                     fit::name(c.noise.source));
}

std::string p_text(double p) {
  return p < 1e-300 ? "p < 1e-300"
         : p < 1e-3 ? fmt::format("p = {:.0e}", p)
                    : fmt::format("p = {:.2g}", p);
}

void print(const std::string& model, const std::string& data, const fit::Comparison& c) {
  const fit::QuantityText q = fit::text_of(c.quantity);
  const std::string unit(q.unit);
  fmt::print("{} against {}: {} row{}, {}\n\n", model, data, c.rows, c.rows == 1 ? "" : "s",
             q.in_words);
  fmt::print("RMS error       {:>10} {}   mean error (bias) {:>10} {}\n", number(c.rmse / q.factor),
             unit, difference(c.bias, c), unit);
  fmt::print("mean abs error  {:>10} {}   largest error     {:>10} {}\n", number(c.mae / q.factor),
             unit, number(c.max_abs / q.factor), unit);
  if (!std::isnan(c.fit_percent))
    fmt::print("fit             {:>10} %\n", number(c.fit_percent, 3));
  fmt::print("noise of the data: {}\n", noise_text(c));
  if (!std::isnan(c.lack_of_fit.p_value))
    fmt::print("lack of fit: {} = {}, {}\n",
               c.noise.source == fit::NoiseSource::repeats ? "F" : "chi2/dof",
               number(c.lack_of_fit.statistic, 3), p_text(c.lack_of_fit.p_value));
  TextTable where({{"where it fails", "", true}, {"rows", ""}, {"RMS", unit}, {"bias", unit}});
  for (std::size_t i = 0; i < std::min<std::size_t>(c.where.size(), 8); ++i) {
    const fit::ErrorRange& r = c.where[i];
    where.add({range_text(r), fmt::format("{}", r.rows), difference(r.rmse, c, false),
               difference(r.bias, c)});
  }
  if (!c.where.empty()) fmt::print("\n{}", where.text(terminal_width()));
  TextTable worst({{"worst rows", "", true},
                   {"predicted", unit},
                   {"measured", unit},
                   {"difference", unit},
                   {"in sigma", ""}});
  for (const fit::RowError& r : c.worst)
    worst.add({fmt::format("line {}", r.line), difference(r.predicted, c, false),
               difference(r.measured, c, false), difference(r.residual, c),
               std::isnan(r.sigmas) ? "-" : fmt::format("{:+.1f}", r.sigmas)});
  fmt::print("\n{}\n{}\n", worst.text(terminal_width()),
             in_colour(c.statement,
                       c.judgement == fit::Judgement::structure ? Colour::bad : Colour::good));
}

/// The model with `names` fitted to the data and everything else as it stands.
fit::Model refitted(const fit::Model& model, const std::vector<std::string>& names,
                    const fit::DataSet& data) {
  fit::Model wanted = model;
  wanted.free = names;
  const fit::Calibration calibration = fit::calibrate(wanted, data);
  if (!calibration.converged())
    throw std::invalid_argument("the refit of " + fmt::format("{}", fmt::join(names, ", ")) +
                                " does not converge");
  return calibration.model;
}

void print_ladder(const std::vector<std::string>& models,
                  const std::vector<fit::Comparison>& comparisons) {
  constexpr std::size_t bar_width = 24;
  const fit::QuantityText q = fit::text_of(comparisons[0].quantity);
  TextTable ladder({{"model", "", true},
                    {"RMS", std::string(q.unit)},
                    {"bias", std::string(q.unit)},
                    {"fit", "%"},
                    {"", std::isnan(comparisons[0].noise.rms) ? "" : "| noise", true}});
  double worst = 0.0;
  for (const fit::Comparison& c : comparisons) worst = std::max(worst, c.rmse);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const fit::Comparison& c = comparisons[i];
    ladder.add({models[i], number(c.rmse / q.factor), difference(c.bias, c),
                number(c.fit_percent, 3), bar(c.rmse, worst, bar_width, c.noise.rms)});
  }
  fmt::print("{}noise of the data: {}\n", ladder.text(terminal_width()),
             noise_text(comparisons[0]));
}

/// What the rows lack is filled in from the first model; another rig would need other rows.
void note_other_rigs(const std::vector<io::ModelFile>& files) {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const fit::Rig& first = files[0].model.rig;
  for (const io::ModelFile& file : files) {
    const fit::Rig& rig = file.model.rig;
    if (!same(rig.inertia, first.inertia) || !same(rig.axial_load, first.axial_load) ||
        !same(rig.radial_load, first.radial_load) || !same(rig.temperature, first.temperature) ||
        !same(rig.minimum_speed, first.minimum_speed))
      tell({fmt::format("{}: its [rig] differs from that of {}, which is used for all models",
                        file.source, files[0].source)});
    const auto& shaft = file.model.shaft;
    const auto& first_shaft = files[0].model.shaft;
    if (shaft && first_shaft && shaft->external_load != first_shaft->external_load)
      tell(
          {fmt::format("{}: its external_load_N differs from that of {}, which is used for all "
                       "models",
                       file.source, files[0].source)});
  }
}

int run(const Flags& flags) {
  if (flags.files.size() < 2)
    throw io::InputError(
        "raceway compare: DATA is missing: one model or more come first, the measurements last");
  const std::string& data_file = flags.files.back();
  const std::vector<std::string> models(flags.files.begin(), flags.files.end() - 1);
  flags.report.check(flags.force);
  std::vector<io::ModelFile> files;
  for (const std::string& m : models) files.push_back(open_model(m, Subject::bearing_or_shaft));
  std::vector<fit::Comparison> comparisons;
  note_other_rigs(files);
  const fit::DataSet data = open_data(data_file, files[0].model);
  std::vector<fit::Model> compared;
  for (std::size_t i = 0; i < models.size(); ++i) {
    try {
      const fit::Model& model = files[i].model;
      compared.push_back(flags.refit.empty() ? model : refitted(model, flags.refit, data));
      comparisons.push_back(
          fit::compare(compared.back(), data, static_cast<int>(flags.refit.size())));
    } catch (const std::invalid_argument& e) {
      refuse_data(models[i], data, e);
    }
    if (const auto& missing = comparisons.back().rows_not_predicted; !missing.empty())
      tell({fmt::format("{}: {} rows have no equilibrium and are left out, the first in line {}",
                        models[i], missing.size(), missing.front())});
  }
  if (!flags.refit.empty())
    tell({fmt::format("{} refitted to {} in each model; all else as in the files",
                      fmt::join(flags.refit, " and "), data_file)});
  if (flags.json) {
    fmt::print("{}", io::comparison_json(models, comparisons, data));
  } else if (models.size() == 1) {
    print(models[0], data_file, comparisons[0]);
  } else {
    print_ladder(models, comparisons);
  }
  flags.report.write([&] { return io::comparison_report(models, compared, comparisons, data); },
                     flags.force);
  return done;
}

}  // namespace

Run setup_compare(CLI::App& command) {
  auto flags = std::make_shared<Flags>();
  command.add_option("FILES", flags->files, "MODEL [MODEL2 ...] DATA: models (TOML), then one CSV")
      ->type_name("")
      ->expected(-1);
  command.add_option("--refit", flags->refit, "fit these to DATA first, such as f0,z (by comma)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command.add_flag("--force", flags->force, "replace the page if it exists");
  command.footer(
      "Errors are prediction minus reading.\n\n"
      "Example:\n  raceway compare my.toml rig.csv\n"
      "  raceway compare my.toml fitted.toml rig.csv --report page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
