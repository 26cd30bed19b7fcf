#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raceway::record {

/// Place in a file or in a command, to which a message refers. A member is empty or 0 if it is
/// unknown.
struct Place {
  std::string file = {};
  int line = 0;          ///< line number, starting at 1
  std::string key = {};  ///< name of a key, a column or a flag

  [[nodiscard]] std::string text() const { return file + ":" + std::to_string(line); }
};

enum class NoteKind {
  note,     ///< information about the treatment of the input
  doubt,    ///< an input may be wrong
  warning,  ///< a result may be wrong or incomplete
};

[[nodiscard]] std::string_view name(NoteKind kind);

struct Note;

/// Code that identifies the subject of a note. Programs should compare the name of the code,
/// because the text of a note may change.
struct NoteCode {
  std::string_view name;
  NoteKind kind;
  std::string_view meaning;

  /// Returns a note with this code. `text` is the complete text of the note.
  [[nodiscard]] Note operator()(std::string text, Place place = {}) const;
};

/// A message that accompanies a result. The text is for people and may change between versions.
struct Note {
  const NoteCode* code = nullptr;
  std::string text;
  Place place = {};

  [[nodiscard]] NoteKind kind() const { return code->kind; }
};

/// Codes of all notes. `raceway::record::note::left_out("3 rows ...")` creates a note with the code
/// left_out.
namespace note {

inline constexpr NoteCode read_as{"read-as", NoteKind::note,
                                  "how a file, a column or a unit was read"};
inline constexpr NoteCode unused{"unused", NoteKind::note, "a column or key that is not used"};
inline constexpr NoteCode filled_in{"filled-in", NoteKind::note,
                                    "a value that replaces a missing value of the file"};
inline constexpr NoteCode left_out{"left-out", NoteKind::note,
                                   "rows or readings that are not used"};
inline constexpr NoteCode averaged{"averaged", NoteKind::note,
                                   "rows that were averaged to one row"};
inline constexpr NoteCode defaults{"defaults", NoteKind::note, "number of defaults of the model"};
inline constexpr NoteCode assumed{"assumed", NoteKind::note,
                                  "what the program assumed, chose or refitted"};
inline constexpr NoteCode odd_value{
    "odd-value", NoteKind::note,
    "an unusual or inconsistent value of the model or the command; it is used unchanged"};
inline constexpr NoteCode band{"band", NoteKind::note,
                               "what the 95 % band of the results contains"};
inline constexpr NoteCode load_limit{
    "load-limit", NoteKind::note,
    "a load, pressure or contact angle beyond the limits of the bearing"};
inline constexpr NoteCode law_limit{"law-limit", NoteKind::note,
                                    "a state outside the range of the law"};
inline constexpr NoteCode exported{"export", NoteKind::note,
                                   "how an exported correction differs from its model"};
inline constexpr NoteCode unknown{"unknown", NoteKind::note,
                                  "quantities that the data or files do not determine"};

inline constexpr NoteCode unit{"unit", NoteKind::doubt,
                               "values that are probably in another unit, sign or column"};
inline constexpr NoteCode sensor{"sensor", NoteKind::doubt,
                                 "readings that point to a faulty sensor"};
inline constexpr NoteCode plan{"plan", NoteKind::doubt,
                               "measurements whose order or levels can hide an effect"};

inline constexpr NoteCode ignored{"ignored", NoteKind::warning,
                                  "data of the model or the command that have no effect"};
inline constexpr NoteCode other_rig{"other-rig", NoteKind::warning,
                                    "models that are compared although their rigs differ"};
inline constexpr NoteCode beyond_range{"beyond-range", NoteKind::warning,
                                       "inputs outside the training data of the model"};
inline constexpr NoteCode no_prediction{"no-prediction", NoteKind::warning,
                                        "points or rows without a result"};
inline constexpr NoteCode unloaded{"unloaded", NoteKind::warning,
                                   "a bearing without contact or below its minimum load"};
inline constexpr NoteCode over_limit{
    "over-limit", NoteKind::warning,
    "a speed, load, fit or temperature beyond the limit of a part"};
inline constexpr NoteCode cut_contact{"cut-contact", NoteKind::warning,
                                      "a contact ellipse that reaches over a shoulder"};
inline constexpr NoteCode at_bound{"at-bound", NoteKind::warning, "a parameter at its bound"};
inline constexpr NoteCode not_identifiable{"not-identifiable", NoteKind::warning,
                                           "parameters that the data do not determine"};
inline constexpr NoteCode misfit{"misfit", NoteKind::warning,
                                 "errors beyond the noise, and their effect on the result"};
inline constexpr NoteCode noise{"noise", NoteKind::warning,
                                "how the scatter of the readings was estimated or weighted"};
inline constexpr NoteCode not_converged{"not-converged", NoteKind::warning,
                                        "a fit or a state that did not converge"};
inline constexpr NoteCode check_data{"check-data", NoteKind::warning,
                                     "data that are probably wrong according to the verdict"};
inline constexpr NoteCode rows_used{"rows-used", NoteKind::warning,
                                    "rows or channels that a fit does not use"};
inline constexpr NoteCode polynomial{"polynomial", NoteKind::warning,
                                     "physically impossible properties of printed polynomials"};
inline constexpr NoteCode due{"due", NoteKind::warning,
                              "a reading that was rejected, or a new identification that is due"};
inline constexpr NoteCode limits{"limits", NoteKind::warning,
                                 "what a result does not include, or the limits of its validity"};

}  // namespace note

/// Returns all codes, in the order of their declarations.
[[nodiscard]] std::span<const NoteCode* const> note_codes();

/// Returns one note for each of `texts`. Each note has the code `code` and the place `place`.
[[nodiscard]] std::vector<Note> notes_of(const NoteCode& code, std::vector<std::string> texts,
                                         const Place& place = {});
[[nodiscard]] std::vector<std::string> texts(const std::vector<Note>& notes);
void append(std::vector<Note>& to, std::vector<Note> notes);

}  // namespace raceway::record
