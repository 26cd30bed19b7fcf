#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "session/messages.h"

/// Messages of a run, one function for each kind. Nothing else writes to stderr or, for a JSON
/// document, to stdout.
namespace raceway::cli {

/// Silences say(), tell() and warn() from now on, for `--quiet`. Errors stay.
void set_quiet(bool quiet);

/// Prints every note and warning from now on. Otherwise at most three of one code are printed.
void show_every_message();

/// Prints how many notes and warnings of each code were not printed.
void count_hidden_messages();

/// Returns true if progress bars are shown: stderr is a terminal and --quiet is not set.
[[nodiscard]] bool shows_progress();

/// Reports a completed action, as `my.toml written`. It follows all that stdout has so far; so do
/// the other messages.
void say(const std::string& line);

/// Each behind `note: `, or behind `warning: ` where it is a doubt or a warning.
void tell(const std::vector<record::Note>& notes);
/// Prints notes, each behind `note: `.
void tell(const std::vector<std::string>& notes);

/// Prints warnings, each behind `warning: `.
void warn(const std::string& warning);
void warn(const std::vector<std::string>& warnings);

/// Receives the messages of a session and prints them as tell() does; files that a session reads
/// may not be outputs.
[[nodiscard]] session::Messages& messages();

/// Prints the reason why there is no result, also with --quiet.
void complain(const std::string& line);

/// The JSON document of this run: it leaves when the command has done all else, so that an error
/// never stands behind it.
void put_document(std::string json);

/// Takes the JSON document out of this run; empty where there is none.
[[nodiscard]] std::string take_document();

}  // namespace raceway::cli
