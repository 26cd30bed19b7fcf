#include "record/note.h"

#include <array>
#include <iterator>
#include <utility>

namespace raceway::record {

std::string_view name(NoteKind kind) {
  switch (kind) {
    case NoteKind::note:
      return "note";
    case NoteKind::doubt:
      return "doubt";
    case NoteKind::warning:
      break;
  }
  return "warning";
}

Note NoteCode::operator()(std::string text, Place place) const {
  return {.code = this, .text = std::move(text), .place = std::move(place)};
}

std::span<const NoteCode* const> note_codes() {
  static constexpr std::array list{&note::read_as,
                                   &note::unused,
                                   &note::filled_in,
                                   &note::left_out,
                                   &note::averaged,
                                   &note::defaults,
                                   &note::assumed,
                                   &note::odd_value,
                                   &note::band,
                                   &note::load_limit,
                                   &note::law_limit,
                                   &note::exported,
                                   &note::unknown,
                                   &note::unit,
                                   &note::sensor,
                                   &note::plan,
                                   &note::ignored,
                                   &note::other_rig,
                                   &note::beyond_range,
                                   &note::no_prediction,
                                   &note::unloaded,
                                   &note::over_limit,
                                   &note::cut_contact,
                                   &note::at_bound,
                                   &note::not_identifiable,
                                   &note::misfit,
                                   &note::noise,
                                   &note::not_converged,
                                   &note::check_data,
                                   &note::rows_used,
                                   &note::polynomial,
                                   &note::due,
                                   &note::limits};
  return list;
}

std::vector<Note> notes_of(const NoteCode& code, std::vector<std::string> texts,
                           const Place& place) {
  std::vector<Note> list;
  for (std::string& text : texts) list.push_back(code(std::move(text), place));
  return list;
}

std::vector<std::string> texts(const std::vector<Note>& notes) {
  std::vector<std::string> list;
  for (const Note& one : notes) list.push_back(one.text);
  return list;
}

void append(std::vector<Note>& to, std::vector<Note> notes) {
  to.insert(to.end(), std::make_move_iterator(notes.begin()), std::make_move_iterator(notes.end()));
}

}  // namespace raceway::record
