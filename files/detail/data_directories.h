#pragma once

namespace raceway::files {

/// Folders of the catalogues, set by the build; part of catalogue_file.h.
extern const char* const built_data_directory;      ///< folder in the sources
extern const char* const installed_data_directory;  ///< folder in the installation prefix

}  // namespace raceway::files
