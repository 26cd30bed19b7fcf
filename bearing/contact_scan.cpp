#include "bearing/contact_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace raceway::bearing {
namespace {

constexpr int locked_nodes = 40, free_nodes = 12;  // of the grid in each direction
constexpr std::size_t table_nodes = 56;            // of the places of a groove, in each direction
constexpr int most_ball_steps = 40;
// How far the ring is moved, of the distance of its groove centres [1].
constexpr double farthest_in = 0.3, farthest_aside = 0.4, farthest_tilt = 0.6;

/// The ring on a line and about an axis that the load gives: x, y along the load, R θ about the
/// axis across it [m].
struct Node {
  double axial, radial, tilt;
};

class ContactScan {
 public:
  ContactScan(const RingSystem& system, double direction)
      : system_(system),
        constants_(system.constants()),
        distance_(constants_.inner_radius + constants_.outer_radius),
        cos_(std::cos(direction)),
        sin_(std::sin(direction)),
        tilts_(system.options().tilt == Tilt::free) {
    const BearingGeometry& g = system.geometry();
    arm_ = g.inner_conformity * g.ball_diameter / system.lever();
    const auto load = system.load();
    load_[0] = load[0];
    load_[1] = load[1] * cos_ + load[2] * sin_;
    load_[2] = load[4] * cos_ - load[3] * sin_;
    for (std::size_t k = 0; k < system.balls_used(); ++k)
      along_.push_back(system.bearing().cos_azimuth()[k] * cos_ +
                       system.bearing().sin_azimuth()[k] * sin_);
  }

  std::vector<ScannedSet> run() {
    tabulate();
    const int nodes = tilts_ ? free_nodes : locked_nodes;
    for (int i = 0; i < (tilts_ ? nodes : 1); ++i)
      for (int j = 0; j < nodes; ++j)
        for (int k = 0; k < nodes; ++k)
          visit(
              {at(k, nodes, -system_.free_groove_centre().axial, farthest_in * distance_),
               at(j, nodes, -farthest_aside * distance_, farthest_aside * distance_),
               tilts_ ? at(i, nodes, -farthest_tilt * distance_, farthest_tilt * distance_) : 0.0});
    std::stable_sort(sets_.begin(), sets_.end(), [](const ScannedSet& a, const ScannedSet& b) {
      return a.imbalance < b.imbalance;
    });
    return std::move(sets_);
  }

 private:
  /// How a ball may stand where the grooves come too near for it: off their line to either side, or
  /// without the inner race.
  enum class Stand { outward, inward, lost };
  static constexpr std::array stands{Stand::outward, Stand::inward, Stand::lost};
  struct Held {
    Plane place;
    Plane force;          ///< on the ring [N]
    double moment_force;  ///< [N]
    InnerContact contact;
  };
  /// All ways in which a ball can stand with its groove there.
  using Ways = std::vector<Held>;

  static double at(int i, int nodes, double low, double high) {
    return low + (high - low) * i / (nodes - 1);
  }

  [[nodiscard]] Plane groove_centre(const Node& n, double along) const {
    const Plane free = system_.free_groove_centre();
    return {free.axial + n.axial - n.tilt * along, free.radial + n.radial * along};
  }

  /// Touching both races, between the groove centres or beside their line.
  [[nodiscard]] Plane between(Plane a, Stand stand) const {
    const double outer = system_.thrown_ball().radial, inner = 1.0001 * constants_.inner_radius;
    const double length = std::hypot(a.axial, a.radial);
    const Plane along{a.axial / length, a.radial / length};
    double part = length * outer / (outer + inner), aside = 0.0;
    if (length < outer + inner) {
      part = (outer * outer - inner * inner + length * length) / (2.0 * length);
      aside = std::sqrt(std::max(outer * outer - part * part, 0.0));
      if (stand == Stand::inward) aside = -aside;
    }
    return {part * along.axial + aside * along.radial, part * along.radial - aside * along.axial};
  }

  /// One ball that stands so; nothing where it finds no balance or would pull.
  [[nodiscard]] std::optional<Held> held(Plane a, Stand stand) const {
    const InnerContact contact = stand == Stand::lost ? InnerContact::lost : InnerContact::kept;
    Plane x = stand == Stand::lost ? system_.thrown_ball() : between(a, stand);
    for (int i = 0; i < most_ball_steps; ++i) {
      const BallBalance b =
          ball_balance_under<Rotation::inner_control, double>(constants_, a, x, arm_, contact);
      const double inv = -1.0 / (b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2]);
      Plane step{inv * (b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial),
                 inv * (b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial)};
      const double length = std::hypot(step.axial, step.radial);
      if (!std::isfinite(length)) return std::nullopt;
      if (length < 1e-7 * distance_) {
        if ((b.inner_approach > 0.0) != (contact == InnerContact::kept)) return std::nullopt;
        return Held{x, b.force, b.moment_force, contact};
      }
      const double share = std::min(1.0, 0.2 * constants_.outer_radius / length);
      x = {x.axial + share * step.axial, x.radial + share * step.radial};
      const double outer = std::hypot(x.axial, x.radial);
      const double least =
          constants_.outer_radius + 0.1 * std::max(b.outer_approach, 0.0);  // never off the race
      if (outer < least) x = {x.axial * least / outer, x.radial * least / outer};
    }
    return std::nullopt;
  }

