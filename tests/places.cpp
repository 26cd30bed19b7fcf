// Paths of this build. They stand in this file alone, so that every other object of the tests is
// the same in all clones and comes from the compiler cache.
#include "tests/places.h"

namespace raceway::tests {

std::string source_dir() { return RACEWAY_SOURCE_DIR; }
std::string program() { return RACEWAY_PROGRAM; }

}  // namespace raceway::tests
