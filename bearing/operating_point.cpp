#include "bearing/operating_point.h"

#include <cmath>

#include "bearing/validation.h"

namespace raceway::bearing {

void validate(const OperatingPoint& p) {
  require_between("speed", p.speed, 0.0, 1e6 * rpm, rpm, "rpm");
  require_between("axial_load", p.axial_load, -1e8, 1e8, 1.0, "N");
  require_between("radial_load", p.radial_load, -1e8, 1e8, 1.0, "N");
  require_between("radial_load_z", p.radial_load_z, -1e8, 1e8, 1.0, "N");
  require_between("moment_y", p.moment_y, -1e8, 1e8, N_mm, "Nmm");
  require_between("moment_z", p.moment_z, -1e8, 1e8, N_mm, "Nmm");
}

}  // namespace raceway::bearing
