#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raceway::text {

/// Behaviour if the output file exists. `replace` overwrites the file. With `refuse`, the error
/// message names the flag --force, which allows overwriting. With `refuse_naming_replace`, the
/// message names the flag --replace, for commands in which --force gives a load.
enum class IfExists { refuse, refuse_naming_replace, replace };

/// Throws InputError if write_text() would fail: for a name of a binary format such as a workbook
/// or a raster picture (st.xlsx, st.png), an existing file that must not be replaced, a directory,
/// and a missing or read-only folder. Call this function before a long calculation.
void require_writable(const std::string& path, IfExists if_exists);

/// Kind of output. require_name_of() throws InputError for a file name with the ending of another
/// kind: a table in st.json, a picture in st.html. Names without a known ending are allowed.
enum class Written { table, picture, page };
void require_name_of(const std::string& path, Written what);

/// Writes a complete file or nothing. The function first writes a temporary file in the same folder
/// and then renames it. A new file keeps the permissions of the file that it replaces. A file that
/// another program has written in the meantime is replaced only if `if_exists` allows it. Throws
/// InputError under the conditions of require_writable(), and if the disk is full.
void write_text(const std::string& path, std::string_view text, IfExists if_exists);

/// An output file; its text must live until the file is written.
struct OutputFile {
  std::string path;
  std::string_view text;
};
/// Writes files that belong together. All temporary files are complete before the first one is
/// renamed. If two runs write the same files, all files come from the later run. Throws the same
/// exceptions as write_text(). After an error, the old files remain, unless the disk fails between
/// two renames.
void write_files(const std::vector<OutputFile>& files, IfExists if_exists);

/// Stops all writing before the process ends: removes unfinished files and prevents further files.
/// Returns the files that write_text() has completed. Any thread may call this function. The
/// process must end afterwards.
[[nodiscard]] std::vector<std::string> stop_writing();

}  // namespace raceway::text
