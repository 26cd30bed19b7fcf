#pragma once

#include <string>
#include <vector>

#include "record/record.h"

/// Averages the rows of a logged record over dwells. A dwell is a period at one operating point.
namespace raceway::fit {

/// Column of an averaged record: number of original rows that were averaged; 1 for a row outside
/// dwells. Record files do not contain this column.
inline constexpr record::Channel dwell_rows{
    .name = "dwell_rows", .words = "rows of a dwell", .role = record::Role::deviation};
/// Column of an averaged record: line number of the last original row that was averaged.
inline constexpr record::Channel dwell_last_line{
    .name = "dwell_last_line", .words = "last line of a dwell", .role = record::Role::deviation};
/// Column of an averaged record: index of the operating state. If a dwell is divided into several
/// rows, these rows have the same index. Successive dwells of a run with equal settings also have
/// the same index.
inline constexpr record::Channel dwell_state{
    .name = "dwell_state", .words = "state of a dwell", .role = record::Role::deviation};
/// Column of an averaged record: standard deviation of the mean reading of a dwell, divided by the
/// RMS of all mean readings [1]. The standard deviation comes from the scatter of the rows within
/// dwells. The column exists only for records with one measured channel.
inline constexpr record::Channel dwell_scatter{
    .name = "dwell_scatter", .words = "scatter of a mean", .role = record::Role::deviation};

/// Record after averaging over dwells, with counts of rows and dwells.
struct Averaged {
  record::Record record{};  ///< one row for each dwell and for each row outside a dwell
  std::size_t rows = 0;     ///< number of rows before averaging
  std::size_t dwells = 0;   ///< number of rows that are means; a split dwell gives several means
  std::size_t alone = 0;    ///< number of unchanged rows outside dwells
  std::size_t ramps = 0;    ///< number of rows on fast ramps between dwells, which are left out
  std::size_t split = 0;    ///< number of dwells that were split because a temperature drifted
  /// Correlation time of the scatter of rows within dwells [s]; NaN if unknown or if the rows are
  /// not correlated.
  double correlation_time = unset;
  /// Channels whose values were replaced by means.
  std::vector<const record::Channel*> channels{};

  [[nodiscard]] bool any() const { return dwells > 0; }
  /// Returns a sentence about the averaging: "1440 rows form 36 dwells: ...".
  [[nodiscard]] std::string statement() const;
};

/// Averages the rows of each dwell. The result has one row for each dwell, with the means of
/// inputs, time and readings. Rows outside dwells are unchanged, or left out if they are on a fast
/// ramp: rows follow each other within 5 s, and the first setting, usually the speed, rises or
/// falls from the row before to the row after by more than twice the largest deviation that a dwell
/// may have. The reading of such a row contains the torque that accelerates the rotor.
///
/// A dwell has at least five consecutive rows of one run, with equal settings and at most two
/// minutes between rows. Temperatures may drift. A dwell in which a temperature changes by more
/// than 1 K is cut into pieces with a smaller change, and each piece gives one mean. If the pieces
/// have fewer than five rows on average, the dwell is not averaged. Rows of a ramp, in which a
/// setting changes all the time, are not averaged.
///
/// The function averages no rows and leaves Averaged::record empty in these cases:
///   - The record has no dwell, or a single operating point.
///   - The record gives standard deviations of the readings.
///   - More than half of the rows are outside dwells.
///
/// The readings of a dwell may be correlated. The mean of m readings has the variance
///
///   s² [ w/m + (1 - w)/m² sum_ik φ^|i-k| ]
///
/// where i and k run from 1 to m. s, the standard deviation of a reading, is proportional to a
/// power of the reading with an exponent from 0 to 2. φ is the correlation of successive rows, and
/// w the share of uncorrelated scatter in s². s, φ and w come from a restricted maximum likelihood
/// estimate. The estimate uses the deviations of the rows from the mean of their dwell, or from a
/// linear trend if a temperature drifts. The column dwell_scatter contains the standard deviation
/// of each mean.
[[nodiscard]] Averaged average_dwells(const record::Record& record);

}  // namespace raceway::fit
