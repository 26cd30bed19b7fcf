#pragma once

#include <cstddef>
#include <iterator>
#include <span>
#include <stdexcept>
#include <vector>

#include "record/units.h"

namespace raceway::bearing {

/// Symmetry of the ball loads. The symmetry determines the unknowns of the solver: ball positions
/// and ring coordinates (x, y, z, and the tilts θy, θz).
enum class Symmetry {
  /// Pure axial load, so that all balls have equal loads. Unknowns: x and the position of one ball.
  thrust,
  /// Load in the x-y plane, so that ball k and ball Z - k have equal loads. Z is the number of
  /// balls. Unknowns: the positions of balls 0 to Z/2, x, y, and θz if the tilt is free.
  mirror,
  /// No symmetry. Unknowns: the positions of all balls, x, y, z, and θy and θz if the tilt is free.
  none
};

/// Number of distinct balls in a bearing with `count` balls. Of the balls that have equal loads by
/// symmetry, only the ball with the lowest index is distinct.
[[nodiscard, gnu::always_inline]] constexpr int distinct_balls(Symmetry symmetry, int count) {
  return symmetry == Symmetry::thrust ? 1 : symmetry == Symmetry::mirror ? count / 2 + 1 : count;
}

/// Number of balls with the same load as distinct ball k, including ball k [1].
[[nodiscard, gnu::always_inline]] constexpr double weight_of_ball(Symmetry symmetry, int count,
                                                                  int k) {
  if (symmetry == Symmetry::none) return 1.0;
  if (symmetry == Symmetry::thrust) return count;
  return k == 0 || 2 * k == count ? 1.0 : 2.0;
}

/// Azimuth ψ of ball k, from +y towards +z [rad].
[[nodiscard]] constexpr double azimuth_of_ball(int k, int count) { return 2.0 * pi * k / count; }

/// Angles, loads and forces of one ball in equilibrium.
struct BallEquilibrium {
  double azimuth = unset;              ///< ψ from +y towards +z [rad]
  double inner_contact_angle = unset;  ///< αi [rad]; NaN without contact at the inner race
  double outer_contact_angle = unset;  ///< αo [rad]; NaN for a ball at rest without contact
  double inner_load = unset;           ///< Qi, load at the inner race [N]
  double outer_load = unset;           ///< Qo, load at the outer race [N]
  double inner_friction = unset;       ///< Ti, friction force at the inner race [N]
  double outer_friction = unset;       ///< To, friction force at the outer race [N]
  double centrifugal_force = unset;    ///< Fc [N]
  double gyroscopic_moment = unset;    ///< M_g, balanced by Ti and To [N m]
};

/// All Z balls of a bearing in equilibrium, with ball k at azimuth 2 π k/Z. Balls with equal loads
/// by symmetry are stored once. For a sum over all balls, use `distinct()` and `weight()`.
class Balls {
 public:
  Balls() = default;

  /// Sets the number of balls and the symmetry. Returns the elements of distinct(), into which the
  /// solver writes its results.
  std::span<BallEquilibrium> reset(int count, Symmetry symmetry) {
    count_ = count;
    symmetry_ = symmetry;
    distinct_.resize(static_cast<std::size_t>(distinct_balls(symmetry, count)));
    return distinct_;
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(count_); }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Index of the ball in distinct() that has the same load as ball k.
  [[nodiscard]] std::size_t twin(std::size_t k) const {
    return symmetry_ == Symmetry::thrust                     ? 0
           : symmetry_ == Symmetry::mirror && 2 * k > size() ? size() - k
                                                             : k;
  }
  [[nodiscard]] BallEquilibrium operator[](std::size_t k) const {
    BallEquilibrium ball = distinct_[twin(k)];
    ball.azimuth = azimuth_of_ball(static_cast<int>(k), count_);
    return ball;
  }
  [[nodiscard]] BallEquilibrium at(std::size_t k) const {
    if (k >= size()) throw std::out_of_range("the bearing has no ball with this number");
    return (*this)[k];
  }

  /// First ball of each group of balls with equal loads, in the order of azimuth.
  [[nodiscard]] std::span<const BallEquilibrium> distinct() const { return distinct_; }
  /// Number of balls with the same load as distinct ball i, including ball i [1].
  [[nodiscard]] double weight(std::size_t i) const {
    return weight_of_ball(symmetry_, count_, static_cast<int>(i));
  }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = BallEquilibrium;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = BallEquilibrium;

    Iterator(const Balls& balls, std::size_t k) : balls_(&balls), k_(k) {}
    BallEquilibrium operator*() const { return (*balls_)[k_]; }
    Iterator& operator++() {
      ++k_;
      return *this;
    }
    Iterator operator++(int) { return {*balls_, k_++}; }
    bool operator==(const Iterator& other) const { return k_ == other.k_; }

   private:
    const Balls* balls_;
    std::size_t k_;
  };
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

 private:
  std::vector<BallEquilibrium> distinct_;
  int count_ = 0;
  Symmetry symmetry_ = Symmetry::none;
};

}  // namespace raceway::bearing
