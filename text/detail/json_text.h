#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"

/// Writer of numbers as JSON; shared by the writers of results and pages.
namespace raceway::text {

using json = nlohmann::ordered_json;

/// Text of a document: the number of its format, then its members. Two blanks of indent, 15 digits
/// (see with_15_digits()). Numbers that are not finite become null; bytes that are no UTF-8 (file
/// names) are replaced.
[[nodiscard]] std::string text(const json& document);

/// Writes the texts of notes for people at `key`. Adds each note with its kind, code and place to
/// the end of the member `said`, for programs.
void put_notes(json& document, std::string_view key, const std::vector<record::Note>& notes);

/// Returns a value on one line, without a line end.
[[nodiscard]] std::string line_text(const json& value);

}  // namespace raceway::text
