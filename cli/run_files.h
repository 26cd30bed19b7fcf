#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// Files of a run. A command does not overwrite its inputs and does not write two outputs to the
/// same file.
namespace raceway::cli {

/// Finds the inputs and outputs in a parsed command line. The files of --output, --report, --plot,
/// --save, --correction, --end-state and --field are outputs. Every other argument that names an
/// existing file is an input. Standard input is an input if it is a file. Throws text::InputError
/// if an output is also an input, even by another path, if two outputs are the same file, and for
/// an argument with a control character. As an exception, `calibrate` and `add` may replace their
/// own MODEL.
void check_files(const CLI::App& command);

/// Throws text::InputError if an output whose name is known only during the run is an input or
/// another output of the run. Call it after check_files().
void check_outputs(const std::vector<std::string>& outputs);

/// Checks a file that a model names and that the run reads. Throws text::InputError if the file is
/// also an output. Call it after check_files().
void add_input(const std::string& file);

}  // namespace raceway::cli
