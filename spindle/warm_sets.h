#pragma once

#include <span>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "effects/spindle_condition.h"
#include "model/model.h"
#include "model/row_predictor.h"
#include "shaft/shaft_balance.h"
#include "spindle/bearing_conduction.h"
#include "spindle/loaded_shaft.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Temperatures and elongation that act on the sets.
struct SetsAsked {
  std::vector<double> inner_ring, outer_ring;  ///< mean temperature of each ring [K]
  double elongation = 0.0;                     ///< shaft relative to the housing [m]
};

/// Friction heat of one bearing, with its forces, clearance and heat conduction.
struct BearingHeat {
  double inner = 0.0, outer = 0.0;  ///< heat produced at each ring [W]
  double force = 0.0;               ///< axial force [N]
  double radial_force = 0.0;        ///< [N]
  double clearance = unset;         ///< diametral clearance s of a roller bearing [m]
  double conductance = 0.0;  ///< conductance of balls or rollers through their contacts [W/K]
  double band = 0.0;         ///< half width of the 95 % band of the heat, from a friction table [W]
  [[nodiscard]] double power() const { return inner + outer; }
};

/// Sets of a spindle at given ring temperatures: equilibrium, forces and friction heat.
///
/// Each bearing has its own ring temperatures (thermal_shift()); balls and lubricant have the mean
/// temperature of the rings, as in the reference data of the tests. Friction depends on the axial
/// forces of the warm sets. If the model sets `preload_feedback` to false, friction depends on the
/// forces of the cold sets at the same speed. The contributions of radial loads to forces, friction
/// and position are kept between two calls of bear().
class WarmSets {
 public:
  /// Throws std::invalid_argument if the sets cannot be mounted.
  WarmSets(const model::Model& model, const effects::SpindleCondition& condition);

  /// Sets the operating conditions of the sets. Returns false if the cold sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Returns false if the sets have no equilibrium; the state is then unchanged.
  [[nodiscard]] bool solve(const SetsAsked& asked);
  /// Adds the bearing loads of the bent shaft to the axial loads, at the temperatures of the last
  /// solve(); null means no bent shaft. Returns false if a friction value is not finite.
  [[nodiscard]] bool bear(const LoadedShaft* bent);

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] std::span<const BearingHeat> heat() const { return heat_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& sets() const { return sets_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& cold_sets() const { return cold_; }
  [[nodiscard]] const bearing::ArrangementCondition& asked() const { return asked_.sets; }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return balance_.arrangement(); }
  [[nodiscard]] std::size_t bearings() const { return heat_.size(); }
  /// Return the position of the shaft and the forces of the sets, including radial loads [m], [N].
  [[nodiscard]] double position() const { return sets_.position + more_position_; }
  [[nodiscard]] double front_force() const { return sets_.front_force + more_front_; }
  [[nodiscard]] double rear_force() const { return sets_.rear_force + more_rear_; }
  /// Returns the position of the shaft at standstill without load and heat [m].
  [[nodiscard]] double rest() const { return rest_; }

 private:
  [[nodiscard]] bool find_condition(const bearing::OperatingPoint& point,
                                    shaft::ShaftCondition& condition) const;
  /// Balls with unequal loads, and the load on the bearing.
  struct UnevenBalls {
    const bearing::Vector5& load;
    const bearing::BearingEquilibrium& balls;
  };
  /// Returns the heat under the axial load of `sets`, or for balls with unequal loads.
  [[nodiscard]] BearingHeat heat_of(std::size_t bearing, const SetsAsked& asked,
                                    const bearing::ArrangementEquilibrium& sets,
                                    const UnevenBalls* uneven = nullptr) const;
  /// Returns the heat interpolated between the contacts in the warm sets and the contacts in the
  /// cold sets.
  [[nodiscard]] BearingHeat heat_of_contacts(std::size_t bearing, double temperature,
                                             const bearing::ArrangementEquilibrium& sets,
                                             const UnevenBalls* uneven, BearingHeat heat) const;
  [[nodiscard]] BearingHeat heat_with_effects(std::size_t bearing, double load, double temperature,
                                              const SetsAsked& asked,
                                              const bearing::ArrangementEquilibrium& sets,
                                              const UnevenBalls* uneven) const;

  model::Model model_;
  model::Steps steps_, friction_;
  bool has_effects_ = false;  ///< true if effects act on friction
  bool has_conditions_ = false;
  double feedback_ = 1.0;  ///< interpolation from cold to warm forces [1]
  shaft::ShaftBalance balance_;
  std::vector<model::Model> singles_;  ///< model of each bearing alone, if effects need one
  Inputs inputs_;
  shaft::ShaftCondition speed_, asked_;  ///< condition at speed only; condition with temperatures
  bearing::ArrangementEquilibrium cold_, sets_;
  SetsAsked temperatures_;  ///< temperatures of the last solve()
  std::vector<BallConduction> conduction_;
  std::vector<BearingHeat> heat_;
  std::vector<BearingHeat> more_;  ///< additional heat from radial loads; empty without them
  double more_position_ = 0.0, more_front_ = 0.0, more_rear_ = 0.0;
  double rest_ = 0.0;
};

}  // namespace raceway::spindle
