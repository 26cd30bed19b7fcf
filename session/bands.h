#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/operating_point.h"
#include "files/model_file.h"
#include "friction/stribeck_table.h"
#include "model/band.h"
#include "record/record.h"
#include "results/band_of_result.h"

namespace raceway::session {

/// Returns the 95 % band of a model's predictions, from the uncertainty of the fitted parameters.
/// `asked_by` is the flag or argument that requests the band. `remedy` names the commands that
/// write a model with a covariance. Throws text::InputError if the model file contains no
/// covariance of its parameters; `asked_by` and `remedy` are parts of the message.
[[nodiscard]] model::Band band_of(const files::ModelFile& file, std::string_view asked_by,
                                  std::string_view remedy);

/// Returns one sentence that names the fitted parameters whose uncertainty gives the band.
[[nodiscard]] std::string band_statement(const model::Band& band);

/// Returns the names of the columns for the band. A table with a band contains these columns after
/// the columns of table_columns().
[[nodiscard]] std::vector<std::string> band_columns(const model::Model& model);

/// Computes the columns of band_columns() at the given operating points, and writes them into `out`
/// [SI]. Several threads may call this function at the same time.
void fill_band(const model::Model& model, const model::Band& band,
               std::span<const bearing::OperatingPoint> points,
               std::span<friction::TablePoint> out);

/// Returns the half widths of the band for one bearing at one operating point: friction torque,
/// power loss, and heat of both rings.
[[nodiscard]] results::BandOfResult point_band(const model::Band& band,
                                               const bearing::OperatingPoint& point);

/// Returns the half width of the band for each predicted reading of a record [SI], in the order of
/// the predictions of fit::predict().
[[nodiscard]] std::vector<double> record_band(const model::Band& band,
                                              const record::Record& record);

}  // namespace raceway::session
