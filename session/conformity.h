#pragma once

#include <string>
#include <vector>

#include "files/named_files.h"
#include "session/messages.h"
#include "shaft/conformity.h"

namespace raceway::session {

/// Groove conformity of a catalogue bearing, fitted to the printed axial rigidities of its preload
/// classes. Manufacturers do not print the conformity.
struct CatalogueConformity {
  std::string bearing{};  ///< full name of the catalogue row
  shaft::ConformityFit fit{};
  std::string text{};  ///< model file with the fitted conformity; empty if not found()
  std::vector<files::NamedFile> files{};  ///< files that the model names

  [[nodiscard]] bool found() const;
  /// Returns the message that no conformity in the searched range gives the printed rigidities;
  /// empty if found().
  [[nodiscard]] std::string problem() const;
  /// Returns a warning if the rigidities with the fitted conformity differ from the printed
  /// rigidities by more than 5 % (RMS over the preload classes).
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::string json() const;
};

/// Fits the groove conformity of a catalogue bearing to its printed rigidities. `model` is a
/// designation, or a model file with the key `catalogue` under [bearing]. Throws text::InputError
/// for a bearing without printed rigidities.
[[nodiscard]] CatalogueConformity catalogue_conformity(Messages& messages,
                                                       const std::string& model);

}  // namespace raceway::session
