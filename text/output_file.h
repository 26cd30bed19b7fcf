#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raceway::text {

/// Behaviour for a file that exists already: `refuse` names --force as the flag that replaces it,
/// `refuse_naming_replace` --replace, for a command whose --force is a load.
enum class IfExists { refuse, refuse_naming_replace, replace };

/// Throws InputError where write_text() would: a name that promises a workbook, a picture of points
/// or another format that is no text (st.xlsx, st.png), an existing file that is not to be
/// replaced, a directory, a folder that is missing or not writable. To be asked before a long
/// calculation.
void require_writable(const std::string& path, IfExists if_exists);

/// Throws InputError for a name that promises another of our formats: a table in st.json, a picture
/// in st.html. Names without a known ending are free.
enum class Written { table, picture, page };
void require_name_of(const std::string& path, Written what);

/// Writes a whole file or nothing: into a temporary file in the same folder first, which then takes
/// its name. Keeps the permissions of a file it replaces. A file that came meanwhile is kept unless
/// it is to be replaced. Throws InputError as above, and where the disk is full.
void write_text(const std::string& path, std::string_view text, IfExists if_exists);

/// A file to be written; its text must live until it is.
struct OutputFile {
  std::string path;
  std::string_view text;
};
/// Writes files that belong together. All of them are whole before the first takes its name. Where
/// two runs write the same files, all come from the later run. Throws as write_text(); the old
/// files are then still there, unless the disk fails between two names.
void write_files(const std::vector<OutputFile>& files, IfExists if_exists);

/// Stops writing in a process that is about to end: removes half-written files and refuses further
/// ones. Returns the files that write_text() has written whole. May be called from any thread; the
/// process must end then.
[[nodiscard]] std::vector<std::string> stop_writing();

}  // namespace raceway::text
