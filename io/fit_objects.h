#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "correction/range.h"
#include "fit/add.h"
#include "fit/compare.h"
#include "fit/likelihood.h"
#include "io/json_text.h"
#include "record/record.h"

/// Results of the loop as JSON objects, which documents are made of; shared by the writers of
/// results, not for other code.
namespace raceway::io {

/// Of one model; the first channel at the top, all of them in `channels` where there are several.
[[nodiscard]] json comparison_object(const std::string& model_file,
                                     const std::vector<const fit::Comparison*>& channels,
                                     const record::Record& record);

[[nodiscard]] json calibration_object(const fit::Calibration& calibration,
                                      const record::Record& record);

/// `quantity` and `unit` of a measured channel.
[[nodiscard]] json channel_object(const record::Channel& channel);

/// A channel, and how many of its readings a fit was made to.
struct ChannelCount {
  const record::Channel* channel;
  int readings;
};

/// chi_square, degrees_of_freedom, aic and bic of a fit to all channels together, of readings in
/// the units of the document. What has no likelihood is null.
[[nodiscard]] json likelihood_object(const fit::Likelihood& likelihood,
                                     const std::vector<ChannelCount>& channels);

/// ln det(2 pi S) of the same noise, in those units.
[[nodiscard]] double log_determinant_in_units(const fit::Likelihood& likelihood,
                                              const std::vector<ChannelCount>& channels);

/// By the order of their parameters.
[[nodiscard]] json correlation_rows(const Eigen::MatrixXd& correlation);

/// Puts a list with one entry for each measured channel into a document, where there are several.
void add_channels(json& document, json channels);

/// The file of a record, or a list of those that were joined.
[[nodiscard]] json data_of(const record::Record& record);

/// `notes` of a record, and `dwells` where rows were averaged: how many, and which columns.
void add_notes(json& document, const record::Record& record);

/// Rows for people: lines, with the name of the record where several were joined.
[[nodiscard]] json lines_of(const record::Record& record, const std::vector<std::size_t>& rows);

[[nodiscard]] json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                                   const std::vector<const record::Channel*>& channels);

/// rows_beyond_range (null where the model does not say what it has seen) and beyond_range.
[[nodiscard]] json beyond_object(const correction::Beyond& beyond, const record::Record& record);

}  // namespace raceway::io
