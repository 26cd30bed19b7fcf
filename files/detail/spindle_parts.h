#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Parts of the reader of spindles; see files/detail/spindle_section.h.
namespace raceway::files {

inline constexpr double longest_mm = 1e5;  ///< limit for a spindle and its parts
inline constexpr Form anywhere = between(-longest_mm, longest_mm, "mm"),
                      on_the_shaft = between(0, longest_mm, "mm"),
                      a_length = between(0.001, longest_mm, "mm");

/// Returns the tables of a list such as [[shaft.segment]] or segment = [{...}]; empty if the key is
/// missing.
[[nodiscard]] std::vector<Section> tables_in(const Section& s, std::string_view key,
                                             const Keys& keys = {});
/// Returns the tables [[sensor]].
[[nodiscard]] std::vector<Section> sensor_sections(const ModelTables& tables,
                                                   const Keys& keys = {});
/// Returns the tables [[heat]].
[[nodiscard]] std::vector<Section> heat_sections(const ModelTables& tables, const Keys& keys = {});

/// Returns true for a name that a column can have before its unit: letters, digits and _.
[[nodiscard]] bool names_a_column(std::string_view name);

/// Returns the key tables of [shaft], [housing], [seat] and [gap]; of [network]; and of [ambient],
/// [coolant], [motor] ... [sensor].
[[nodiscard]] std::vector<KeyTable> body_tables();
[[nodiscard]] std::vector<KeyTable> network_tables();
[[nodiscard]] std::vector<KeyTable> surroundings_tables();

/// Returns the thermal expansion of [shaft] or [housing] [1/K]. The reader of [arrangement] uses
/// this value too.
[[nodiscard]] double expansion_of(const ModelTables& tables, std::string_view table,
                                  double fallback);

[[nodiscard]] model::ShaftBody read_shaft_body(ModelTables& tables);
[[nodiscard]] model::Housing read_housing(ModelTables& tables);
[[nodiscard]] model::Seat read_seat(ModelTables& tables);
[[nodiscard]] std::optional<model::Gap> read_gap(const ModelTables& tables);

[[nodiscard]] model::Ambient read_ambient(ModelTables& tables);
[[nodiscard]] std::optional<model::Coolant> read_coolant(ModelTables& tables,
                                                         const model::Ambient& ambient);
/// Returns the tables [[coolant.circuit]].
[[nodiscard]] std::vector<Section> circuit_sections(const ModelTables& tables);
[[nodiscard]] std::vector<model::Circuit> read_circuits(ModelTables& tables,
                                                        const model::Coolant& first);
/// Reads [motor] or [drive].
[[nodiscard]] std::optional<model::HeatSource> read_heat_source(ModelTables& tables,
                                                                std::string_view table);
/// Reads [[heat]]. `bearings`: names of all bearings on the shaft, in the order of
/// model::rings_of().
[[nodiscard]] std::vector<model::HeatSource> read_heat_sources(ModelTables& tables,
                                                               const Names& bearings);
/// Reads the belt force of [drive]; returns nothing if [drive] gives no force.
[[nodiscard]] std::optional<model::Belt> read_belt(const ModelTables& tables);
[[nodiscard]] std::vector<model::ThermometerPlace> read_sensors(const ModelTables& tables);
[[nodiscard]] model::Network read_network(const ModelTables& tables, const model::Ambient& ambient);

/// Returns every node of a network as a place for a thermometer, including the surroundings. Throws
/// InputError if the file has [[sensor]].
[[nodiscard]] std::vector<model::ThermometerPlace> sensors_of_network(
    const ModelTables& tables, const model::Network& network);

/// Checks relations between tables: bearings on the shaft and in the housing, sensors inside their
/// parts, and so on. Adds a note on each unusual but possible value to `notes`.
void check_spindle(const ModelTables& tables, const model::Spindle& spindle,
                   const model::Shaft& shaft, Names& notes);

}  // namespace raceway::files
