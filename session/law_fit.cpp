#include "session/law_fit.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "session/law_statement.h"
#include "text/error.h"

namespace raceway::session {
namespace {

std::optional<results::LawAtSpeed> law_at(double speed_rpm, const shaft::KinematicLaw& law) {
  if (std::isnan(speed_rpm)) return std::nullopt;
  const results::LawAtSpeed at{speed_rpm * rpm, evaluate(law, speed_rpm * rpm)};
  if (!at.value.inside)
    throw text::InputError(fmt::format("--at = {:.10g} rpm: the law is valid only within the "
                                       "speeds of the displacement curve, {:.10g} to {:.10g} rpm",
                                       speed_rpm, law.lowest_speed / rpm, law.highest_speed / rpm),
                           {.key = "--at"});
  return at;
}

}  // namespace

std::string LawFit::statement(const std::string& table) const { return law_statement(fit, table); }

std::string LawFit::json(const std::string& table) const {
  return results::kinematic_law_json(fit, statement(table), at);
}

LawFit fit_law(Messages& messages, const Source& curve, const Reading& reading, double at_rpm) {
  LawFit result;
  result.curve = files::read_displacement_curve(curve, reading.options());
  messages.say(result.curve.notes);
  try {
    result.fit = shaft::fit_kinematic_law(result.curve.points);
  } catch (const std::invalid_argument& e) {
    throw text::InputError(result.curve.source + ": " + e.what(), {.file = result.curve.source});
  }
  messages.say(result.fit.notes);
  result.at = law_at(at_rpm, result.fit.law);
  return result;
}

}  // namespace raceway::session
