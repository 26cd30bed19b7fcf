#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"

/// Removes readings and rows that are clearly wrong from records.
namespace raceway::fit {

/// Criteria for isolated readings.
struct Isolation {
  /// True: without_isolated_readings() uses limit 1 and limit 2; false: only limit 2.
  bool steady = true;
  /// Limit 2 of without_isolated_readings(), divided by the range of the readings [1]. A larger
  /// distance of a reading from both neighbours cannot be due to a change of speed.
  double impossible = 3.0;
};

/// Time record without its isolated readings, and a list of these readings.
struct Isolated {
  record::Record record{};          ///< record in which isolated readings are NaN
  std::vector<std::size_t> rows{};  ///< rows of isolated readings, in ascending order
  /// Channel of the isolated readings; null if no reading was removed.
  const record::Channel* channel = nullptr;
  bool impossible = false;  ///< true if limit 2 alone led to the removal of a reading
  Isolation by{};           ///< criteria that were used
  bool by_model = false;    ///< true if the readings were found in the residuals of a model

  [[nodiscard]] bool any() const { return !rows.empty(); }
  /// Returns a sentence about the removed readings, for example "56 readings of axial displacement
  /// jump and return ...".
  [[nodiscard]] std::string statement() const;
};

/// Removes isolated readings of the first measured channel: one or two successive readings that
/// jump and return, for example because a chip touches the probe. Both neighbours are lower than
/// such a reading, or both are higher, and the distance of the reading from each neighbour is more
/// than three times the distance between the neighbours. A reading is removed only if its distance
/// from each neighbour also exceeds one of two limits:
///
///   - Limit 1 is 6 robust standard deviations, if speed and loads are steady. The robust standard
///     deviation is 1.4826 times the median distance of readings from the median of their four
///     neighbours, but at least 0.3 % of the range of the central 90 % of the readings.
///   - Limit 2 is Isolation::impossible times the range of the readings, at any speed and load. The
///     range excludes the smallest and the largest 1 % of the readings, at least two readings at
///     each end.
///
/// A rise after a standstill, a peak at a change of speed and a lasting jump are not isolated
/// readings. If more than a tenth of the readings would be removed, none is removed. A channel with
/// fewer than 30 readings is not tested.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record);

/// Removes isolated readings of the channel `channel`. If `predicted` gives a prediction for each
/// row [SI], the function tests the residuals instead of the readings. The rules then differ from
/// the rules for readings:
///   - Limit 1 of without_isolated_readings() is used even if speed and loads are not steady. A
///     reading is kept if a speed or load jumps and returns together with the reading.
///   - An isolated group can have up to three successive readings.
///   - Up to three readings at the end of a record are removed if they jump, even without a return.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record,
                                                 const record::Channel& channel,
                                                 const Isolation& by = {},
                                                 std::span<const double> predicted = {});

/// Record without impossible rows, and sentences about the removed rows.
struct PossibleRows {
  record::Record record{};
  std::vector<std::string> statements{};
};

/// Removes impossible rows from the record of a rig or shaft: rows with a recorded input
/// temperature below -60 C or above 200 C, and rows with an extreme reading of the first measured
/// channel.
///
/// A reading is extreme if it lies outside the range of the readings by more than three times this
/// range, although the inputs of its row are within the range of the other rows. The range of the
/// readings excludes the smallest and the largest 1 % of them, at least two readings at each end.
///
/// A criterion removes no rows if more than a tenth of the rows meet this criterion. Records with
/// fewer than 15 rows are not changed.
[[nodiscard]] PossibleRows without_impossible_rows(const record::Record& record);

}  // namespace raceway::fit
