#pragma once

#include <string>
#include <string_view>

namespace raceway::io {

/// What to do where the file to be written exists already.
enum class IfExists { refuse, replace };

/// Throws InputError where write_text() would: an existing file under `refuse`, a directory, a
/// folder that is missing or not writable. To be asked before a long calculation.
void require_writable(const std::string& path, IfExists if_exists);

/// Writes a whole file or nothing: into a file beside it first, which then takes its name. Keeps
/// the permissions of a file it replaces. Throws InputError as above, and where the disk is full.
void write_text(const std::string& path, std::string_view text, IfExists if_exists);

}  // namespace raceway::io
