#include "bearing/contact_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace raceway::bearing {
namespace {

// Nodes of the ring's grid in each direction: some 1600 over two coordinates, 1700 over three.
constexpr int locked_tilt_nodes = 40, free_tilt_nodes = 12;
// Places of a groove in each direction: no finer than what a node of the ring can say.
constexpr std::size_t groove_places = 56;

// How far the ring is put, of the distance of its groove centres [1]: in from where grooves stand
// opposite each other, to both sides along the load, and tilted; as far as the brute force looks.
constexpr double farthest_in = 0.3, farthest_aside = 0.4, farthest_tilt = 0.6;

// Newton's method on one ball. The result is a start, so no rounding is asked for.
constexpr int most_scan_ball_steps = 12;
constexpr double scan_ball_tolerance = 1e-7;  // last step, of the distance of groove centres [1]
constexpr double longest_ball_step = 0.2;     // of the radius of the outer groove centre's circle

// A way of a ball is taken where it leaves less than this of the imbalance: no turns for rounding.
constexpr double worth_a_turn = 0.999;
// A set that has occurred is taken once more where it comes that much nearer to balance.
constexpr double worth_a_start = 0.7;

/// A ring on the plane of the load [m]; tilt is R_i θ about the axis across it.
struct RingPlace {
  double axial, along, tilt;
};

/// A ball in balance with its groove at some place.
struct StandingBall {
  Plane centre;
  Plane force;          ///< on the ring [N]
  double moment_force;  ///< f_m of BallBalance [N]
  InnerContact contact;
};

/// All ways in which a ball can stand with its groove at one place.
using BallWays = std::vector<StandingBall>;

class ContactScan {
 public:
  ContactScan(const RingSystem& system, double direction)
      : system_(system),
        constants_(system.constants()),
        free_(system.free_groove_centre()),
        thrown_(system.thrown_ball()),
        touching_(1.0001 * constants_.inner_radius),
        distance_(constants_.inner_radius + constants_.outer_radius),
        cos_(std::cos(direction)),
        sin_(std::sin(direction)),
        tilts_(system.options().tilt == Tilt::free) {
    const BearingGeometry& g = system.geometry();
    arm_ = g.inner_conformity * g.ball_diameter / system.lever();
    const Vector5 load = system.load();
    load_ = {load[0], load[1] * cos_ + load[2] * sin_,
             tilts_ ? load[4] * cos_ - load[3] * sin_ : 0.0};
    for (std::size_t k = 0; k < system.balls_used(); ++k)
      along_.push_back(system.bearing().cos_azimuth()[k] * cos_ +
                       system.bearing().sin_azimuth()[k] * sin_);
  }

  std::vector<ScannedSet> run() {
    span_table();
    const int nodes = tilts_ ? free_tilt_nodes : locked_tilt_nodes;
    const double aside = farthest_aside * distance_, tilt = farthest_tilt * distance_;
    for (int i = 0; i < (tilts_ ? nodes : 1); ++i)
      for (int j = 0; j < nodes; ++j)
        for (int k = 0; k < nodes; ++k)
          visit({.axial = node(k, nodes, -free_.axial, farthest_in * distance_),
                 .along = node(j, nodes, -aside, aside),
                 .tilt = tilts_ ? node(i, nodes, -tilt, tilt) : 0.0});
    std::stable_sort(sets_.begin(), sets_.end(), [](const ScannedSet& a, const ScannedSet& b) {
      return a.imbalance < b.imbalance;
    });
    return std::move(sets_);
  }

 private:
  /// Where Newton's method on a ball starts: on both races, at a larger or a smaller angle to the
  /// outer one, or thrown against that.
  enum class Start { larger_angle, smaller_angle, thrown };

  /// Along the axis, along the load, and the moment across it divided by the lever [N].
  using RingForce = std::array<double, 3>;

  static double length_of(Plane p) { return std::sqrt(p.axial * p.axial + p.radial * p.radial); }

  static double node(int i, int nodes, double low, double high) {
    return low + (high - low) * i / (nodes - 1);
  }

  /// Inner groove centre of a ball, whose azimuth has this cosine to the load.
  [[nodiscard]] Plane groove_centre(const RingPlace& ring, double cosine) const {
    return {free_.axial + ring.axial - ring.tilt * cosine, free_.radial + ring.along * cosine};
  }

