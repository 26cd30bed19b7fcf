#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "session/messages.h"

/// Messages of a run, one function for each kind. All messages on stderr and all JSON documents on
/// stdout use these functions, except for the progress bar and the message after a stop signal.
namespace raceway::cli {

/// Switches off the output of say(), tell() and warn(), for `--quiet`. Errors are still printed.
void set_quiet(bool quiet);

/// Makes the program print every note and warning. By default, the program prints at most three
/// messages with the same code.
void show_every_message();

/// Prints for each code the number of notes and warnings that were not printed, and resets the
/// numbers. Prints nothing with `--quiet` or after show_every_message().
void count_hidden_messages();

/// Returns true if progress bars are shown: stderr is a terminal and --quiet is not set.
[[nodiscard]] bool shows_progress();

/// Reports a completed action, such as `my.toml written`. This message and all other messages
/// appear after all earlier output on stdout.
void say(const std::string& line);

/// Prints each note after `note: `, or after `warning: ` if its kind is doubt or warning.
void tell(const std::vector<record::Note>& notes);
/// Prints notes, each after `note: `.
void tell(const std::vector<std::string>& notes);

/// Prints warnings, each after `warning: `.
void warn(const std::string& warning);
void warn(const std::vector<std::string>& warnings);

/// Returns the receiver of the messages of a session. The receiver prints messages like tell(). The
/// receiver also rejects files that the session reads and that are outputs of the same run.
[[nodiscard]] session::Messages& messages();

/// Prints the reason why a command gives no result, even with --quiet.
void complain(const std::string& line);

/// Stores the JSON document of this run. The document is printed after all other work of the
/// command, so that no error can follow it.
void put_document(std::string json);

/// Returns the JSON document of this run and clears it; empty if there is none.
[[nodiscard]] std::string take_document();

}  // namespace raceway::cli
