#pragma once

#include <string>
#include <vector>

#include "correction/catalogue.h"
#include "effects/effect.h"
#include "files/catalogue_file.h"
#include "session/messages.h"

/// Functions that search the catalogues of effects and bearings.
namespace raceway::session {

struct FoundEffects {
  std::vector<effects::Description> effects{};
  /// Matching effects that a correction can contain.
  std::vector<correction::EffectCard> of_records{};
  /// False if the search text is the id of an effect, or if `effects` contains the only match.
  /// `effects` then contains the forms of this effect for rig, shaft and spindle.
  bool is_list = true;
  /// Message if the search text names an uncertain value of the model (model::own_data()) instead
  /// of an effect; otherwise empty.
  std::string own_datum{};

  /// Throws text::InputError with the message `own_datum` if this message is not empty.
  [[nodiscard]] std::string json() const;
};

/// Finds an effect by its id or by words of its description. If `asked` is empty, finds all
/// effects. Throws text::InputError if no effect matches.
[[nodiscard]] FoundEffects find_effects(const std::string& asked);

/// Finds the bearings whose name contains `name`. If no name matches and `name` is a designation,
/// finds the bearings with the size of this designation, such as 7014, and sends a note. If `bore`
/// or `outer_diameter` [m] is NaN, every value is accepted. Throws text::InputError if no bearing
/// matches.
[[nodiscard]] std::vector<files::CatalogueBearing> find_bearings(Messages& messages,
                                                                 const std::string& name,
                                                                 double bore,
                                                                 double outer_diameter);

}  // namespace raceway::session
