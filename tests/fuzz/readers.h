#pragma once

#include <span>
#include <string>

/// All that reads what a user wrote, each as a function of a text. Whatever the text, a reader
/// takes it or throws text::InputError; anything else that leaves these functions is a fault.
namespace raceway::fuzz {

struct Reader {
  const char* name;  ///< of its folder of inputs in corpus/
  void (*read)(const std::string& text);
};

[[nodiscard]] std::span<const Reader> readers();

}  // namespace raceway::fuzz
