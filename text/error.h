#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace raceway::text {

/// Where something stands that a user wrote; what is not known is empty or 0.
struct Place {
  std::string file = {};
  int line = 0;          ///< from 1
  std::string key = {};  ///< of a model file, column, or flag

  [[nodiscard]] std::string text() const { return file + ":" + std::to_string(line); }
};

/// Something a user wrote is wrong. The message is complete and meant to be shown as it stands:
/// `FILE:LINE: key or column = value: what is wrong or allowed range`. It may have several lines;
/// the place is then that of the first.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& message, Place where = {})
      : std::runtime_error(message), place(std::move(where)) {}
  Place place;

  /// The message without the file and the line in front of it.
  [[nodiscard]] std::string without_place() const {
    const std::string message = what(), front = place.text() + ": ";
    return message.starts_with(front) ? message.substr(front.size()) : message;
  }
};

}  // namespace raceway::text
