#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

/// Number types for code that computes one operating point, or several operating points in
/// parallel: `double`, or SIMD batches with one point per lane. Batches define arithmetic,
/// comparisons, sqrt and other functions (found by argument-dependent lookup). This header adds
/// functions that `double` lacks, such as select(), and functions for both number types. If lanes
/// need different results, the code selects these results with a mask instead of a branch.
namespace raceway::bearing {

/// Properties of a number type T: `Mask` is the type of the result of `a < b`, and `count` is the
/// number of operating points in one T.
template <typename T>
struct Lanes {
  using Mask = typename T::batch_bool_type;
  static constexpr std::size_t count = T::size;
};

template <>
struct Lanes<double> {
  using Mask = bool;
  static constexpr std::size_t count = 1;
};

template <typename T>
using Mask = typename Lanes<T>::Mask;

template <typename T>
inline constexpr bool is_scalar = Lanes<T>::count == 1;

[[gnu::always_inline]] inline double select(bool mask, double yes, double no) {
  return mask ? yes : no;
}
[[gnu::always_inline]] inline bool any(bool mask) { return mask; }
[[gnu::always_inline]] inline bool all(bool mask) { return mask; }

/// Returns sine and cosine. Batches define their own function with this name.
[[gnu::always_inline]] inline std::pair<double, double> sincos(double x) {
  return {std::sin(x), std::cos(x)};
}

/// Returns the mask of lanes that are neither infinite nor NaN. One subtraction tests all lanes.
template <typename T>
[[gnu::always_inline]] inline Mask<T> finite(const T& x) {
  return x - x == T(0.0);
}

template <typename T>
[[gnu::always_inline]] inline double lane(const T& x, std::size_t i) {
  double value;
  std::memcpy(&value, reinterpret_cast<const char*>(&x) + i * sizeof value, sizeof value);
  return value;
}

template <typename T>
[[gnu::always_inline]] inline void set_lane(T& x, std::size_t i, double value) {
  std::memcpy(reinterpret_cast<char*>(&x) + i * sizeof value, &value, sizeof value);
}

/// Copies `count` lanes of all members of a struct: lanes j, j + 1, ... of `from` become lanes i,
/// i + 1, ... of `to`. All members of the struct must have the number type of the struct.
template <std::size_t count = 1, typename T, typename U, template <typename> class Struct>
[[gnu::always_inline]] inline void copy_lanes(Struct<T>& to, std::size_t i, const Struct<U>& from,
                                              std::size_t j) {
  constexpr std::size_t members = sizeof(Struct<double>) / sizeof(double);
  for (std::size_t m = 0; m < members; ++m)
    std::memcpy(reinterpret_cast<char*>(&to) + m * sizeof(T) + i * sizeof(double),
                reinterpret_cast<const char*>(&from) + m * sizeof(U) + j * sizeof(double),
                count * sizeof(double));
}

/// Values of one quantity at eight operating points, in memory. SIMD batches of 2, 4 or 8 points
/// load from this memory.
struct alignas(64) Eight {
  static constexpr std::size_t size = 8;
  double lanes[size];
  Eight() = default;
  [[gnu::always_inline]] Eight(double all) {
    for (double& x : lanes) x = all;
  }
};

}  // namespace raceway::bearing
