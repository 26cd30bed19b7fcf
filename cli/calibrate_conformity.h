#pragma once

#include <string>

namespace raceway::cli {

struct ConformityFlags {
  std::string model;   ///< model file with [bearing] catalogue, or a designation of the catalogue
  std::string output;  ///< model file to write; none if empty
  bool json = false, force = false;
};

/// `raceway calibrate` without measurements: the groove conformity, which no maker prints, from the
/// axial rigidities that it prints. Gives the exit status.
int calibrate_conformity(const ConformityFlags& flags);

}  // namespace raceway::cli
