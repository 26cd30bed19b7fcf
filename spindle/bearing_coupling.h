#pragma once

#include <optional>
#include <vector>

#include "spindle/shaft_loads.h"
#include "spindle/thermal_system.h"
#include "spindle/warm_rollers.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

/// Quantities that couple bearings and cells:
///
///   felt s    for each bearing, the mean temperatures of inner and outer ring and of the cells
///             at its two raceways [K]; for each roller bearing also shaft and housing at its
///             seats; then the elongation between the sets, in um
///   given y   heat into the cells at the inner and the outer raceway of each bearing [W]
///
/// Friction heat arises at the raceways. Heat conducted by the balls flows between the raceways. A
/// raceway is warmer than the cells behind it by the temperature drop over half a cell:
///
///   T_s = a + w/S,   Q = G (T_si - T_so),   w_i = q_i - Q,   w_o = q_o + Q
///
/// S is the conductance from cells to raceway. Radial loads on the shaft reach the bearings through
/// the beam. The bearing loads from these radial loads are constant between two calls of bear(),
/// like heat transfer coefficients and seats. The elongation is in um so that all elements of s
/// have similar size.
class BearingCoupling {
 public:
  BearingCoupling(const model::Model& model, const effects::SpindleCondition& condition,
                  const ThermalSystem& system);

  [[nodiscard]] Eigen::Index felt_count() const { return felt_.rows(); }
  [[nodiscard]] Eigen::Index given_count() const {
    return static_cast<Eigen::Index>(2 * bearings());
  }
  /// Returns s for these temperatures.
  [[nodiscard]] Vector felt(const Vector& temperatures) const {
    return felt_ * temperatures + offset_;
  }
  /// The terms of s = F T + s0: felt_rows() is F, and felt_offset() is s0.
  [[nodiscard]] const SparseMatrix& felt_rows() const { return felt_; }
  [[nodiscard]] const Vector& felt_offset() const { return offset_; }
  /// Index in s of each element of the argument `given`. Heat enters the cells of a raceway with
  /// the same weights as in the mean temperature of the raceway.
  [[nodiscard]] const std::vector<Eigen::Index>& given_rows() const { return given_rows_; }
  /// Adds y to the heat flow into each cell [W].
  void add_given(const Vector& given, Vector& inflow) const;

  [[nodiscard]] const WarmSets& sets() const { return sets_; }
  /// Sets speed and loads of the bearings. Returns false if the cold sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Distributes the radial loads of the shaft to the bearings in their state at s. Returns false
  /// if there is no equilibrium.
  [[nodiscard]] bool bear(const Vector& felt);
  /// Returns the bent shaft of the last bear(); null if no load bends it and no rollers support it.
  [[nodiscard]] const LoadedShaft* shaft() const { return bent_ ? &*bent_ : nullptr; }
  /// Returns true if bear() has any effect.
  [[nodiscard]] bool bends() const { return shaft_.has_value(); }
  /// Returns the position of the shaft at standstill without heat, under the belt load only [m].
  [[nodiscard]] double rest() const { return sets_.rest() + bent_rest_; }
  [[nodiscard]] std::size_t bearings() const { return inner_raceway_.size(); }
  /// Returns the state of bearing b at s, after evaluate() for this s.
  [[nodiscard]] BearingState state(std::size_t b, const Vector& felt) const;
  /// Computes y for s. Returns false if the sets have no equilibrium.
  [[nodiscard]] bool evaluate(const Vector& felt, Vector& given);
  /// Computes dy/ds by differences about the last evaluated s. Returns false if a neighbouring s
  /// has no equilibrium.
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
  std::vector<Eigen::Index> given_rows_;
  std::vector<Shares> given_;                          // cells of each raceway
  std::vector<double> inner_raceway_, outer_raceway_;  // S for each bearing [W/K]
  std::vector<double> lubricant_;                      // for each bearing [W/K]
  double factor_;
  std::vector<ShaftLoad> loads_;
  std::optional<ShaftOnBearings> shaft_;  // created at first use
  std::optional<LoadedShaft> bent_;
  double bent_rest_ = 0.0;  // part of the position from the belt at standstill [m]
};

}  // namespace raceway::spindle
