#include "cli/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string_view>
#include <utility>

#include "cli/process.h"
#include "cli/run_files.h"
#include "cli/text_table.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

struct State {
  bool quiet = false, every = false;
  std::map<const record::NoteCode*, int> heard = {};  // of each code
  std::string document;
};

constexpr int most_of_a_code = 3;

State& state() {
  static State of_this_run;
  return of_this_run;
}

/// The text as a terminal shows it: lines are broken between words, and what follows is set in.
std::string broken_at(std::size_t width, std::string_view text) {
  constexpr std::string_view break_here = "\n  ";
  std::vector<std::string> broken;
  for (const std::string_view line : text::split(text, '\n'))
    broken.push_back(line.size() <= width
                         ? std::string(line)
                         : fmt::format("{}", fmt::join(filled(line, width - 2), break_here)));
  return fmt::format("{}", fmt::join(broken, "\n"));
}

void put_line(const char* kind, const std::string& line) {
  std::fflush(stdout);  // a log of both keeps the order
  const std::string text = kind + line;
  const bool on_terminal = isatty(STDERR_FILENO) != 0;
  write_message((on_terminal ? broken_at(terminal_width(STDERR_FILENO), text) : text) + '\n');
}

class ToPeople : public session::Messages {
 public:
  void hear(const record::Note& note) override {
    if (++state().heard[note.code] > most_of_a_code && !state().every) return;
    if (note.kind() == record::NoteKind::note)
      tell(std::vector<std::string>{note.text});
    else
      warn(note.text);
  }
  void reads(const std::string& file) override { add_input(file); }
};

}  // namespace

void set_quiet(bool quiet) { state().quiet = quiet; }

void show_every_message() { state().every = true; }

void count_hidden_messages() {
  if (!state().every)
    for (const auto& [code, count] : state().heard)
      if (count > most_of_a_code && !state().quiet)
        put_line(
            code->kind == record::NoteKind::note ? "note: " : "warning: ",
            fmt::format(
                "number of further messages with the code \"{}\": {}; --json shows all messages",
                code->name, count - most_of_a_code));
  state().heard.clear();
}

bool shows_progress() { return !state().quiet && isatty(STDERR_FILENO) != 0; }

void say(const std::string& line) {
  if (!state().quiet) put_line("", line);
}

void tell(const std::vector<std::string>& notes) {
  if (state().quiet) return;
  for (const std::string& note : notes) put_line("note: ", note);
}

void tell(const std::vector<record::Note>& notes) { messages().say(notes); }

void warn(const std::string& warning) {
  if (!state().quiet) put_line("warning: ", warning);
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) warn(warning);
}

session::Messages& messages() {
  static ToPeople of_this_run;
  return of_this_run;
}

void complain(const std::string& line) { put_line("", line); }

void put_document(std::string json) { state().document = std::move(json); }

std::string take_document() { return std::exchange(state().document, {}); }

}  // namespace raceway::cli
