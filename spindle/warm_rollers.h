#pragma once

#include "friction/lubricant.h"
#include "model/model.h"
#include "spindle/layout.h"
#include "spindle/roller_clearance.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

/// Temperatures that act on a roller bearing on its seats [K].
struct RollersAsked {
  double inner_ring = unset, outer_ring = unset;  ///< mean temperature of each ring
  double shaft = unset, housing = unset;          ///< temperatures of the parts at the seats
};

/// A cylindrical roller bearing of a spindle at the temperatures of its rings and seats: clearance,
/// friction heat and conduction.
///
/// Between two calls of take(), the roller loads change only linearly with the clearance. Heat and
/// preload therefore also interact within a time step.
class WarmRollers {
 public:
  WarmRollers(const model::Model& model, const model::RollerOnShaft& rollers, const Layout& layout,
              const BearingPlace& place);

  void set_speed(double speed) { speed_ = speed; }
  /// Returns the operating clearance s [m].
  [[nodiscard]] double clearance(const RollersAsked& asked) const;
  /// Stores the roller loads.
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
  double inner_sum_ = unset, outer_sum_ = unset, conductance_ = unset;  ///< values for taken_
};

}  // namespace raceway::spindle