  /// What a ball does depends on the place of its groove alone.
  void tabulate() {
    const Plane free = system_.free_groove_centre();
    const double tilt = tilts_ ? farthest_tilt * distance_ : 0.0;
    low_ = {-tilt, free.radial - farthest_aside * distance_};
    const Plane high{free.axial + farthest_in * distance_ + tilt,
                     free.radial + farthest_aside * distance_};
    step_ = {(high.axial - low_.axial) / (table_nodes - 1),
             (high.radial - low_.radial) / (table_nodes - 1)};
    table_.resize(table_nodes * table_nodes);
    for (std::size_t i = 0; i < table_nodes; ++i)
      for (std::size_t j = 0; j < table_nodes; ++j)
        for (const Stand stand : stands)
          if (const auto ball = held({low_.axial + static_cast<double>(i) * step_.axial,
                                      low_.radial + static_cast<double>(j) * step_.radial},
                                     stand))
            table_[i * table_nodes + j].push_back(*ball);
  }

  [[nodiscard]] const Ways& ways_near(Plane a) const {
    const auto index = [](double x) {
      return static_cast<std::size_t>(
          std::clamp(std::lround(x), 0L, static_cast<long>(table_nodes) - 1));
    };
    return table_[index((a.axial - low_.axial) / step_.axial) * table_nodes +
                  index((a.radial - low_.radial) / step_.radial)];
  }

  using Sums = std::array<double, 3>;
  /// What ball k adds, standing so [N].
  [[nodiscard]] Sums adds(std::size_t k, const Held& ball) const {
    const double weight = system_.weight(k);
    return {weight * ball.force.axial, weight * ball.force.radial * along_[k],
            tilts_ ? -weight * ball.moment_force * along_[k] : 0.0};
  }

  /// Of each ball the way that leaves the ring nearest to balance, by turns.
  void visit(const Node& node) {
    chosen_.assign(along_.size(), 0);
    ways_.clear();
    Sums sums{-load_[0], -load_[1], tilts_ ? -load_[2] : 0.0};
    for (std::size_t k = 0; k < along_.size(); ++k) {
      const Ways& ways = ways_near(groove_centre(node, along_[k]));
      if (ways.empty()) return;
      ways_.push_back(&ways);
      const Sums first = adds(k, ways.front());
      for (std::size_t i = 0; i < 3; ++i) sums[i] += first[i];
    }
    while (improve(sums)) {
    }
    keep(node, size(sums));
  }

  static double size(const Sums& sums) {
    return std::max({std::abs(sums[0]), std::abs(sums[1]), std::abs(sums[2])});
  }

  /// Takes the one other way of a ball that helps most.
  bool improve(Sums& sums) {
    double least = size(sums);
    Sums best{};
    std::size_t ball = along_.size(), way = 0;
    for (std::size_t k = 0; k < along_.size(); ++k)
      for (std::size_t w = 0; w < ways_[k]->size() && ways_[k]->size() > 1; ++w) {
        const Sums before = adds(k, (*ways_[k])[chosen_[k]]), after = adds(k, (*ways_[k])[w]);
        Sums with = sums;
        for (std::size_t i = 0; i < 3; ++i) with[i] += after[i] - before[i];
        if (!(size(with) < 0.999 * least)) continue;
        least = size(with);
        best = with;
        ball = k;
        way = w;
      }
    if (ball == along_.size()) return false;
    chosen_[ball] = way;
    sums = best;
    return true;
  }

  /// A set is worth a try from the node where the ring is nearest to balance, and from those before
  /// it that were much nearer than any other.
  void keep(const Node& node, double imbalance) {
    std::vector<InnerContact> contacts;
    RingState state;
    for (std::size_t k = 0; k < along_.size(); ++k) {
      contacts.push_back((*ways_[k])[chosen_[k]].contact);
      state.balls.push_back((*ways_[k])[chosen_[k]].place);
    }
    const auto [known, fresh] = best_.try_emplace(contacts, imbalance);
    if (!fresh && imbalance > 0.7 * known->second) return;
    known->second = imbalance;
    state.ring << node.axial, node.radial * cos_, node.radial * sin_, -node.tilt * sin_,
        node.tilt * cos_;
    sets_.push_back({std::move(contacts), std::move(state), imbalance / system_.load_scale()});
  }

  const RingSystem& system_;
  const BallConstantsOf<double>& constants_;
  double distance_, cos_, sin_, arm_ = 0.0;
  bool tilts_;
  double load_[3] = {};        // axial, along, and about the axis across [N]
  std::vector<double> along_;  // cosines of the balls to the load
  Plane low_, step_;           // of the table of groove places
  std::vector<Ways> table_;
  std::vector<const Ways*> ways_;  // of each ball at a node
  std::vector<std::size_t> chosen_;
  std::map<std::vector<InnerContact>, double> best_;  // nearest to balance so far
  std::vector<ScannedSet> sets_;
};

}  // namespace

std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction) {
  return ContactScan(system, direction).run();
}

}  // namespace raceway::bearing
