#include "cli/calibrate_conformity.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "cli/text_table.h"
#include "files/model_file.h"
#include "results/conformity_results.h"
#include "session/open_input.h"
#include "shaft/conformity.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

/// Root mean square of ln(computed/printed) above which one conformity does not explain the
/// classes.
constexpr double poor = 0.05;

struct Start {
  files::CatalogueBearing row;
  std::string text;                       ///< of the model to be changed
  std::vector<files::NamedFile> files{};  ///< that it names
};

Start start_of(const std::string& model) {
  std::error_code ignored;
  if (model != "-" && !model.ends_with(".toml") && !std::filesystem::exists(model, ignored)) {
    files::CatalogueBearing row = files::find_bearing(files::read_catalogues(), model);
    std::string text = files::new_model_text(row);
    return {.row = std::move(row), .text = std::move(text)};
  }
  files::ModelFile file = session::open_model(messages(), model);
  if (file.catalogue.empty())
    throw text::InputError(
        fmt::format("raceway calibrate: DATA is missing; without measurements {} needs catalogue = "
                    "\"NAME\" "
                    "under [bearing], whose printed rigidities the conformity is fitted to",
                    model),
        {.file = model, .key = "catalogue"});
  return {files::find_bearing(files::read_catalogues(), file.catalogue), std::move(file.text),
          std::move(file.files)};
}

std::vector<shaft::PairRigidity> classes_of(const files::CatalogueBearing& row) {
  std::vector<shaft::PairRigidity> classes;
  for (const auto& [name, preload] :
       {std::pair{"L", &row.light}, {"M", &row.medium}, {"S", &row.strong}})
    if (preload->force > 0.0 && preload->axial_rigidity > 0.0)
      classes.push_back(
          {.preload_class = name, .preload = preload->force, .printed = preload->axial_rigidity});
  if (classes.empty())
    throw text::InputError(row.full_name() +
                               ": the catalogue prints no axial rigidity at a preload, so the "
                               "conformity cannot be fitted",
                           {.key = "catalogue"});
  return classes;
}

void print(const files::CatalogueBearing& row, const shaft::ConformityFit& fit) {
  fmt::print("{}: groove conformity from the axial rigidity of a preloaded pair at rest\n\n",
             row.full_name());
  TextTable table({{"class", "", true},
                   {"preload", "N"},
                   {"printed", "N/um"},
                   {"computed", "N/um"},
                   {"difference", "%"}});
  for (const shaft::PairRigidity& c : fit.classes)
    table.add({c.preload_class, number(c.preload, 4), number(c.printed / N_per_um, 4),
               number(c.computed / N_per_um, 4), beside(100.0 * c.deviation(), 1.0, 2, true)});
  fmt::print("{}\n", table.text(terminal_width()));
  fmt::print("conformity of both grooves  {:.5f}{}\n", fit.conformity,
             std::isnan(fit.std) ? "" : fmt::format(" +- {}", number(fit.std, 2)));
}

std::string names_of(const shaft::ConformityFit& fit) {
  std::string names;
  for (const shaft::PairRigidity& c : fit.classes)
    names += (names.empty() ? "" : ", ") + c.preload_class;
  return names;
}

}  // namespace

int calibrate_conformity(const std::string& model, const OutputFlags& flags, bool json) {
  flags.require_writable();
  const Start start = start_of(model);
  // The rigidities are printed for steel balls and the row as it stands, whatever the model
  // changes.
  const shaft::ConformityFit fit = shaft::fit_conformity(
      {start.row.geometry, bearing::steel(), bearing::steel()}, classes_of(start.row));
  const bool found = fit.status == fit::FitStatus::converged && fit.at_bound == record::Bound::none;
  if (json)
    put_document(results::conformity_json(start.row.full_name(), fit));
  else if (fit.status == fit::FitStatus::converged)
    print(start.row, fit);
  if (!found) {
    complain(
        fmt::format("raceway calibrate: no conformity from {} to {} has the printed rigidities; {}",
                    shaft::lowest_conformity, shaft::highest_conformity,
                    flags.output.empty() ? "no result" : flags.output + " is not written"));
    return not_converged;
  }
  if (fit.rms > poor)
    warn(
        {fmt::format("with one conformity, the rigidities differ from the printed ones by {:.2g} % "
                     "(rms): use it with care",
                     100.0 * fit.rms)});
  if (flags.output.empty()) return done;
  const double shown = std::round(fit.conformity * 1e5) / 1e5;  // far below its standard error
  const std::string origin =
      fmt::format("fitted to the catalogue's rigidity at preload {}{}", names_of(fit),
                  std::isnan(fit.std) ? "" : fmt::format(", std {}", number(fit.std, 1)));
  flags.put_model(files::with_values(start.text,
                                     std::vector<files::KeyValue>{
                                         {"bearing.inner_conformity", shown, origin},
                                         {"bearing.outer_conformity", shown, "the same for both"}}),
                  start.files);
  return done;
}

}  // namespace raceway::cli
