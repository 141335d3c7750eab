#include "vehicle/phs_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace phs::vehicle {
namespace {

using Kind = PhsWarning::Kind;
using Json = nlohmann::ordered_json;

/// What is said of a kind, and how its numbers are written.
struct Words {
  const char* kind;
  const char* quantity;  ///< key of the worst value
  const char* limit;     ///< key of the limit
  const char* says;
  double scale;
  const char* unit;
};

Words WordsOf(Kind kind) {
  switch (kind) {
    case Kind::kEndStop:
      return {"end_stop", "piston_m", "limit_m", "touches its end stop", 1e3, "mm"};
    case Kind::kCylinderForce:
      return {"cylinder_force", "force_N", "limit_N", "is beyond its rated force", 1e-3, "kN"};
    case Kind::kLowPressure:
      return {"low_pressure", "pressure_Pa", "limit_Pa", "is nearly empty", 1e-6, "MPa"};
    case Kind::kBlowOffOpen:
      break;
  }
  return {
      "blow_off_open", "pressure_Pa", "limit_Pa", "opens its blow-off accumulator", 1e-6, "MPa"};
}

/// Arc length of the foremost wheelset.
double FrontPlace(const mjData* d, const plugin::Binding& binding) {
  if (!binding.has_rail()) return 0;
  double front = -std::numeric_limits<double>::infinity();
  for (const auto& w : binding.wheelsets()) {
    const mjtNum* x = d->xpos + 3 * w.body;
    front = std::max(front, binding.track().Project({x[0], x[1], x[2]}));
  }
  return front;
}

}  // namespace

double PhsWarning::Excess(double value) const {
  switch (kind) {
    case Kind::kEndStop:
    case Kind::kCylinderForce:
      return std::abs(value) - limit;
    case Kind::kLowPressure:
      return limit - value;
    case Kind::kBlowOffOpen:
      break;
  }
  return value - limit;
}

PhsWatch::PhsWatch(const plugin::Binding& binding) : binding_(binding) {
  const bool several = binding.phs().size() > 1;
  for (const plugin::PhsBinding& phs : binding.phs()) {
    const std::string prefix = several ? phs.name + "_" : "";
    const hydraulics::PhsParams& params = phs.system->params();
    for (const auto& cylinder : params.cylinders) {
      const std::string part = prefix + cylinder.name;
      watched_.push_back(
          {.kind = Kind::kEndStop, .part = part, .limit = cylinder.end_stop.clearance_m});
      watched_.push_back(
          {.kind = Kind::kCylinderForce, .part = part, .limit = kRatedCylinderForce});
    }
    for (const auto& line : params.lines) {
      const std::string part = prefix + line.name;
      const double opens = line.accumulator.volume_m3 > 0 ? line.accumulator_precharge_Pa
                                                          : std::numeric_limits<double>::infinity();
      watched_.push_back({.kind = Kind::kLowPressure, .part = part, .limit = kLowestLinePressure});
      watched_.push_back({.kind = Kind::kBlowOffOpen, .part = part, .limit = opens});
    }
  }
}

void PhsWatch::Check(const mjData* d, double time, double h) {
  size_t at = 0;
  for (const plugin::PhsBinding& phs : binding_.phs()) {
    for (int i = 0; i < phs.system->num_cylinders(); ++i) {
      Watch(at++, d->userdata[phs.pistons_at + i], d, time, h);
      Watch(at++, -d->userdata[phs.forces_at + i], d, time, h);
    }
    for (int i = 0; i < phs.system->num_lines(); ++i) {
      const double pressure = d->userdata[phs.pressures_at + i];
      Watch(at++, pressure, d, time, h);
      Watch(at++, pressure, d, time, h);
    }
  }
}

void PhsWatch::Watch(size_t at, double value, const mjData* d, double time, double h) {
  PhsWarning& w = watched_[at];
  const double excess = w.Excess(value);
  if (!(excess > 0)) return;
  const bool first = w.duration_s == 0;
  w.duration_s += h;
  if (!first && excess <= w.Excess(w.worst)) return;
  w.worst = value;
  w.worst_time_s = time;
  w.worst_s_m = FrontPlace(d, binding_);
  if (!first) return;
  w.first_time_s = time;
  w.first_s_m = w.worst_s_m;
}

std::vector<PhsWarning> PhsWatch::Warnings() const {
  std::vector<PhsWarning> passed;
  for (const PhsWarning& w : watched_) {
    if (w.duration_s > 0) passed.push_back(w);
  }
  std::stable_sort(passed.begin(), passed.end(), [](const PhsWarning& a, const PhsWarning& b) {
    return a.first_time_s < b.first_time_s;
  });
  return passed;
}

Json WarningsJson(const std::vector<PhsWarning>& warnings) {
  Json all = Json::array();
  for (const PhsWarning& w : warnings) {
    const Words words = WordsOf(w.kind);
    const char* part = w.IsOfLine() ? "line" : "cylinder";
    const std::string text = fmt::format(
        "{} {} {}: first at t = {:.2f} s, s = {:.1f} m; at worst {:.4g} {} (limit {:.4g}) at "
        "t = {:.2f} s, s = {:.1f} m; {:.3g} s in all",
        part, w.part, words.says, w.first_time_s, w.first_s_m, w.worst * words.scale, words.unit,
        w.limit * words.scale, w.worst_time_s, w.worst_s_m, w.duration_s);
    all.push_back({{"name", std::string(words.kind) + "_" + w.part},
                   {"kind", words.kind},
                   {part, w.part},
                   {words.quantity, w.worst},
                   {words.limit, w.limit},
                   {"first_time_s", w.first_time_s},
                   {"first_s_m", w.first_s_m},
                   {"worst_time_s", w.worst_time_s},
                   {"worst_s_m", w.worst_s_m},
                   {"duration_s", w.duration_s},
                   {"text", text}});
  }
  return all;
}

}  // namespace phs::vehicle
