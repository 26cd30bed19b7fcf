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
///   face_to_face   X: opposite directions
///   tandem         all bearings in one set, which pushes towards the tool, against a spring
enum class Layout { back_to_back, face_to_face, tandem };

/// Support of the outer rings of the rear set: fixed in the housing, or preloaded by a spring.
enum class Mounting { rigid, spring };

enum class Side { front, rear };

/// One bearing of a set.
struct MountedBearing {
  std::shared_ptr<const Bearing> bearing;
  /// Additional compression of this bearing relative to its set, because of its ground faces [m].
  double offset = 0.0;
  [[nodiscard]] bool operator==(const MountedBearing&) const = default;
};

/// Axial force on each side at standstill, the sum over its bearings [N], > 0.
struct PreloadForce {
  double force = unset;
  [[nodiscard]] bool operator==(const PreloadForce&) const = default;
};

/// Clamping travel from first contact of the two sides [m]. This travel equals the gap ground into
/// the faces.
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
  /// Interpolation from this mounting (0) to the other one (1) [1]: from a spring to a rigid
  /// mounting, or from a rigid mounting to a spring of constant force. See Arrangement::Seat.
  double other_mounting = 0.0;
  /// Axial stiffness between the sets, in series with them [N/m].
  double shaft_stiffness = std::numeric_limits<double>::infinity();
  double housing_stiffness = std::numeric_limits<double>::infinity();
  /// Distance of the sets, for thermal expansion [m]
  double distance = 0.0;
  double shaft_expansion = 11.5 * per_million_K;    ///< [1/K]
  double housing_expansion = 11.5 * per_million_K;  ///< [1/K]
  double mounting_temperature = kelvin(20);         ///< temperature when the preload was set [K]
  [[nodiscard]] bool operator==(const ArrangementDesign&) const = default;
};

/// Sets of bearings on a shaft, preloaded at standstill. Immutable. The constructor solves the
/// equilibrium at rest. There each ball acts as two springs in series, so its position is not an
/// unknown. Copies share the bearings.
///
/// x is the shaft's axial position at the front set, positive towards the tool, zero as mounted: at
/// standstill, at the mounting temperature, without external load. With d = 1 (X: d = -1), the
/// axial compressions of the two sets are
///
///   front   δ_f = δ_f0 - d x
///   rear    δ_r = δ_r0 + d (x - e) - c (F_r - F_0)     rigid, c = 1/shaft + 1/housing stiffness
///           F_r = F_0 + k (d (x - e) - (δ_r - δ_r0))   spring, 1/k = 1/rate + c
///
/// δ is zero if the balls of a bearing just touch at their nominal contact angle. e is the
/// elongation of the shaft minus the elongation of the housing between the sets. In tandem the
/// spring replaces the rear set.
class Arrangement {
 public:
  /// Throws std::invalid_argument for a missing or impossible value. The message gives its name,
  /// its value with unit, and the allowed range.
  explicit Arrangement(ArrangementDesign design);

  [[nodiscard]] const ArrangementDesign& design() const { return design_; }
  /// Bearings from the tool to the rear, front set first.
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
  /// δ_f0 or δ_r0 [m].
  [[nodiscard]] double displacement(Side side) const {
    return side == Side::front ? front_displacement_ : rear_displacement_;
  }
  /// Seat of the rear set: `softness` (F_r - F_0) = `hardness` (d (x - e) - (δ_r - δ_r0)).
  ///
  /// Without a share m of the other mounting, (softness, hardness) is (c [m/N], 1) for a rigid
  /// mounting and (1, k [N/m]) for a spring. With m = ArrangementDesign::other_mounting > 0, the
  /// pair is
  ///
  ///   (1 - m) (c K_r, K_r) + m (1, 0)     for an entered rigid mounting
  ///   (1 - m) (1, k) + m (c K_r, K_r)     for an entered spring
  ///
  /// K_r is the stiffness of the rear set as mounted. The rear set and its seat in series then have
  /// the stiffness (1 - m) K_r for a rigid mounting with c = 0, and m K_r for a spring with k = 0.
  /// The preload varies in proportion to this stiffness, so the variation is linear in m.
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

/// External axial loads at which one side of the mounted arrangement loses its load at standstill
/// [N].
/// Source: geometry of the mounted state; F ~ δ^1.5 gives 2.83 preloads for a pair [SNFA, p. 33].
struct LiftOff {
  double front = unset;  ///< the front set loses its load; positive towards the tool
  /// the rear set loses its load. The value is NaN without a rear set (tandem), if a spring of
  /// constant force keeps the set loaded, or if a smaller load already dents the contacts of the
  /// front set.
  double rear = unset;
};

[[nodiscard]] LiftOff lift_off(const Arrangement& arrangement);

/// Axial force of one bearing at standstill when the inner ring is displaced by `displacement` from
/// the no-load position [N]. The ball acts as two springs in series.
[[nodiscard]] double axial_force_at_rest(const Bearing& bearing, double displacement);

/// Displacement under an axial force >= 0 [m]; the inverse of axial_force_at_rest().
[[nodiscard]] double displacement_at_rest(const Bearing& bearing, double force);

/// Preload gap of bearings whose faces are ground so that they are flush under the force of a
/// preload class. The gap is the sum of the displacements of one front bearing and one rear
/// bearing, each under the force printed for a pair. Sets of universally matched bearings have a
/// higher preload than the pair: 1.35 times for two bearings against one, 2 times for two against
/// two [SNFA, p. 31].
[[nodiscard]] PreloadOffset matched_preload(const Bearing& front, double front_force,
                                            const Bearing& rear, double rear_force);

}  // namespace raceway::bearing
