#pragma once

#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Returns the descriptions of all effects in the order of all_effects.h. Each id occurs once. If
/// an effect has several forms (for a rig, a shaft or a spindle), the list contains the description
/// for `form`. The list also contains effects that do not exist in this form, because messages may
/// name these effects. For such effects, Requirements::belongs_to(form) is false.
[[nodiscard]] std::span<const Description> catalogue(Form form = Form::rig);

/// Returns the effect with this id in catalogue(form); null if there is none.
[[nodiscard]] const Description* find(std::string_view id, Form form = Form::rig);

/// Returns all forms of all effects, in the order of all_effects.h.
[[nodiscard]] std::span<const Description> all_forms();

}  // namespace raceway::effects
