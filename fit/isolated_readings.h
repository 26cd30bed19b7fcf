#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"

/// Removes readings and rows that are certainly wrong from records.
namespace raceway::fit {

/// Criteria for isolated readings.
struct Isolation {
  /// True: jumps of more than 6 standard deviations while speed and loads are steady are removed
  /// too.
  bool steady = true;
  /// Distance of a reading from both neighbours that no change of speed can explain, divided by the
  /// range of the readings without their outermost 1 % at either end [1].
  double impossible = 3.0;
};

/// Time record without its isolated readings, and a list of these readings.
struct Isolated {
  record::Record record{};                   ///< record in which isolated readings are NaN
  std::vector<std::size_t> rows{};           ///< rows of isolated readings, in ascending order
  const record::Channel* channel = nullptr;  ///< channel of the readings; null if none were removed
  bool impossible = false;  ///< true if a reading was removed only because of `by.impossible`
  Isolation by{};           ///< criteria that were used
  bool by_model = false;    ///< true if the readings were found in the residuals of a model

  [[nodiscard]] bool any() const { return !rows.empty(); }
  /// Returns a sentence about the removed readings: "56 readings of axial displacement jump and
  /// return ...".
  [[nodiscard]] std::string statement() const;
};

/// Removes isolated readings of the first measured channel: one or two successive readings that
/// jump and return, for example because a chip touches the probe. Two rules find them.
///
/// First rule, while speed and loads are steady: both neighbours are on the same side of the
/// reading. The distance of the reading from each neighbour is more than 6 robust standard
/// deviations and more than three times the distance between the two neighbours. The robust
/// standard deviation is 1.4826 times the median distance of readings from the median of their four
/// neighbours, but at least 0.3 % of the range of the central 90 % of the readings. A rise after
/// a standstill, a peak at a change of speed and a lasting jump are not isolated readings. Second
/// rule, at any speed: the 6 standard deviations are replaced by Isolation::impossible times the
/// range of the readings (without the outermost 1 %, or at least two readings, at either end). If
/// both rules together would remove more than a tenth of the readings, none is removed. Fewer than
/// 30 readings are not tested.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record);

/// Removes isolated readings of the channel `channel`. If `predicted` gives a prediction for each
/// row [SI], the function tests the residuals instead of the readings. Settings may then change,
/// but no speed or load may jump and return together with the reading. Up to three successive
/// readings may then jump, and the last readings of a record need not return.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record,
                                                 const record::Channel& channel,
                                                 const Isolation& by = {},
                                                 std::span<const double> predicted = {});

/// Record without impossible rows, and sentences about the removed rows (empty if no rows were
/// removed).
struct PossibleRows {
  record::Record record{};
  std::vector<std::string> statements{};
};

/// Removes impossible rows from the record of a rig or shaft: rows with a recorded input
/// temperature below -60 or above 200 C, and rows with an extreme reading of the first measured
/// channel. A test that would remove more than a tenth of the rows removes none. A reading is
/// extreme if it lies outside the range of the readings by more than three times this range,
/// although the inputs of its row are within the range of the other rows. The range of the readings
/// excludes the outermost 1 % of the readings, or at least two readings, at either end. Records
/// with fewer than 15 rows are not changed.
[[nodiscard]] PossibleRows without_impossible_rows(const record::Record& record);

}  // namespace raceway::fit
