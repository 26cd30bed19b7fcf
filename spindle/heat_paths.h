#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::spindle {

/// Destinations of heat.
enum class Reservoir { air, machine, coolant };
inline constexpr std::size_t reservoirs = 3;

using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Bodies that store heat, and the ways between them and out of them:
///
///   C_i dT_i/dt = sum G_ij (T_j - T_i) + sum G_ir (T_r - T_i) + q_i
///
/// Conductances may be set anew as long as no way is added.
struct HeatPaths {
  struct Link {
    int first, second;
    double conductance;  ///< [W/K]
  };
  struct Outlet {
    int node;
    Reservoir reservoir;
    double conductance;  ///< [W/K]
  };
  Vector capacity;  ///< [J/K], > 0
  Vector source;    ///< what does not depend on temperatures [W]
  std::vector<Link> links;
  std::vector<Outlet> outlets;
  std::array<double, reservoirs> temperature{unset, unset, unset};  ///< of the reservoirs [K]

  [[nodiscard]] Eigen::Index size() const { return capacity.size(); }
  /// Heat that flows out to each reservoir [W].
  [[nodiscard]] std::array<double, reservoirs> outflow(const Vector& temperatures) const;
  /// Heat flow from all paths and sources into each body [W].
  [[nodiscard]] Vector inflow(const Vector& temperatures) const;
  /// Part of inflow() that does not depend on the temperatures of bodies [W].
  [[nodiscard]] Vector constant_inflow() const;
};

/// The symmetric matrix of `scale` C + factor * conductances of some ways, its pattern kept.
class ConductanceMatrix {
 public:
  /// `paths` may change its conductances afterwards, and nothing else.
  explicit ConductanceMatrix(const HeatPaths& paths);
  /// Lower half of capacity_factor C + G [W/K].
  [[nodiscard]] const SparseMatrix& fill(const HeatPaths& paths, double capacity_factor);

 private:
  struct Places {
    Eigen::Index first, second, off;
  };
  SparseMatrix matrix_;
  std::vector<Places> links_;
  std::vector<Eigen::Index> diagonal_;
};

}  // namespace raceway::spindle
