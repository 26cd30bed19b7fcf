#include "tests/spindle_study/mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spindle_study {
namespace {

struct Solid {
  double conductivity, heat_per_volume;
};

Solid solid(Part part) {
  switch (part) {
    case Part::shaft:
      return {42.0, 7850.0 * 460.0};
    case Part::housing:
      return {48.0, 7250.0 * 500.0};
    default:
      return {46.0, 7800.0 * 460.0};
  }
}

constexpr double shaft_expansion = 11.5e-6, housing_expansion = 10.5e-6;  // [1/K]
constexpr double same = 1e-7;                                             // [m]

std::vector<double> lines(std::vector<double> breaks, double size) {
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(
      std::unique(breaks.begin(), breaks.end(), [](double a, double b) { return b - a < same; }),
      breaks.end());
  std::vector<double> all{breaks.front()};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double from = breaks[i - 1], length = breaks[i] - from;
    const int n = std::max(1, static_cast<int>(std::ceil(length / size - 1e-6)));
    for (int k = 1; k <= n; ++k) all.push_back(from + length * k / n);
  }
  return all;
}

/// Builds the mesh on a grid of planes and cylinders, cells only where there is metal.
class Builder {
 public:
  Builder(const Spindle& s, double size) : s_(s) {
    std::vector<double> x{0.0}, r{0.5 * s.shaft_bore};
    for (const ShaftPiece& p : s.shaft) {
      x.push_back(x.back() + p.length);
      r.push_back(0.5 * p.diameter);
    }
    for (double centre : centres()) {
      x.push_back(centre - 0.5 * s.bearing_width);
      x.push_back(centre + 0.5 * s.bearing_width);
    }
    for (double v : {s.housing_start, s.housing_start + s.housing_length,
                     s.flange - 0.5 * s.flange_length, s.flange, s.flange + 0.5 * s.flange_length})
      x.push_back(v);
    for (double d :
         {s.bearing_bore, s.inner_shoulder, s.outer_shoulder, s.bearing_outer, s.housing_diameter})
      r.push_back(0.5 * d);
    if (s.cooled) {
      x.insert(x.end(), {s.helix.start, s.helix.end});
      r.insert(r.end(), {0.5 * (s.helix.diameter - s.helix.depth),
                         0.5 * (s.helix.diameter + s.helix.depth)});
    }
    x_ = lines(x, size);
    r_ = lines(r, size);
  }

  Mesh build() {
    place_cells();
    for (std::size_t i = 0; i < columns(); ++i)
      for (std::size_t j = 0; j < rows(); ++j)
        if (const int c = at(i, j); c >= 0) {
          outward(i, j, static_cast<std::size_t>(c));
          rearward(i, j, static_cast<std::size_t>(c));
          ends(i, j, static_cast<std::size_t>(c));
        }
    means();
    expansion();
    for (const Thermometer& t : s_.thermometers) mesh_.thermometers.push_back(place(t));
    return std::move(mesh_);
  }

 private:
  std::size_t columns() const { return x_.size() - 1; }
  std::size_t rows() const { return r_.size() - 1; }
  std::vector<double> centres() const {
    std::vector<double> all = s_.front;
    all.insert(all.end(), s_.rear.begin(), s_.rear.end());
    return all;
  }
  int& at(std::size_t i, std::size_t j) { return grid_[i * rows() + j]; }
  const Cell& cell(int c) const { return mesh_.cells[static_cast<std::size_t>(c)]; }
  double shaft_radius(double x) const {
    double end = 0.0;
    for (const ShaftPiece& p : s_.shaft)
      if (x < (end += p.length)) return 0.5 * p.diameter;
    return 0.0;
  }
  int bearing_at(double x) const {
    const std::vector<double> all = centres();
    for (std::size_t k = 0; k < all.size(); ++k)
      if (std::fabs(x - all[k]) < 0.5 * s_.bearing_width) return static_cast<int>(k);
    return -1;
  }
  bool in_housing(double x) const {
    return x > s_.housing_start && x < s_.housing_start + s_.housing_length;
  }
  /// In the layer of the channel, where only the land between its turns conducts.
  bool in_land(const Cell& c) const {
    return s_.cooled && c.part == Part::housing && c.x() > s_.helix.start && c.x() < s_.helix.end &&
           std::fabs(2.0 * c.r() - s_.helix.diameter) < s_.helix.depth;
  }
  double land() const { return 1.0 - s_.helix.width / s_.helix.pitch; }

