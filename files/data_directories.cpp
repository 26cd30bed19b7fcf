#include "files/detail/data_directories.h"

namespace raceway::files {

const char* const built_data_directory = RACEWAY_DATA_DIR;
const char* const installed_data_directory = RACEWAY_INSTALLED_DATA_DIR;

}  // namespace raceway::files
