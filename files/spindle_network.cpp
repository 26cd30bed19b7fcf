#include <algorithm>
#include <cmath>

#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/spindle_parts.h"

namespace raceway::files {
namespace {

constexpr Key network_keys[]{
    {"node", a_list, is_required,
     "bodies of a thermal network, instead of a geometry, [[network.node]]"},
    {"link", a_list, unset, "heat paths between the bodies, [[network.link]]"},
};
constexpr Key network_node_keys[]{
    {"name", a_text, is_required, "name of the body in results and links"},
    {"capacity_J_K", between(1e-6, 1e12, "J/K"), unset,
     "heat capacity; give either capacity_J_K or temperature_C"},
    {"temperature_C", between(-273, 2000, "C"), unset, "constant temperature of the body"},
    {"heat_W", between(-1e9, 1e9, "W"), 0.0, "heat flow into the body"},
};
constexpr Key network_link_keys[]{
    {"from", a_text, is_required, "name of a node, ambient or machine"},
    {"to", a_text, is_required, "name of a node, ambient or machine"},
    {"conductance_W_K", between(1e-12, 1e9, "W/K"), is_required,
     "thermal conductance between the two nodes"},
};

using model::Network;

/// Bodies that a link may name and no table has to: the surroundings, whose temperature is known.
constexpr std::array surroundings{std::string_view("ambient"), std::string_view("machine")};

std::size_t node_of(Network& network, const Section& s, const char* key,
                    const model::Ambient& ambient) {
  const auto name = s.text(key);
  if (!name) s.fail(key, fmt::format("[network.link] {} is missing: give the name of a node", key));
  Names known;
  for (std::size_t k = 0; k < network.nodes.size(); ++k) {
    if (network.nodes[k].name == *name) return k;
    known.push_back(network.nodes[k].name);
  }
  if (std::find(surroundings.begin(), surroundings.end(), *name) == surroundings.end()) {
    known.insert(known.end(), surroundings.begin(), surroundings.end());
    const std::string near = text::suggestion(*name, known);
    s.fail(key, fmt::format("{} = \"{}\": no such node{}", key, *name,
                            near.empty() ? "; the network has " + text::listed(known) : near));
  }
  const bool own = *name == "machine" && !std::isnan(ambient.machine_temperature);
  network.nodes.push_back(
      {.name = *name, .temperature = own ? ambient.machine_temperature : ambient.temperature});
  return network.nodes.size() - 1;
}

void read_nodes(const Section& s, Network& network) {
  for (const Section& one : tables_in(s, "node", {network_node_keys})) {
    const auto name = one.text("name");
    if (!name || name->empty()) one.fail("name", "[network.node] name is missing");
    if (!names_a_column(*name))
      one.fail("name", fmt::format("name = \"{}\": must be letters, digits and _, because it "
                                   "becomes part of the column NAME_temperature_C",
                                   *name));
    for (const Network::Node& other : network.nodes)
      if (other.name == *name)
        one.fail(
            "name",
            fmt::format("name = \"{}\": another node has this name; choose another name", *name));
    Network::Node node{.name = *name};
    if (const auto value = one.number("temperature_C")) node.temperature = kelvin(*value);
    one.take("capacity_J_K", node.capacity);
    if (std::isnan(node.capacity) == std::isnan(node.temperature))
      one.fail("capacity_J_K", fmt::format("node {}: give either capacity_J_K or temperature_C "
                                           "(for a body at constant temperature)",
                                           *name));
    node.heat = one.value("heat_W");
    network.nodes.push_back(std::move(node));
  }
  if (network.nodes.empty())
    s.fail("node", "[network] has no node: give at least one [[network.node]]");
}

/// From where heat can leave: a body that no link leads to from one that is held warms for ever.
void require_ways_out(const Section& s, const Network& network, std::size_t written) {
  std::vector<bool> reached(network.nodes.size());
  for (std::size_t k = 0; k < reached.size(); ++k)
    reached[k] = !std::isnan(network.nodes[k].temperature);
  for (bool any = true; any;) {
    any = false;
    for (const Network::Link& link : network.links)
      if (reached[link.from] != reached[link.to])
        reached[link.from] = reached[link.to] = any = true;
  }
  const std::vector<Section> nodes = tables_in(s, "node");
  for (std::size_t k = 0; k < written; ++k) {
    const bool linked =
        std::any_of(network.links.begin(), network.links.end(),
                    [&](const Network::Link& l) { return l.from == k || l.to == k; });
    if (reached[k] && linked) continue;
    nodes[k].fail(
        "name",
        linked
            ? fmt::format(
                  "node {}: no chain of links leads from this node to a body at constant "
                  "temperature (temperature_C, ambient, machine), so the heat cannot leave it",
                  network.nodes[k].name)
            : fmt::format("node {}: no [[network.link]] names this node", network.nodes[k].name));
  }
}

}  // namespace

std::vector<KeyTable> network_tables() {
  return {{"network", network_keys},
          {"network.node", network_node_keys},
          {"network.link", network_link_keys}};
}

std::vector<model::ThermometerPlace> sensors_of_network(const ModelTables& tables,
                                                        const Network& network) {
  for (const Section& s : sensor_sections(tables))
    throw text::InputError(fmt::format("{}: [[sensor]]: a [network] already gives the temperature "
                                       "of each node; remove the sensor",
                                       s.place()),
                           s.at());
  std::vector<model::ThermometerPlace> sensors;
  for (const Network::Node& node : network.nodes) sensors.push_back({.name = node.name});
  return sensors;
}

model::Network read_network(const ModelTables& tables, const model::Ambient& ambient) {
  const Section s = tables.section("network", {network_keys});
  Network network;
  read_nodes(s, network);
  const std::size_t written = network.nodes.size();
  for (const Section& one : tables_in(s, "link", {network_link_keys})) {
    Network::Link link{.from = node_of(network, one, "from", ambient),
                       .to = node_of(network, one, "to", ambient),
                       .conductance = one.required("conductance_W_K")};
    if (link.from == link.to)
      one.fail("to", fmt::format("to = \"{}\": a link must connect two different nodes",
                                 network.nodes[link.to].name));
    network.links.push_back(link);
  }
  require_ways_out(s, network, written);
  return network;
}

}  // namespace raceway::files