  void place_cells() {
    grid_.assign(columns() * rows(), -1);
    for (std::size_t i = 0; i < columns(); ++i)
      for (std::size_t j = 0; j < rows(); ++j) {
        Cell c{.part = Part::shaft, .x0 = x_[i], .x1 = x_[i + 1], .r0 = r_[j], .r1 = r_[j + 1]};
        const int bearing = bearing_at(c.x());
        if (c.r() < shaft_radius(c.x()) && c.r() > 0.5 * s_.shaft_bore) {
          c.part = Part::shaft;
        } else if (bearing >= 0 && c.r() < 0.5 * s_.inner_shoulder) {
          c.part = Part::inner_ring;
          c.bearing = bearing;
        } else if (bearing >= 0 && c.r() > 0.5 * s_.outer_shoulder &&
                   c.r() < 0.5 * s_.bearing_outer) {
          c.part = Part::outer_ring;
          c.bearing = bearing;
        } else if (in_housing(c.x()) && c.r() > 0.5 * s_.bearing_outer &&
                   c.r() < 0.5 * s_.housing_diameter) {
          c.part = Part::housing;
        } else {
          continue;
        }
        const Solid m = solid(c.part);
        const double length = c.x1 - c.x0, full = 2.0 * pi * m.conductivity * length;
        const double share = in_land(c) ? land() : 1.0;
        c.capacity = m.heat_per_volume * c.disc() * length * share;
        c.half_inner = share * full / std::log(c.r() / c.r0);
        c.half_outer = share * full / std::log(c.r1 / c.r());
        c.half_axial = (in_land(c) ? 0.0 : 1.0) * m.conductivity * c.disc() / (0.5 * length);
        at(i, j) = static_cast<int>(mesh_.cells.size());
        mesh_.cells.push_back(c);
      }
  }

  /// What lies beyond the outer cylinder of a cell.
  void outward(std::size_t i, std::size_t j, std::size_t a) {
    const Cell& c = mesh_.cells[a];
    const double area = c.cylinder(c.r1);
    std::size_t k = j + 1;
    while (k < rows() && at(i, k) < 0) ++k;
    if (k == rows()) {
      to_the_room(a, area);
      return;
    }
    const std::size_t b = static_cast<std::size_t>(at(i, k));
    const Cell& d = mesh_.cells[b];
    Link link{.a = a, .b = b, .half_a = c.half_outer, .half_b = d.half_inner, .area = area};
    if (c.part == d.part) {
      channel_walls(a, b, area);
    } else if (c.part == Part::shaft && d.part == Part::inner_ring) {
      link.kind = LinkKind::inner_seat;
      link.bearing = d.bearing;
    } else if (c.part == Part::outer_ring) {
      link.kind = LinkKind::outer_seat;
      link.bearing = c.bearing;
    } else if (c.part == Part::inner_ring) {
      mesh_.raceways.push_back(
          {a, b, c.half_outer, d.half_inner, (c.x1 - c.x0) / s_.bearing_width, c.bearing});
      return;
    } else if (c.x() > s_.front.front() && c.x() < s_.rear.back()) {
      link.kind = LinkKind::gap;
      link.inner_radius = c.r1;
      link.outer_radius = d.r0;
    } else {
      if (c.x() > s_.rear.back()) to_the_room(a, area);
      return;
    }
    mesh_.links.push_back(link);
  }

  void channel_walls(std::size_t a, std::size_t b, double area) {
    const Cell &c = mesh_.cells[a], &d = mesh_.cells[b];
    if (in_land(c) == in_land(d)) return;
    const bool inner = in_land(d);  // the wall is c, the channel lies outside of it
    const double half = inner ? c.half_outer : d.half_inner;
    mesh_.faces.push_back({inner ? a : b, FaceKind::channel, half, area * (1.0 - land())});
  }

