#pragma once

#include "friction/lubricant.h"
#include "model/model.h"
#include "spindle/layout.h"
#include "spindle/roller_clearance.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

/// Temperatures that a roller bearing on its seats feels [K].
struct RollersAsked {
  double inner_ring = unset, outer_ring = unset;  ///< mean of each ring
  double shaft = unset, housing = unset;          ///< of what the seats sit on
};

/// A cylindrical roller bearing of a spindle at the temperatures of its rings and seats: clearance,
/// friction heat, conduction.
///
/// What the rollers carry is held from one take() to the next, and moves with the clearance along
/// its tangent: heat and preload drive each other within a time step too.
class WarmRollers {
 public:
  WarmRollers(const model::Model& model, const model::RollerOnShaft& rollers, const Layout& layout,
              const BearingPlace& place);

  void set_speed(double speed) { speed_ = speed; }
  /// s in operation [m].
  [[nodiscard]] double clearance(const RollersAsked& asked) const;
  /// Takes what the rollers carry.
  void take(const bearing::RollerEquilibrium& rollers);
  [[nodiscard]] BearingHeat heat(const RollersAsked& asked) const;
  [[nodiscard]] const bearing::RollerEquilibrium& rollers() const { return taken_; }

 private:
  model::RollerOnShaft bearing_;
  friction::Lubricant lubricant_;
  RollerSeats seats_;
  double mounted_at_;  ///< [K]
  double roller_conductivity_;
  double speed_ = 0.0;
  bearing::RollerEquilibrium taken_;
  double inner_sum_ = unset, outer_sum_ = unset, conductance_ = unset;  ///< of taken_
};

}  // namespace raceway::spindle
