#pragma once

namespace raceway::files {

/// Data folders with the catalogues, set at build time: see data_file() in catalogue_file.h.
extern const char* const built_data_directory;      ///< data folder in the source tree
extern const char* const installed_data_directory;  ///< data folder in the installation

}  // namespace raceway::files
