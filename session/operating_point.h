#pragma once

#include <span>
#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "files/model_file.h"
#include "friction/stribeck_table.h"
#include "session/messages.h"
#include "session/wording.h"
#include "shaft/shaft_prediction.h"

/// Operating points of a question: defaults from the model, ranges of the numbers, and loads that a
/// shaft takes. Numbers are in the units of files.
namespace raceway::session {

/// NaN where the model says: the axial load of its rig, on a shaft the external one; the radial
/// load and the temperature of its rig.
struct AskedPoint {
  double speed_rpm = unset, axial_load_N = unset, radial_load_N = unset, temperature_C = unset,
         moment_y_Nmm = unset, moment_z_Nmm = unset;
};

/// Operating point of a model, without a speed. The axial load is NaN if the model gives none.
[[nodiscard]] bearing::OperatingPoint point_of(const model::Model& model);
/// Operating point of a model with the requested values.
[[nodiscard]] bearing::OperatingPoint point_of(const model::Model& model, const AskedPoint& asked);

/// Loads that a question contains.
struct GivenLoads {
  bool axial_load = false;
  bool acting_axial_load = false;  ///< one that is not 0
  bool radial_load = false, moments = false;
};

/// Throws text::InputError for an axial load that neither the question nor the model has, and for a
/// load that a shaft does not take. Warns of moments that change nothing.
void require_loads(Messages& messages, const files::ModelFile& file, const GivenLoads& given,
                   Wording wording);

/// A requested point, with its numbers in their ranges. Throws text::InputError as require_loads(),
/// and for a number out of its range.
[[nodiscard]] bearing::OperatingPoint operating_point(Messages& messages,
                                                      const files::ModelFile& file,
                                                      const AskedPoint& asked, Wording wording);

/// Axes of a table, each rising; an empty one has the one value of the model.
struct AskedAxes {
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
};

/// Throws text::InputError as operating_point(), for no speed and for an axis that does not rise.
[[nodiscard]] friction::TableAxes table_axes(Messages& messages, const files::ModelFile& file,
                                             const AskedAxes& asked, Wording wording);

/// Operating points as points of a shaft.
[[nodiscard]] std::vector<shaft::ShaftPoint> shaft_points(
    std::span<const bearing::OperatingPoint> points);

}  // namespace raceway::session
