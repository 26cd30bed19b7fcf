#pragma once

#include <optional>
#include <vector>

#include "spindle/shaft_loads.h"
#include "spindle/thermal_system.h"
#include "spindle/warm_rollers.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

using Matrix = Eigen::MatrixXd;

/// The few numbers by which bearings and cells act on each other:
///
///   felt s    of each bearing the means of inner and outer ring and of the cells at its two
///             raceways [K], of each roller bearing also shaft and housing at its seats,
///             then the elongation between the sets, in um
///   given y   heat into the cells at the inner and the outer raceway of each bearing [W]
///
/// Friction heat arises at the raceways. What the balls carry flows between the raceways, which are
/// warmer than the cells behind them by what half a cell resists:
///
///   T_s = a + w/S,   Q = G (T_si - T_so),   w_i = q_i - Q,   w_o = q_o + Q
///
/// with the conductance S from cells to raceway. Loads across the shaft reach the bearings through
/// the beam; what they add is held from one bear() to the next, as films and seats are. The
/// elongation is counted in um so that all of s
/// is of one size.
class BearingCoupling {
 public:
  BearingCoupling(const model::Model& model, const effects::SpindleCondition& condition,
                  const ThermalSystem& system);

  [[nodiscard]] Eigen::Index felt_count() const { return felt_.rows(); }
  [[nodiscard]] Eigen::Index given_count() const { return given_.cols(); }
  /// s of these temperatures.
  [[nodiscard]] Vector felt(const Vector& temperatures) const {
    return felt_ * temperatures + offset_;
  }
  [[nodiscard]] const SparseMatrix& felt_rows() const { return felt_; }
  /// Cells by given number [1].
  [[nodiscard]] const Matrix& given() const { return given_; }

  [[nodiscard]] const WarmSets& sets() const { return sets_; }
  /// Sets speed and loads of the bearings. Returns false if the cold sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Distributes the loads across the shaft to the bearings as they are at s; false where they have
  /// no balance.
  [[nodiscard]] bool bear(const Vector& felt);
  /// The shaft of the last bear(); null where nothing bends it and no rollers hold it.
  [[nodiscard]] const LoadedShaft* shaft() const { return bent_ ? &*bent_ : nullptr; }
  /// True where bear() changes anything.
  [[nodiscard]] bool bends() const { return shaft_.has_value(); }
  /// Position of the shaft at standstill without heat, under the belt alone [m].
  [[nodiscard]] double rest() const { return sets_.rest() + bent_rest_; }
  [[nodiscard]] std::size_t bearings() const { return inner_raceway_.size(); }
  /// Bearing b at s, which was evaluated last.
  [[nodiscard]] BearingState state(std::size_t b, const Vector& felt) const;
  /// y of s; false where the sets have no balance.
  [[nodiscard]] bool evaluate(const Vector& felt, Vector& given);
  /// dy/ds by differences, about the s that was evaluated last; false where a neighbour of it has
  /// no balance.
  [[nodiscard]] bool differentiate(const Vector& felt, const Vector& given, Matrix& jacobian);

 private:
  [[nodiscard]] Eigen::Index place(std::size_t bearing) const;
  [[nodiscard]] RollersAsked rollers_at(std::size_t bearing, const Vector& felt) const;
  [[nodiscard]] BearingHeat heat(std::size_t bearing, const Vector& felt) const;
  [[nodiscard]] bool solve_sets(const Vector& felt);
  [[nodiscard]] Vector flows(const Vector& felt) const;

  WarmSets sets_;
  std::vector<WarmRollers> rollers_;
  SparseMatrix felt_;
  Vector offset_;
  Matrix given_;
  std::vector<double> inner_raceway_, outer_raceway_;  // S of each bearing [W/K]
  std::vector<double> lubricant_;                      // of each bearing [W/K]
  double factor_;
  std::vector<ShaftLoad> loads_;
  std::optional<ShaftOnBearings> shaft_;  // made when it is first needed
  std::optional<LoadedShaft> bent_;
  double bent_rest_ = 0.0;  // of the position by the belt, at standstill [m]
};

}  // namespace raceway::spindle
