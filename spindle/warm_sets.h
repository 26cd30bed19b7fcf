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

/// Ring temperatures and elongation on which the equilibrium of the bearing sets depends.
struct SetsAsked {
  std::vector<double> inner_ring, outer_ring;  ///< mean temperature of each ring [K]
  double elongation = 0.0;  ///< elongation of the shaft minus the elongation of the housing [m]
};

/// Friction heat, forces, clearance and heat conduction of one bearing.
struct BearingHeat {
  double inner = 0.0, outer = 0.0;  ///< heat produced at each ring [W]
  double force = 0.0;               ///< axial force [N]
  double radial_force = 0.0;        ///< radial force [N]
  double clearance = unset;         ///< diametral clearance s, only for a roller bearing [m]
  /// Thermal conductance of balls or rollers through their contacts [W/K].
  double conductance = 0.0;
  /// Half width of the 95 % error band of power() [W]. The value is 0 unless the friction law of
  /// the bearing is a table with an error band.
  double band = 0.0;
  [[nodiscard]] double power() const { return inner + outer; }
};

/// Equilibrium, forces and friction heat of the bearing sets at given ring temperatures.
///
/// Each bearing has its own ring temperatures, and thermal_shift() computes the change of its
/// dimensions by thermal expansion. Balls and lubricant have the mean temperature of both rings.
/// Friction depends on the axial forces of the warm sets. If the model sets `preload_feedback` to
/// false, friction depends on the forces of the cold sets at the same speed. An effect can
/// interpolate between both cases (SpindleCondition::other_preload_feedback). solve() considers
/// only axial loads. bear() computes the contributions of radial loads to forces, friction and
/// shaft position; these contributions stay constant until the next call of bear().
class WarmSets {
 public:
  /// Mounts the bearing sets. Throws std::invalid_argument if the sets cannot be mounted.
  WarmSets(const model::Model& model, const effects::SpindleCondition& condition);

  /// Sets speed and axial load. Returns false if the cold bearing sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Computes equilibrium and friction heat. Returns false if the sets have no equilibrium, if a
  /// ring temperature is outside 50 to 800 K, if a ring shift exceeds 1 mm or the elongation 10 mm,
  /// or if a friction value is not finite. After such a failure, the previous results remain
  /// unchanged.
  [[nodiscard]] bool solve(const SetsAsked& asked);
  /// Adds the effect of radial loads to the results of the last solve(), at unchanged temperatures.
  /// `bent` is the equilibrium of the bent shaft, and contains the loads on the bearings. If `bent`
  /// is null, only axial loads act. Returns false if a friction value is not finite.
  [[nodiscard]] bool bear(const LoadedShaft* bent);

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] std::span<const BearingHeat> heat() const { return heat_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& sets() const { return sets_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& cold_sets() const { return cold_; }
  [[nodiscard]] const bearing::ArrangementCondition& asked() const { return asked_.sets; }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return balance_.arrangement(); }
  [[nodiscard]] std::size_t bearings() const { return heat_.size(); }
  /// Axial position of the shaft [m] and axial forces of the sets [N], with the contributions of
  /// radial loads.
  [[nodiscard]] double position() const { return sets_.position + more_position_; }
  [[nodiscard]] double front_force() const { return sets_.front_force + more_front_; }
  [[nodiscard]] double rear_force() const { return sets_.rear_force + more_rear_; }
  /// Returns the axial position of the shaft at standstill without load and heat [m].
  [[nodiscard]] double rest() const { return rest_; }

 private:
  [[nodiscard]] bool find_condition(const bearing::OperatingPoint& point,
                                    shaft::ShaftCondition& condition) const;
  /// Load on a bearing, and the equilibrium of its balls, which have unequal loads.
  struct UnevenBalls {
    const bearing::Vector5& load;
    const bearing::BearingEquilibrium& balls;
  };
  /// Returns the friction heat of a bearing. If `uneven` is null, the axial load in `sets` acts on
  /// the bearing, otherwise the load in `uneven`.
  [[nodiscard]] BearingHeat heat_of(std::size_t bearing, const SetsAsked& asked,
                                    const bearing::ArrangementEquilibrium& sets,
                                    const UnevenBalls* uneven = nullptr) const;
  /// Returns the friction heat by the contact law: the weighted mean of the heat in the warm sets
  /// (weight feedback_) and the heat in the cold sets (weight 1 - feedback_).
  [[nodiscard]] BearingHeat heat_of_contacts(std::size_t bearing, double temperature,
                                             const bearing::ArrangementEquilibrium& sets,
                                             const UnevenBalls* uneven, BearingHeat heat) const;
  [[nodiscard]] BearingHeat heat_with_effects(std::size_t bearing, double load, double temperature,
                                              const SetsAsked& asked,
                                              const bearing::ArrangementEquilibrium& sets,
                                              const UnevenBalls* uneven) const;

  model::Model model_;
  model::Steps steps_, friction_;
  bool has_effects_ = false;  ///< true if the model has effects that change friction
  bool has_conditions_ = false;
  /// Weight of the forces of the warm sets in the friction [1]. The forces of the cold sets have
  /// the weight 1 - feedback_.
  double feedback_ = 1.0;
  shaft::ShaftBalance balance_;
  /// Model of each single bearing; empty if no effect changes friction.
  std::vector<model::Model> singles_;
  Inputs inputs_;
  /// `speed_` is the condition of the cold sets, and `asked_` the condition of the warm sets.
  shaft::ShaftCondition speed_, asked_;
  bearing::ArrangementEquilibrium cold_, sets_;
  SetsAsked temperatures_;  ///< temperatures given to the last solve()
  std::vector<BallConduction> conduction_;
  std::vector<BearingHeat> heat_;
  /// Additional heat from radial loads; empty without radial loads.
  std::vector<BearingHeat> more_;
  double more_position_ = 0.0, more_front_ = 0.0, more_rear_ = 0.0;
  double rest_ = 0.0;
};

}  // namespace raceway::spindle
