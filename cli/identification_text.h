#pragma once

#include "correction/baseline.h"
#include "correction/identify.h"
#include "correction/trust.h"
#include "record/record.h"

namespace raceway::cli {

/// The line of trust.
void print_trust(const record::Channel& displacement, const correction::Trust& trust);

/// Errors that papers state in addition to RMS and fit: mean absolute, peak to peak, reduction of
/// the largest; nothing where nothing was read.
void print_more_errors(const record::Channel& displacement, const correction::Metrics& m);

/// The text of an identification: lags, gains, and the error they leave.
void print_identification(const correction::Identification& found, const record::Record& record);
/// Prints a baseline that is shown and not written.
void print_baseline(const record::Channel& displacement, const correction::ArxBaseline& found,
                    const record::Record& record);

}  // namespace raceway::cli
