#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bearing/bearing.h"
#include "files/bearing_estimate.h"
#include "files/catalogue_file.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the tables of bearings and materials in a model file.
namespace raceway::files {

/// A bearing that a table of the model file describes, with its catalogue row.
struct NamedBearing {
  bearing::Bearing bearing;
  std::string name;
  std::optional<CatalogueBearing> row = {};
  std::string catalogue{};  ///< designation in the file; empty if the file gives all numbers
};

[[nodiscard]] std::vector<KeyTable> bearing_tables();
/// Returns the keys that every table of a bearing may have.
[[nodiscard]] std::span<const Key> bearing_keys();

/// Returns the keys of [bearing] for a geometry, with values in the units of the keys. Unknown
/// values are omitted.
[[nodiscard]] std::vector<std::pair<std::string, double>> keys_of(
    const bearing::BearingGeometry& geometry);

/// Returns the required keys that [bearing] lacks; empty if it names a catalogue bearing.
[[nodiscard]] Names missing_keys_of_bearing(const ModelTables& tables);

class BearingReader {
 public:
  /// Reads the tables [material.NAME]. Throws InputError like read_model().
  explicit BearingReader(ModelTables& tables);

  /// Reads a table of a bearing. Omitted keys have the values of `base`, if it is not null. The
  /// table may also contain the keys `further`.
  [[nodiscard]] NamedBearing read(const Section& table, const NamedBearing* base, Keys further);

  /// Returns the keys of the tables read so far, each once, without `name` and `catalogue`. Keys
  /// whose value equals the default or the value of the catalogue bearing are omitted too, because
  /// every file written by new_model_text() contains such keys.
  [[nodiscard]] const Names& written() const { return written_; }

  /// Returns the material that a key of a bearing names. Without this key, returns `inherited`, or
  /// steel if `inherited` is null.
  [[nodiscard]] bearing::Material material(const Section& s, const char* key,
                                           const bearing::Material* inherited = nullptr);

 private:
  struct Draft;
  void read_material(const toml::key& key, const toml::node& node);
  [[nodiscard]] const bearing::Material* find_material(std::string_view name) const;
  void take_catalogue_row(const Section& s, const NamedBearing* base, Draft& draft);
  void take_estimate(const Section& s, const std::string& designation, const NamedRow& named,
                     Draft& draft);
  void read_geometry(const Section& s, Draft& draft);
  void note_written(const Section& s, const Draft& draft);
  void read_envelope(const Section& s, bearing::BearingGeometry& g);

  ModelTables& tables_;
  std::vector<bearing::Material> materials_;
  Names written_;
};

}  // namespace raceway::files
