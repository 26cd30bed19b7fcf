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

/// Builds operating points from requested values in the units of files. Missing values come from
/// the model. The functions throw text::InputError for values outside their ranges, and for loads
/// that are not possible for a shaft or a roller bearing.
namespace raceway::session {

/// Requested operating point. A NaN load or temperature is replaced by the value of the model. For
/// a model of a shaft, the axial load is the external axial load. A NaN moment is 0.
struct AskedPoint {
  double speed_rpm = unset, axial_load_N = unset, radial_load_N = unset, temperature_C = unset,
         moment_y_Nmm = unset, moment_z_Nmm = unset;
};

/// Returns the loads and the temperature of a model as an operating point without a speed. The
/// axial load is NaN if the model has no axial load.
[[nodiscard]] bearing::OperatingPoint point_of(const model::Model& model);
/// Returns the operating point with the requested values. Values of the model replace loads and a
/// temperature that are NaN.
[[nodiscard]] bearing::OperatingPoint point_of(const model::Model& model, const AskedPoint& asked);

/// Loads that a request contains. A member is true if the request gives this load.
struct GivenLoads {
  bool axial_load = false;
  bool acting_axial_load = false;  ///< true if the given axial load is not 0
  bool radial_load = false, moments = false;
};

/// Throws text::InputError if neither the request nor the model gives an axial load, or if a load
/// is not possible for a shaft or a roller bearing. Adds a warning if moments have no effect
/// because the model locks the tilt.
void require_loads(Messages& messages, const files::ModelFile& file, const GivenLoads& given,
                   Wording wording);

/// Returns the requested operating point. Throws the same exceptions as require_loads(), and
/// text::InputError for a value outside its range.
[[nodiscard]] bearing::OperatingPoint operating_point(Messages& messages,
                                                      const files::ModelFile& file,
                                                      const AskedPoint& asked, Wording wording);

/// Axes of a table, each with values in ascending order. The speeds must be given. If a load or the
/// temperature has no values here, its axis has one value, the value of the model.
struct AskedAxes {
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
};

/// Returns the axes of a table [SI]. Throws the same exceptions as operating_point(). Also throws
/// text::InputError if no speed is given, and for an axis whose values are not in ascending order.
[[nodiscard]] friction::TableAxes table_axes(Messages& messages, const files::ModelFile& file,
                                             const AskedAxes& asked, Wording wording);

/// Converts operating points of a bearing to operating points of a shaft.
[[nodiscard]] std::vector<shaft::ShaftPoint> shaft_points(
    std::span<const bearing::OperatingPoint> points);

}  // namespace raceway::session
