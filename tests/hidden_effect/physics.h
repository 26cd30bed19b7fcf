#pragma once

#include <array>
#include <map>
#include <span>
#include <string_view>
#include <utility>

/// Friction of a thrust loaded spindle bearing by formulas and numerics of its own. Nothing of the
/// library is used, so what it says of the library's answers is worth something. Everything is in
/// the units of the published formulas: N, mm, N mm, rpm, degrees Celsius, mm2/s.
namespace hidden_effect {

/// A bearing as its maker's catalogue gives it, with one set of ball and ring material.
struct Machine {
  std::string_view name;
  int balls;
  double ball_diameter, pitch_diameter;  ///< [mm]
  double contact_angle;                  ///< [deg]
  double inner_conformity, outer_conformity;
  double load_rating;  ///< C0 [N]
  bool ceramic_balls;
  double viscosity_40, viscosity_100;  ///< of its oil [mm2/s]

  [[nodiscard]] double bore() const { return pitch_diameter - 1.5 * ball_diameter; }
  [[nodiscard]] double outer_diameter() const { return pitch_diameter + 1.5 * ball_diameter; }
};

/// One stationary state of the rig.
struct Point {
  double speed;         ///< n [rpm]
  double load;          ///< F [N], axial
  double temperature;   ///< T of the oil [C]
  double time = 0.0;    ///< since the first row [s]
  double radial = 0.0;  ///< load across the shaft [N]
};

/// How the balls of a thrust loaded bearing stand, all alike.
struct Balance {
  double inner_angle, outer_angle;      ///< [rad]
  double inner_load, outer_load;        ///< [N]
  double gyroscopic_moment;             ///< M_g [N mm]
  double spin_ratio;                    ///< w_s/w at the inner race
  double cage_ratio;                    ///< w_m/w
  double inner_rolling, outer_rolling;  ///< turning of ball against race about the tangent, over w
  double displacement;                  ///< of the inner ring along the shaft [mm]
};

/// Point contact of ball and groove after Johnson, Contact Mechanics, eqs. 4.26 to 4.28: peak
/// pressure from the curvatures, load and approach from the peak pressure.
struct Contact {
  double stiffness;       ///< Q = K d^1.5 [N/mm^1.5]
  double major_axis;      ///< a at 1 N [mm], a grows as Q^(1/3)
  double second_ellipse;  ///< E(e)
  double ellipse_ratio;   ///< a/b
  double conformity;
  double radius_ratio;  ///< equivalent radius across rolling over that along it
  double softer_by;     ///< modulus of steel on steel over that of this contact
};

/// Remembers the balances it has found, so each thread has its own.
class Bearing {
 public:
  explicit Bearing(const Machine& machine);

  /// Two equations in the two contact angles. With the ball rolling on the outer race, without spin
  /// there,
  ///
  ///   F/Z (cot ai - cot ao) + Fc + (2 Mg/D)/sin ao = 0
  ///   (lo) cos ao + (li) cos ai = BD cos a0,   l = (f - 0.5) D + (Q/K)^(2/3)
  ///
  /// the first found by iteration at a given inner angle, the second by bracketing. Load > 0.
  [[nodiscard]] const Balance& balance(double speed, double load) const;
  /// The same of the moments of its contacts, with rolling as it is and all else; temperature of
  /// the film [C].
  struct Moments {
    double rolling, other;  ///< [N mm]
  };
  [[nodiscard]] const Moments& contact_moments(double speed, double load, double temperature) const;

  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Contact& inner() const { return inner_; }
  [[nodiscard]] const Contact& outer() const { return outer_; }
  /// ASTM D341 [mm2/s].
  [[nodiscard]] double viscosity(double temperature) const;

 private:
  Machine machine_;
  Contact inner_, outer_;
  double ball_mass_;  // [kg]
  double astm_offset_, astm_slope_;
  mutable std::map<std::pair<double, double>, Balance> found_;
  mutable std::map<std::array<double, 3>, Moments> moments_;

  [[nodiscard]] Balance solve(double speed, double load) const;
};

/// A formula for the bearing as a whole.
enum class Formula {
  palmgren,
  skf,      ///< rolling and sliding of a single row angular contact bearing after SKF's catalogue
  houpert,  ///< hydrodynamic rolling resistance of point contacts, and sliding as F^(4/3)
};

/// Palmgren's law as the rig really has it, or another formula; or, of its contacts, that of
/// contact_truth.h.
struct BaseLaw {
  double f0 = 1.5, z = 1e-3, y = 0.33;
  double viscous_exponent = 2.0 / 3.0;
  bool contacts = false;
  double rolling_factor = 1.0;  ///< on the rolling resistance; not for Palmgren's law
  double sliding_factor = 1.0;  ///< on all other parts; not for Palmgren's law
  Formula formula = Formula::palmgren;
  /// Exponents of Houpert's law: of speed times viscosity, of load in rolling, of load in sliding.
  std::array<double, 3> powers{0.656, 0.466, 4.0 / 3.0};
  bool by_ball_loads = false;  ///< true: Houpert's law is a mean over the ball contacts
};

/// The values of an effect: its size, and a second number that only gives the shape.
struct Values {
  double size;
  double shape;
};

/// What an effect may look at. Effects write to the sums that follow.
struct Scene {
  const Bearing& bearing;
  BaseLaw law;
  Point point;
  double load;         ///< entered load plus what effects add [N]
  double temperature;  ///< of the film [C]
  double factor;       ///< on the viscous moment
  double moment;       ///< added [N mm]
};

enum class Kind { catalogue, other_form, outside };

/// One way in which a rig departs from the base law.
struct Effect {
  std::string_view id;      ///< of the catalogue, or a name of its own
  std::string_view family;  ///< id in the catalogue that this is a form of; empty outside
  Kind kind;
  std::span<const std::string_view> aliases;  ///< other ids that have this shape exactly or nearly
  bool negative;                              ///< may the size be below zero as well
  double shape, shape_lower, shape_upper;     ///< second parameter; equal bounds: it is fixed
  double largest;                             ///< size beyond which nothing is searched
  void (*condition)(Scene&, const Values&);   ///< changes load, temperature of the film or factor
  void (*moment)(Scene&, const Values&);      ///< adds to the moment
};

/// The effects of the catalogue that reach a torque, in the forms the catalogue documents.
[[nodiscard]] std::span<const Effect> catalogue_effects();
/// The same mechanisms in other forms.
[[nodiscard]] std::span<const Effect> other_forms();
/// What no catalogue has.
[[nodiscard]] std::span<const Effect> outside_effects();
/// True of one that a law of the contacts has itself, or that has no place in it.
[[nodiscard]] bool within_contacts(std::string_view id);
/// Throws std::out_of_range.
[[nodiscard]] const Effect& effect(std::string_view id);

struct Hidden {
  const Effect* effect;
  Values values;
};

/// Friction torque that the rig reads, without noise [N mm].
[[nodiscard]] double torque(const Bearing& bearing, const BaseLaw& law, const Point& point,
                            std::span<const Hidden> hidden);

}  // namespace hidden_effect
