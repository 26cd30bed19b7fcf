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
  std::vector<correction::EffectCard> of_records{};  ///< correction effects that match the request
  /// False: the request is the id of one effect; its forms for rig, shaft and spindle are listed.
  bool is_list = true;
  std::string own_datum{};  ///< message if the requested id is a value of the model, not an effect

  /// Throws text::InputError with `own_datum` if the id is a value of the model, not an effect.
  [[nodiscard]] std::string json() const;
};

/// Finds an effect by its id or by words of its description. If `asked` is empty, finds all
/// effects. Throws text::InputError if no effect matches.
[[nodiscard]] FoundEffects find_effects(const std::string& asked);

/// Finds the bearings whose name contains `name`. If no name matches, finds the bearings of the
/// size that the designation `name` gives, and sends a note. If `bore` or `outer_diameter` [m] is
/// NaN, every value is accepted. Throws text::InputError if no bearing matches.
[[nodiscard]] std::vector<files::CatalogueBearing> find_bearings(Messages& messages,
                                                                 const std::string& name,
                                                                 double bore,
                                                                 double outer_diameter);

}  // namespace raceway::session
