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

/// Temperatures that the sets feel.
struct SetsAsked {
  std::vector<double> inner_ring, outer_ring;  ///< mean of each ring [K]
  double elongation = 0.0;                     ///< of the shaft beyond the housing [m]
};

/// The friction of one bearing, and what it carries and conducts.
struct BearingHeat {
  double inner = 0.0, outer = 0.0;  ///< heat that arises at each ring [W]
  double force = 0.0;               ///< axial [N]
  double radial_force = 0.0;        ///< [N]
  double clearance = unset;         ///< s of a roller bearing [m]
  double conductance = 0.0;         ///< of balls or rollers by their contacts [W/K]
  double band = 0.0;  ///< half width of the 95 % band that a friction table gives its power [W]
  [[nodiscard]] double power() const { return inner + outer; }
};

/// The sets of a spindle at the temperatures of its rings: balance, forces, friction heat.
///
/// Each bearing has its own ring temperatures (thermal_shift(), balls at the mean of the rings);
/// the lubricant is at the mean of the rings, as in the data with a known answer. Friction follows
/// the axial forces of the warm sets, or the cold ones at that speed. What loads across
/// the shaft add to forces, friction and position is held from one bear() to the next.
class WarmSets {
 public:
  /// Throws std::invalid_argument where the sets cannot be mounted.
  WarmSets(const model::Model& model, const effects::SpindleCondition& condition);

  /// Sets what the sets run under from now on; false where the cold sets have no balance.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// False where the sets have no balance; then nothing has changed.
  [[nodiscard]] bool solve(const SetsAsked& asked);
  /// Takes what the bent shaft puts on the bearings at the temperatures of the last solve(), in
  /// addition to the axial loads; null: nothing. False where a friction has no number.
  [[nodiscard]] bool bear(const LoadedShaft* bent);

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] std::span<const BearingHeat> heat() const { return heat_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& sets() const { return sets_; }
  [[nodiscard]] const bearing::ArrangementEquilibrium& cold_sets() const { return cold_; }
  [[nodiscard]] const bearing::ArrangementCondition& asked() const { return asked_.sets; }
  [[nodiscard]] const bearing::Arrangement& arrangement() const { return balance_.arrangement(); }
  [[nodiscard]] std::size_t bearings() const { return heat_.size(); }
  /// Position of the shaft and forces of the sets, loads across it included [m], [N].
  [[nodiscard]] double position() const { return sets_.position + more_position_; }
  [[nodiscard]] double front_force() const { return sets_.front_force + more_front_; }
  [[nodiscard]] double rear_force() const { return sets_.rear_force + more_rear_; }
  /// Position that the sets have at standstill without any load or heat [m].
  [[nodiscard]] double rest() const { return rest_; }

 private:
  [[nodiscard]] bool find_condition(const bearing::OperatingPoint& point,
                                    shaft::ShaftCondition& condition) const;
  /// Balls that are not all alike, and what presses their bearing.
  struct UnevenBalls {
    const bearing::Vector5& load;
    const bearing::BearingEquilibrium& balls;
  };
  /// Under the axial load of `sets`, or of the uneven balls.
  [[nodiscard]] BearingHeat heat_of(std::size_t bearing, const SetsAsked& asked,
                                    const bearing::ArrangementEquilibrium& sets,
                                    const UnevenBalls* uneven = nullptr) const;
  /// `heat` with the contacts in warm and cold sets, each by its share.
  [[nodiscard]] BearingHeat heat_of_contacts(std::size_t bearing, double temperature,
                                             const bearing::ArrangementEquilibrium& sets,
                                             const UnevenBalls* uneven, BearingHeat heat) const;
  [[nodiscard]] BearingHeat heat_with_effects(std::size_t bearing, double load, double temperature,
                                              const SetsAsked& asked,
                                              const bearing::ArrangementEquilibrium& sets,
                                              const UnevenBalls* uneven) const;

  model::Model model_;
  model::Steps steps_, friction_;
  bool has_effects_ = false;  ///< that act on friction
  bool has_conditions_ = false;
  double feedback_ = 1.0;  ///< share of the way from cold to warm forces [1]
  shaft::ShaftBalance balance_;
  std::vector<model::Model> singles_;  ///< of each bearing alone, where effects ask for one
  Inputs inputs_;
  shaft::ShaftCondition speed_, asked_;  ///< as the speed makes it; with temperatures
  bearing::ArrangementEquilibrium cold_, sets_;
  SetsAsked temperatures_;  ///< of the last solve()
  std::vector<BallConduction> conduction_;
  std::vector<BearingHeat> heat_;
  std::vector<BearingHeat> more_;  ///< by loads across the shaft; empty without
  double more_position_ = 0.0, more_front_ = 0.0, more_rear_ = 0.0;
  double rest_ = 0.0;
};

}  // namespace raceway::spindle
