#pragma once

#include <string>
#include <vector>

#include "correction/record_check.h"
#include "files/used_default.h"
#include "loop/check.h"
#include "record/record.h"

namespace raceway::cli {

/// Rows, noise and columns of a record, and which numbers can be fitted and effects be tested.
void print_check(const loop::Check& check, const record::Record& data);
/// Between which rows the settings of a control hold.
void print_settings_hold(record::SettingsHold hold);
/// Clock, noise of a reading, last digits and printed transfer functions of a record over time.
void print_check(const correction::RecordCheck& check);
/// The numbers that a model leaves to the program, a line each.
void print_defaults(const std::string& source, const std::vector<files::UsedDefault>& defaults);

}  // namespace raceway::cli
