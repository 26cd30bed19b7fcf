#pragma once

#include <string>
#include <vector>

#include "record/record.h"

/// Converts the rows of a logger to dwells. A dwell is a period at one operating point.
namespace raceway::fit {

/// Number of rows in a dwell. Only averaged records have this column; files do not.
inline constexpr record::Channel dwell_rows{
    .name = "dwell_rows", .words = "rows of a dwell", .role = record::Role::deviation};
inline constexpr record::Channel dwell_last_line{
    .name = "dwell_last_line", .words = "last line of a dwell", .role = record::Role::deviation};
/// Number of the operating state. Pieces of one dwell have the same number. Dwells with equal
/// settings that are separated only by stray rows also have the same number.
inline constexpr record::Channel dwell_state{
    .name = "dwell_state", .words = "state of a dwell", .role = record::Role::deviation};
/// Standard deviation of the mean reading of a dwell, from the scatter of its rows, divided by the
/// rms of all means [1]. The column exists only for records with one measured channel.
inline constexpr record::Channel dwell_scatter{
    .name = "dwell_scatter", .words = "scatter of a mean", .role = record::Role::deviation};

/// A record after averaging over dwells, and the counts of its rows.
struct Averaged {
  record::Record record{};  ///< one row for each dwell and for each row outside a dwell
  std::size_t rows = 0;     ///< number of rows before averaging
  std::size_t dwells = 0;   ///< number of averaged rows; each piece of a split dwell counts
  std::size_t alone = 0;    ///< number of unchanged rows outside dwells
  std::size_t split = 0;    ///< number of dwells split because their temperature drifted
  /// Correlation time of the scatter within dwells [s]; NaN if unknown.
  double correlation_time = unset;
  /// Channels whose rows were replaced by means.
  std::vector<const record::Channel*> channels{};

  [[nodiscard]] bool any() const { return dwells > 0; }
  /// Describes the averaging: "1440 rows form 36 dwells: ...".
  [[nodiscard]] std::string statement() const;
};

/// Averages the rows of each dwell. A dwell has at least five consecutive rows of one run with
/// equal settings (temperatures may drift) and at most two minutes between rows. Inputs, time and
/// readings become means. A dwell whose temperature changes by more than 1 K is cut into pieces
/// with less change. The function does not average the rows of a ramp, on which a setting moves all
/// the time. Records at a single operating point, with declared standard deviations, or with more
/// than half of the rows outside dwells are not averaged. Rows that scatter about one state may be
/// correlated. The mean of m such rows has the variance
///
///   s² [ w/m + (1 - w)/m² sum_ik φ^|i-k| ]
///
/// The standard deviation s, the correlation φ and the share w of uncorrelated scatter come from a
/// restricted maximum likelihood estimate. The estimate uses the deviations of the rows from the
/// mean of their dwell, or from the trend of the dwell if a temperature drifts. The scatter s is
/// proportional to a power (0 to 2) of the reading. The result is in the column dwell_scatter.
[[nodiscard]] Averaged average_dwells(const record::Record& record);

}  // namespace raceway::fit
