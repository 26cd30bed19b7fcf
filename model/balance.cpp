#include "model/balance.h"

#include <vector>

#include "friction/contact/balanced_equilibrium.h"
#include "friction/contact/contact_law.h"

namespace raceway::model {

BallTurning ball_turning(const Model& model, const friction::Lubricant& oil, double temperature) {
  if (!model.balanced_balls) return {};
  const auto law = friction::contact::contact_law(model.contact, model.law_values);
  return {.temperature = temperature,
          .viscosity_40C = oil.viscosity_40C(),
          .viscosity_100C = oil.viscosity_100C(),
          .boundary_friction = law.boundary_friction,
          .limiting_traction = law.limiting_traction};
}

bearing::BearingEquilibrium solve_balls(const Model& model, const bearing::Bearing& bearing,
                                        const bearing::OperatingPoint& point,
                                        const bearing::EquilibriumOptions& options,
                                        const friction::Lubricant& oil,
                                        const bearing::BearingEquilibrium* neighbour) {
  if (model.balanced_balls)
    return friction::contact::solve_balanced_equilibrium(
               bearing, point, oil_state(oil, model.contact.oil, point.temperature),
               contact_law(model.contact, model.law_values), options, neighbour)
        .equilibrium;
  return neighbour ? solve_bearing_equilibrium(bearing, point, options, *neighbour)
                   : solve_bearing_equilibrium(bearing, point, options);
}

bearing::ArrangementEquilibrium solve_sets(const Model& model,
                                           const bearing::Arrangement& arrangement,
                                           const bearing::ArrangementCondition& condition,
                                           std::span<const double> temperatures,
                                           const bearing::ArrangementEquilibrium* neighbour) {
  if (!model.balanced_balls)
    return solve_arrangement(arrangement, condition, model.solver, neighbour);
  std::vector<friction::contact::OilState> oils;
  oils.reserve(temperatures.size());
  for (const double t : temperatures)
    oils.push_back(oil_state(model.lubricant, model.contact.oil, t));
  return solve_balanced_arrangement(arrangement, condition, oils,
                                    contact_law(model.contact, model.law_values), model.solver,
                                    neighbour);
}

}  // namespace raceway::model
