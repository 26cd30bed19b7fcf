#pragma once

#include <string>
#include <vector>

#include "correction/record_check.h"
#include "files/used_default.h"
#include "loop/check.h"
#include "record/record.h"

namespace raceway::cli {

/// Prints the number of rows, the noise and the columns of a record, the parameters that can be
/// fitted and the effects that can be tested.
void print_check(const loop::Check& check, const record::Record& data);
/// Prints the time interval in which the settings of a row (speed, load, feed, coolant) apply: from
/// the previous row to this row, or from this row to the next row. Also prints whether the program
/// assumes that readings were taken just before the settings changed.
void print_settings_hold(record::SettingsHold hold);
/// Prints the sampling interval and the noise of a displacement record, and the resolution of each
/// column. Also prints the time constants and the DC gain of each transfer function in the model.
void print_check(const correction::RecordCheck& check);
/// Prints the assumptions of a model, one per line: defaults, estimates, and values that the file
/// marks as assumed.
void print_defaults(const std::string& source, const std::vector<files::UsedDefault>& defaults);

}  // namespace raceway::cli
