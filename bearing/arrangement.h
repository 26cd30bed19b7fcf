#pragma once

#include <limits>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "bearing/bearing.h"

namespace raceway::bearing {

/// Orientation of the bearing sets at the two ends of a shaft. `front` is the tool side.
///
///   back_to_back   O: front bearings push the shaft towards the tool, rear bearings away from it
///   face_to_face   X: front bearings push the shaft away from the tool, rear bearings towards it
///   tandem         all bearings are in one set, which pushes the shaft towards the tool against
///                  a spring
enum class Layout { back_to_back, face_to_face, tandem };

/// Support of the outer rings of the rear set: rigid in the housing, or pushed by a preload spring.
enum class Mounting { rigid, spring };

enum class Side { front, rear };

/// One bearing of a set.
struct MountedBearing {
  std::shared_ptr<const Bearing> bearing;
  /// Axial compression of this bearing minus the compression δ of its set (front or rear) [m]. Face
  /// grinding of the rings causes this offset.
  double offset = 0.0;
  [[nodiscard]] bool operator==(const MountedBearing&) const = default;
};

/// Preload force at standstill [N], >= 0: sum of the axial forces of the front bearings. The force
/// on the rear side is equal: the sum of the axial forces of the rear bearings or, in tandem, the
/// spring force.
struct PreloadForce {
  double force = unset;
  [[nodiscard]] bool operator==(const PreloadForce&) const = default;
};

/// Preload given as the axial gap between the rings that clamping closes [m]. Before clamping, the
/// balls of both sets just touch the races without load.
struct PreloadOffset {
  double offset = unset;
  [[nodiscard]] bool operator==(const PreloadOffset&) const = default;
};

using Preload = std::variant<PreloadForce, PreloadOffset>;

/// Arrangement as the user enters it.
struct ArrangementDesign {
  Layout layout = Layout::back_to_back;
  std::vector<MountedBearing> front = {};
  std::vector<MountedBearing> rear = {};  ///< empty in tandem
  Mounting mounting = Mounting::rigid;
  Preload preload = {};
  double spring_rate = 0.0;  ///< rate of a spring mounting [N/m]; 0: constant force
  /// Share m of the kind of mounting that is not in `mounting` [1]. With m = 0, the support is of
  /// the kind in `mounting`; with m = 1, the support is of the other kind. A value of m between 0
  /// and 1 gives a support between rigid and spring. The other kind is rigid if `mounting` is
  /// `spring`, and a spring of constant force if `mounting` is `rigid`. The share must be 0 in
  /// tandem. See Arrangement::Seat for the formula.
  double other_mounting = 0.0;
  /// Axial stiffness of the shaft between the sets, in series with the sets [N/m].
  double shaft_stiffness = std::numeric_limits<double>::infinity();
  double housing_stiffness = std::numeric_limits<double>::infinity();
  /// Distance between the sets, along which shaft and housing expand thermally [m].
  double distance = 0.0;
  double shaft_expansion = 11.5 * per_million_K;    ///< [1/K]
  double housing_expansion = 11.5 * per_million_K;  ///< [1/K]
  double mounting_temperature = kelvin(20);         ///< temperature when the preload was set [K]
  [[nodiscard]] bool operator==(const ArrangementDesign&) const = default;
};

/// Immutable sets of bearings on a shaft, preloaded at standstill. The constructor solves the
/// equilibrium at rest. Copies of the object share the bearings.
///
/// x is the axial position of the shaft at the front set, positive towards the tool. In the mounted
/// state, x is 0. The mounted state is at standstill, at the mounting temperature and without
/// external load. d is -1 for an X arrangement, otherwise 1. The axial compressions of the front
/// set (δ_f) and the rear set (δ_r) are
///
///   front   δ_f = δ_f0 - d x
///   rear    δ_r = δ_r0 + d (x - e) - c (F_r - F_0)     rigid mounting
///           F_r = F_0 + k (d (x - e) - (δ_r - δ_r0))   spring mounting
///   c = 1/shaft_stiffness + 1/housing_stiffness,  1/k = 1/spring_rate + c
///
/// At δ = 0, the balls of a bearing with MountedBearing::offset = 0 just touch both races, at the
/// nominal contact angle. e is the elongation of the shaft minus the elongation of the housing
/// between the sets. F_r is the axial force of the rear set. The index 0 denotes the mounted state.
/// In tandem, the spring replaces the rear set.
class Arrangement {
 public:
  /// Throws std::invalid_argument for a missing or impossible value. The message gives name, value
  /// and allowed range.
  explicit Arrangement(ArrangementDesign design);

