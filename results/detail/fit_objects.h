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

/// Results of the loop as JSON objects, which documents are made of; shared by the writers of
/// results.
namespace raceway::results {

/// Comparison of one model; the first channel at the top, all of them in `channels` where there are
/// several.
[[nodiscard]] text::json comparison_object(const std::string& model_file,
                                           const std::vector<const verdict::Comparison*>& channels,
                                           const record::Record& record);

[[nodiscard]] text::json calibration_object(const verdict::Calibration& calibration,
                                            const record::Record& record);

/// `quantity` and `unit` of a measured channel.
[[nodiscard]] text::json channel_object(const record::Channel& channel);

/// A channel, and how many of its readings a fit was made to.
struct ChannelCount {
  const record::Channel* channel;
  int readings;
};

/// chi_square, degrees_of_freedom, aic and bic of a fit to all channels together, of readings in
/// the units of the document. What has no likelihood is null.
[[nodiscard]] text::json likelihood_object(const fit::Likelihood& likelihood,
                                           const std::vector<ChannelCount>& channels);

/// ln det(2 pi S) of the same noise, in those units.
[[nodiscard]] double log_determinant_in_units(const fit::Likelihood& likelihood,
                                              const std::vector<ChannelCount>& channels);

/// Rows of the matrix, in the order of the parameters.
[[nodiscard]] text::json correlation_rows(const Eigen::MatrixXd& correlation);

/// Puts a list with one entry for each measured channel into a document, where there are several.
void add_channels(text::json& document, text::json channels);

/// The file of a record, or a list of those that were joined.
[[nodiscard]] text::json data_of(const record::Record& record);

/// `notes` of a record, and `dwells` where rows were averaged: how many, and which columns.
void add_notes(text::json& document, const record::Record& record);

/// Rows for people: lines, with the name of the record where several were joined.
[[nodiscard]] text::json lines_of(const record::Record& record,
                                  const std::vector<std::size_t>& rows);

[[nodiscard]] text::json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                                         const std::vector<const record::Channel*>& channels);

/// rows_beyond_range (null where the model gives no range) and beyond_range.
[[nodiscard]] text::json beyond_object(const correction::Beyond& beyond,
                                       const record::Record& record);

}  // namespace raceway::results
