#include "files/source.h"

#include <filesystem>

#include "text/input_file.h"

namespace raceway::files {

Source repeatable(const Source& source) {
  if (source.text || source.table) return source;
  std::error_code error;
  if (source.name != "-" && !std::filesystem::is_fifo(source.name, error)) return source;
  return {text::input_name(source.name), text::read_text(source.name)};
}

}  // namespace raceway::files