  [[nodiscard]] const ArrangementDesign& design() const { return design_; }
  /// Bearings in the order from the tool to the rear.
  [[nodiscard]] std::span<const MountedBearing> bearings() const { return bearings_; }
  [[nodiscard]] std::size_t front_count() const { return design_.front.size(); }
  [[nodiscard]] Side side(std::size_t bearing) const {
    return bearing < front_count() ? Side::front : Side::rear;
  }
  /// Sign d in the equations above: 1 if the front set pushes the shaft towards the tool, else -1.
  [[nodiscard]] double direction() const {
    return design_.layout == Layout::face_to_face ? -1.0 : 1.0;
  }
  /// Axial force F_0 on each side in the mounted state [N].
  [[nodiscard]] double preload() const { return preload_; }
  /// Axial compression of a set in the mounted state, δ_f0 or δ_r0 [m]; 0 for the rear side of a
  /// tandem arrangement.
  [[nodiscard]] double displacement(Side side) const {
    return side == Side::front ? front_displacement_ : rear_displacement_;
  }
  /// Support of the outer rings of the rear set. `softness` and `hardness` describe the support by
  /// this relation:
  ///
  ///   softness (F_r - F_0) = hardness (d (x - e) - (δ_r - δ_r0))
  ///
  /// F_r, F_0, d, x, e, δ_r and δ_r0 are explained in the comment of Arrangement.
  ///
  /// (softness, hardness) is (c [m/N], 1) for a rigid mounting and (1, k [N/m]) for a spring. If
  /// the share m = ArrangementDesign::other_mounting is above 0, (softness, hardness) is
  ///
  ///   (1 - m) (c K_r, K_r) + m (1, 0)     for Mounting::rigid
  ///   (1 - m) (1, k) + m (c K_r, K_r)     for Mounting::spring
  ///
  /// K_r is the stiffness of the rear set in the mounted state. If c = 0, the rear set in series
  /// with a support of type Mounting::rigid has the stiffness (1 - m) K_r. If k = 0, the rear set
  /// in series with a support of type Mounting::spring has the stiffness m K_r. In both cases, the
  /// stiffness is linear in m.
  struct Seat {
    double softness, hardness;
  };
  [[nodiscard]] Seat seat() const { return seat_; }

 private:
  ArrangementDesign design_;
  std::vector<MountedBearing> bearings_;
  Seat seat_{};
  double preload_ = 0.0, front_displacement_ = 0.0, rear_displacement_ = 0.0;
};

/// External axial loads at which the front set or the rear set of a mounted arrangement becomes
/// unloaded at standstill [N]. The loads are positive towards the tool.
/// Source: equilibrium of the mounted state. For a pair of equal bearings, the contact law F ~
///         δ^1.5 (force F, compression δ) gives a lift-off load of 2.83 times the preload [SNFA, p.
///         33].
struct LiftOff {
  double front = unset;  ///< load at which the front set becomes unloaded
  /// Load at which the rear set becomes unloaded. NaN means that this load does not exist (in
  /// tandem, or if a spring of constant force keeps the rear set loaded), or that this load would
  /// raise the contact pressure in the front set above static_limit_pressure.
  double rear = unset;
};

[[nodiscard]] LiftOff lift_off(const Arrangement& arrangement);

/// Axial force of one bearing at standstill [N]. The inner ring is displaced axially by
/// `displacement` [m] from the no-load position.
[[nodiscard]] double axial_force_at_rest(const Bearing& bearing, double displacement);

/// Axial displacement of the inner ring at standstill under an axial force >= 0 [m]. This is the
/// inverse function of axial_force_at_rest().
[[nodiscard]] double displacement_at_rest(const Bearing& bearing, double force);

/// Preload gap of a pair of universally matched bearings. If such a bearing is loaded with the
/// force of its preload class, the faces of its inner and outer ring are flush. The gap is the sum
/// of the displacements of one front bearing and one rear bearing, each under the preload force
/// that the catalogue gives for a pair. Larger sets have a higher preload than the pair: 1.35 times
/// if one set has two bearings, and 2 times if both sets have two bearings [SNFA, p. 31].
[[nodiscard]] PreloadOffset matched_preload(const Bearing& front, double front_force,
                                            const Bearing& rear, double rear_force);

}  // namespace raceway::bearing
