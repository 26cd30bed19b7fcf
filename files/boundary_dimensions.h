#pragma once

#include <optional>
#include <string_view>

namespace raceway::files {

/// Boundary dimensions of a radial rolling bearing.
struct BoundaryDimensions {
  double bore, outer_diameter, width;  ///< [m]
};

/// Returns the boundary dimensions of a bearing size; empty for an unknown size. The dimension
/// series is "18", "19", "10", "02" or "03" (first digit: width series; second digit: diameter
/// series). The bore code is, for example, "14" for a bore of 70 mm. The largest bore is 200 mm
/// (series 03: 120 mm).
///
/// Source:   ISO 15; the standard itself was not available. The sizes of series 10 and 19 up to a
///           bore of 130 mm are from NTN-SNR (ULTAGE, 7000 and 7900) and [GMN4000]. The sizes of
///           series 02 up to a bore of 100 mm are from GB/T 276. All other sizes were not compared
///           with a publication.
[[nodiscard]] std::optional<BoundaryDimensions> boundary_dimensions(
    std::string_view dimension_series, std::string_view bore_code);

/// Returns the bore code for a bore diameter [mm], such as "14" for 70, or "00" to "03" for 10, 12,
/// 15 and 17. The result is empty if the bore has no code.
[[nodiscard]] std::string_view bore_code_of(int bore_mm);

}  // namespace raceway::files
