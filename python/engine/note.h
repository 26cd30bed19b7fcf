#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "record/note.h"

/// Converts a note to a `raceway.Note` in Python: a str with kind, code and place.
template <>
struct pybind11::detail::type_caster<raceway::record::Note> {
  PYBIND11_TYPE_CASTER(raceway::record::Note, const_name("raceway.Note"));
  static bool load(handle, bool) { return false; }
  static handle cast(const raceway::record::Note& note, return_value_policy, handle) {
    const auto text_or_none = [](const std::string& text) -> object {
      if (text.empty()) return none();
      return str(text);
    };
    return module_::import("raceway._note")
        .attr("Note")(note.text, std::string(raceway::record::name(note.kind())),
                      std::string(note.code->name), text_or_none(note.place.file),
                      note.place.line > 0 ? object(int_(note.place.line)) : object(none()),
                      text_or_none(note.place.key))
        .release();
  }
};
