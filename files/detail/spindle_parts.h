#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads single tables of the model file of a spindle, for read_spindle() in spindle_section.h.
namespace raceway::files {

inline constexpr double longest_mm = 1e5;  ///< largest length in a spindle model
inline constexpr Form anywhere = between(-longest_mm, longest_mm, "mm"),
                      on_the_shaft = between(0, longest_mm, "mm"),
                      a_length = between(0.001, longest_mm, "mm");

/// Returns the tables of a list that is written as [[shaft.segment]] or segment = [{...}]; empty if
/// the key is missing.
[[nodiscard]] std::vector<Section> tables_in(const Section& s, std::string_view key,
                                             const Keys& keys = {});
/// Returns the tables [[sensor]].
[[nodiscard]] std::vector<Section> sensor_sections(const ModelTables& tables,
                                                   const Keys& keys = {});
/// Returns the tables [[heat]].
[[nodiscard]] std::vector<Section> heat_sections(const ModelTables& tables, const Keys& keys = {});

/// Returns true if a name has only letters, digits and _, so that it may be the start of a column
/// name, before the quantity and the unit.
[[nodiscard]] bool names_a_column(std::string_view name);

/// Key tables of the parts of a spindle: body_tables() returns [shaft], [housing], [seat] and
/// [gap]; network_tables() returns [network]; surroundings_tables() returns [ambient], [coolant],
/// [motor], [drive], [heat] and [sensor].
[[nodiscard]] std::vector<KeyTable> body_tables();
[[nodiscard]] std::vector<KeyTable> network_tables();
[[nodiscard]] std::vector<KeyTable> surroundings_tables();

/// Returns the coefficient of thermal expansion in [shaft] or [housing] [1/K]; `fallback` if it is
/// missing.
[[nodiscard]] double expansion_of(const ModelTables& tables, std::string_view table,
                                  double fallback);

[[nodiscard]] model::ShaftBody read_shaft_body(ModelTables& tables);
[[nodiscard]] model::Housing read_housing(ModelTables& tables);
[[nodiscard]] model::Seat read_seat(ModelTables& tables);
[[nodiscard]] std::optional<model::Gap> read_gap(const ModelTables& tables);

[[nodiscard]] model::Ambient read_ambient(ModelTables& tables);
[[nodiscard]] std::optional<model::Coolant> read_coolant(ModelTables& tables,
                                                         const model::Ambient& ambient);
/// Returns the tables [[coolant.circuit]]. For a circuit without a fluid or an inlet temperature,
/// read_circuits() uses the value of `first`, the coolant in [coolant].
[[nodiscard]] std::vector<Section> circuit_sections(const ModelTables& tables);
[[nodiscard]] std::vector<model::Circuit> read_circuits(ModelTables& tables,
                                                        const model::Coolant& first);
/// Returns the heat source in [motor] or [drive]; nothing if the table is missing.
[[nodiscard]] std::optional<model::HeatSource> read_heat_source(ModelTables& tables,
                                                                std::string_view table);
/// Returns the heat sources in [[heat]]. `bearings`: names of all bearings on the shaft, in the
/// order of model::rings_of().
[[nodiscard]] std::vector<model::HeatSource> read_heat_sources(ModelTables& tables,
                                                               const Names& bearings);
/// Returns the belt force in [drive]; nothing if [drive] has no force.
[[nodiscard]] std::optional<model::Belt> read_belt(const ModelTables& tables);
[[nodiscard]] std::vector<model::ThermometerPlace> read_sensors(const ModelTables& tables);
[[nodiscard]] model::Network read_network(const ModelTables& tables, const model::Ambient& ambient);

/// Returns one place for a thermometer for each node of a network, including the surroundings.
/// Throws InputError if the file has [[sensor]].
[[nodiscard]] std::vector<model::ThermometerPlace> sensors_of_network(
    const ModelTables& tables, const model::Network& network);

/// Checks values that depend on several tables, such as the positions of bearings on the shaft and
/// of sensors in their bodies. Throws InputError for impossible values. Adds a note to `notes` for
/// each possible but unusual value.
void check_spindle(const ModelTables& tables, const model::Spindle& spindle,
                   const model::Shaft& shaft, Names& notes);

}  // namespace raceway::files
