#pragma once

#include <span>
#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "effects/effect.h"
#include "fit/calibrate.h"
#include "fit/compare.h"
#include "fit/data_set.h"
#include "fit/model.h"
#include "fit/prediction.h"
#include "friction/heat.h"
#include "friction/stribeck_table.h"
#include "io/catalogue_file.h"

/// Results as JSON documents, two blanks of indent, keys with their units (DESIGN.md, Commands).
/// What is not known, or has no balance, is null.
namespace raceway::io {

[[nodiscard]] std::string solve_json(const fit::Model& model, const bearing::OperatingPoint& point,
                                     const bearing::BearingEquilibrium& equilibrium,
                                     const fit::FrictionPrediction& friction,
                                     const friction::HeatSplit& heat);

[[nodiscard]] std::string table_json(const fit::Model& model, const friction::StribeckTable& table);

[[nodiscard]] std::string calibration_json(const fit::Calibration& calibration);

/// One document for one model; for several `{"models": [...]}` in the order given.
[[nodiscard]] std::string comparison_json(const std::vector<std::string>& model_files,
                                          const std::vector<fit::Comparison>& comparisons,
                                          const fit::DataSet& data);

[[nodiscard]] std::string bearings_json(const std::vector<CatalogueBearing>& rows);

/// The page of one effect, or `{"effects": [...]}` of all.
[[nodiscard]] std::string effect_json(const effects::Description& effect);
[[nodiscard]] std::string effects_json(std::span<const effects::Description> effects);

/// One column of a data set: what was read, in the file's unit.
struct ColumnSummary {
  std::string name;  ///< with unit, as in files
  double lower = unset, upper = unset;
  int levels = 0;  ///< different values, as far as files distinguish them
};

/// What `check` tells of a model and a data set.
struct CheckSummary {
  std::string model_name;
  std::string quantity;
  int rows = 0, runs = 0;
  std::string noise_source;
  double noise = unset;  ///< rms [N m] or [m]
  std::vector<ColumnSummary> columns;
  std::vector<std::string> defaults, notes;
  struct Testable {
    std::string id;
    std::string missing;  ///< what the data or the model lack; empty if testable
    std::string levels;   ///< without which base parameters do nearly the same; empty if none
  };
  std::vector<Testable> effects;
  struct Free {
    std::string name;
    bool identifiable = true;
  };
  std::vector<Free> free_parameters;
};

[[nodiscard]] std::string check_json(const CheckSummary& summary);

}  // namespace raceway::io
