#pragma once

#include <limits>
#include <vector>

/// Spindles with a known truth for the diagnosis: physics and numerics of its own.
namespace spindle_study {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double rpm = pi / 30.0;  ///< [rad/s]
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double steel_expansion = 11.5e-6;  ///< [1/K]

struct BearingData {
  double ball_diameter = nan, pitch_diameter = nan;  ///< [m]
  int ball_count = 0;
  double contact_angle = nan;                             ///< free [rad]
  double inner_conformity = nan, outer_conformity = nan;  ///< [1]
  double static_rating = nan;                             ///< [N]
};

/// Hertz contact of a steel ball with one race.
struct Race {
  double stiffness = nan;           ///< K in Q = K δ^1.5 [N/m^1.5]
  double major = nan, minor = nan;  ///< semi-axes at 1 N; they grow with Q^(1/3) [m]
};

/// Rings against the state as mounted.
struct RingState {
  double inner = 0.0, outer = 0.0;  ///< rises of temperature [K]
};

/// What one bearing carries, and where its contacts are.
struct BearingLoad {
  double force = 0.0;                               ///< axial, of the whole bearing [N]
  double inner_contact = 0.0, outer_contact = 0.0;  ///< of one ball [N]
};

/// One angular contact bearing under pure axial load, all balls alike; rolling at the outer race.
class BallBearing {
 public:
  explicit BallBearing(const BearingData& data);
  [[nodiscard]] BearingLoad pressed(double axial, double speed, const RingState& rings) const;
  /// How far the inner ring is pressed under a force, still and as mounted [m].
  [[nodiscard]] double approach_under(double force) const;
  [[nodiscard]] const BearingData& data() const { return data_; }
  [[nodiscard]] const Race& inner() const { return inner_; }
  [[nodiscard]] const Race& outer() const { return outer_; }

 private:
  BearingData data_;
  Race inner_, outer_;
};

/// Front bearings in tandem against rear ones in tandem, back to back, mounted without a spring.
struct BearingSet {
  BearingSet(const BearingData& data, int front_count, int rear_count, double preload);
  BallBearing bearing;
  int front, rear;
  double front_pressed, rear_pressed;  ///< approaches under the preload, cold and still [m]
};

struct SetState {
  double position = 0.0;              ///< of the shaft at the front set, towards the nose [m]
  std::vector<BearingLoad> bearings;  ///< from the nose to the rear
  double front_force = 0.0;           ///< sum [N]
};

/// `elongation`: of the shaft beyond the housing between the sets [m]. `guess`: a position.
[[nodiscard]] SetState balance(const BearingSet& set, double speed,
                               const std::vector<RingState>& rings, double elongation,
                               double guess = 0.0);

/// Conductance of the contacts of all balls, two constrictions in series each [W/K].
[[nodiscard]] double contact_conductance(const BallBearing& bearing, const BearingLoad& load,
                                         double conductivity);

}  // namespace spindle_study
