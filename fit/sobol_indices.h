#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::fit {

/// Sample points for the Sobol' indices of a function: two sets A and B of points in the unit cube.
/// For every input i, the set AB_i consists of the points of A, with input i replaced by the value
/// in B.
///
/// The points are Sobol' points in 2 x inputs dimensions with the direction numbers of Joe and Kuo.
/// The first half of the dimensions gives A, the second half gives B. The points are randomised by
/// Owen scrambling with the hash of Burley.
///
/// Source:   [Saltelli2010] for the sets; [JoeKuo2008]; [Burley2020, section 3].
/// Domain:   1 to 1800 inputs; the number of samples is a power of two from 2 to 2^24, because only
///           powers of two fill the cube evenly.
class SobolDesign {
 public:
  /// Throws std::invalid_argument outside the domain. Equal arguments give equal points.
  SobolDesign(std::size_t inputs, std::size_t samples, std::uint64_t seed);

  [[nodiscard]] std::size_t inputs() const { return inputs_; }
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Returns the number of points at which the function is evaluated. All points of the first
  /// sample come first, then all points of the second sample, and so on. The order within a sample
  /// is A, B, AB_1, AB_2 and so on.
  [[nodiscard]] std::size_t evaluations() const { return samples_ * (inputs_ + 2); }
  /// Writes the coordinates of the point with the index `evaluation`: one number in [0, 1) for each
  /// input.
  void point(std::size_t evaluation, std::span<double> point) const;

 private:
  std::size_t inputs_, samples_;
  std::vector<std::uint32_t> points_;  // sample by sample, A before B
};

/// Sobol' indices of one input: its shares in the variance of a function [1]. `first_error` and
/// `total_error` are the half widths of the 95 % confidence intervals.
struct SobolIndex {
  double first = unset, first_error = unset;  ///< share that this input alone causes
  /// Share that this input causes alone and by all its interactions with other inputs.
  double total = unset, total_error = unset;
};

/// Result of sobol_indices().
struct SobolIndices {
  /// Number of samples for which the function is finite at all points. Other samples are not used.
  std::size_t complete = 0;
  double mean = unset, std = unset;  ///< mean and standard deviation of the function over A and B
  /// One entry for each input; NaN if the function is constant or `complete` is below 2.
  std::vector<SobolIndex> inputs;
};

/// Computes the Sobol' indices of a function. `values` are the values of the function at the points
/// of `design`, in the order of the points.
///
///   S_i  = mean(f_B (f_AB_i - f_A)) / V
///   ST_i = mean((f_A - f_AB_i)²) / (2 V)
///
/// S_i is SobolIndex::first, and ST_i is SobolIndex::total. f_A, f_B and f_AB_i are the values at
/// the points of the sets A, B and AB_i (see SobolDesign), minus the mean over A and B. V is the
/// variance of the function over A and B.
///
/// The errors of the indices are 1.96 times their standard deviation over 200 bootstrap resamplings
/// of the samples. The bootstrap assumes independent samples, but Sobol' points fill the cube more
/// evenly than independent points. The errors are therefore slightly too large.
///
/// Source:   S_i [Saltelli2010, table 2 (b)]; ST_i [Jansen1999], [Saltelli2010, table 2 (f)];
///           bootstrap of indices [Archer1997].
/// Domain:   independent inputs.
[[nodiscard]] SobolIndices sobol_indices(const SobolDesign& design, std::span<const double> values,
                                         std::uint64_t seed);

}  // namespace raceway::fit
