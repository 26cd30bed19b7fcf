#include "io/data_directories.h"

namespace raceway::io {

const char* const built_data_directory = RACEWAY_DATA_DIR;
const char* const installed_data_directory = RACEWAY_INSTALLED_DATA_DIR;

}  // namespace raceway::io
