#pragma once

#include <string>
#include <vector>

#include "files/named_files.h"
#include "session/messages.h"
#include "shaft/conformity.h"

namespace raceway::session {

/// Groove conformity of a catalogue bearing. Catalogues do not contain the conformity, but they
/// contain the axial rigidity for each preload class. The conformity is fitted to these printed
/// rigidities.
struct CatalogueConformity {
  std::string bearing{};  ///< full name of the bearing in the catalogue
  shaft::ConformityFit fit{};
  std::string text{};  ///< model file with the fitted conformity; empty if not found()
  std::vector<files::NamedFile> files{};  ///< files to which the model refers

  [[nodiscard]] bool found() const;
  /// Returns a message if no conformity in the searched range gives the printed rigidities; empty
  /// if found().
  [[nodiscard]] std::string problem() const;
  /// Returns a warning if the rigidities with the fitted conformity differ from the printed
  /// rigidities by more than 5 % (RMS over the preload classes).
  [[nodiscard]] std::vector<std::string> warnings() const;
  [[nodiscard]] std::string json() const;
};

/// Fits the groove conformity of a catalogue bearing to the axial rigidities in the catalogue.
/// `model` is a designation, or a model file with the key `catalogue` under [bearing]. Throws
/// text::InputError if the catalogue has no rigidities of the bearing.
[[nodiscard]] CatalogueConformity catalogue_conformity(Messages& messages,
                                                       const std::string& model);

}  // namespace raceway::session
