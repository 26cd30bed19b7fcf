#pragma once

#include <cmath>

#include "friction/contact/contact_law.h"

namespace raceway::friction::contact {

/// Sums over the contacts of a bearing that a ContactResult needs in addition to the powers. Only
/// contact_law.cpp and many_contacts.cpp use it.
struct ContactSums {
  double slip = 0.0, load = 0.0;
  double holding = unset, over_traction = unset;

  void add(double mean_slip, double mean_friction, double contact_load, double friction_force,
           double weight) {
    slip += weight * contact_load * mean_slip;
    load += weight * contact_load;
    const double asked = std::abs(friction_force) / contact_load;
    holding = std::fmax(holding, asked);
    if (mean_friction > 0.0) over_traction = std::fmax(over_traction, asked / mean_friction);
  }
  void give(ContactResult& r) const {
    r.mean_slip = load > 0.0 ? slip / load : 0.0;
    r.holding_coefficient = holding;
    r.holding_over_traction = over_traction;
  }
};

}  // namespace raceway::friction::contact
