#pragma once

#include <string>

#include "io/json_text.h"

namespace raceway::io {

/// JSON on one line; text that is no UTF-8 is kept as far as it is.
inline std::string dump(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The document of a report in the making: its members in order, each of them JSON already.
class Document {
 public:
  explicit Document(const std::string& kind) {
    add("raceway_report", "1");
    add("program", dump("raceway " RACEWAY_VERSION));
    add("kind", dump(kind));
  }
  void add(const std::string& key, const std::string& value) {
    text_ += (text_.empty() ? "{" : ",\n") + dump(key) + ":" + value;
  }
  [[nodiscard]] std::string text() const { return text_ + "\n}"; }

 private:
  std::string text_;
};

}  // namespace raceway::io
