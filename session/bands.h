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

/// The band of the predictions of a model from its fitted parameters. `asked_by`: the flag or
/// argument that requests it, `remedy`: the commands that make a model with one. Throws
/// text::InputError for a model without a covariance of its values.
[[nodiscard]] model::Band band_of(const files::ModelFile& file, std::string_view asked_by,
                                  std::string_view remedy);

/// Description of a band in a sentence.
[[nodiscard]] std::string band_statement(const model::Band& band);

/// Columns that a band adds to table_columns(), behind all others.
[[nodiscard]] std::vector<std::string> band_columns(const model::Model& model);

/// Fills in the last columns of points [SI]. May be called by several threads at once.
void fill_band(const model::Model& model, const model::Band& band,
               std::span<const bearing::OperatingPoint> points,
               std::span<friction::TablePoint> out);

/// Half widths for one bearing at one point: friction torque, loss, heat of both rings.
[[nodiscard]] results::BandOfResult point_band(const model::Band& band,
                                               const bearing::OperatingPoint& point);

/// Half widths for the readings that fit::predict() gives of a record, in their order [SI].
[[nodiscard]] std::vector<double> record_band(const model::Band& band,
                                              const record::Record& record);

}  // namespace raceway::session
