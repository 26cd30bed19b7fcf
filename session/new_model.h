#pragma once

#include <string>

#include "files/bearing_estimate.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// A bearing to write a model of.
struct NewModel {
  std::string bearing{};  ///< its designation
  files::BearingOutline
      outline{};  ///< of one that is in no catalogue; the material of the elements of any
  double contact_angle = unset;  ///< of the same [deg]
  /// "palmgren", "skf" or "contact"; empty: contact for balls on a rig, else palmgren.
  std::string law{};
  bool spindle = false;  ///< three of it in a spindle, in place of one on a rig
  std::string oil{};     ///< ISO VG grade (files/oil_grade.h); empty: a thin spindle oil
};

/// A commented model file with the defaults of its law. Throws text::InputError for a bearing that
/// is not known and not described.
[[nodiscard]] std::string new_model_text(Messages& messages, const NewModel& wanted);

/// A commented model of a correction for the displacements of a record over time, with a channel
/// for each of its temperatures (files/new_correction.h). What looks wrong in the record is warned
/// of. Throws text::InputError as its reader, and for a record without a displacement.
[[nodiscard]] std::string new_correction_text(Messages& messages, const Source& data,
                                              const Reading& reading);

}  // namespace raceway::session
