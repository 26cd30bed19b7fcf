#pragma once

#include "bearing/lanes.h"

namespace raceway::bearing {

/// Solves the linear equations a x = b by Gaussian elimination with partial pivoting. The result x
/// replaces b, and a is overwritten. If a is singular, x is not finite or, because of rounding
/// errors, very large.
template <int n, typename T>
[[gnu::always_inline]] inline void solve_linear(T (&a)[n][n], T (&b)[n]) {
  using std::abs;
  const auto exchange = [](const Mask<T>& where, T& x, T& y) {
    const T old = x;
    x = select(where, y, x);
    y = select(where, old, y);
  };
  for (int c = 0; c < n; ++c) {
    for (int r = c + 1; r < n; ++r) {
      const Mask<T> larger = abs(a[r][c]) > abs(a[c][c]);
      for (int j = c; j < n; ++j) exchange(larger, a[c][j], a[r][j]);
      exchange(larger, b[c], b[r]);
    }
    const T pivot = 1.0 / a[c][c];
    for (int j = c + 1; j < n; ++j) a[c][j] = a[c][j] * pivot;
    b[c] = b[c] * pivot;
    for (int r = c + 1; r < n; ++r) {
      for (int j = c + 1; j < n; ++j) a[r][j] = a[r][j] - a[r][c] * a[c][j];
      b[r] = b[r] - a[r][c] * b[c];
    }
  }
  for (int c = n - 1; c > 0; --c)
    for (int r = 0; r < c; ++r) b[r] = b[r] - a[r][c] * b[c];
}

}  // namespace raceway::bearing
