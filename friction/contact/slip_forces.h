#pragma once

#include <array>
#include <cstddef>

#include "friction/contact/shear.h"
#include "friction/contact/traction.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Slip between ball and race in one contact, with x along rolling and y across. ω_roll is the
/// relative angular velocity about the y axis, and ω_s about the contact normal. R is the radius of
/// the deformed contact across rolling (ContactShape).
///
///   v_x = v_x0 + ω_roll y²/(2 R) - ω_s y,   v_y = v_y0 + ω_s x
struct SlipMotion {
  double along = 0.0, across = 0.0;  ///< v_x0, v_y0 [m/s]
  double rolling = 0.0, spin = 0.0;  ///< ω_roll, ω_s, signed [rad/s]
};

/// Friction forces and moments that resist the four components of a SlipMotion (v_x0, v_y0, ω_roll,
/// ω_s), and their derivatives.
///
///   force_k = Σ τ·∂v/∂k,   slope_kl = ∂force_k/∂l = Σ ∂v/∂k·(dτ/dv)·∂v/∂l
///
/// The indices k and l denote two of the four components. Σ is the integral over the contact
/// ellipse, and p is the contact pressure. The shear stress τ is the gradient of a potential that
/// is convex in the slip v. Therefore, the matrix of slopes is symmetric and has no negative
/// eigenvalue. The friction power is the sum of the four products of force_k and slip component k.
struct SlipForces {
  std::array<double, 4> force{};  ///< forces along x and y [N], moments of rolling and spin [N m]
  double slope[4][4] = {};        ///< slope_kl [N s/m], [N s] or [N m s]
  double power = 0.0;             ///< Σ τ v [W]
  double size = 0.0;              ///< Σ |τ| [N]
  double pressure_slip = 0.0;     ///< Σ p |v| [N m/s]
};

/// Loaded contact ellipse that computes friction forces for any combination of the four slip
/// components. For a contact with fixed rolling and spin, use TractionField.
///
/// Source:   slip by the equation of SlipMotion, as in TractionField.
/// Domain:   contact load Q > 0; any motion.
/// Accuracy: with 8 x 16 points of the ellipse, the power is accurate to 0.03 % with a film and to
///           0.3 % with dry friction.
class SlippingContact {
 public:
  SlippingContact() = default;
  /// Uses only the load and the half axes of `ellipse`. `pressed_radius` is the radius R of the
  /// deformed contact across rolling [m].
  SlippingContact(const SlidingEllipse& ellipse, const FilmShear& shear, double pressed_radius);

  [[nodiscard]] SlipForces forces(const SlipMotion& motion) const;
  [[nodiscard]] const SlidingEllipse& ellipse() const { return ellipse_; }
  [[nodiscard]] double pressed_radius() const { return pressed_radius_; }

  /// Sets the slip speed below which dry friction falls smoothly to zero, as a multiple of
  /// FilmShear::small_speed.
  void smooth(double times);

 private:
  static constexpr std::size_t radial = 8, angles = 8;
  template <bool film, bool asperities>
  [[nodiscard, gnu::always_inline]] SlipForces pass_of(const SlipMotion& motion) const;
  template <bool film, bool asperities>
  [[nodiscard]] SlipForces pass(const SlipMotion& motion) const;
  template <bool film, bool asperities>
  [[nodiscard]] SlipForces any_pass(const SlipMotion& motion) const;
  template <bool film, bool asperities>
  [[nodiscard]] SlipForces wide_pass(const SlipMotion& motion) const;

  SlidingEllipse ellipse_;
  double pressed_radius_ = unset, small_speed_ = unset;
  std::array<FilmShear::Point, radial> points_{};
};

}  // namespace raceway::friction::contact
