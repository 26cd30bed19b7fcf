#include "session/conformity.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "files/model_file.h"
#include "results/conformity_results.h"
#include "session/open_input.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::session {
namespace {

/// Root mean square of ln(computed/printed) above which one conformity does not explain the
/// classes.
constexpr double poor = 0.05;

struct Start {
  files::CatalogueBearing row;
  std::string text;                       ///< of the model to be changed
  std::vector<files::NamedFile> files{};  ///< that it names
};

Start start_of(Messages& messages, const std::string& model) {
  std::error_code ignored;
  if (model != "-" && !model.ends_with(".toml") && !std::filesystem::exists(model, ignored)) {
    files::CatalogueBearing row = files::find_bearing(files::read_catalogues(), model);
    std::string text = files::new_model_text(row);
    return {.row = std::move(row), .text = std::move(text)};
  }
  files::ModelFile file = open_model(messages, model);
  if (file.catalogue.empty())
    throw text::InputError(
        fmt::format("raceway calibrate: DATA is missing. To fit the conformity to the rigidities "
                    "in the catalogue instead, {} needs catalogue = \"NAME\" under [bearing]",
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
                               ": the catalogue has no axial rigidity for this bearing, so the "
                               "conformity cannot be fitted",
                           {.key = "catalogue"});
  return classes;
}

std::string with_conformity(const std::string& text, const shaft::ConformityFit& fit) {
  std::string names;
  for (const shaft::PairRigidity& c : fit.classes)
    names += (names.empty() ? "" : ", ") + c.preload_class;
  const double shown = std::round(fit.conformity * 1e5) / 1e5;  // far below its standard error
  const std::string origin = fmt::format(
      "fitted to the catalogue rigidity of preload class {}{}", names,
      std::isnan(fit.std) ? "" : fmt::format(", standard error {}", text::number(fit.std, 1)));
  return files::with_values(
      text, std::vector<files::KeyValue>{
                {"bearing.inner_conformity", shown, origin},
                {"bearing.outer_conformity", shown, "the same value for both grooves"}});
}

}  // namespace

bool CatalogueConformity::found() const {
  return fit.status == fit::FitStatus::converged && fit.at_bound == record::Bound::none;
}

std::string CatalogueConformity::problem() const {
  return found() ? std::string()
                 : fmt::format("no conformity from {} to {} gives the rigidities of the catalogue",
                               shaft::lowest_conformity, shaft::highest_conformity);
}

std::vector<std::string> CatalogueConformity::warnings() const {
  if (!found() || !(fit.rms > poor)) return {};
  return {
      fmt::format("the rigidities with this conformity differ from the rigidities of the catalogue "
                  "by {:.2g} % (RMS): use the conformity with care",
                  100.0 * fit.rms)};
}

std::string CatalogueConformity::json() const { return results::conformity_json(bearing, fit); }

CatalogueConformity catalogue_conformity(Messages& messages, const std::string& model) {
  Start start = start_of(messages, model);
  // The rigidities are printed for steel balls and the row as it stands, whatever the model
  // changes.
  CatalogueConformity answer{
      .bearing = start.row.full_name(),
      .fit = shaft::fit_conformity({start.row.geometry, bearing::steel(), bearing::steel()},
                                   classes_of(start.row)),
      .files = std::move(start.files)};
  if (answer.found()) answer.text = with_conformity(start.text, answer.fit);
  return answer;
}

}  // namespace raceway::session
