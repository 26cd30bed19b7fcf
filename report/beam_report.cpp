#include "report/beam_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "record/digits.h"
#include "record/units.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/report_columns.h"
#include "results/shaft_results.h"

namespace raceway::report {
namespace {

constexpr int shape_digits = 5;
constexpr std::size_t drawn_shapes = 8;  // speeds of which the shapes are on the page

double drawn_number(double value) { return record::with_digits(value, shape_digits); }

/// The pieces of the shaft with its bearings and disks, as they are drawn below a line along it.
text::json shaft_json(const model::Model& model, const bearing::Arrangement& arrangement,
                      const std::vector<double>& places) {
  text::json pieces = text::json::array(), bearings = text::json::array(),
             disks = text::json::array();
  double start = 0.0;
  for (const model::Segment& s : model.spindle->shaft.segments) {
    pieces.push_back({{"start_mm", drawn_number(start / mm)},
                      {"end_mm", drawn_number((start + s.length) / mm)},
                      {"diameter_mm", drawn_number(s.diameter / mm)},
                      {"bore_mm", drawn_number(s.bore / mm)}});
    start += s.length;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bearing::BearingGeometry& g = arrangement.bearings()[i].bearing->geometry();
    bearings.push_back({{"label", results::bearing_place(arrangement, i)},
                        {"position_mm", drawn_number(places[i] / mm)},
                        {"pitch_diameter_mm", drawn_number(g.pitch_diameter / mm)},
                        {"ball_diameter_mm", drawn_number(g.ball_diameter / mm)}});
  }
  for (const model::Disk& d : model.spindle->shaft.disks)
    disks.push_back(
        {{"position_mm", drawn_number(d.position / mm)}, {"mass_kg", drawn_number(d.mass)}});
  return {{"pieces", std::move(pieces)},
          {"bearings", std::move(bearings)},
          {"disks", std::move(disks)}};
}

/// Every other number of (v, θ) of all nodes.
text::json deflections(const Eigen::VectorXd& shape, double unit) {
  text::json list = text::json::array();
  for (Eigen::Index k = 0; k < shape.size(); k += 2) list.push_back(drawn_number(shape[k] / unit));
  return list;
}

text::json nodes_json(const spindle::Beam& beam) {
  text::json list = text::json::array();
  for (const double node : beam.nodes()) list.push_back(drawn_number(node / mm));
  return list;
}

/// Shapes of up to so many speeds that have modes, evenly chosen, lowest and highest among them.
text::json shapes_json(const std::vector<results::ModesAtSpeed>& speeds) {
  std::vector<const results::ModesAtSpeed*> found;
  for (const results::ModesAtSpeed& m : speeds)
    if (m.converged()) found.push_back(&m);
  text::json list = text::json::array();
  const std::size_t count = std::min(drawn_shapes, found.size());
  for (std::size_t k = 0; k < count; ++k) {
    const results::ModesAtSpeed& m = *found[count == 1 ? 0 : k * (found.size() - 1) / (count - 1)];
    text::json modes = text::json::array();
    for (const spindle::Mode& mode : m.modes.modes)
      modes.push_back({{"frequency_Hz", mode.frequency / (2.0 * pi)},
                       {"whirl", spindle::name(mode.whirl)},
                       {"y", deflections(mode.y, 1.0)},
                       {"z", deflections(mode.z, 1.0)}});
    list.push_back({{"speed_rpm", m.speed / rpm}, {"modes", std::move(modes)}});
  }
  return list;
}

void add_head(Document& document, const ModelOfPage& of, bool warm,
              const model::Findings& findings) {
  document.add("judged", model::warnings_of(findings));
  document.add("assumed", model_facts({of}));
  document.add("model", of.file);
  document.add("bearing", of.model.name);
  document.add("warm", warm);
}

}  // namespace

std::string modes_report(const ModelOfPage& of, const bearing::Arrangement& arrangement,
                         const spindle::Beam& beam, const std::vector<double>& places, bool warm,
                         const std::vector<results::ModesAtSpeed>& speeds,
                         const model::Findings& findings) {
  Document document("modes");
  add_head(document, of, warm, findings);
  document.add("weight_kg", drawn_number(beam.weight()));
  document.add_text("results", results::campbell_json(arrangement, speeds, of.file, findings));
  text::json bearings = text::json::array();
  for (std::size_t i = 0; i < arrangement.bearings().size(); ++i)
    bearings.push_back(results::bearing_place(arrangement, i));
  document.add("bearings", std::move(bearings));
  document.add("shaft", shaft_json(of.model, arrangement, places));
  document.add("nodes_mm", nodes_json(beam));
  document.add("shapes", shapes_json(speeds));
  return report_page(document.text());
}

std::string deflection_report(const ModelOfPage& of, const bearing::Arrangement& arrangement,
                              const spindle::Beam& beam, const std::vector<double>& places,
                              bool warm, const results::DeflectionResult& result,
                              const Eigen::VectorXd& tangent, const Eigen::VectorXd& stiff,
                              const model::Findings& findings) {
  Document document("deflection");
  add_head(document, of, warm, findings);
  document.add("load", results::load_words(result));
  document.add_text("results", results::deflection_json(arrangement, result, of.file, findings));
  document.add("shaft", shaft_json(of.model, arrangement, places));
  document.add("nodes_mm", nodes_json(beam));
  text::json line = text::json::object();
  if (result.converged()) {
    line["total_um"] = deflections(result.shaft.y, um);
    line["tangent_um"] = deflections(tangent, um);
    line["stiff_um"] = deflections(stiff, um);
    text::json before = text::json::array();
    for (const bearing::BearingEquilibrium& b : result.sets.bearings)
      before.push_back(b.stiffness(1, 1) / N_per_um);
    line["radial_stiffness_before_N_um"] = std::move(before);
  }
  document.add("line", std::move(line));
  return report_page(document.text());
}

}  // namespace raceway::report
