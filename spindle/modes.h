#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "spindle/beam.h"

namespace raceway::spindle {

/// Whirl direction of a mode: forward with the rotation of the shaft, or backward against the
/// rotation. `standing` means no whirl, as at standstill.
enum class Whirl { backward, standing, forward };

/// Returns the name of a whirl direction in result files, such as "backward".
[[nodiscard]] std::string_view name(Whirl whirl);

struct Mode {
  double frequency = unset;  ///< undamped angular frequency [rad/s]
  Whirl whirl = Whirl::standing;
  /// Amplitudes (v, θ) of all nodes in the planes of y and z. The motion is v_y = y cos ωt and
  /// v_z = z sin ωt. The largest displacement amplitude of a node in one plane is 1.
  Eigen::VectorXd y, z;
};

/// Outcome of a search for modes. `not_held` means that the shaft can move freely.
enum class ModesStatus { not_run, converged, not_held, not_converged };

struct Modes {
  ModesStatus status = ModesStatus::not_run;
  std::vector<Mode> modes;  ///< in ascending order of frequency
  [[nodiscard]] bool converged() const { return status == ModesStatus::converged; }
};

/// Finds the lowest modes of a rotating shaft on springs, without damping. With the mass matrix M,
/// the gyroscopic matrix G and the deflection v + i w = q e^{iωt}, isotropic springs give
///
///   (-ω² M + ω Ω G + K) q = 0,   ω > 0 forward, ω < 0 backward.
///
/// Ω is the speed, and K is the stiffness matrix. Anisotropic springs couple forward and backward
/// whirl. For these springs, the amplitudes are a and b with v = a e^{iωt} and w = -i b e^{iωt}, so
/// that the matrices remain real and symmetric. For isotropic and anisotropic springs, Lanczos
/// iterations solve the linear eigenvalue problem B x = (1/ω) A x for the largest |1/ω|. x contains
/// the amplitudes and ω times the amplitudes. B consists of M and Ω G. A = diag(K, M) is positive
/// definite.
///
/// Domain:   speed >= 0 [rad/s]; springs at nodes of the beam, with principal planes parallel to y
///           and z. Throws std::invalid_argument if `count` is below 1 or a spring is not at a
///           node.
/// Accuracy: the discretisation error of the frequencies decreases with the square of the element
///           length. The eigenvalue solver adds only errors close to rounding. Damping, axial and
///           torsional modes, and modes of the housing are neglected.
[[nodiscard]] Modes find_modes(const Beam& beam, std::span<const Spring> springs, double speed,
                               int count = 6);

/// Finds the modes at each speed [rad/s], with a list of springs for each speed. The speeds are
/// computed in parallel. Throws std::invalid_argument if the numbers of speeds and spring lists
/// differ.
[[nodiscard]] std::vector<Modes> campbell(const Beam& beam, std::span<const double> speeds,
                                          std::span<const std::vector<Spring>> springs,
                                          int count = 6);

}  // namespace raceway::spindle
