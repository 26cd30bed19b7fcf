#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/correction_study/floors.h"
#include "tests/correction_study/machine.h"
#include "tests/correction_study/plan.h"

namespace correction_study {

/// What is hidden in a rig.
struct Class {
  std::string_view id;
  std::vector<std::string_view> hidden{};  ///< ids of the catalogue, or one name of its own
  bool outside = false;                    ///< it is in no catalogue
};

/// A datum of the record is wrong, and the machine lacks nothing.
[[nodiscard]] bool is_wrong_data(const Class& wished);

/// Nothing, each effect of the catalogue, pairs, and what is outside.
[[nodiscard]] std::span<const Class> classes();
/// Throws std::invalid_argument with those that there are.
[[nodiscard]] const Class& find_class(std::string_view id);

/// Columns that the user has recorded.
struct Columns {
  bool rear = false, motor = false, headstock = false, base = false, column = false;
  int ambient = 1;  ///< sensors in the room
  bool feeds = false, coolant = false;
};

/// A machine, what is believed of it and how it is recorded.
struct Setup {
  Machine machine{};  ///< as it is
  Machine plain{};    ///< without what is hidden
  Base base{};
  Columns columns{};
  PlanWish train_wish{}, test_wish{};
  double quantum = 0.1;      ///< of the temperatures [K]
  double noise = 0.25;       ///< standard deviation of a displacement [um]
  double table_scale = 1.0;  ///< the friction table is another spindle's
  double table_exponent = 0.6;
  double strays = 0.0;           ///< share of the readings that a chip under the probe falsifies
  std::string exchanged_with{};  ///< sensor whose column has the name of the front bearing's
  double loose_from = 0.0, loose_to = 0.0;  ///< while the front sensor hangs in the air [s]
  double loose_sees = 1.0;                  ///< of the rise of its bearing above the room [1]
  bool noise_declared = true;
  std::vector<PlannedRow> train{}, test{};
  /// The machine of the second record: what only a reading suffers does not happen again.
  [[nodiscard]] Machine machine_later() const;
};

/// The same seed gives the same machine and plans; `size` only changes how much is hidden.
[[nodiscard]] Setup draw_setup(const Class& wished, std::uint64_t seed, double size);

}  // namespace correction_study
