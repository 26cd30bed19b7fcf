#pragma once

#include "friction/lubricant.h"
#include "model/model.h"
#include "spindle/layout.h"
#include "spindle/roller_clearance.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

/// Temperatures on which the clearance and friction of a roller bearing depend [K].
struct RollersAsked {
  double inner_ring = unset, outer_ring = unset;  ///< mean temperature of each ring
  double shaft = unset, housing = unset;  ///< temperatures of shaft and housing at the seats
};

/// Clearance, friction heat and heat conduction of a cylindrical roller bearing at the temperatures
/// of its rings and seats.
///
/// Between two calls of take(), heat() assumes that the sums of the roller loads on each ring
/// change linearly with the clearance, down to zero. Friction heat and preload therefore also
/// interact within a time step.
class WarmRollers {
 public:
  WarmRollers(const model::Model& model, const model::RollerOnShaft& rollers, const Layout& layout,
              const BearingPlace& place);

  void set_speed(double speed) { speed_ = speed; }
  /// Returns the diametral operating clearance s [m].
  [[nodiscard]] double clearance(const RollersAsked& asked) const;
  /// Stores the roller loads from an equilibrium that includes the bending of the shaft.
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
  /// Results of the last call of take(): sum of the roller loads on each ring [N], and thermal
  /// conductance [W/K].
  double inner_sum_ = unset, outer_sum_ = unset, conductance_ = unset;
};

}  // namespace raceway::spindle
