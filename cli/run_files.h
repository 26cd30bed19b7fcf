#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// Checks the files of a run: a command must not overwrite its inputs, and must not write two
/// outputs to the same file.
namespace raceway::cli {

/// Finds the inputs and outputs in a parsed command line. The files of --output, --report, --plot,
/// --save, --correction, --end-state and --field are outputs. Every other argument that names an
/// existing file is an input. A file that is redirected to standard input is also an input. Throws
/// text::InputError if an output is also an input, even if both have different paths, if two
/// outputs are the same file, or if an argument contains a control character. The commands
/// `calibrate` and `add` may replace the file of their argument MODEL.
void check_files(const CLI::App& command);

/// Checks outputs whose names are known only during the run. Throws text::InputError if such an
/// output is an input or another output of the run. Call this function after check_files().
void check_outputs(const std::vector<std::string>& outputs);

/// Adds an input that is not on the command line, such as a file that the model names. Throws
/// text::InputError if `file` is also an output. Call this function after check_files().
void add_input(const std::string& file);

}  // namespace raceway::cli
