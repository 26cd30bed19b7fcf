// Compiled with nothing but the header in reach: it is what a controller copies.
#include "shaft/kinematic_law.h"

double displacement_at(double speed);
double displacement_at(double speed) {
  return raceway::shaft::evaluate({1.28e-3, 0.697, 5.3e-4, 0.0, 1000.0}, speed).displacement;
}
