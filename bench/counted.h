#pragma once

#include <cmath>

#include "bearing/lanes.h"

namespace raceway::limit {

/// A double that counts the operations on it. The solver runs with this type, so its own code is
/// counted.
struct Counted {
  double value = 0.0;
  static inline long roots = 0, divisions = 0, products = 0, sums = 0;

  Counted() = default;
  Counted(double v) : value(v) {}  // NOLINT: numbers mix with double
  friend bool operator==(const Counted&, const Counted&) = default;
};

inline Counted operator+(const Counted& a, const Counted& b) {
  ++Counted::sums;
  return a.value + b.value;
}
inline Counted operator-(const Counted& a, const Counted& b) {
  ++Counted::sums;
  return a.value - b.value;
}
inline Counted operator*(const Counted& a, const Counted& b) {
  ++Counted::products;
  return a.value * b.value;
}
inline Counted operator/(const Counted& a, const Counted& b) {
  ++Counted::divisions;
  return a.value / b.value;
}
inline Counted& operator+=(Counted& a, const Counted& b) { return a = a + b; }
inline Counted& operator-=(Counted& a, const Counted& b) { return a = a - b; }
inline Counted operator-(const Counted& a) { return -a.value; }
inline Counted sqrt(const Counted& a) {
  ++Counted::roots;
  return std::sqrt(a.value);
}
inline Counted abs(const Counted& a) { return std::abs(a.value); }
inline Counted max(const Counted& a, const Counted& b) { return std::fmax(a.value, b.value); }
inline bool operator<(const Counted& a, const Counted& b) { return a.value < b.value; }
inline bool operator>(const Counted& a, const Counted& b) { return a.value > b.value; }
inline bool operator<=(const Counted& a, const Counted& b) { return a.value <= b.value; }
inline bool operator>=(const Counted& a, const Counted& b) { return a.value >= b.value; }
inline Counted select(bool mask, const Counted& yes, const Counted& no) { return mask ? yes : no; }

}  // namespace raceway::limit

template <>
struct raceway::bearing::Lanes<raceway::limit::Counted> {
  using Mask = bool;
  static constexpr std::size_t count = 1;
};
