#pragma once

#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "friction/contact/contact_law.h"
#include "model/prediction.h"

namespace raceway::session {

/// Returns one line that describes film and friction, such as "full film (smallest lambda 15.7);
/// largest part of the friction torque: rolling resistance of the oil, 98 %". Lambda is the film
/// ratio.
[[nodiscard]] std::string judgement(const friction::contact::ContactResult& result);

/// Compares the torque of the contact law with the torque of the same bearing with steel balls at
/// the same operating point, and gives the values that cause the difference: centrifugal force,
/// load at the outer race, and elastic modulus. The text is empty for steel balls, for other
/// friction laws, for shafts, and at operating points without equilibrium.
[[nodiscard]] std::string balls_statement(const model::Model& model,
                                          const bearing::OperatingPoint& point);

/// Returns notes on a bearing in equilibrium, one line each: a load at which balls may skid, a
/// gyroscopic moment that friction cannot balance, and a modified rating life that is not
/// calculated, because ISO 281 has no a_ISO for the ball material.
[[nodiscard]] std::vector<std::string> notes_on_state(const model::Model& model,
                                                      const bearing::Bearing& bearing,
                                                      const bearing::OperatingPoint& point,
                                                      const model::FrictionPrediction& prediction);

}  // namespace raceway::session