  void to_the_room(std::size_t a, double area) {
    const Cell& c = mesh_.cells[a];
    if (c.part == Part::housing) {
      const bool bolted = std::fabs(c.x() - s_.flange) < 0.5 * s_.flange_length;
      mesh_.faces.push_back({a, bolted ? FaceKind::flange : FaceKind::housing_cylinder,
                             c.half_outer, area, 2.0 * c.r1});
    } else if (c.part == Part::shaft) {
      const bool front = c.x() < s_.front.front();
      mesh_.faces.push_back(
          {a, front ? FaceKind::nose : FaceKind::rear, c.half_outer, area, 2.0 * c.r1});
    }
  }

  void rearward(std::size_t i, std::size_t j, std::size_t a) {
    if (i + 1 == columns() || at(i + 1, j) < 0) return;
    const std::size_t b = static_cast<std::size_t>(at(i + 1, j));
    const Cell &c = mesh_.cells[a], &d = mesh_.cells[b];
    Link link{.a = a, .b = b, .half_a = c.half_axial, .half_b = d.half_axial, .area = c.disc()};
    if (c.part != d.part || c.bearing != d.bearing) {  // ring against shoulder or ring
      const bool over_the_gap = c.part == Part::shaft
                                    ? d.part == Part::outer_ring
                                    : c.part == Part::outer_ring && d.part == Part::shaft;
      const double film =
          (over_the_gap ? s_.collar_conductance : s_.shoulder_conductance) * link.area;
      link.half_b = 1.0 / (1.0 / film + 1.0 / link.half_b);
    }
    mesh_.links.push_back(link);
  }

  /// Faces across the axis that the air touches.
  void ends(std::size_t i, std::size_t j, std::size_t a) {
    const Cell& c = mesh_.cells[a];
    for (const bool front : {true, false}) {
      const bool open =
          front ? (i == 0 || at(i - 1, j) < 0) : (i + 1 == columns() || at(i + 1, j) < 0);
      if (!open || (c.part != Part::housing && c.part != Part::shaft)) continue;
      const double plane = front ? c.x0 : c.x1;
      if (c.part == Part::housing) {
        mesh_.faces.push_back(
            {a, FaceKind::housing_end, c.half_axial, c.disc(), s_.housing_diameter});
      } else if (plane <= same || plane >= x_.back() - same || plane >= s_.shaft_length() - same) {
        mesh_.faces.push_back({a, plane <= same ? FaceKind::nose : FaceKind::rear, c.half_axial,
                               c.disc(), 2.0 * shaft_radius(c.x())});
      }
    }
  }

  template <typename Belongs>
  Weights mean(const Belongs& belongs) const {
    Weights w;
    double sum = 0.0;
    for (std::size_t k = 0; k < mesh_.cells.size(); ++k) {
      const Cell& c = mesh_.cells[k];
      if (!belongs(c)) continue;
      w.emplace_back(k, c.disc() * (c.x1 - c.x0));
      sum += w.back().second;
    }
    for (auto& [k, weight] : w) weight /= sum;
    return w;
  }

  void means() {
    const std::vector<double> all = centres();
    for (std::size_t b = 0; b < all.size(); ++b) {
      const int id = static_cast<int>(b);
      const auto beside = [&, centre = all[b]](const Cell& c) {
        return std::fabs(c.x() - centre) < 0.5 * s_.bearing_width;
      };
      mesh_.inner_rings.push_back(
          mean([&](const Cell& c) { return c.part == Part::inner_ring && c.bearing == id; }));
      mesh_.outer_rings.push_back(
          mean([&](const Cell& c) { return c.part == Part::outer_ring && c.bearing == id; }));
      mesh_.shaft_seats.push_back(
          mean([&](const Cell& c) { return c.part == Part::shaft && beside(c); }));
      mesh_.housing_seats.push_back(
          mean([&](const Cell& c) { return c.part == Part::housing && beside(c); }));
    }
  }