  /// The places to which a groove comes with the ring on the grid.
  void span_table() {
    const double tilt = tilts_ ? farthest_tilt * distance_ : 0.0;
    const double aside = farthest_aside * distance_;
    low_ = {-tilt, free_.radial - aside};
    const Plane high{free_.axial + farthest_in * distance_ + tilt, free_.radial + aside};
    step_ = {(high.axial - low_.axial) / (groove_places - 1),
             (high.radial - low_.radial) / (groove_places - 1)};
    table_.resize(groove_places * groove_places);
  }

  /// A ball in every way at the nearest place, which is filled in when a ball first comes there.
  const BallWays& ways_near(Plane groove) {
    const auto index = [](double x) {
      return static_cast<std::size_t>(
          std::clamp(std::lround(x), 0L, static_cast<long>(groove_places) - 1));
    };
    const std::size_t i = index((groove.axial - low_.axial) / step_.axial);
    const std::size_t j = index((groove.radial - low_.radial) / step_.radial);
    std::optional<BallWays>& ways = table_[i * groove_places + j];
    if (!ways)
      ways = ways_at({low_.axial + static_cast<double>(i) * step_.axial,
                      low_.radial + static_cast<double>(j) * step_.radial});
    return *ways;
  }

  [[nodiscard]] BallWays ways_at(Plane groove) const {
    BallWays ways;
    for (const Start start : {Start::larger_angle, Start::smaller_angle, Start::thrown}) {
      // Both starts are the same there.
      if (start == Start::smaller_angle && presses_on_both(groove)) continue;
      if (const auto ball = balanced(groove, start)) ways.push_back(*ball);
    }
    return ways;
  }

  /// One ball from that start; nothing where Newton's method finds no balance, where a kept contact
  /// would pull or a lost one reach into the race.
  [[nodiscard]] std::optional<StandingBall> balanced(Plane groove, Start start) const {
    const bool kept = start != Start::thrown;
    const InnerContact contact = kept ? InnerContact::kept : InnerContact::lost;
    Plane x = kept ? on_both_races(groove, start) : thrown_;
    for (int i = 0; i < most_scan_ball_steps; ++i) {
      const BallBalance b =
          ball_balance_under<Rotation::inner_control, double>(constants_, groove, x, arm_, contact);
      const double inv = -1.0 / (b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2]);
      const Plane step{inv * (b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial),
                       inv * (b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial)};
      const double length = length_of(step);
      if (!std::isfinite(length)) return std::nullopt;
      if (length < scan_ball_tolerance * distance_) {
        if ((b.inner_approach > 0.0) != kept) return std::nullopt;
        return StandingBall{x, b.force, b.moment_force, contact};
      }
      const double share = std::min(1.0, longest_ball_step * constants_.outer_radius / length);
      x = {x.axial + share * step.axial, x.radial + share * step.radial};
      // The centrifugal force keeps every ball on the outer race; a step that leaves it is cut.
      const double outer = length_of(x);
      const double least = constants_.outer_radius + 0.1 * std::max(b.outer_approach, 0.0);
      if (outer < least) x = {x.axial * least / outer, x.radial * least / outer};
    }
    return std::nullopt;
  }

  /// True if a ball on the line between the groove centres is pressed on both races.
  [[nodiscard]] bool presses_on_both(Plane groove) const {
    return length_of(groove) >= thrown_.radial + touching_;
  }

  /// Centre of a ball on both races. If the ball is pressed on the line between the groove centres,
  /// the centre is on this line; otherwise the ball just touches both races beside the line, and is
  /// pressed slightly into the inner race, which has no stiffness without load.
  [[nodiscard]] Plane on_both_races(Plane groove, Start start) const {
    const double outer = thrown_.radial, length = length_of(groove);
    const Plane line{groove.axial / length, groove.radial / length};
    double part = length * outer / (outer + touching_), beside = 0.0;
    if (!presses_on_both(groove)) {  // corner of a triangle with sides outer, touching_ and length
      part = (outer * outer - touching_ * touching_ + length * length) / (2.0 * length);
      beside = std::sqrt(std::max(outer * outer - part * part, 0.0));
      if (start == Start::smaller_angle) beside = -beside;
    }
    return {part * line.axial + beside * line.radial, part * line.radial - beside * line.axial};
  }

