#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace raceway::spindle {

/// A case of data/reference/spindle_reference.json, with its inputs and outputs. Throws where there
/// is none.
inline nlohmann::json reference(const std::string& id) {
  static const nlohmann::json all = nlohmann::json::parse(
      std::ifstream(RACEWAY_SOURCE_DIR "/data/reference/spindle_reference.json"));
  for (const nlohmann::json& one : all)
    if (one.at("id") == id) return one;
  throw std::runtime_error("spindle_reference.json has no case " + id);
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

}  // namespace raceway::spindle
