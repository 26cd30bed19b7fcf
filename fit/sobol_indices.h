#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::fit {

/// Sample points for the Sobol' indices of a function: two sets A and B of points in the unit cube,
/// and for every input i the set AB_i, A with column i of B.
///
/// Sobol' points in 2 x inputs dimensions with the direction numbers of Joe and Kuo, the columns of
/// A before the columns of B, with Owen scrambling by the hash of Burley.
///
/// Source:   [Saltelli2010] for the sets; [JoeKuo2008]; [Burley2020, section 3].
/// Domain:   1 to 1800 inputs; samples a power of two from 2 to 2^24, which alone fill the cube
///           evenly.
class SobolDesign {
 public:
  /// Throws std::invalid_argument outside the domain. One seed gives one set of points.
  SobolDesign(std::size_t inputs, std::size_t samples, std::uint64_t seed);

  [[nodiscard]] std::size_t inputs() const { return inputs_; }
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Sample after sample, of each A, B, AB_1, ... AB_k.
  [[nodiscard]] std::size_t evaluations() const { return samples_ * (inputs_ + 2); }
  /// In [0, 1), one number for each input.
  void point(std::size_t evaluation, std::span<double> point) const;

 private:
  std::size_t inputs_, samples_;
  std::vector<std::uint32_t> points_;  // sample by sample, A before B
};

/// Shares of the variance of one function [1]; errors are half the width of a 95 % interval.
struct SobolIndex {
  double first = unset, first_error = unset;  ///< of this input alone
  double total = unset, total_error = unset;  ///< with all that it does together with others
};

struct SobolIndices {
  std::size_t complete = 0;  ///< samples whose values are all numbers; the others take no part
  double mean = unset, std = unset;  ///< of A and B
  std::vector<SobolIndex> inputs;    ///< NaN where the function does not vary or has no values
};

/// Indices of a function from its values at all points of a design, in their order.
///
///   S_i  = mean(f_B (f_AB_i - f_A)) / V        f less its mean
///   ST_i = mean((f_A - f_AB_i)²) / (2 V)       V: variance of f over A and B
///
/// Errors are 1.96 times the scatter over 200 resamplings of the samples (bootstrap). These take
/// the samples for independent, which points of Sobol' beat: the errors are rather too large.
///
/// Source:   S_i [Saltelli2010, table 2 (b)]; ST_i [Jansen1999], [Saltelli2010, table 2 (f)];
///           bootstrap of indices [Archer1997].
/// Domain:   inputs that are independent of each other.
[[nodiscard]] SobolIndices sobol_indices(const SobolDesign& design, std::span<const double> values,
                                         std::uint64_t seed);

}  // namespace raceway::fit
