#include "results/conformity_results.h"

#include "record/units.h"
#include "text/detail/json_text.h"

namespace raceway::results {

std::string conformity_json(const std::string& bearing, const shaft::ConformityFit& fit) {
  text::json classes = text::json::array();
  for (const shaft::PairRigidity& c : fit.classes)
    classes.push_back({{"class", c.preload_class},
                       {"preload_N", c.preload},
                       {"printed_N_um", c.printed / N_per_um},
                       {"computed_N_um", c.computed / N_per_um},
                       {"difference_percent", 100.0 * c.deviation()}});
  const text::json document = {{"bearing", bearing},
                               {"conformity",
                                {{"value", fit.conformity},
                                 {"std", fit.std},
                                 {"unit", "1"},
                                 {"lower", shaft::lowest_conformity},
                                 {"upper", shaft::highest_conformity},
                                 {"at_bound", fit.at_bound != record::Bound::none}}},
                               {"rms_percent", 100.0 * fit.rms},
                               {"classes", classes},
                               {"report", {{"status", fit::name(fit.status)}}}};
  return text::text(document);
}

}  // namespace raceway::results
