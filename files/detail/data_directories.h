#pragma once

namespace raceway::files {

/// Folders of the catalogues, set by the build. Part of catalogue_file.h.
extern const char* const built_data_directory;      ///< in the sources
extern const char* const installed_data_directory;  ///< below the prefix of the installation

}  // namespace raceway::files
