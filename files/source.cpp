#include "files/source.h"

#include <filesystem>

#include "text/input_file.h"

namespace raceway::files {

Source repeatable(const Source& source) {
  Source result = source;
  for (Source& other : result.beside) other = repeatable(other);
  if (source.text || source.table) return result;
  std::error_code error;
  if (source.name != "-" && !std::filesystem::is_fifo(source.name, error)) return result;
  result.name = text::input_name(source.name);
  result.text = std::make_shared<const std::string>(text::read_text(source.name));
  return result;
}

}  // namespace raceway::files
