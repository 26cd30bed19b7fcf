#include "text/detail/json_text.h"

#include <fmt/format.h>

#include <cmath>

#include "text/format_number.h"

namespace raceway::text {
namespace {

/// With a point or an exponent, so that it reads back as a number of the same kind.
std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text = fmt::format("{:.15g}", value);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

std::string scalar_text(const json& value) {
  if (value.is_number_float()) return number_text(value.get<double>());
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The library's own writer gives some numbers one digit too many, so that of numbers is ours.
/// `indent` below zero: all on one line.
void append(std::string& out, const json& value, int indent, int depth) {
  if (!value.is_structured() || value.empty()) {
    out += value.is_structured() ? (value.is_object() ? "{}" : "[]") : scalar_text(value);
    return;
  }
  const auto new_line = [&](int levels) {
    if (indent < 0) return;
    out += '\n';
    out.append(static_cast<std::size_t>(indent * levels), ' ');
  };
  const bool object = value.is_object();
  out += object ? '{' : '[';
  bool first = true;
  for (const auto& [key, element] : value.items()) {
    if (!first) out += ',';
    first = false;
    new_line(depth + 1);
    if (object) out += scalar_text(key) + (indent < 0 ? ":" : ": ");
    append(out, element, indent, depth + 1);
  }
  new_line(depth);
  out += object ? '}' : ']';
}

}  // namespace

std::string text(const json& document) {
  std::string out = fmt::format("{{\n  \"format\": {}", format_number);
  for (const auto& [key, element] : document.items()) {
    out += ",\n  " + scalar_text(key) + ": ";
    append(out, element, 2, 1);
  }
  return out + "\n}\n";
}

void put_notes(json& document, std::string_view key, const std::vector<record::Note>& notes) {
  document[std::string(key)] = texts(notes);
  json& said = document["said"];
  if (said.is_null()) said = json::array();
  for (const record::Note& one : notes) {
    json object = {{"kind", name(one.kind())}, {"code", one.code->name}, {"text", one.text}};
    if (!one.place.file.empty()) object["file"] = one.place.file;
    if (one.place.line > 0) object["line"] = one.place.line;
    if (!one.place.key.empty()) object["key"] = one.place.key;
    said.push_back(std::move(object));
  }
}

std::string line_text(const json& value) {
  std::string out;
  append(out, value, -1, 0);
  return out;
}

}  // namespace raceway::text
