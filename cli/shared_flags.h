#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "session/loop_model.h"
#include "session/reading.h"
#include "text/output_file.h"

/// Flags of several commands, each declared once.
namespace raceway::cli {

/// Behaviour for an existing file, set by --force.
[[nodiscard]] inline text::IfExists on_existing(bool force) {
  return force ? text::IfExists::replace : text::IfExists::refuse;
}

/// Argument `MODEL`: a model file `with` these tables.
void declare_model(CLI::App& command, std::string& model, const std::string& with = {});

/// `--json`.
void declare_json(CLI::App& command, bool& json);

/// `--coolant on` or `off`.
void declare_coolant(CLI::App& command, bool& on, const std::string& help);

/// `--columns map.toml` and `--drop-nan` of a command that reads measurements.
void declare(CLI::App& command, session::Reading& reading);

/// `--beside FILE` of a command on records over time.
void declare_beside(CLI::App& command, session::Reading& reading);

/// `--from 20h` and `--until 24h` of a command on records over time.
void declare(CLI::App& command, session::Period& period);

/// Flag `--channel COLUMN`, formerly `--displacement`.
void declare_channel(CLI::App& command, std::string& channel);

/// Flags of every command of the loop: the flags above and `--per-record f0,z`.
void declare(CLI::App& command, session::LoopOptions& loop);

/// `--tolerance 2um,0.5K`.
void declare(CLI::App& command, session::Tolerance& tolerance);

}  // namespace raceway::cli
