#pragma once

namespace raceway::files {

// Defaults for values that catalogues of manufacturers do not give: the conformity of both grooves,
// and the parameters of Palmgren's friction law (viscous factor f0; load factor z (P0/C0)^y).
inline constexpr double catalogue_conformity = 0.52;
inline constexpr double catalogue_f0 = 1.5, catalogue_z = 0.001, catalogue_y = 0.33;

}  // namespace raceway::files
