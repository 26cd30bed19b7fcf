#include "io/csv_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace raceway::io {

void append_model(fmt::memory_buffer& out, std::string_view model_text) {
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "# model:\n");
  while (!model_text.empty()) {
    const std::size_t end = std::min(model_text.find('\n'), model_text.size());
    std::string_view line = model_text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    fmt::format_to(put, "{}{}{}\n", model_mark, line.empty() ? "" : " ", line);
    model_text.remove_prefix(std::min(end + 1, model_text.size()));
  }
}

void append_value(fmt::memory_buffer& out, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(out), "{:.12g}", value);
}

}  // namespace raceway::io
