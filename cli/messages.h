#pragma once

#include <string>
#include <vector>

#include "record/note.h"
#include "session/messages.h"

/// Prints the messages of a run. Each kind of message has its own function. Messages go to stderr,
/// and the JSON document goes to stdout. The progress bar and the message after a stop signal are
/// printed by functions in progress.h and process.h.
namespace raceway::cli {

/// Switches off the output of say(), tell() and warn(), for `--quiet`. Errors are still printed.
void set_quiet(bool quiet);

/// Makes the program print every note and warning. By default, the program prints at most three
/// messages with the same message code.
void show_every_message();

/// Prints the number of notes and warnings that were not printed, for each message code. Sets these
/// numbers to 0. Prints nothing with `--quiet` or after show_every_message().
void count_hidden_messages();

/// Returns true if progress bars are shown: stderr is a terminal and --quiet is not set.
[[nodiscard]] bool shows_progress();

/// Prints a message about a completed action, such as `my.toml written`. All output that was
/// earlier written to stdout appears before the message.
void say(const std::string& line);

/// Prints each note with the prefix `note: `. If the kind of the note is doubt or warning, the
/// prefix is `warning: `.
void tell(const std::vector<record::Note>& notes);
/// Prints notes, each with the prefix `note: `.
void tell(const std::vector<std::string>& notes);

/// Prints warnings, each with the prefix `warning: `.
void warn(const std::string& warning);
void warn(const std::vector<std::string>& warnings);

/// Returns the object that receives the messages of a calculation. The object prints notes by
/// tell() and warnings by warn(). The object also throws an error if a file that the program reads
/// is an output of the command.
[[nodiscard]] session::Messages& messages();

/// Prints the reason why a command gives no result. The reason is also printed with --quiet.
void complain(const std::string& line);

/// Stores the JSON document of this run. The program prints the document after all other work, so
/// that no error can follow the document.
void put_document(std::string json);

/// Returns the JSON document of this run, and deletes the stored document. The text is empty if
/// there is no document.
[[nodiscard]] std::string take_document();

}  // namespace raceway::cli
