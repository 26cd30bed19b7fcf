#pragma once

#include <string>

namespace raceway::cli {

struct ConformityFlags {
  std::string model;   ///< model file with [bearing] catalogue, or a designation of the catalogue
  std::string output;  ///< model file to write; none if empty
  bool json = false, force = false;
};

/// Runs `raceway calibrate` without measurements: fits the groove conformity, which makers do not
/// print, to the printed axial rigidities. Returns the exit status.
int calibrate_conformity(const ConformityFlags& flags);

}  // namespace raceway::cli
