#pragma once

#include <string>
#include <vector>

#include "tests/correction_study/floors.h"
#include "tests/correction_study/setup.h"

namespace correction_study {

/// A record as it stands in its file.
struct Recording {
  struct Column {
    std::string name;
    std::vector<double> values;  ///< NaN: an empty cell
    int decimals;
  };
  std::vector<Column> columns{};
  std::vector<double> clean{};  ///< displacement without noise [um]

  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] std::string csv() const;
};

/// What the sensors of a setup write down. `later`: the second record.
[[nodiscard]] Recording record(const Setup& setup, bool later, std::uint64_t seed);

/// What of its displacement is hidden: the machine against the plain one [um].
[[nodiscard]] std::vector<double> hidden_part(const Setup& setup, bool later);

/// The same as the classes of model see it, but for what is hidden.
[[nodiscard]] Signals signals(const Setup& setup, const Recording& recording);

/// Torque of the table that the user has [N m].
[[nodiscard]] double table_torque(const Setup& setup, double speed_rpm, double temperature);
[[nodiscard]] std::string friction_table(const Setup& setup);

}  // namespace correction_study