  /// Adds `factor` ∫ α (mean of the section) dx from one place to another.
  void add_length(Weights& w, Part part, double from, double to, double factor) const {
    const double sign = to < from ? -factor : factor;
    const double low = std::min(from, to), high = std::max(from, to);
    const double expansion = part == Part::shaft ? shaft_expansion : housing_expansion;
    for (std::size_t i = 0; i < columns(); ++i) {
      const double length = std::min(x_[i + 1], high) - std::max(x_[i], low);
      if (length <= 0.0) continue;
      Weights column;
      double sum = 0.0;
      for (std::size_t j = 0; j < rows(); ++j) {
        const int c = grid_[i * rows() + j];
        if (c < 0 || cell(c).part != part) continue;
        column.emplace_back(static_cast<std::size_t>(c), cell(c).disc());
        sum += cell(c).disc();
      }
      for (const auto& [c, area] : column)
        w.emplace_back(c, sign * expansion * length * area / sum);
    }
  }

  void expansion() {
    const auto middle = [](const std::vector<double>& v) {
      double sum = 0.0;
      for (double x : v) sum += x;
      return sum / static_cast<double>(v.size());
    };
    const double front = middle(s_.front), rear = middle(s_.rear);
    add_length(mesh_.elongation, Part::shaft, front, rear, 1.0);
    add_length(mesh_.elongation, Part::housing, front, rear, -1.0);
    add_length(mesh_.nose, Part::shaft, 0.0, front, 1.0);
    add_length(mesh_.nose, Part::housing, front, s_.flange, 1.0);
  }

  /// Linear between the nearest cells of the part, nearest where there is none beyond.
  Weights place(const Thermometer& t) const {
    const auto fits = [&](const Cell& c) {
      switch (t.part) {
        case Thermometer::Part::shaft:
          return c.part == Part::shaft;
        case Thermometer::Part::housing:
          return c.part == Part::housing;
        default:
          return c.part == Part::inner_ring || c.part == Part::outer_ring;
      }
    };
    const Cell* home = nullptr;
    for (const Cell& c : mesh_.cells)
      if (fits(c) && t.position >= c.x0 - same && t.position <= c.x1 + same &&
          t.radius >= c.r0 - same && t.radius <= c.r1 + same)
        home = &c;
    if (!home) throw std::invalid_argument(t.name + ": no such part at that place");
    const double wish_x = t.position < home->x() ? home->x0 : home->x1;
    const double wish_r = t.radius < home->r() ? home->r0 : home->r1;
    Weights w;
    double sum = 0.0;
    for (std::size_t k = 0; k < mesh_.cells.size(); ++k) {
      const Cell& c = mesh_.cells[k];
      if (c.part != home->part || c.bearing != home->bearing) continue;
      const bool x_same = &c == home || std::fabs(c.x() - home->x()) < same;
      const bool r_same = &c == home || std::fabs(c.r() - home->r()) < same;
      const bool x_next =
          !x_same && (std::fabs(c.x0 - wish_x) < same || std::fabs(c.x1 - wish_x) < same);
      const bool r_next =
          !r_same && (std::fabs(c.r0 - wish_r) < same || std::fabs(c.r1 - wish_r) < same);
      if (!(x_same || x_next) || !(r_same || r_next)) continue;
      const double fx = share(t.position, home->x(), home->x1 - home->x0);
      const double fr = share(t.radius, home->r(), home->r1 - home->r0);
      const double weight = (x_same ? 1.0 - fx : fx) * (r_same ? 1.0 - fr : fr);
      w.emplace_back(k, weight);
      sum += weight;
    }
    for (auto& [k, weight] : w) weight /= sum;
    return w;
  }
  static double share(double at, double centre, double size) {
    return std::fabs(at - centre) / size;  // towards a neighbour of about the same size
  }

  const Spindle& s_;
  std::vector<double> x_, r_;
  std::vector<int> grid_;
  Mesh mesh_;
};

}  // namespace

Mesh make_mesh(const Spindle& spindle, double size) { return Builder(spindle, size).build(); }

}  // namespace spindle_study
