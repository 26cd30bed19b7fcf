#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "session/loop_model.h"
#include "session/reading.h"
#include "text/output_file.h"

/// Flags that several commands share.
namespace raceway::cli {

/// Returns the action for an output file that already exists: `replace` if `force` is true,
/// otherwise `refuse`.
[[nodiscard]] inline text::IfExists on_existing(bool force) {
  return force ? text::IfExists::replace : text::IfExists::refuse;
}

/// Declares the argument `MODEL`: a model file. `with` names the TOML tables that the model file
/// must have.
void declare_model(CLI::App& command, std::string& model, const std::string& with = {});

/// Declares `--json`.
void declare_json(CLI::App& command, bool& json);

/// Declares `--coolant on` and `--coolant off`.
void declare_coolant(CLI::App& command, bool& on, const std::string& help);

/// Declares `--columns map.toml` and `--drop-nan` for a command that reads measurements.
void declare(CLI::App& command, session::Reading& reading);

/// Declares `--beside FILE` for a command on records over time. FILE is another file of the same
/// record, such as the temperatures of another logger.
void declare_beside(CLI::App& command, session::Reading& reading);

/// Declares `--from 20h` and `--until 24h` for a command that reads records over time.
void declare(CLI::App& command, session::Period& period);

/// Declares `--channel COLUMN`. The command also accepts the old name of this flag,
/// `--displacement`.
void declare_channel(CLI::App& command, std::string& channel);

/// Declares the flags that calibrate, diagnose, add and similar commands share: `--channel`,
/// `--per-record f0,z`, `--rows`, and the flags for reading measurements.
void declare(CLI::App& command, session::LoopOptions& loop);

/// Declares `--tolerance 2um,0.5K`.
void declare(CLI::App& command, session::Tolerance& tolerance);

}  // namespace raceway::cli
