#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace raceway::spindle {

/// All cases of data/reference/spindle_reference.json.
inline const nlohmann::json& references() {
  static const nlohmann::json all = nlohmann::json::parse(
      std::ifstream(RACEWAY_SOURCE_DIR "/data/reference/spindle_reference.json"));
  return all;
}

/// One of them, with its inputs and outputs. Throws where there is none.
inline nlohmann::json reference(const std::string& id) {
  for (const nlohmann::json& one : references())
    if (one.at("id") == id) return one;
  throw std::runtime_error("spindle_reference.json has no case " + id);
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

}  // namespace raceway::spindle