  /// With the ring there, of each ball the way that leaves least of the load.
  void visit(const RingPlace& ring) {
    ways_.clear();
    chosen_.assign(along_.size(), 0);
    RingForce left{-load_[0], -load_[1], -load_[2]};
    for (std::size_t k = 0; k < along_.size(); ++k) {
      const BallWays& ways = ways_near(groove_centre(ring, along_[k]));
      if (ways.empty()) return;  // a ball that cannot stand there at all
      ways_.push_back(&ways);
      const RingForce first = force_of(k, ways.front());
      for (std::size_t i = 0; i < left.size(); ++i) left[i] += first[i];
    }
    while (turn_best_ball(left)) {
    }
    keep(ring, largest(left));
  }

  /// Turns the one ball, to that other way, after which least is left; false where none helps.
  bool turn_best_ball(RingForce& left) {
    double least = largest(left);
    RingForce best{};
    std::size_t ball = along_.size(), way = 0;
    for (std::size_t k = 0; k < along_.size(); ++k) {
      const BallWays& ways = *ways_[k];
      if (ways.size() == 1) continue;
      const RingForce now = force_of(k, ways[chosen_[k]]);
      for (std::size_t w = 0; w < ways.size(); ++w) {
        const RingForce then = force_of(k, ways[w]);
        RingForce with = left;
        for (std::size_t i = 0; i < with.size(); ++i) with[i] += then[i] - now[i];
        if (!(largest(with) < worth_a_turn * least)) continue;
        least = largest(with);
        best = with;
        ball = k;
        way = w;
      }
    }
    if (ball == along_.size()) return false;
    chosen_[ball] = way;
    left = best;
    return true;
  }

  /// The set of this node, if it has not occurred nearer to balance before.
  void keep(const RingPlace& ring, double imbalance) {
    const auto ball = [&](std::size_t k) -> const StandingBall& { return (*ways_[k])[chosen_[k]]; };
    contacts_.clear();
    for (std::size_t k = 0; k < along_.size(); ++k) contacts_.push_back(ball(k).contact);
    const auto [known, fresh] = nearest_.try_emplace(contacts_, imbalance);
    if (!fresh && imbalance > worth_a_start * known->second) return;
    known->second = imbalance;
    RingState state;
    for (std::size_t k = 0; k < along_.size(); ++k) state.balls.push_back(ball(k).centre);
    state.ring << ring.axial, ring.along * cos_, ring.along * sin_, -ring.tilt * sin_,
        ring.tilt * cos_;
    sets_.push_back({contacts_, std::move(state), imbalance / system_.load_scale()});
  }

  /// What ball k, with those like it, does to the ring.
  [[nodiscard]] RingForce force_of(std::size_t k, const StandingBall& ball) const {
    const double weight = system_.weight(k);
    return {weight * ball.force.axial, weight * ball.force.radial * along_[k],
            tilts_ ? -weight * ball.moment_force * along_[k] : 0.0};
  }

  static double largest(const RingForce& force) {
    return std::max({std::abs(force[0]), std::abs(force[1]), std::abs(force[2])});
  }

  const RingSystem& system_;
  const BallConstantsOf<double>& constants_;
  Plane free_;       // inner groove centre with the ring in its no-load place [m]
  Plane thrown_;     // a ball without inner contact [m]
  double touching_;  // from the inner groove centre to a ball pressed a trace into the race [m]
  double distance_;  // of the groove centres there [m]
  double cos_, sin_, arm_ = 0.0;
  bool tilts_;
  RingForce load_{};
  std::vector<double> along_;  // cosines of the balls' azimuths to the load
  Plane low_, step_;           // first place of the table, and from one to the next [m]
  std::vector<std::optional<BallWays>> table_;  // by axial and then by radial place of the groove
  std::vector<const BallWays*> ways_;           // of each ball at the node in hand
  std::vector<std::size_t> chosen_;             // one of these
  std::vector<InnerContact> contacts_;          // of the chosen ones
  std::map<std::vector<InnerContact>, double> nearest_;  // least imbalance of each set so far [N]
  std::vector<ScannedSet> sets_;
};

}  // namespace

std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction) {
  return ContactScan(system, direction).run();
}

}  // namespace raceway::bearing
