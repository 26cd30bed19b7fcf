#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "spindle/beam.h"

namespace raceway::spindle {

/// The sense in which the shaft's axis runs around in a mode, with the rotation or against it.
/// `standing` where it does neither, as at standstill.
enum class Whirl { backward, standing, forward };

/// Name in files: "backward".
[[nodiscard]] std::string_view name(Whirl whirl);

struct Mode {
  double frequency = unset;  ///< angular, undamped [rad/s]
  Whirl whirl = Whirl::standing;
  /// (v, θ) of all nodes, amplitudes in the planes of y and z, a quarter of a period apart: v_y =
  /// y cos ωt, v_z = z sin ωt. The largest displacement of the axis is 1.
  Eigen::VectorXd y, z;
};

/// Outcome of a search for modes.
enum class ModesStatus { not_run, converged, not_held, not_converged };

struct Modes {
  ModesStatus status = ModesStatus::not_run;
  std::vector<Mode> modes;  ///< rising in frequency
  [[nodiscard]] bool converged() const { return status == ModesStatus::converged; }
};

/// The lowest modes of a turning shaft on springs, without damping. With N the mass, G the
/// gyroscopic matrix, q e^{iωt} the deflection v + i w where all springs are isotropic,
///
///   (-ω² M + ω Ω G + K) q = 0,   ω > 0 forward, ω < 0 backward.
///
/// Anisotropic springs couple both senses; with w = -i b e^{iωt} the matrices of both planes stay
/// real and symmetric. Either is solved as B x = (1/ω) A x with A = diag(K, M), positive definite,
/// by Lanczos iterations on the largest |1/ω|, in sparse matrices throughout.
///
/// Domain:   speed >= 0 [rad/s]; springs at nodes of the beam, their planes parallel to y and z.
/// Accuracy: of the mesh (h² for many elements, exact in statics); of the solver near rounding.
///           Damping, axial and torsional modes and the housing's own are left out.
[[nodiscard]] Modes find_modes(const Beam& beam, std::span<const Spring> springs, double speed,
                               int count = 6);

/// One set of springs and one answer for each speed, on all threads. Throws std::invalid_argument
/// if the sizes differ.
[[nodiscard]] std::vector<Modes> campbell(const Beam& beam, std::span<const double> speeds,
                                          std::span<const std::vector<Spring>> springs,
                                          int count = 6);

}  // namespace raceway::spindle
