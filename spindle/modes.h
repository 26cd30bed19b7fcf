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
  /// Amplitudes (v, θ) of all nodes in the planes of y and z. With the mode frequency ω, the motion
  /// is `y` cos ωt in the plane of y and `z` sin ωt in the plane of z. The amplitudes are scaled so
  /// that the largest deflection amplitude of all nodes, in both planes, is 1.
  Eigen::VectorXd y, z;
};

/// Outcome of a search for modes. `not_held` means that the shaft can move freely, because springs
/// and supports do not hold it.
enum class ModesStatus { not_run, converged, not_held, not_converged };

struct Modes {
  ModesStatus status = ModesStatus::not_run;
  std::vector<Mode> modes;  ///< in ascending order of frequency
  [[nodiscard]] bool converged() const { return status == ModesStatus::converged; }
};

/// Finds the first `count` undamped modes of a rotating shaft on springs, in ascending order of
/// frequency. v and w are the deflections in the planes of y and z. For isotropic springs, the
/// equation of the node displacements q is
///
///   (-ω² M + ω Ω G + K) q = 0,   v + i w = q e^{iωt},   ω > 0 forward, ω < 0 backward.
///
/// M, G and K are the mass, gyroscopic and stiffness matrices, and Ω is the speed. If the springs
/// are anisotropic, forward and backward whirl are coupled. Each mode then has different amplitudes
/// a and b in the two planes:
///
///   v = a e^{iωt},   w = -i b e^{iωt}
///
/// Lanczos iterations solve the eigenvalue problem.
///
/// Domain:   speed >= 0 [rad/s]; springs at nodes of the beam, with principal planes parallel to y
///           and z. Throws std::invalid_argument if `count` is below 1 or a spring is not at a
///           node.
/// Accuracy: the discretisation error of the frequencies decreases with the square of the element
///           length. The eigenvalue solver adds only errors close to rounding. Damping, axial and
///           torsional modes, and modes of the housing are neglected.
[[nodiscard]] Modes find_modes(const Beam& beam, std::span<const Spring> springs, double speed,
                               int count = 6);

/// Finds the first `count` modes at each speed [rad/s]. `springs` contains a list of springs for
/// each speed. The modes at different speeds are computed in parallel. Throws std::invalid_argument
/// if the numbers of speeds and spring lists differ.
[[nodiscard]] std::vector<Modes> campbell(const Beam& beam, std::span<const double> speeds,
                                          std::span<const std::vector<Spring>> springs,
                                          int count = 6);

}  // namespace raceway::spindle
