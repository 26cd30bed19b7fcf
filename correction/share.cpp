#include "correction/share.h"

#include <cmath>

#include "record/record.h"

namespace raceway::correction {
namespace {

/// Adds a share by its kind; what has no size costs no time.
struct Adder {
  const Series& series;
  const Interval& seen;
  const Sink& sink;

  void operator()(std::monostate) const {}
  void operator()(const DrivenShare& s) const {
    if (s.gain == 0.0) return;
    const double size = s.gain * um / s.input.factor();
    if (std::isnan(s.time_constant))
      sink(size, series.at_once(s.input));
    else
      sink(size, series.lag(s.input, s.time_constant, {}));
  }
  void operator()(const MotorShare& s) const {
    if (s.gain != 0.0) sink(s.gain * um, series.motor(s.decay_speed, s.time_constant, seen));
  }
  void operator()(const SettlingShare& s) const {
    if (s.size != 0.0) sink(s.size * um, series.settling(s.time_constant));
  }
  void operator()(const JumpShare& s) const {
    const std::span<const double> time = series.record().values(record::time);
    for (const JumpShare::Jump& jump : s.jumps) {
      if (jump.size == 0.0) continue;
      auto step = std::make_shared<std::vector<double>>(series.rows());
      for (std::size_t k = 0; k < step->size(); ++k) (*step)[k] = time[k] >= jump.time ? 1.0 : 0.0;
      sink(jump.size * um, step);
    }
  }
  void operator()(const Kinematic& law) const {
    if (law.A != 0.0) sink(law.A * um, series.kinematic(law.B, law.C, seen));
  }
};

}  // namespace

void add_share(const Share& share, const Series& series, const Interval& seen, const Sink& sink) {
  std::visit(Adder{series, seen, sink}, share);
}

}  // namespace raceway::correction
