#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raceway::text {

/// Behaviour if a file exists already. `refuse` names --force as the flag that replaces it;
/// `refuse_naming_replace` names --replace, for a command whose --force is a load.
enum class IfExists { refuse, refuse_naming_replace, replace };

/// Throws InputError where write_text() would: a name of a binary format such as a workbook or a
/// raster picture (st.xlsx, st.png), an existing file that must not be replaced, a directory, a
/// missing or read-only folder. Call it before a long calculation.
void require_writable(const std::string& path, IfExists if_exists);

/// Kind of output. Throws InputError for a name of another of our formats: a table in st.json, a
/// picture in st.html. Names without a known ending are free.
enum class Written { table, picture, page };
void require_name_of(const std::string& path, Written what);

/// Writes a whole file or nothing: into a temporary file in the same folder first, which then takes
/// its name. Keeps the permissions of a file it replaces. A file that appeared in the meantime is
/// kept unless it may be replaced. Throws InputError as above, and if the disk is full.
void write_text(const std::string& path, std::string_view text, IfExists if_exists);

/// An output file; its text must live until the file is written.
struct OutputFile {
  std::string path;
  std::string_view text;
};
/// Writes files that belong together. All files are complete before the first takes its name. If
/// two runs write the same files, all come from the later run. Throws as write_text(); the old
/// files then remain, unless the disk fails between two renames.
void write_files(const std::vector<OutputFile>& files, IfExists if_exists);

/// Stops writing in a process that is about to end: removes half-written files and refuses further
/// ones. Returns the files that write_text() has completed. May be called from any thread; the
/// process must end then.
[[nodiscard]] std::vector<std::string> stop_writing();

}  // namespace raceway::text
