#include "cli/calibrate_conformity.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/text_table.h"
#include "record/units.h"
#include "session/conformity.h"

namespace raceway::cli {
namespace {

void print(const std::string& bearing, const shaft::ConformityFit& fit) {
  fmt::print("{}: groove conformity from the axial rigidity of a preloaded pair at rest\n\n",
             bearing);
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

}  // namespace

int calibrate_conformity(const std::string& model, const OutputFlags& flags, bool json) {
  flags.require_writable();
  const session::CatalogueConformity found = session::catalogue_conformity(messages(), model);
  if (json)
    put_document(found.json());
  else if (found.fit.status == fit::FitStatus::converged)
    print(found.bearing, found.fit);
  if (!found.found()) {
    complain(fmt::format("raceway calibrate: {}; {}", found.problem(),
                         flags.output.empty() ? "no result" : flags.output + " is not written"));
    return not_converged;
  }
  warn(found.warnings());
  flags.put_model(found.text, found.files);
  return done;
}

}  // namespace raceway::cli
