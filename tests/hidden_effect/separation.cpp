#include "tests/hidden_effect/separation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/hidden_effect/likelihood.h"

namespace hidden_effect {

Visibility visibility(const Rig& rig) {
  const std::vector<std::string_view> right = rig.accepted();
  Eigen::VectorXd torques(static_cast<Eigen::Index>(rig.train.size())), variance = torques;
  for (Eigen::Index i = 0; i < torques.size(); ++i) {
    const Reading& r = rig.train[static_cast<std::size_t>(i)];
    torques[i] = r.torque;
    variance[i] = r.sigma * r.sigma;
  }
  const Likelihood likelihood(rig, rig.train, torques, variance.asDiagonal());
  Visibility v;
  v.detection = v.separation = likelihood.least({});
  double odds_against = 0.0;
  for (const Effect& candidate : catalogue_effects()) {
    if (std::find(right.begin(), right.end(), candidate.id) != right.end()) continue;
    if (rig.setup.law.contacts && within_contacts(candidate.id)) continue;
    const double left = likelihood.least({.effects = {&candidate}});
    const double wins = 0.5 * std::erfc(-std::sqrt(std::max(left, 0.0) / 8.0));
    odds_against += (1.0 - wins) / wins;
    if (left >= v.separation) continue;
    v.separation = left;
    v.nearest = candidate.id;
  }
  v.right_first = 1.0 / (1.0 + odds_against);
  return v;
}

}  // namespace hidden_effect
