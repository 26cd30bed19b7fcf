#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "spindle/beam.h"

namespace raceway::spindle {

/// Direction in which the axis of the shaft whirls in a mode, with or against the rotation.
/// `standing` means neither, as at standstill.
enum class Whirl { backward, standing, forward };

/// Returns the name in files: "backward".
[[nodiscard]] std::string_view name(Whirl whirl);

struct Mode {
  double frequency = unset;  ///< undamped angular frequency [rad/s]
  Whirl whirl = Whirl::standing;
  /// Amplitudes (v, θ) of all nodes in the planes of y and z, a quarter of a period apart: v_y = y
  /// cos ωt, v_z = z sin ωt. The largest displacement of the axis is 1.
  Eigen::VectorXd y, z;
};

/// Outcome of a search for modes.
enum class ModesStatus { not_run, converged, not_held, not_converged };

struct Modes {
  ModesStatus status = ModesStatus::not_run;
  std::vector<Mode> modes;  ///< in order of rising frequency
  [[nodiscard]] bool converged() const { return status == ModesStatus::converged; }
};

/// Finds the lowest modes of a rotating shaft on springs, without damping. With the mass matrix M,
/// the gyroscopic matrix G and the deflection v + i w = q e^{iωt}, isotropic springs give
///
///   (-ω² M + ω Ω G + K) q = 0,   ω > 0 forward, ω < 0 backward.
///
/// Anisotropic springs couple forward and backward whirl. With w = -i b e^{iωt} the matrices of
/// both planes remain real and symmetric. Both problems are solved as B x = (1/ω) A x with the
/// positive definite A = diag(K, M), by Lanczos iterations for the largest |1/ω|, with sparse
/// matrices.
///
/// Domain:   speed >= 0 [rad/s]; springs at nodes of the beam, their planes parallel to y and z.
/// Accuracy: the error of the mesh falls with the square of the element length, and is zero in
///           statics; the solver itself is accurate to about rounding. Damping, axial and torsional
///           modes, and modes of the housing are neglected.
[[nodiscard]] Modes find_modes(const Beam& beam, std::span<const Spring> springs, double speed,
                               int count = 6);

/// Finds the modes at each speed, with one set of springs for each speed, on all threads. Throws
/// std::invalid_argument if the sizes differ.
[[nodiscard]] std::vector<Modes> campbell(const Beam& beam, std::span<const double> speeds,
                                          std::span<const std::vector<Spring>> springs,
                                          int count = 6);

}  // namespace raceway::spindle
