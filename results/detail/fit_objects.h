#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "correction/range.h"
#include "fit/likelihood.h"
#include "record/record.h"
#include "text/detail/json_text.h"
#include "verdict/add.h"
#include "verdict/compare.h"

/// Builds JSON objects for results of check, compare, fit, diagnose and add, for all writers in
/// results/.
namespace raceway::results {

/// Returns the errors of one model on a record. The top level describes the first measured channel.
/// If the record has several measured channels, the member `channels` describes all of them.
[[nodiscard]] text::json comparison_object(const std::string& model_file,
                                           const std::vector<const verdict::Comparison*>& channels,
                                           const record::Record& record);

[[nodiscard]] text::json calibration_object(const verdict::Calibration& calibration,
                                            const record::Record& record);

/// Returns an object with the `quantity` and the `unit` of a measured channel.
[[nodiscard]] text::json channel_object(const record::Channel& channel);

/// Measured channel and the number of its readings in a fit.
struct ChannelCount {
  const record::Channel* channel;
  int readings;
};

/// Returns chi_square, degrees_of_freedom, aic and bic of a fit to all channels, for readings in
/// the units of the document. Values are null if they are unknown.
[[nodiscard]] text::json likelihood_object(const fit::Likelihood& likelihood,
                                           const std::vector<ChannelCount>& channels);

/// Returns ln det(2 pi S) with the noise covariance S of readings in the units of the document.
[[nodiscard]] double log_determinant_in_units(const fit::Likelihood& likelihood,
                                              const std::vector<ChannelCount>& channels);

/// Returns the correlation matrix of the parameters as a list of rows.
[[nodiscard]] text::json correlation_rows(const Eigen::MatrixXd& correlation);

/// Adds the list `channels` with one entry for each measured channel, if there are several
/// channels.
void add_channels(text::json& document, text::json channels);

/// Returns the file name of a record, or the list of file names of joined records.
[[nodiscard]] text::json data_of(const record::Record& record);

/// Adds the `notes` of a record. If rows of dwells were averaged, adds `dwells` with the numbers of
/// rows and dwells and the averaged columns.
void add_notes(text::json& document, const record::Record& record);

/// Returns the line number of each row and, if several records were joined, the name of its record.
[[nodiscard]] text::json lines_of(const record::Record& record,
                                  const std::vector<std::size_t>& rows);

[[nodiscard]] text::json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                                         const std::vector<const record::Channel*>& channels);

/// Returns rows_beyond_range, the number of rows outside the range of the fit (null if the model
/// gives no range), and the list beyond_range with the parts of the record that contain these rows.
[[nodiscard]] text::json beyond_object(const correction::Beyond& beyond,
                                       const record::Record& record);

}  // namespace raceway::results
