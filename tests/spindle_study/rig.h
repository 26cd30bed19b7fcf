#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/spindle_study/simulator.h"

namespace spindle_study {

/// What may be hidden.
struct Class {
  std::string_view id;
  std::vector<std::string>
      accept;  ///< names that are right; none where nothing is, or no name fits
  std::vector<std::string> verdicts;  ///< that are right
  bool outside = false;               ///< in no catalogue
  bool data = false;                  ///< a number of the model that is wrong
};

[[nodiscard]] std::span<const Class> classes();
/// Throws std::invalid_argument with the names of all.
[[nodiscard]] const Class& find_class(std::string_view id);

/// One row of a record: what was recorded, and the truth behind it.
struct Row {
  Inputs inputs;
  Reading truth = {};
  double ambient_read = nan;
  double displacement_read = nan;
  std::vector<double> thermometers_read = {};
};

/// A spindle, what its user believes, and two records.
struct Rig {
  std::string id, kind;
  Spindle truth = {}, believed = {};
  Hidden hidden = {};
  double size = nan;  ///< of what is hidden, in the unit of the catalogue
  std::vector<std::string> accept, verdicts;
  /// Of what is hidden on the training record, beside an f0 refitted: rms over all readings, each
  /// in units of its noise and the floor of models.
  double signal = nan;
  std::vector<Row> train = {}, test = {};
  double balance = nan;
  std::size_t cells = 0;
};

/// Records of so many hours.
struct Hours {
  double train = 8.0, test = 5.0;
};

[[nodiscard]] Rig make_rig(const Class& of, std::uint64_t seed, const Hours& hours = {});

/// model.toml, train.csv, test.csv and truth.json in a folder of the rig's own.
void write_rig(const Rig& rig, const std::string& folder);

}  // namespace spindle_study
