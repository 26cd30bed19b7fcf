#pragma once

#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "friction/contact/contact_law.h"
#include "model/prediction.h"

namespace raceway::session {

/// Returns one line on film and friction: "full film (lambda 15.7), rolling of the oil is 98 % of
/// the torque of the contacts".
[[nodiscard]] std::string judgement(const friction::contact::ContactResult& result);

/// Returns the reason why balls of another material change the torque of the contact law. The text
/// compares the bearing with the same bearing with steel balls at the same point. The text is empty
/// for steel balls, for other laws, and at points without equilibrium.
[[nodiscard]] std::string balls_statement(const model::Model& model,
                                          const bearing::OperatingPoint& point);

/// Returns notes on a bearing in equilibrium, one line each: a load below which balls may skid, a
/// gyroscopic moment that friction cannot balance, and a life outside the standard.
[[nodiscard]] std::vector<std::string> notes_on_state(const model::Model& model,
                                                      const bearing::Bearing& bearing,
                                                      const bearing::OperatingPoint& point,
                                                      const model::FrictionPrediction& prediction);

}  // namespace raceway::session
