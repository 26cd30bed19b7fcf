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

/// Builds JSON objects for results of the loop, shared by the writers of results.
namespace raceway::results {

/// Returns the comparison of one model, with the first channel at the top level. If there are
/// several channels, `channels` contains all of them.
[[nodiscard]] text::json comparison_object(const std::string& model_file,
                                           const std::vector<const verdict::Comparison*>& channels,
                                           const record::Record& record);

[[nodiscard]] text::json calibration_object(const verdict::Calibration& calibration,
                                            const record::Record& record);

/// Returns `quantity` and `unit` of a measured channel.
[[nodiscard]] text::json channel_object(const record::Channel& channel);

/// A channel with the number of its readings in a fit.
struct ChannelCount {
  const record::Channel* channel;
  int readings;
};

/// Returns chi_square, degrees_of_freedom, aic and bic of a fit to all channels, for readings in
/// the units of the document. The values are null if there is no likelihood.
[[nodiscard]] text::json likelihood_object(const fit::Likelihood& likelihood,
                                           const std::vector<ChannelCount>& channels);

/// Returns ln det(2 pi S) of the noise with covariance S, in the units of the document.
[[nodiscard]] double log_determinant_in_units(const fit::Likelihood& likelihood,
                                              const std::vector<ChannelCount>& channels);

/// Returns the rows of the matrix, in the order of the parameters.
[[nodiscard]] text::json correlation_rows(const Eigen::MatrixXd& correlation);

/// Adds a list with one entry for each measured channel to a document, if there are several
/// channels.
void add_channels(text::json& document, text::json channels);

/// Returns the file of a record, or the list of joined files.
[[nodiscard]] text::json data_of(const record::Record& record);

/// Adds the `notes` of a record and, if rows were averaged, `dwells` with their number and columns.
void add_notes(text::json& document, const record::Record& record);

/// Returns the line numbers of rows, with the name of the record if several records were joined.
[[nodiscard]] text::json lines_of(const record::Record& record,
                                  const std::vector<std::size_t>& rows);

[[nodiscard]] text::json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                                         const std::vector<const record::Channel*>& channels);

/// Returns rows_beyond_range (null if the model gives no range) and beyond_range.
[[nodiscard]] text::json beyond_object(const correction::Beyond& beyond,
                                       const record::Record& record);

}  // namespace raceway::results
