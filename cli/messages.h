#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "session/messages.h"

/// Messages of a run, one function for each kind. All output to stderr, and a JSON document on
/// stdout, goes through these.
namespace raceway::cli {

/// Silences say(), tell() and warn() from now on, for `--quiet`. Errors stay.
void set_quiet(bool quiet);

/// Prints every note and warning from now on. Otherwise at most three of one code are printed.
void show_every_message();

/// Prints how many notes and warnings of each code were not printed.
void count_hidden_messages();

/// Returns true if progress bars are shown: stderr is a terminal and --quiet is not set.
[[nodiscard]] bool shows_progress();

/// Reports a completed action, as `my.toml written`. It follows all earlier output on stdout; so do
/// the other messages.
void say(const std::string& line);

/// Prints each message after `note: `, or after `warning: ` for a doubt or a warning.
void tell(const std::vector<record::Note>& notes);
/// Prints notes, each after `note: `.
void tell(const std::vector<std::string>& notes);

/// Prints warnings, each after `warning: `.
void warn(const std::string& warning);
void warn(const std::vector<std::string>& warnings);

/// Receives the messages of a session and prints them as tell() does. Files that a session reads
/// may not be outputs.
[[nodiscard]] session::Messages& messages();

/// Prints the reason why there is no result, also with --quiet.
void complain(const std::string& line);

/// Stores the JSON document of this run. It is printed after all other work of the command, so that
/// no error follows it.
void put_document(std::string json);

/// Takes the JSON document of this run; empty if there is none.
[[nodiscard]] std::string take_document();

}  // namespace raceway::cli
