#pragma once

#include <map>
#include <string>

#include "cli/commands.h"
#include "text/error.h"

namespace raceway::cli {

/// Ends a run before it has an answer.
struct Refusal {
  std::string message;
  text::Place place = {};
};

/// The commands with their flags, and what runs them.
class Program {
 public:
  Program();

  [[nodiscard]] std::string help() const { return app_.help(); }

  /// The command of that name; throws Refusal if there is none.
  [[nodiscard]] const CLI::App& command(const std::string& name) const;

  /// Exit status. Throws Refusal, text::InputError and the exceptions of the libraries.
  int run(int argc, char** argv);

 private:
  CLI::App app_{
      "Computes friction, kinematics and heat of spindle bearings, compares the model with "
      "measurements, and finds the physical effect that the model lacks"};
  std::map<CLI::App*, Run> runs_;
};

}  // namespace raceway::cli
