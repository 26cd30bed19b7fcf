#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"

/// Writes JSON documents as text; shared by the writers of results and pages.
namespace raceway::text {

using json = nlohmann::ordered_json;

/// Returns the text of a document: the format number, then the members. The indentation is two
/// blanks. Numbers have 15 digits (see with_15_digits()). Numbers that are not finite become null.
/// Bytes that are not UTF-8, for example in file names, are replaced.
[[nodiscard]] std::string text(const json& document);

/// Writes the texts of notes for readers to the member `key`. Also appends each note with kind,
/// code and place to the member `said`, for programs that read the document.
void put_notes(json& document, std::string_view key, const std::vector<record::Note>& notes);

/// Returns a value on one line, without a line end.
[[nodiscard]] std::string line_text(const json& value);

}  // namespace raceway::text
