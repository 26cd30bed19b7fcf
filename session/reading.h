#pragma once

#include <string>
#include <vector>

#include "files/model_file.h"
#include "session/period.h"
#include "session/source.h"

namespace raceway::session {

/// `--columns map.toml` and `--drop-nan` of a command that reads measurements.
struct Reading {
  std::string columns{};
  std::string columns_text{};  ///< the map itself, in place of its file
  bool drop_nan = false;
  std::vector<std::string> beside{};  ///< further files of the same record over time
  Period period{};                    ///< declared where records over time are read
  bool one_by_one =
      false;  ///< readings come one after the other: none is judged by those behind it

  /// Files of a question, with the files of --beside. Throws text::InputError where these are
  /// several records.
  [[nodiscard]] std::vector<Source> sources(std::vector<Source> data) const;
  /// Options for reading measurements: by the map of the flag, else by [columns] of the model.
  /// Throws text::InputError for a period: rows of a friction rig are no course in time.
  [[nodiscard]] files::ReadOptions options(const files::ModelFile& model) const;
  [[nodiscard]] files::ReadOptions options(const files::ColumnMap& of_model) const;
  /// As above, without a model.
  [[nodiscard]] files::ReadOptions options() const;
};

}  // namespace raceway::session
