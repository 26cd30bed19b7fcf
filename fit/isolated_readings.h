#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"

/// Removes readings that cannot be true from records over time.
namespace raceway::fit {

/// Criteria for isolated readings, as distances from the neighbours.
struct Isolation {
  bool steady = true;       ///< true: also removes small jumps while speed and loads are steady
  double impossible = 3.0;  ///< limit at any speed, in multiples of the range of the readings
};

/// A time record without its isolated readings, and a list of them.
struct Isolated {
  record::Record record{};                   ///< isolated readings are NaN
  std::vector<std::size_t> rows{};           ///< rows of isolated readings, in ascending order
  const record::Channel* channel = nullptr;  ///< channel of the readings; null if none were removed
  bool impossible = false;  ///< true if a reading was removed because of `by.impossible`
  Isolation by{};           ///< criteria that were used
  bool by_model = false;    ///< true if the readings were found in the residuals of a model

  [[nodiscard]] bool any() const { return !rows.empty(); }
  /// Describes the result: "56 readings of axial displacement jump and return ...".
  [[nodiscard]] std::string statement() const;
};

/// Removes isolated readings of the first measured channel: one or two successive rows that jump
/// and return while speed and loads are steady. Example: a chip touches the probe.
///
/// Both neighbours must be on the same side of the reading. The distance of the reading from each
/// neighbour must be more than 6 robust standard deviations and more than three times the distance
/// between the two neighbours. The robust standard deviation is 1.4826 times the median distance of
/// readings from the middle of their four neighbours. The lower limit of this deviation is 0.3 % of
/// the range of the central 90 % of the readings. A rise after a standstill, a peak at a change of
/// speed and a lasting jump are not isolated readings. At any speed, a reading is isolated if its
/// distance from both neighbours exceeds `by.impossible` times the range of the readings (without
/// two readings, or the outermost 1 %, at either end). If both rules together would remove more
/// than a tenth of the readings, none is removed. Fewer than 30 readings are not tested.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record);

/// Removes isolated readings of the given channel. If `predicted` gives a value for each row, the
/// test uses the residuals of the model. With residuals, settings may change, except for a speed or
/// load that jumps and returns together with the reading. Up to three successive rows may jump, and
/// the last ones of a record need not return.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record,
                                                 const record::Channel& channel,
                                                 const Isolation& by = {},
                                                 std::span<const double> predicted = {});

/// A record without impossible rows, and statements about the removed rows (empty if none were
/// removed).
struct PossibleRows {
  record::Record record{};
  std::vector<std::string> statements{};
};

/// Removes impossible rows from the record of a rig or shaft: rows with a temperature below -60 or
/// above 200 C, and rows with an extreme reading of the first measured channel. A test that would
/// remove more than a tenth of the rows removes none. A reading is extreme if it lies outside the
/// range of the readings by more than three times this range, although the inputs of its row are
/// within the range of the other rows. The range excludes two readings, or a hundredth of the
/// readings, at either end. Records with fewer than 15 rows are not changed.
[[nodiscard]] PossibleRows without_impossible_rows(const record::Record& record);

}  // namespace raceway::fit
