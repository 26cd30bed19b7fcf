#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "record/note.h"

namespace raceway::text {

using record::Place;

/// An error in the user's input. The message is complete and can be shown unchanged: `FILE:LINE:
/// key or column = value: what is wrong or allowed range`. If the message has several lines,
/// `place` is the file position that the first line names.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& message, Place where = {})
      : std::runtime_error(message), place(std::move(where)) {}
  Place place;

  /// Returns the message without file and line.
  [[nodiscard]] std::string without_place() const {
    const std::string message = what(), front = place.text() + ": ";
    return message.starts_with(front) ? message.substr(front.size()) : message;
  }
};

}  // namespace raceway::text
