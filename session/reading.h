#pragma once

#include <string>
#include <vector>

#include "files/model_file.h"
#include "session/period.h"
#include "session/source.h"

namespace raceway::session {

/// Options of a command that reads measurements, such as `--columns map.toml` and `--drop-nan`.
struct Reading {
  std::string columns{};       ///< file with a column map; empty: the column map of the model
  std::string columns_text{};  ///< column map as text; replaces the file `columns`
  bool drop_nan = false;       ///< true: rows with an empty cell are left out
  std::vector<std::string> beside{};  ///< files with further columns of the time record
  Period period{};                    ///< period of readings; only for time records
  bool without_readings = false;      ///< true: the time record may have no measured displacement
  bool one_by_one = false;  ///< true: readings arrive one by one; later readings are unknown

  /// Returns the data files to read. With --beside, `data` must contain a single file; the files of
  /// --beside are read as further columns of this file. Throws text::InputError if --beside is
  /// given together with several data files.
  [[nodiscard]] std::vector<Source> sources(std::vector<Source> data) const;
  /// Returns the options for reading measurements. The column map comes from the flag `--columns`
  /// or, without the flag, from [columns] of the model. The overload for a ModelFile throws
  /// text::InputError if a period is given, because only corrections accept a period.
  [[nodiscard]] files::ReadOptions options(const files::ModelFile& model) const;
  [[nodiscard]] files::ReadOptions options(const files::ColumnMap& of_model) const;
  /// Returns the options for reading without a model.
  [[nodiscard]] files::ReadOptions options() const;
};

}  // namespace raceway::session
