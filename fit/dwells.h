#pragma once

#include <string>
#include <vector>

#include "record/record.h"

/// Averages the rows of a logged record over dwells. A dwell is a period at one operating point.
namespace raceway::fit {

/// Number of original rows whose mean is a row of an averaged record; 1 for a row outside dwells.
/// Files do not have this column.
inline constexpr record::Channel dwell_rows{
    .name = "dwell_rows", .words = "rows of a dwell", .role = record::Role::deviation};
inline constexpr record::Channel dwell_last_line{
    .name = "dwell_last_line", .words = "last line of a dwell", .role = record::Role::deviation};
/// Number that identifies the operating state. If a dwell is divided into several rows, these rows
/// have the same number. Dwells with equal settings have the same number if only rows outside
/// dwells separate them.
inline constexpr record::Channel dwell_state{
    .name = "dwell_state", .words = "state of a dwell", .role = record::Role::deviation};
/// Standard deviation of the mean reading of a dwell, from the scatter of its rows, divided by the
/// RMS of all mean readings [1]. The column exists only for records with one measured channel.
inline constexpr record::Channel dwell_scatter{
    .name = "dwell_scatter", .words = "scatter of a mean", .role = record::Role::deviation};

/// Record after averaging over dwells, with counts of rows and dwells.
struct Averaged {
  record::Record record{};  ///< one row for each dwell and for each row outside a dwell
  std::size_t rows = 0;     ///< number of rows before averaging
  std::size_t dwells = 0;   ///< number of rows that are means; a split dwell gives several rows
  std::size_t alone = 0;    ///< number of unchanged rows outside dwells
  std::size_t split = 0;    ///< number of dwells split because a temperature drifted
  /// Correlation time of the scatter of rows within dwells [s]; NaN if unknown or if the rows are
  /// not correlated.
  double correlation_time = unset;
  /// Channels whose rows were replaced by means.
  std::vector<const record::Channel*> channels{};

  [[nodiscard]] bool any() const { return dwells > 0; }
  /// Returns a sentence about the averaging: "1440 rows form 36 dwells: ...".
  [[nodiscard]] std::string statement() const;
};

/// Averages the rows of each dwell. A dwell has at least five consecutive rows of one run with
/// equal settings (temperatures may drift) and at most two minutes between rows. The result has one
/// row for each dwell, with the means of inputs, time and readings. A dwell in which a temperature
/// changes by more than 1 K is cut into pieces with a smaller change, and each piece gives one row.
/// If the pieces have fewer than five rows on average, the dwell is not averaged. The function does
/// not average the rows of a ramp, in which a setting changes all the time. Records at a single
/// operating point, with declared standard deviations, or with more than half of the rows outside
/// dwells are not averaged. The readings of a dwell may be correlated. The mean of m readings has
/// the variance
///
///   s² [ w/m + (1 - w)/m² sum_ik φ^|i-k| ]
///
/// The standard deviation s, the correlation φ of successive rows and the share w of uncorrelated
/// scatter come from a restricted maximum likelihood estimate. The estimate uses the deviations of
/// the rows from the mean of their dwell, or from the trend of the dwell if a temperature drifts. s
/// is proportional to a power (0 to 2) of the reading. The column dwell_scatter contains the
/// standard deviation of each mean.
[[nodiscard]] Averaged average_dwells(const record::Record& record);

}  // namespace raceway::fit
