#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// The files of a run. No command overwrites its inputs, nor writes two outputs to one file.
namespace raceway::cli {

/// Takes the files from a parsed command line: --output, --report, --plot, --save, --correction,
/// --end-state and --field are written, every other argument that names a file is read, and so is
/// standard input. Throws text::InputError if an output is also an input, by any path, or two
/// outputs are the same file. `calibrate` and `add` may write onto their own MODEL. An argument
/// with a control character is refused, too.
void check_files(const CLI::App& command);

/// Checks outputs with names known only during the run. Call it after check_files().
void check_outputs(const std::vector<std::string>& outputs);

/// Checks a file that a model names and that is read too. Throws text::InputError if it is an
/// output. Call it after check_files().
void add_input(const std::string& file);

}  // namespace raceway::cli
