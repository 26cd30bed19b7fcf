#pragma once

#include <string>

#include "files/bearing_estimate.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// Description of the bearing for a new model file.
struct NewModel {
  std::string bearing{};  ///< designation in the catalogue
  files::BearingOutline
      /// outline of a bearing outside the catalogue; its material of balls or rollers is also used
      /// for a catalogue bearing
      outline{};
  double contact_angle = unset;  ///< contact angle of a bearing outside the catalogue [deg]
  /// Friction law: "palmgren", "skf" or "contact". An empty text means contact for balls on a rig
  /// and palmgren otherwise.
  std::string law{};
  bool spindle = false;  ///< true: three of these bearings in a spindle; false: one on a rig
  /// ISO VG grade such as "VG 32" (files/oil_grade.h); empty: a thin spindle oil.
  std::string oil{};
};

/// Returns a commented model file with the default values of its law. Throws text::InputError if
/// the bearing is not in the catalogue and `outline` does not describe it, and if a member does not
/// suit the bearing, such as a spindle with roller bearings.
[[nodiscard]] std::string new_model_text(Messages& messages, const NewModel& wanted);

/// Returns a commented correction model for the displacements of a time record, with a channel for
/// each temperature (files/new_correction.h). Implausible readings in the record give warnings.
/// Throws text::InputError for a record that cannot be read or that has no displacement.
[[nodiscard]] std::string new_correction_text(Messages& messages, const Source& data,
                                              const Reading& reading);

}  // namespace raceway::session
