#pragma once

#include <string>
#include <vector>

#include "record/record.h"

/// Rows of a logger as the states that it stood at.
namespace raceway::fit {

/// Columns of a record of dwells; no file has them.
inline constexpr record::Channel dwell_rows{
    .name = "dwell_rows", .words = "rows of a dwell", .role = record::Role::deviation};
inline constexpr record::Channel dwell_last_line{
    .name = "dwell_last_line", .words = "last line of a dwell", .role = record::Role::deviation};
/// Pieces of one dwell, and dwells with stray rows alone between them, stand at one state.
inline constexpr record::Channel dwell_state{
    .name = "dwell_state", .words = "state of a dwell", .role = record::Role::deviation};
/// Standard deviation that the mean of the readings has from the scatter within its rows, over the
/// rms of all readings [1].
inline constexpr record::Channel dwell_scatter{
    .name = "dwell_scatter", .words = "scatter of a mean", .role = record::Role::deviation};

/// A record after averaging, and what was averaged.
struct Averaged {
  record::Record record{};          ///< a row for each dwell, and for each row outside of one
  std::size_t rows = 0;             ///< of the record before
  std::size_t dwells = 0;           ///< averaged rows, pieces of split dwells counted
  std::size_t alone = 0;            ///< rows outside of dwells, as they were
  std::size_t split = 0;            ///< dwells in several pieces, as their temperature moved
  double correlation_time = unset;  ///< of the scatter within dwells [s]; NaN where it has none
  /// Columns of which a mean stands in place of the rows.
  std::vector<const record::Channel*> channels{};

  [[nodiscard]] bool any() const { return dwells > 0; }
  /// "1440 rows are 36 dwells: ...", for people.
  [[nodiscard]] std::string statement() const;
};

/// Averages the rows of each dwell: five consecutive rows or more with equal settings (but for
/// temperatures, which follow), not further apart than two minutes, of one run. Inputs, time and
/// readings are means; a dwell whose temperature moves by more than 1 K is cut into pieces of less.
/// Rows of a ramp, on which a setting moves all the time, stay rows, and so do rows of one
/// operating point and rows whose readings come with a standard deviation. Rows that scatter about
/// one state are correlated: a mean of m of them has the variance
///
///   s² [ w/m + (1 - w)/m² sum_ik φ^|i-k| ]
///
/// (dwell_scatter) with s, φ and the white share w by restricted maximum likelihood from what all
/// dwells leave about their own mean (and trend, where a temperature drifts); s grows with a power
/// of the reading.
[[nodiscard]] Averaged average_dwells(const record::Record& record);

}  // namespace raceway::fit
