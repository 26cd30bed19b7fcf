#include "results/kinematic_results.h"

#include <cmath>

#include "text/detail/json_text.h"

namespace raceway::results {
namespace {

/// A speed without the rounding of a change of unit: 6000 rpm are not 6000.000000000001.
double in_rpm(double speed) { return std::round(speed / rpm * 1e6) / 1e6; }

}  // namespace

std::string kinematic_law_json(const shaft::KinematicLawFit& fit, const std::string& statement,
                               const std::optional<LawAtSpeed>& at) {
  text::json parameters = text::json::object();
  for (const record::Parameter& p : fit.parameters)
    parameters[p.name] = {{"value", p.value},
                          {"std", p.std},
                          {"unit", p.unit},
                          {"at_bound", p.at_bound != record::Bound::none},
                          {"identifiable", p.identifiable}};
  text::json document = {
      {"law", "u = A n^(1 - B exp(-C n)), u in um, n in rpm"},
      {"parameters", parameters},
      {"correlation",
       {{"A_B", fit.correlation(0, 1)},
        {"A_C", fit.correlation(0, 2)},
        {"B_C", fit.correlation(1, 2)}}},
      {"mae_um", fit.mae / um},
      {"max_abs_um", fit.max_abs / um},
      {"max_abs_at_rpm", in_rpm(fit.speed_of_max_abs)},
      {"scatter_um", fit.scatter / um},
      {"rows", fit.rows},
      {"rows_at_standstill", fit.rows_at_standstill},
      {"valid_from_rpm", in_rpm(fit.law.lowest_speed)},
      {"valid_to_rpm", in_rpm(fit.law.highest_speed)},
      {"verdict", shaft::name(fit.verdict)},
      {"statement", statement},
      {"notes", nullptr},
      {"report", {{"status", fit::name(fit.status)}, {"iterations", fit.iterations}}}};
  text::put_notes(document, "notes", fit.notes);
  if (at)
    document["at"] = {{"speed_rpm", in_rpm(at->speed)},
                      {"axial_displacement_um", at->value.displacement / um},
                      {"slope_um_rpm", at->value.slope / (um / rpm)}};
  return text::text(std::move(document));
}

}  // namespace raceway::results
