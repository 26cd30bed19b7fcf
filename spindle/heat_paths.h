#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::spindle {

/// Surroundings that receive the heat of the spindle.
enum class Reservoir { air, machine, coolant };
inline constexpr std::size_t reservoirs = 3;

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Bodies that store heat, the heat paths between bodies, and the heat paths to reservoirs at the
/// temperatures T_r:
///
///   C_i dT_i/dt = sum G_ij (T_j - T_i) + sum G_ir (T_r - T_i) + q_i
///
/// T_i is the temperature of body i, C_i its heat capacity, G a thermal conductance, and q_i the
/// heat of the sources in the body. A solver stores which paths exist. After the construction of a
/// solver, you may change conductances, but not add paths.
struct HeatPaths {
  struct Link {
    int first, second;
    double conductance;  ///< [W/K]
  };
  struct Outlet {
    int node;
    Reservoir reservoir;
    double conductance;  ///< [W/K]
    double above = 0.0;  ///< temperature at the outlet minus temperature of its reservoir [K]
    [[nodiscard]] double outside(const std::array<double, reservoirs>& temperature) const {
      return temperature[static_cast<std::size_t>(reservoir)] + above;
    }
  };
  Vector capacity;  ///< [J/K], > 0
  Vector source;    ///< heat sources, independent of temperatures [W]
  std::vector<Link> links;
  std::vector<Outlet> outlets;
  /// Temperature of each reservoir [K].
  std::array<double, reservoirs> temperature{unset, unset, unset};

  [[nodiscard]] Eigen::Index size() const { return capacity.size(); }
  /// Returns the heat that flows to each reservoir [W].
  [[nodiscard]] std::array<double, reservoirs> outflow(const Vector& temperatures) const;
  /// Returns the heat flow from all paths and sources into each body [W].
  [[nodiscard]] Vector inflow(const Vector& temperatures) const;
  /// Returns the terms of inflow() that do not depend on body temperatures [W].
  [[nodiscard]] Vector constant_inflow() const;
};

}  // namespace raceway::spindle
