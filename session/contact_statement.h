#pragma once

#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "friction/contact/contact_law.h"
#include "model/prediction.h"

namespace raceway::session {

/// One line on film and friction: "full film (lambda 15.7), rolling of the oil is 98 % of the
/// torque of the contacts".
[[nodiscard]] std::string judgement(const friction::contact::ContactResult& result);

/// Explains why balls that are not of steel change the torque of the contact law, compared with the
/// same bearing with steel balls at that point; empty for steel balls, other laws and points
/// without balance.
[[nodiscard]] std::string balls_statement(const model::Model& model,
                                          const bearing::OperatingPoint& point);

/// Notes for a user of a bearing in balance, one line each: a load below which its balls may skid,
/// a gyroscopic moment that no friction holds, a life that no standard defines.
[[nodiscard]] std::vector<std::string> notes_on_state(const model::Model& model,
                                                      const bearing::Bearing& bearing,
                                                      const bearing::OperatingPoint& point,
                                                      const model::FrictionPrediction& prediction);

}  // namespace raceway::session
