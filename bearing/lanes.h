#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

/// Number types for code that computes one operating point, or several operating points in
/// parallel: `double`, or SIMD batches. A batch contains one number for each of several operating
/// points; the place of one number in a batch is called a lane. Batches define arithmetic,
/// comparisons, sqrt and other functions. This header adds functions that `double` lacks, such as
/// select(), and functions for both number types. If the operating points need different formulas,
/// the code evaluates every formula for all lanes, and select() chooses one result for each lane.
namespace raceway::bearing {

/// Properties of a number type T. `Mask` is the type of the result of `a < b`, and `count` is the
/// number of operating points in one value of type T.
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

/// Returns sine and cosine. For SIMD batches, the library xsimd has a function sincos().
[[gnu::always_inline]] inline std::pair<double, double> sincos(double x) {
  return {std::sin(x), std::cos(x)};
}

/// Returns true for each lane whose value is neither infinite nor NaN.
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

/// Copies `count` lanes of all members of a struct: lanes j, j + 1, ... of `from` become
/// lanes i, i + 1, ... of `to`. All members of Struct<T> must have the type T.
template <std::size_t count = 1, typename T, typename U, template <typename> class Struct>
[[gnu::always_inline]] inline void copy_lanes(Struct<T>& to, std::size_t i, const Struct<U>& from,
                                              std::size_t j) {
  constexpr std::size_t members = sizeof(Struct<double>) / sizeof(double);
  for (std::size_t m = 0; m < members; ++m)
    std::memcpy(reinterpret_cast<char*>(&to) + m * sizeof(T) + i * sizeof(double),
                reinterpret_cast<const char*>(&from) + m * sizeof(U) + j * sizeof(double),
                count * sizeof(double));
}

/// Array with the values of one quantity at eight operating points. SIMD batches of 2, 4 or 8
/// numbers are loaded from this array.
struct alignas(64) Eight {
  static constexpr std::size_t size = 8;
  double lanes[size];
  Eight() = default;
  [[gnu::always_inline]] Eight(double all) {
    for (double& x : lanes) x = all;
  }
};

}  // namespace raceway::bearing
