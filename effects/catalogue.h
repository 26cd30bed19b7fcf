#pragma once

#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// The catalogue with its types erased, in the order of the list in all_effects.h: every id once,
/// in that form where it has one. What does not belong to the form is among them, so that it can be
/// named: see Requirements::belongs_to() and Description::moves().
[[nodiscard]] std::span<const Description> catalogue(Form form = Form::rig);

/// The effect of that id in catalogue(form), null if there is none.
[[nodiscard]] const Description* find(std::string_view id, Form form = Form::rig);

/// All forms of all effects, in the order of the list.
[[nodiscard]] std::span<const Description> all_forms();

}  // namespace raceway::effects
