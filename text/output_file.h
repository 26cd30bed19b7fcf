#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raceway::text {

/// Behaviour if the output file exists. `replace` overwrites the file. `refuse` throws InputError
/// with a message that names the flag --force, which allows overwriting. `refuse_naming_replace` is
/// for commands in which --force gives a load in N. The message then names the flag --replace,
/// which allows overwriting in these commands.
enum class IfExists { refuse, refuse_naming_replace, replace };

/// Throws InputError if write_text() would fail. Call this function before a long calculation. The
/// function checks these conditions:
///   - The file extension is not of a binary format, such as a workbook or picture (.xlsx, .png).
///   - The path is not a directory.
///   - The file does not exist, or may be replaced.
///   - The folder exists and is writable.
void require_writable(const std::string& path, IfExists if_exists);

/// Kind of output. require_name_of() throws InputError for a file name with the extension of
/// another kind, such as st.json for a table or st.html for a picture. Names without a known
/// extension are allowed.
enum class Written { table, picture, page };
void require_name_of(const std::string& path, Written what);

/// Writes a complete file or nothing. The function first writes a temporary file in the same folder
/// and then renames it. A new file keeps the permissions of the file that it replaces. A file that
/// another program has written in the meantime is replaced only if `if_exists` is `replace`. Throws
/// InputError if a condition of require_writable() is not satisfied, or if the disk is full.
void write_text(const std::string& path, std::string_view text, IfExists if_exists);

/// Path and text of an output file. The string to which `text` refers must exist until the file is
/// written.
struct OutputFile {
  std::string path;
  std::string_view text;
};
/// Writes files that belong together. The function first writes all temporary files, and then
/// renames them. If two programs write the same files at the same time, all files come from the
/// program that writes last. Throws InputError in the same cases as write_text(). After an error,
/// the old files remain, unless the disk fails between two renames.
void write_files(const std::vector<OutputFile>& files, IfExists if_exists);

/// Stops all writing before the process ends: removes unfinished files and prevents the writing of
/// further files. Returns the names of the files that write_text() and write_files() have
/// completed. Any thread may call this function. The process must end afterwards.
[[nodiscard]] std::vector<std::string> stop_writing();

}  // namespace raceway::text
