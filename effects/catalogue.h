#pragma once

#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Returns the descriptions of all effects in the order of all_effects.h. Each id occurs once, in
/// the requested form if the effect has this form. Effects of other forms are included, so that
/// messages can name them: see Requirements::belongs_to() and Description::moves().
[[nodiscard]] std::span<const Description> catalogue(Form form = Form::rig);

/// Returns the effect with this id in catalogue(form); null if there is none.
[[nodiscard]] const Description* find(std::string_view id, Form form = Form::rig);

/// Returns all forms of all effects, in the order of all_effects.h.
[[nodiscard]] std::span<const Description> all_forms();

}  // namespace raceway::effects
