#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raceway::record {

/// Place in the user's input. Unknown parts are empty or 0.
struct Place {
  std::string file = {};
  int line = 0;          ///< line number, starting at 1
  std::string key = {};  ///< key of a model file, column, or flag

  [[nodiscard]] std::string text() const { return file + ":" + std::to_string(line); }
};

enum class NoteKind {
  note,     ///< for information
  doubt,    ///< an input that may be wrong
  warning,  ///< a result that is doubtful
};

[[nodiscard]] std::string_view name(NoteKind kind);

struct Note;

/// Kind of a note. Programs should identify a note by the name of its code, not by its text.
struct NoteCode {
  std::string_view name;
  NoteKind kind;
  std::string_view meaning;

  /// Returns a note with this code; `text` is complete.
  [[nodiscard]] Note operator()(std::string text, Place place = {}) const;
};

/// A message that accompanies an answer. Its text is for the reader and may change.
struct Note {
  const NoteCode* code = nullptr;
  std::string text;
  Place place = {};

  [[nodiscard]] NoteKind kind() const { return code->kind; }
};

/// All codes. `raceway::record::note::left_out("3 rows ...")` creates a note.
namespace note {

inline constexpr NoteCode read_as{"read-as", NoteKind::note,
                                  "how a file, a column or a unit was read"};
inline constexpr NoteCode unused{"unused", NoteKind::note, "a column or key that is not used"};
inline constexpr NoteCode filled_in{"filled-in", NoteKind::note,
                                    "a value that stands for one that the file does not have"};
inline constexpr NoteCode left_out{"left-out", NoteKind::note,
                                   "rows or readings that take no part"};
inline constexpr NoteCode averaged{"averaged", NoteKind::note, "rows that became one"};
inline constexpr NoteCode defaults{"defaults", NoteKind::note, "number of defaults of the model"};
inline constexpr NoteCode assumed{"assumed", NoteKind::note,
                                  "what was taken for granted, chosen or refitted"};
inline constexpr NoteCode odd_value{"odd-value", NoteKind::note,
                                    "a value of the model or the question that is unusual or not "
                                    "consistent; it is used as it stands"};
inline constexpr NoteCode band{"band", NoteKind::note, "confidence of the numbers that follow"};
inline constexpr NoteCode load_limit{"load-limit", NoteKind::note,
                                     "a load, pressure or contact angle beyond what the bearing "
                                     "is made for"};
inline constexpr NoteCode law_limit{"law-limit", NoteKind::note,
                                    "a state beyond what the law describes"};
inline constexpr NoteCode exported{"export", NoteKind::note,
                                   "how an exported correction differs from its model"};
inline constexpr NoteCode unknown{"unknown", NoteKind::note, "what the data or files cannot tell"};

inline constexpr NoteCode unit{"unit", NoteKind::doubt,
                               "values that look entered in another unit, sign or column"};
inline constexpr NoteCode sensor{"sensor", NoteKind::doubt,
                                 "readings that look like a fault of their sensor"};
inline constexpr NoteCode plan{"plan", NoteKind::doubt,
                               "measurements whose order or levels hide something"};

inline constexpr NoteCode ignored{"ignored", NoteKind::warning,
                                  "data of the model or the question that change nothing"};
inline constexpr NoteCode other_rig{"other-rig", NoteKind::warning,
                                    "models that are compared although their rigs differ"};
inline constexpr NoteCode beyond_range{"beyond-range", NoteKind::warning,
                                       "inputs outside of what the model was made from"};
inline constexpr NoteCode no_prediction{"no-prediction", NoteKind::warning,
                                        "points or rows without a result"};
inline constexpr NoteCode unloaded{"unloaded", NoteKind::warning,
                                   "a bearing without contact or below its minimum load"};
inline constexpr NoteCode over_limit{"over-limit", NoteKind::warning,
                                     "a speed, load, fit or temperature beyond what a part stands"};
inline constexpr NoteCode cut_contact{"cut-contact", NoteKind::warning,
                                      "a contact that a shoulder cuts off"};
inline constexpr NoteCode at_bound{"at-bound", NoteKind::warning, "a parameter at its bound"};
inline constexpr NoteCode not_identifiable{"not-identifiable", NoteKind::warning,
                                           "parameters that the data do not determine"};
inline constexpr NoteCode misfit{"misfit", NoteKind::warning,
                                 "errors beyond the noise, and what they do to the result"};
inline constexpr NoteCode noise{"noise", NoteKind::warning,
                                "how the scatter of the readings was found or weighs"};
inline constexpr NoteCode not_converged{"not-converged", NoteKind::warning,
                                        "a fit or a state that found no values"};
inline constexpr NoteCode check_data{"check-data", NoteKind::warning,
                                     "data that a verdict holds for wrong"};
inline constexpr NoteCode rows_used{"rows-used", NoteKind::warning,
                                    "rows or channels that a fit does without"};
inline constexpr NoteCode polynomial{"polynomial", NoteKind::warning,
                                     "properties of printed polynomials that no machine has"};
inline constexpr NoteCode due{"due", NoteKind::warning,
                              "a reading that was refused, or an identification that is due"};
inline constexpr NoteCode limits{"limits", NoteKind::warning,
                                 "what a result does not tell, or where it ends"};

}  // namespace note

/// Returns the codes in the order above.
[[nodiscard]] std::span<const NoteCode* const> note_codes();

/// Returns a note with this code and place for each of `texts`.
[[nodiscard]] std::vector<Note> notes_of(const NoteCode& code, std::vector<std::string> texts,
                                         const Place& place = {});
[[nodiscard]] std::vector<std::string> texts(const std::vector<Note>& notes);
void append(std::vector<Note>& to, std::vector<Note> notes);

}  // namespace raceway::record
