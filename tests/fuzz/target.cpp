#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  for (const raceway::fuzz::Reader& reader : raceway::fuzz::readers())
    if (std::string_view(reader.name) == RACEWAY_READER) reader.read(text);
  return 0;
}
