#pragma once

#include <map>
#include <string>

#include "cli/commands.h"
#include "text/error.h"

namespace raceway::cli {

/// Exception that ends the program without a result, for example because of a wrong flag.
struct Refusal {
  std::string message;
  text::Place place = {};
};

/// Commands of the program with their flags, and the functions that run the commands.
class Program {
 public:
  Program();

  [[nodiscard]] std::string help() const { return app_.help(); }

  /// Returns the command with this name; throws Refusal if there is none.
  [[nodiscard]] const CLI::App& command(const std::string& name) const;

  /// Runs the program and returns the exit status. Throws Refusal, text::InputError, and exceptions
  /// of the functions that the command calls.
  int run(int argc, char** argv);

 private:
  CLI::App app_{
      "Computes friction, kinematics and heat of spindle bearings, compares the model with "
      "measurements, and finds the physical effect that the model lacks"};
  std::map<CLI::App*, Run> runs_;
};

}  // namespace raceway::cli
