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

/// Support of the outer rings of the rear set: fixed in the housing, or pushed by a preload spring.
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

/// Preload force at standstill: sum of the axial forces of the front bearings, equal to the sum of
/// the rear bearings or, in tandem, to the spring force [N], >= 0.
struct PreloadForce {
  double force = unset;
  [[nodiscard]] bool operator==(const PreloadForce&) const = default;
};

/// Preload as a gap that clamping closes [m]: axial travel from the position in which both sets
/// just touch, without load, to the clamped position.
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
  /// Share of the other kind of mounting in the support of the rear set, from 0 to 1 [1]. The other
  /// kind is a rigid mounting if `mounting` is `spring`, and a spring of constant force if
  /// `mounting` is `rigid`. The share must be 0 in tandem. See Arrangement::Seat.
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
/// equilibrium at rest, with each ball as two springs in series. Copies of the object share the
/// bearings.
///
/// x is the shaft's axial position at the front set, positive towards the tool, zero as mounted: at
/// standstill, at the mounting temperature, without external load. With d = 1 (X arrangement:
/// d = -1), the axial compressions of the two sets are
///
///   front   δ_f = δ_f0 - d x
///   rear    δ_r = δ_r0 + d (x - e) - c (F_r - F_0)     rigid mounting
///           F_r = F_0 + k (d (x - e) - (δ_r - δ_r0))   spring mounting
///   c = 1/shaft_stiffness + 1/housing_stiffness,  1/k = 1/spring_rate + c
///
/// At δ = 0 the balls of a bearing without offset just touch both races, at the nominal contact
/// angle. e is the elongation of the shaft minus the elongation of the housing between the sets.
/// F_r is the axial force of the rear set, and the index 0 means: as mounted. In tandem the spring
/// replaces the rear set.
class Arrangement {
 public:
  /// Throws std::invalid_argument with name, value and allowed range for a missing or impossible
  /// value.
  explicit Arrangement(ArrangementDesign design);

  [[nodiscard]] const ArrangementDesign& design() const { return design_; }
  /// Bearings in the order from the tool to the rear.
  [[nodiscard]] std::span<const MountedBearing> bearings() const { return bearings_; }
  [[nodiscard]] std::size_t front_count() const { return design_.front.size(); }
  [[nodiscard]] Side side(std::size_t bearing) const {
    return bearing < front_count() ? Side::front : Side::rear;
  }
  /// d: 1 if the front set pushes the shaft towards the tool, else -1.
  [[nodiscard]] double direction() const {
    return design_.layout == Layout::face_to_face ? -1.0 : 1.0;
  }
  /// Axial force on each side as mounted, F_0 [N].
  [[nodiscard]] double preload() const { return preload_; }
  /// Axial compression of a set as mounted, δ_f0 or δ_r0 [m]; 0 for the rear of a tandem.
  [[nodiscard]] double displacement(Side side) const {
    return side == Side::front ? front_displacement_ : rear_displacement_;
  }
  /// Support of the rear set, described by the relation
  ///
  ///   softness (F_r - F_0) = hardness (d (x - e) - (δ_r - δ_r0))
  ///
  /// F_r is the axial force and δ_r the compression of the rear set, F_0 and δ_r0 are their mounted
  /// values, and x, e, d, c and k are as in the comment of Arrangement.
  ///
  /// Without a share m of the other mounting, (softness, hardness) is (c [m/N], 1) for a rigid
  /// mounting and (1, k [N/m]) for a spring. With m = ArrangementDesign::other_mounting > 0, the
  /// pair is
  ///
  ///   (1 - m) (c K_r, K_r) + m (1, 0)     for an entered rigid mounting
  ///   (1 - m) (1, k) + m (c K_r, K_r)     for an entered spring
  ///
  /// K_r is the stiffness of the rear set as mounted. If c = 0, the rear set and its support in
  /// series have the stiffness (1 - m) K_r with an entered rigid mounting, and m K_r with an
  /// entered spring of constant force (k = 0). For a small displacement of the shaft, the change of
  /// the rear force is then linear in m.
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

/// External axial loads, positive towards the tool, at which one side of the mounted arrangement
/// becomes unloaded at standstill [N].
/// Source: geometry of the mounted state; the force law F ~ δ^1.5 gives a lift-off load of 2.83
///         times the preload for a pair of equal bearings [SNFA, p. 33].
struct LiftOff {
  double front = unset;  ///< load at which the front set becomes unloaded
  /// Load at which the rear set becomes unloaded. The value is NaN without a rear set (tandem), if
  /// a spring of constant force keeps the set loaded, or if the pressure in the front set exceeds
  /// static_limit_pressure under this load.
  double rear = unset;
};

[[nodiscard]] LiftOff lift_off(const Arrangement& arrangement);

/// Axial force of one bearing at standstill when the inner ring is displaced by `displacement` from
/// the no-load position [N].
[[nodiscard]] double axial_force_at_rest(const Bearing& bearing, double displacement);

/// Axial displacement of the inner ring at standstill under an axial force >= 0 [m]; the inverse of
/// axial_force_at_rest().
[[nodiscard]] double displacement_at_rest(const Bearing& bearing, double force);

/// Preload gap of bearings whose faces are ground so that they are flush under the force of a
/// preload class. The gap is the sum of the displacements of one front bearing and one rear
/// bearing, each under the preload force printed for a pair. Sets of universally matched bearings
/// have a higher preload than the pair: 1.35 times for two bearings against one, and 2 times for
/// two against two [SNFA, p. 31].
[[nodiscard]] PreloadOffset matched_preload(const Bearing& front, double front_force,
                                            const Bearing& rear, double rear_force);

}  // namespace raceway::bearing
