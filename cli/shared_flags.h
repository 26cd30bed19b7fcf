#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "session/loop_subject.h"
#include "session/reading.h"
#include "session/tolerance.h"

/// Flags that several commands have, each declared once.
namespace raceway::cli {

/// `--columns map.toml` and `--drop-nan` of a command that reads measurements.
void declare(CLI::App& command, session::Reading& reading);

/// `--from 20h` and `--until 24h` of a command on records over time.
void declare(CLI::App& command, session::Period& period);

/// `--tolerance 2um,0.5K`.
void declare(CLI::App& command, session::Tolerance& tolerance);

/// `--per-record f0,z`.
void declare(CLI::App& command, session::PerRecord& per_record);

/// `--displacement COLUMN` of a command that works on one displacement of a file.
void declare_displacement(CLI::App& command, std::string& column);

}  // namespace raceway::cli
