#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "session/messages.h"

/// What a run says beside its numbers: one function for each kind, and no other way to stderr or,
/// for a JSON document, to stdout.
namespace raceway::cli {

/// With `--quiet`: say() and tell() are silent from now on.
void set_quiet(bool quiet);

/// Whether bars and steps of long work are shown: a terminal reads stderr, and nobody asked for
/// silence.
[[nodiscard]] bool shows_progress();

/// What was done, as `my.toml written`. Behind all that stdout has so far, as the following.
void say(const std::string& line);

/// Each behind `note: `, or behind `warning: ` where it is a doubt or a warning.
void tell(const std::vector<record::Note>& notes);
/// What is good to know, each behind `note: `.
void tell(const std::vector<std::string>& notes);

/// What makes a result doubtful, each behind `warning: `. Said in any case.
void warn(const std::string& warning);
void warn(const std::vector<std::string>& warnings);

/// Hears what a session says, as tell() does; files that it reads are none of the outputs.
[[nodiscard]] session::Messages& messages();

/// Why there is no result. Said in any case.
void complain(const std::string& line);

/// The JSON document of this run: it leaves when the command has done all else, so that an error
/// never stands behind it.
void put_document(std::string json);

/// That document, which is then no longer here; empty where there is none.
[[nodiscard]] std::string take_document();

}  // namespace raceway::cli
