#pragma once

#include <optional>
#include <vector>

#include "spindle/shaft_loads.h"
#include "spindle/thermal_system.h"
#include "spindle/warm_rollers.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

/// Coupling between the bearings and the cells of the thermal mesh. The vector s (`felt` in the
/// code) contains the inputs of the bearing calculation. The vector y (`given`) contains the
/// results of this calculation:
///
///   felt s    for each bearing, the mean temperatures of inner and outer ring and of the cells
///             at its two raceways [K]; for each roller bearing also the temperatures of shaft and
///             housing at its seats [K]; last the elongation of the shaft minus the elongation of
///             the housing between the bearing sets [um]
///   given y   heat into the cells at the inner and the outer raceway of each bearing [W]
///
/// Friction heat q arises at the raceways. Heat Q flows from the inner to the outer raceway through
/// the balls or rollers and the lubricant. The raceway temperature T_s is the mean temperature a of
/// the raceway cells plus the temperature drop over half a cell:
///
///   T_s = a + w/S,   Q = G (T_si - T_so),   w_i = q_i - Q,   w_o = q_o + Q
///
/// S is the conductance between the raceway and its cells, w is the heat into these cells, and G is
/// the conductance through balls or rollers and lubricant. The indices i and o denote the inner and
/// the outer raceway. The function bear() uses a beam model of the shaft to compute the bearing
/// loads from the radial loads on the shaft. These bearing loads stay constant until the next call
/// of bear(). The elongation is in um so that all elements of s have a similar magnitude.
class BearingCoupling {
 public:
  BearingCoupling(const model::Model& model, const effects::SpindleCondition& condition,
                  const ThermalSystem& system);

  [[nodiscard]] Eigen::Index felt_count() const { return felt_.rows(); }
  [[nodiscard]] Eigen::Index given_count() const {
    return static_cast<Eigen::Index>(2 * bearings());
  }
  /// Returns the vector s for these cell temperatures [K].
  [[nodiscard]] Vector felt(const Vector& temperatures) const {
    return felt_ * temperatures + offset_;
  }
  /// The vector s depends linearly on the cell temperatures T: s = F T + s0. felt_rows() returns F,
  /// and felt_offset() returns s0.
  [[nodiscard]] const SparseMatrix& felt_rows() const { return felt_; }
  [[nodiscard]] const Vector& felt_offset() const { return offset_; }
  /// Returns, for each element of y, the index of an element of s: the mean temperature of the
  /// cells at the same raceway. The weights of the cells in this mean also divide the heat among
  /// the cells.
  [[nodiscard]] const std::vector<Eigen::Index>& given_rows() const { return given_rows_; }
  /// Adds the raceway heat y = `given` to the heat flow into each cell [W].
  void add_given(const Vector& given, Vector& inflow) const;

  [[nodiscard]] const WarmSets& sets() const { return sets_; }
  /// Sets speed and loads of the bearings. Returns false if the cold bearing sets have no
  /// equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Computes the bearing loads from the radial loads on the shaft, for the temperatures in s.
  /// Returns false if shaft and bearings have no equilibrium.
  [[nodiscard]] bool bear(const Vector& felt);
  /// Returns the equilibrium of the bent shaft from the last call of bear(). The result is null if
  /// no load bends the shaft and no roller bearing supports the shaft.
  [[nodiscard]] const LoadedShaft* shaft() const { return bent_ ? &*bent_ : nullptr; }
  /// Returns true if a load bends the shaft or a roller bearing supports the shaft. Otherwise
  /// bear() has no effect.
  [[nodiscard]] bool bends() const { return shaft_.has_value(); }
  /// Returns the axial position of the cold shaft at standstill under the belt load alone [m].
  [[nodiscard]] double rest() const { return sets_.rest() + bent_rest_; }
  [[nodiscard]] std::size_t bearings() const { return inner_raceway_.size(); }
  /// Returns temperatures, forces and friction of bearing b for the inputs s = `felt`. Call
  /// evaluate() with this s first.
  [[nodiscard]] BearingState state(std::size_t b, const Vector& felt) const;
  /// Computes the raceway heat y = `given` for the inputs s = `felt`. Returns false if the bearing
  /// sets have no equilibrium.
  [[nodiscard]] bool evaluate(const Vector& felt, Vector& given);
  /// Computes the matrix dy/ds by finite differences. s = `felt` contains the inputs, and y =
  /// `given` is the raceway heat for these inputs. Call evaluate() with this s first. Returns false
  /// if the bearing sets have no equilibrium at s or near it.
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
  std::vector<double> lubricant_;  // conductance of the lubricant in each bearing [W/K]
  double factor_;
  std::vector<ShaftLoad> loads_;
  std::optional<ShaftOnBearings> shaft_;  // created at first use
  std::optional<LoadedShaft> bent_;
  double bent_rest_ = 0.0;  // change of the position by the belt at standstill [m]
};

}  // namespace raceway::spindle
