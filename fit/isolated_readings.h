#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"

/// Readings over time that cannot be true.
namespace raceway::fit {

/// Distance by which a reading has to leave.
struct Isolation {
  bool steady = true;       ///< also by little, while the speed and the loads are steady
  double impossible = 3.0;  ///< ranges of all other readings, whatever the speed does
};

/// A record over time without its isolated readings, and which they are.
struct Isolated {
  record::Record record{};                   ///< NaN in their place
  std::vector<std::size_t> rows{};           ///< of isolated readings, rising
  const record::Channel* channel = nullptr;  ///< of which they are; null where there are none
  bool impossible = false;  ///< some are beyond the range of the others, whatever the speed does
  Isolation by{};           ///< what they had to leave by
  bool by_model = false;    ///< told by the residuals of a model

  [[nodiscard]] bool any() const { return !rows.empty(); }
  /// "56 readings of axial displacement leave and return ...", for people.
  [[nodiscard]] std::string statement() const;
};

/// Takes out readings of the first measured channel that leave and return while the speed and the
/// loads are steady, one or two rows in succession, as where a chip touches the probe.
///
/// Both neighbours must be on the same side, at least 6 robust standard deviations away, and three
/// times as far away as they are from each other. The standard deviation is taken from the readings
/// about the middle of their four neighbours (1.4826 of the median), at least 0.3 % of the range
/// that nine in ten readings have. A rise after a standstill, a peak at a change of speed and a
/// jump that stays are no isolated readings; but one that is `by.impossible` times the range of all
/// but a hundredth at either end away from both neighbours is, whatever the speed does. Nothing is
/// taken out where more than a tenth would be.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record);

/// Does this for another channel; for the residuals of a model where `predicted` has its value for
/// each row. Settings may change then, but for a speed or a load that leaves and returns with the
/// reading itself; up to three rows in succession leave, and the last ones of a record need not
/// return.
[[nodiscard]] Isolated without_isolated_readings(const record::Record& record,
                                                 const record::Channel& channel,
                                                 const Isolation& by = {},
                                                 std::span<const double> predicted = {});

/// A record of states without rows that cannot be, and what is said of them: empty where there are
/// none.
struct PossibleRows {
  record::Record record{};
  std::vector<std::string> statements{};
};

/// Takes out rows of a rig or a shaft, at most a tenth: with a temperature that no machine has
/// (below -60 or above 200 C), and with a reading of the first measured channel that is
/// three times the range of all others away from them, at inputs that lie within the range of the
/// other rows. The range is over all but the two readings, or the hundredth, at either end. Nothing
/// is taken out of fewer than 15 rows.
[[nodiscard]] PossibleRows without_impossible_rows(const record::Record& record);

}  // namespace raceway::fit
