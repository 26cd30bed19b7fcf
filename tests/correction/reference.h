#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/places.h"

namespace raceway::correction {

/// A case of data/reference/correction_reference.json. Throws where there is none.
inline nlohmann::json reference(const std::string& name) {
  static const nlohmann::json all = nlohmann::json::parse(
      std::ifstream(tests::source_dir() + "/data/reference/correction_reference.json"));
  return all.at(name);
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

}  // namespace raceway::correction
