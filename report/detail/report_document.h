#pragma once

#include <string>

#include "text/detail/json_text.h"

namespace raceway::report {

/// Builder of a report document, a JSON text. Its members have the order in which they are added.
class Document {
 public:
  explicit Document(const std::string& kind);
  void add(const std::string& key, text::json value) {
    add_text(key, text::line_text(std::move(value)));
  }
  /// Adds a member whose value is JSON text.
  void add_text(const std::string& key, const std::string& value) {
    text_ += (text_.empty() ? "{" : ",\n") + text::line_text(key) + ":" + value;
  }
  [[nodiscard]] std::string text() const { return text_ + "\n}"; }

 private:
  std::string text_;
};

}  // namespace raceway::report
