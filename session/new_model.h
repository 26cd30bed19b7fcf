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
  /// Dimensions, number of balls and material of balls or rollers. For a bearing in the catalogue
  /// and for a roller bearing, only the material may be given.
  files::BearingOutline outline{};
  double contact_angle = unset;  ///< contact angle of a bearing that is not in the catalogue [deg]
  /// Friction law: "palmgren", "skf" or "contact". An empty text means contact for a ball bearing
  /// on a rig, and palmgren otherwise.
  std::string law{};
  /// True: three of these bearings in a spindle; false: one bearing on a rig.
  bool spindle = false;
  /// ISO VG grade such as "VG 32" (files/oil_grade.h); empty: a thin spindle oil.
  std::string oil{};
};

/// Returns a model file with comments and with the default values of the friction law. Throws
/// text::InputError if the bearing is not in the catalogue and neither NewModel::bearing nor
/// NewModel::outline gives the dimensions. Also throws text::InputError if the bearing does not
/// allow an option, for example a spindle with roller bearings, or dimensions for a bearing in the
/// catalogue.
[[nodiscard]] std::string new_model_text(Messages& messages, const NewModel& wanted);

/// Returns the text of a correction model, with comments, for the displacements of a time record.
/// The model has a channel for each temperature: see files/new_correction.h. Implausible readings
/// in the record give warnings. Throws text::InputError for a record that cannot be read or that
/// has no displacement.
[[nodiscard]] std::string new_correction_text(Messages& messages, const Source& data,
                                              const Reading& reading);

}  // namespace raceway::session
