#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "correction/range.h"
#include "fit/add.h"
#include "fit/compare.h"
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

/// Puts a list with one entry for each measured channel into a document, where there are several.
void add_channels(json& document, json channels);

/// The file of a record, or a list of those that were joined.
[[nodiscard]] json data_of(const record::Record& record);

/// Rows for people: lines, with the name of the record where several were joined.
[[nodiscard]] json lines_of(const record::Record& record, const std::vector<std::size_t>& rows);

[[nodiscard]] json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                                   const std::vector<const record::Channel*>& channels);

/// rows_beyond_range (null where the model does not say what it has seen) and beyond_range.
[[nodiscard]] json beyond_object(const correction::Beyond& beyond, const record::Record& record);

}  // namespace raceway::io
