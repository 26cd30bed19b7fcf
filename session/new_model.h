#pragma once

#include <string>

#include "files/bearing_estimate.h"
#include "session/messages.h"

namespace raceway::session {

/// A bearing that somebody wants a model of.
struct NewModel {
  std::string bearing{};  ///< its designation
  files::BearingOutline
      outline{};  ///< of one that is in no catalogue; the material of the elements of any
  double contact_angle = unset;  ///< of the same [deg]
  /// "palmgren", "skf" or "contact"; empty: contact for balls, palmgren for cylindrical rollers.
  std::string law{};
};

/// A commented model file with the defaults of its law. Throws text::InputError for a bearing that
/// is not known and not described.
[[nodiscard]] std::string new_model_text(Messages& messages, const NewModel& wanted);

}  // namespace raceway::session
