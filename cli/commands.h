#pragma once

#include <CLI/CLI.hpp>
#include <functional>

/// Subcommands of the program `raceway`. Each subcommand has its own source file. A setup function
/// declares the flags of a command and returns a function of type Run. After the arguments are
/// parsed, Run executes the command and returns the exit status.
namespace raceway::cli {

enum ExitStatus { done = 0, wrong_input = 1, not_converged = 2 };

using Run = std::function<int()>;

Run setup_solve(CLI::App& command);
Run setup_table(CLI::App& command);
Run setup_displacement(CLI::App& command);
Run setup_sensitivity(CLI::App& command);
Run setup_spindle(CLI::App& command);
Run setup_step_response(CLI::App& command);
Run setup_deflection(CLI::App& command);
Run setup_modes(CLI::App& command);
Run setup_identify(CLI::App& command);
Run setup_correct(CLI::App& command);
Run setup_export(CLI::App& command);
Run setup_join(CLI::App& command);
Run setup_calibrate(CLI::App& command);
Run setup_calibrate_sensor(CLI::App& command);
Run setup_fit_law(CLI::App& command);
Run setup_compare(CLI::App& command);
Run setup_effects(CLI::App& command);
Run setup_diagnose(CLI::App& command);
Run setup_add(CLI::App& command);
Run setup_keys(CLI::App& command);
Run setup_describe(CLI::App& command);
Run setup_bearings(CLI::App& command);
Run setup_new(CLI::App& command);
Run setup_check(CLI::App& command);
Run setup_workbench(CLI::App& command);

}  // namespace raceway::cli
