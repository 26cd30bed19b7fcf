#include "spindle/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <span>
#include <stdexcept>

#include "model/rings.h"

namespace raceway::spindle {
namespace {

using model::Spindle;

/// Places of faces closer than this are the same.
constexpr double same_place = 1e-7;
/// A shoulder closer than this to the outer face of the last bearing belongs to its seat: the nut
/// covers it. Positions in files are rounded.
constexpr double at_bearing = 10e-6;

struct CellSize {
  double axial, radial;  // [m]
};

/// Sizes at which a spindle of the usual slenderness has some 100, 500 and 1800 cells.
CellSize size_of(model::Cells cells, double shaft_length) {
  const double scale = std::clamp(shaft_length / 0.375, 0.05, 20.0);
  switch (cells) {
    case model::Cells::coarse:
      return {25 * mm * scale, 25 * mm * scale};
    case model::Cells::medium:
      return {7.5 * mm * scale, 9.5 * mm * scale};
    case model::Cells::fine:
      break;
  }
  return {3.5 * mm * scale, 4 * mm * scale};
}

/// Outer radius of the piece of a body at a plane, and its bore; NaN where there is none.
struct Section {
  double inner = unset, outer = unset;
};

Section section_at(const std::vector<model::Segment>& segments, double start, double position) {
  for (const model::Segment& s : segments) {
    if (position >= start && position <= start + s.length) return {0.5 * s.bore, 0.5 * s.diameter};
    start += s.length;
  }
  return {};
}

double length_of(const std::vector<model::Segment>& segments) {
  return std::accumulate(segments.begin(), segments.end(), 0.0,
                         [](double sum, const model::Segment& s) { return sum + s.length; });
}

void add_housing_piece(const Region& whole, std::span<const model::Coolant> channels,
                       std::vector<Region>& regions) {
  const auto coolant = std::find_if(channels.begin(), channels.end(), [&](const auto& c) {
    return std::min(whole.end, c.end) - std::max(whole.start, c.start) >= same_place;
  });
  if (coolant == channels.end()) {
    regions.push_back(whole);
    return;
  }
  const double low = std::max(whole.start, coolant->start);
  const double high = std::min(whole.end, coolant->end);
  const auto part = [&](double start, double end, double inner, double outer, double share) {
    if (end - start < same_place || outer - inner < same_place) return;
    Region r = whole;
    r.start = start, r.end = end, r.inner_radius = inner, r.outer_radius = outer;
    r.solid_share = share;
    regions.push_back(r);
  };
  const double middle = 0.5 * coolant->diameter, half = 0.5 * coolant->channel_depth;
  if (!(middle - half > whole.inner_radius + same_place) ||
      !(middle + half < whole.outer_radius - same_place))
    throw std::invalid_argument(
        fmt::format("coolant: the channel (diameters {:.6g} to {:.6g} mm) does not lie within the "
                    "wall of the housing (diameters {:.6g} to {:.6g} mm)",
                    2e3 * (middle - half), 2e3 * (middle + half), 2e3 * whole.inner_radius,
                    2e3 * whole.outer_radius));
  const auto outside = [&](double start, double end) {
    Region r = whole;
    r.start = start, r.end = end;
    if (end - start >= same_place) add_housing_piece(r, channels, regions);
  };
  outside(whole.start, low);
  outside(high, whole.end);
  part(low, high, whole.inner_radius, middle - half, 1.0);
  part(low, high, middle - half, middle + half, 1.0 - coolant->channel_width / coolant->pitch);
  part(low, high, middle + half, whole.outer_radius, 1.0);
}

/// Circuits share no part of the housing. Throws std::invalid_argument otherwise.
void require_separate(const Spindle& s) {
  if (!s.coolant && !s.circuits.empty())
    throw std::invalid_argument(
        "coolant: further circuits are only possible if [coolant] is given");
  const std::vector<model::Coolant> channels = s.channels();
  for (std::size_t k = 1; k < channels.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (std::min(channels[j].end, channels[k].end) -
              std::max(channels[j].start, channels[k].start) >=
          same_place)
        throw std::invalid_argument(
            fmt::format("coolant: circuit {} overlaps another circuit", s.circuits[k - 1].name));
}

/// Sleeves that keep the inner rings of one set apart.
void add_spacers(const Spindle& s, const std::vector<double>& set, double seat,
                 std::vector<Region>& regions) {
  for (std::size_t k = 0; k + 1 < set.size(); ++k) {
    const double from = set[k] + 0.5 * s.bearing_width, to = set[k + 1] - 0.5 * s.bearing_width;
    if (to - from < same_place) continue;
    // Nothing where the shaft itself stands up between the rings.
    const Section shaft = section_at(s.shaft.segments, 0.0, 0.5 * (from + to));
    if (!(shaft.outer <= seat + same_place)) continue;
    Region r;
    r.body = Body::spacer;
    r.start = from, r.end = to;
    r.inner_radius = seat, r.outer_radius = 0.5 * s.inner_ring_shoulder;
    r.material = model::steel_of_rings;
    regions.push_back(r);
  }
}

/// Sorts the joints of different bodies.
class Joiner {
 public:
  Joiner(const Spindle& s, Layout& layout) : s_(s), layout_(layout), channels_(s.channels()) {
    layout_.coolant_walls.resize(channels_.size());
  }

  void sort() {
    for (const Touch& t : layout_.mesh.touches) {
      const Cell& a = cell(t.first);
      const Cell& b = cell(t.second);
      const Joint joint{t.first, t.second, t.area, t.first_half + t.second_half};
      if (a.body != b.body || (a.body != Body::shaft && a.bearing != b.bearing))
        add_contact(t, a, b, joint);
      else if (a.solid_share != b.solid_share && !t.axial)
        add_wet_wall(t, a, b);
    }
    for (const OpenFace& face : layout_.mesh.open) add_open(face);
    add_gap();
  }

 private:
  [[nodiscard]] const Cell& cell(int k) const {
    return layout_.mesh.cells[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] BearingPlace& bearing(int k) {
    return layout_.bearings[static_cast<std::size_t>(k)];
  }

  void add_contact(const Touch& t, const Cell& a, const Cell& b, const Joint& joint) {
    const auto between = [&](Body x, Body y) {
      return (a.body == x && b.body == y) || (a.body == y && b.body == x);
    };
    if (between(Body::shaft, Body::housing))
      throw std::invalid_argument(fmt::format(
          "shaft: touches the housing at {:.6g} mm behind the nose face", 1e3 * a.start));
    if (ClampedFace* const face = t.axial ? clamped_face(a, b) : nullptr) {
      const bool swapped = face->bearing != a.bearing;
      face->joints.push_back(
          {swapped ? t.second : t.first, swapped ? t.first : t.second, joint.area, joint.half});
    } else if (between(Body::spacer, Body::inner_ring)) {
      layout_.clamped.push_back(joint);
    } else if (between(Body::shaft, Body::inner_ring) && !t.axial) {
      bearing(b.bearing).inner_seat.push_back(joint);
    } else if (between(Body::outer_ring, Body::housing) && !t.axial) {
      bearing(a.bearing).outer_seat.push_back(joint);
    } else if (between(Body::shaft, Body::outer_ring)) {
      layout_.collars.push_back(joint);
    } else {
      layout_.shoulders.push_back(joint);
    }
  }

  /// The face between two cells of which one is a ring; null without a clamping force. The face
  /// between two rings belongs to the front one.
  ClampedFace* clamped_face(const Cell& a, const Cell& b) {
    const bool a_in_front = a.start < b.start;
    const auto face_of = [&](Body ring, std::initializer_list<Body> others,
                             double force) -> ClampedFace* {
      const auto is_other = [&](const Cell& c) {
        return std::find(others.begin(), others.end(), c.body) != others.end();
      };
      if (std::isnan(force)) return nullptr;
      const Cell &first = a_in_front ? a : b, &second = a_in_front ? b : a;
      const bool rear = first.body == ring && (second.body == ring || is_other(second));
      if (!rear && !(second.body == ring && is_other(first))) return nullptr;
      const int of = rear ? first.bearing : second.bearing;
      const bool inner = ring == Body::inner_ring;
      for (ClampedFace& face : layout_.faces)
        if (face.bearing == of && face.inner == inner && face.rear == rear) return &face;
      layout_.faces.push_back(
          {.bearing = of, .inner = inner, .rear = rear, .force = force, .joints = {}});
      return &layout_.faces.back();
    };
    ClampedFace* const inner =
        face_of(Body::inner_ring, {Body::shaft, Body::spacer}, s_.seat.inner_clamping_force);
    return inner ? inner : face_of(Body::outer_ring, {Body::housing}, s_.seat.outer_clamping_force);
  }

  /// The coolant wets both faces of its channel over the width of the turns.
  void add_wet_wall(const Touch& t, const Cell& a, const Cell& b) {
    const bool outward = a.solid_share == 1.0;  // the channel lies outside
    const double share = 1.0 - std::min(a.solid_share, b.solid_share);
    const double middle = 0.5 * (a.start + a.end);
    const auto channel = std::find_if(channels_.begin(), channels_.end(), [&](const auto& c) {
      return middle > c.start && middle < c.end;
    });
    layout_.coolant_walls[static_cast<std::size_t>(channel - channels_.begin())].push_back(
        {outward ? t.first : t.second, -1, share * t.area, outward ? t.first_half : t.second_half});
  }

  void add_open(const OpenFace& face) {
    using FaceSide = OpenFace::Side;
    const Cell& c = cell(face.cell);
    const Joint joint{face.cell, -1, face.area, face.half, !face.radial()};
    const double place = face.side == FaceSide::front  ? c.start
                         : face.side == FaceSide::rear ? c.end
                                                       : 0.5 * (c.start + c.end);
    switch (c.body) {
      case Body::inner_ring:
        if (face.side == FaceSide::outer) bearing(c.bearing).inner_raceway.push_back(joint);
        break;
      case Body::outer_ring:
        if (face.side == FaceSide::inner) bearing(c.bearing).outer_raceway.push_back(joint);
        break;
      case Body::spacer:
        break;
      case Body::shaft:
        if (face.side == FaceSide::inner) break;  // its bore is closed
        if (place < layout_.housing_start - same_place) layout_.nose.push_back(joint);
        if (place > layout_.last_bearing_rear + at_bearing) layout_.rear.push_back(joint);
        break;
      case Body::housing:
        if (face.side == FaceSide::inner) break;
        if (!face.radial()) {
          layout_.housing_ends.push_back(joint);
        } else if (std::abs(place - s_.housing.flange) < 0.5 * s_.housing.flange_length) {
          layout_.flange.push_back(joint);
        } else {
          layout_.housing_cylinder.push_back(joint);
        }
    }
  }

  /// Faces of shaft and housing that see each other across the air between the sets.
  void add_gap() {
    const double from = s_.gap ? s_.gap->start : gap_start();
    const double to = s_.gap ? s_.gap->end : gap_end();
    for (const OpenFace& inner : layout_.mesh.open) {
      const Cell& a = cell(inner.cell);
      const double middle = 0.5 * (a.start + a.end);
      if (a.body != Body::shaft || inner.side != OpenFace::Side::outer || middle < from ||
          middle > to)
        continue;
      for (const OpenFace& outer : layout_.mesh.open) {
        const Cell& b = cell(outer.cell);
        if (b.body != Body::housing || outer.side != OpenFace::Side::inner || b.column != a.column)
          continue;
        const double radius = s_.gap ? 0.25 * (s_.gap->inner_diameter + s_.gap->outer_diameter)
                                     : 0.5 * (a.outer_radius + b.inner_radius);
        layout_.gap.push_back(
            {inner.cell, outer.cell, 2.0 * pi * radius * a.length(), inner.half + outer.half});
      }
    }
  }
  /// Between the sets, and as far as roller bearings in front of them and behind.
  [[nodiscard]] double gap_start() const {
    double start = s_.front_positions.back() + 0.5 * s_.bearing_width;
    for (std::size_t k = first_roller(); k < layout_.bearings.size(); ++k)
      start = std::min(start, layout_.bearings[k].position + 0.5 * layout_.bearings[k].width);
    return start;
  }
  [[nodiscard]] double gap_end() const {
    double end = s_.rear_positions.empty() ? layout_.housing_end
                                           : s_.rear_positions.front() - 0.5 * s_.bearing_width;
    for (std::size_t k = first_roller(); k < layout_.bearings.size(); ++k)
      end = std::max(end, layout_.bearings[k].position - 0.5 * layout_.bearings[k].width);
    return end;
  }
  [[nodiscard]] std::size_t first_roller() const {
    return layout_.bearings.size() - s_.rollers.size();
  }

  const Spindle& s_;
  Layout& layout_;
  std::vector<model::Coolant> channels_;
};

/// Cells of a body between two planes.
std::vector<int> cells_between(const Mesh& mesh, Body body, double from, double to) {
  std::vector<int> found;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const Cell& c = mesh.cells[k];
    const double middle = 0.5 * (c.start + c.end);
    if (c.body == body && middle > from && middle < to) found.push_back(static_cast<int>(k));
  }
  return found;
}

void place_bearings(const std::vector<model::Rings>& rings, const Spindle& s, Layout& layout) {
  for (const model::Rings& r : rings) {
    BearingPlace place;
    place.position = r.position, place.width = r.width;
    place.seat = 0.5 * r.bore, place.housing_seat = 0.5 * r.outer_diameter;
    place.inner_shoulder = 0.5 * r.inner_shoulder;
    place.outer_shoulder = 0.5 * r.outer_shoulder;
    place.seat_bore = section_at(s.shaft.segments, 0.0, r.position).inner;
    place.housing_outer = section_at(s.housing.segments, s.housing.start, r.position).outer;
    place.inner_interference = r.inner_interference, place.outer_clearance = r.outer_clearance;
    layout.bearings.push_back(std::move(place));
  }
}

void find_means(Layout& layout) {
  const Mesh& mesh = layout.mesh;
  for (std::size_t b = 0; b < layout.bearings.size(); ++b) {
    BearingPlace& place = layout.bearings[b];
    std::vector<int> inner, outer;
    for (std::size_t k = 0; k < mesh.size(); ++k) {
      if (mesh.cells[k].bearing != static_cast<int>(b)) continue;
      if (mesh.cells[k].body == Body::inner_ring) inner.push_back(static_cast<int>(k));
      if (mesh.cells[k].body == Body::outer_ring) outer.push_back(static_cast<int>(k));
    }
    const double from = place.position - 0.5 * place.width;
    const double to = place.position + 0.5 * place.width;
    place.inner_ring = mean_over(mesh, inner);
    place.outer_ring = mean_over(mesh, outer);
    place.shaft_below = mean_over(mesh, cells_between(mesh, Body::shaft, from, to));
    place.housing_above = mean_over(mesh, cells_between(mesh, Body::housing, from, to));
    if (place.inner_seat.empty() || place.outer_seat.empty())
      throw std::invalid_argument(fmt::format(
          "bearing {} at {:.6g} mm: its {} does not touch the {}, because the diameters at this "
          "position are different",
          b + 1, 1e3 * place.position, place.inner_seat.empty() ? "inner ring" : "outer ring",
          place.inner_seat.empty() ? "shaft" : "housing"));
  }
}

double mean_of(const std::vector<double>& values) {
  return values.empty() ? unset
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

}  // namespace

Shares mean_over(const Mesh& mesh, const std::vector<int>& cells) {
  Shares shares;
  double sum = 0.0;
  for (const int k : cells) {
    const Cell& c = mesh.cells[static_cast<std::size_t>(k)];
    shares.push_back({k, c.section() * c.length()});
    sum += shares.back().share;
  }
  for (Share& share : shares) share.share /= sum;
  return shares;
}

Shares Layout::source(Body body, double from, double to, double radius) const {
  std::vector<int> cells = cells_between(mesh, body, from, to);
  if (!std::isnan(radius))
    std::erase_if(cells, [&](int k) {
      const Cell& c = mesh.cells[static_cast<std::size_t>(k)];
      return radius < c.inner_radius || radius >= c.outer_radius;
    });
  if (cells.empty())
    cells.push_back(mesh.nearest(body, 0.5 * (from + to), std::isnan(radius) ? 0.0 : radius));
  return mean_over(mesh, cells);
}

std::vector<Region> regions_of(const model::Model& model) {
  const Spindle& s = *model.spindle;
  std::vector<Region> regions;
  double start = 0.0;
  for (const model::Segment& piece : s.shaft.segments) {
    Region r;
    r.body = Body::shaft;
    r.start = start, r.end = start += piece.length;
    r.inner_radius = 0.5 * piece.bore, r.outer_radius = 0.5 * piece.diameter;
    r.material = piece.material;
    regions.push_back(r);
  }
  const auto bearings = model.shaft->arrangement.bearings();
  const double bored = 0.5 * bearings.front().bearing->geometry().outer_diameter;
  start = s.housing.start;
  const std::vector<model::Coolant> channels = s.channels();
  for (const model::Segment& piece : s.housing.segments) {
    Region r;
    r.body = Body::housing;
    r.start = start, r.end = start += piece.length;
    r.inner_radius = std::isnan(piece.bore) ? bored : 0.5 * piece.bore;
    r.outer_radius = 0.5 * piece.diameter;
    r.material = piece.material;
    add_housing_piece(r, channels, regions);
  }
  int k = 0;
  for (const model::Rings& rings : model::rings_of(s, model.shaft->arrangement)) {
    Region r;
    r.bearing = k++;
    r.start = rings.front(), r.end = rings.rear();
    r.material = model::steel_of_rings;
    r.body = Body::inner_ring;
    r.inner_radius = 0.5 * rings.bore, r.outer_radius = 0.5 * rings.inner_shoulder;
    regions.push_back(r);
    r.body = Body::outer_ring;
    r.inner_radius = 0.5 * rings.outer_shoulder, r.outer_radius = 0.5 * rings.outer_diameter;
    regions.push_back(r);
  }
  add_spacers(s, s.front_positions, 0.5 * bearings.front().bearing->geometry().bore, regions);
  add_spacers(s, s.rear_positions, 0.5 * bearings.back().bearing->geometry().bore, regions);
  return regions;
}

Layout make_layout(const model::Model& model, model::Cells cells) {
  if (!model.spindle || !model.shaft || model.spindle->network)
    throw std::invalid_argument("the model is not a spindle with [shaft] and [housing]");
  const Spindle& s = *model.spindle;
  require_separate(s);
  Layout layout;
  layout.housing_start = s.housing.start;
  layout.housing_end = s.housing.start + length_of(s.housing.segments);
  layout.front_centre = mean_of(s.front_positions);
  layout.rear_centre = mean_of(s.rear_positions);
  const std::vector<model::Rings> rings = model::rings_of(s, model.shaft->arrangement);
  place_bearings(rings, s, layout);
  layout.first_bearing_front = rings.front().front();
  layout.last_bearing_rear = rings.front().rear();
  for (const model::Rings& r : rings) {
    layout.first_bearing_front = std::min(layout.first_bearing_front, r.front());
    layout.last_bearing_rear = std::max(layout.last_bearing_rear, r.rear());
  }
  std::vector<double> lines{layout.front_centre, s.housing.flange,
                            s.housing.flange - 0.5 * s.housing.flange_length,
                            s.housing.flange + 0.5 * s.housing.flange_length};
  if (!s.rear_positions.empty()) lines.push_back(layout.rear_centre);
  const CellSize size = size_of(cells, length_of(s.shaft.segments));
  const std::vector<Region> regions = regions_of(model);
  layout.mesh = make_mesh(regions, size.axial, size.radial, lines);
  Joiner(s, layout).sort();
  find_means(layout);
  return layout;
}

}  // namespace raceway::spindle
