#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

/// Code that is written once for one operating point and for several side by side: its numbers are
/// `double`, or SIMD batches with one point per lane. Batches bring arithmetic, comparisons, sqrt
/// and so on with them (found by their arguments); here is the same for `double`, and what
/// both need beyond that. Where lanes may differ, such code selects by mask instead of branching.
namespace raceway::bearing {

/// Result of a comparison of two T, and how many points a T holds.
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

/// Neither infinite nor NaN. Holds without a classification of each lane.
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

/// Members of a struct of T only, one after the other.
template <typename T, template <typename> class Struct>
[[gnu::always_inline]] inline void set_lane(Struct<T>& to, std::size_t i,
                                            const Struct<double>& from) {
  constexpr std::size_t members = sizeof(Struct<double>) / sizeof(double);
  for (std::size_t m = 0; m < members; ++m)
    std::memcpy(reinterpret_cast<char*>(&to) + m * sizeof(T) + i * sizeof(double),
                reinterpret_cast<const char*>(&from) + m * sizeof(double), sizeof(double));
}

/// Members of `from` in lane i, one after the other.
template <typename T, template <typename> class Struct>
[[gnu::always_inline]] inline void get_lane(const Struct<T>& from, std::size_t i,
                                            Struct<double>& to) {
  constexpr std::size_t members = sizeof(Struct<double>) / sizeof(double);
  for (std::size_t m = 0; m < members; ++m)
    std::memcpy(reinterpret_cast<char*>(&to) + m * sizeof(double),
                reinterpret_cast<const char*>(&from) + m * sizeof(T) + i * sizeof(double),
                sizeof(double));
}

}  // namespace raceway::bearing
