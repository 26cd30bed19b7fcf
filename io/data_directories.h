#pragma once

namespace raceway::io {

/// Folders of the catalogues, set by the build. Part of catalogue_file.h, not for other code.
extern const char* const built_data_directory;      ///< in the sources
extern const char* const installed_data_directory;  ///< below the prefix of the installation

}  // namespace raceway::io
