#include "effects/formula_laws.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::ForcePlace;
using hydraulics::Port;
using hydraulics::Sensor;

/// Step of the central difference that gives slopes over pressure [Pa].
constexpr double kNudge = 100;

class FurtherForce final : public hydraulics::ForceLaw {
 public:
  explicit FurtherForce(Formula formula) : formula_(std::move(formula)) {}
  double Force(const ForcePlace& place) const noexcept override { return formula_.Value(place); }

 private:
  Formula formula_;
};

class FurtherReading final : public hydraulics::ReadingLaw {
 public:
  explicit FurtherReading(Formula formula) : formula_(std::move(formula)) {}
  double Error(const ForcePlace& place) const noexcept override { return formula_.Value(place); }

 private:
  Formula formula_;
};

class FurtherVolume final : public hydraulics::VolumeLaw {
 public:
  FurtherVolume(Formula formula, double p0) : formula_(std::move(formula)), p0_(p0) {
    static_volume_ = At(0);
  }
  void Add(double pressure, double, double* volume, double* slope) const noexcept override {
    const double rise = pressure - p0_;
    *volume += At(rise) - static_volume_;
    *slope += (At(rise + kNudge) - At(rise - kNudge)) / (2 * kNudge);
  }
  // int p dV = p V - int V dp, Simpson.
  double Energy(double pressure, double) const noexcept override {
    constexpr int kPanels = 128;
    const double rise = pressure - p0_, step = rise / kPanels;
    double sum = 0;
    for (int i = 0; i <= 2 * kPanels; ++i) {
      const double weight = i == 0 || i == 2 * kPanels ? 1 : (i % 2 == 1 ? 4 : 2);
      sum += weight * (At(0.5 * i * step) - static_volume_);
    }
    return pressure * (At(rise) - static_volume_) - sum * step / 6;
  }

 private:
  double At(double rise) const {
    ForcePlace place;
    place.bore_rise = rise;
    return formula_.Value(place);
  }
  Formula formula_;
  double p0_, static_volume_ = 0;
};

class FurtherFlow final : public hydraulics::FlowLaw {
 public:
  /// `static_dp`: p_from - p_to in the static state [Pa].
  FurtherFlow(Formula formula, double static_dp)
      : formula_(std::move(formula)), static_dp_(static_dp) {}
  double Flow(const hydraulics::FlowPlace& at, double dp, double* slope) const noexcept override {
    *slope = (At(at.time, dp + kNudge) - At(at.time, dp - kNudge)) / (2 * kNudge);
    return At(at.time, dp);
  }

 private:
  double At(double time, double dp) const {
    ForcePlace place;
    place.time = time;
    place.bore_rise = dp - static_dp_;
    return formula_.Value(place);
  }
  Formula formula_;
  double static_dp_;
};

struct SensorPlace {
  int cylinder;
  Sensor sensor;
};

/// The sensors whose readings are meant: of pistons, or of the pressures of lines.
Result<std::vector<SensorPlace>> Sensors(const EffectParams& effect, FormulaUnit unit,
                                         const hydraulics::PhsParams& params) {
  std::vector<SensorPlace> out;
  if (unit == FormulaUnit::kLength || unit == FormulaUnit::kForce) {
    for (int i : TargetCylinders(effect, params)) {
      if (i < 0) return RefuseEffect(effect, "lines have no piston to be measured", "cylinders");
      out.push_back({i, unit == FormulaUnit::kLength ? Sensor::kPiston : Sensor::kLoad});
    }
    return out;
  }
  for (int line : TargetLines(effect, params)) {
    if (line < 0) return RefuseEffect(effect, "a pressure is that of a line", "lines");
    const std::string& name = params.lines[static_cast<size_t>(line)].name;
    for (size_t i = 0; i < params.cylinders.size(); ++i) {
      const auto& c = params.cylinders[i];
      if (c.bore_line != name && c.rod_line != name) continue;
      out.push_back({static_cast<int>(i),
                     c.bore_line == name ? Sensor::kBorePressure : Sensor::kRodPressure});
    }
  }
  return out;
}

}  // namespace

Error RefuseEffect(const EffectParams& effect, const std::string& what,
                   const std::string& allowed) {
  return Error{"effects." + effect.name, what, allowed};
}

void AddForceTo(int cylinder, const Formula& formula, Extension* extension) {
  extension->AddForce(cylinder, std::make_unique<FurtherForce>(formula));
}

Status AddVolume(const EffectParams& effect, const Formula& formula, Extension* extension) {
  if (const std::string other = formula.VariableOtherThan("p"); !other.empty()) {
    return RefuseEffect(effect, "a volume of a line over " + other, "a formula over p alone");
  }
  for (int line : TargetLines(effect, extension->params())) {
    if (line < 0)
      return RefuseEffect(effect, "a volume belongs to lines, not to cylinders", "lines");
    extension->AddVolume(
        line, std::make_unique<FurtherVolume>(formula, extension->line(line).static_pressure_Pa));
  }
  return {};
}

Status AddFlow(const EffectParams& effect, const Formula& formula, Extension* extension) {
  if (const std::string other = formula.VariableOtherThan("pt"); !other.empty()) {
    return RefuseEffect(effect, "a flow over " + other, "a formula over p and t");
  }
  if (formula.VariableOtherThan("p").empty() && formula.Value({}) != 0) {
    return RefuseEffect(effect, "a flow that does not vanish at rest", "0 at p = 0, or over t");
  }
  const auto& params = extension->params();
  const auto rest = [&](const std::string& name) { return StaticPressure(name, *extension); };
  for (const std::string& target : effect.targets) {
    if (const int i = params.FindCylinder(target); i >= 0 && params.FindLine(target) < 0) {
      const auto& c = params.cylinders[static_cast<size_t>(i)];
      extension->AddFlow(
          Port::kBore, Port::kRod, i, -1, effect.name,
          std::make_unique<FurtherFlow>(formula, rest(c.bore_line) - rest(c.rod_line)));
      continue;
    }
    extension->AddFlow(
        Port::kLine, Port::kAtmosphere, -1, params.FindLine(target), effect.name,
        std::make_unique<FurtherFlow>(formula, rest(target) - hydraulics::kAtmosphere));
  }
  if (effect.targets.empty())
    return RefuseEffect(effect, "a flow without targets", "targets: [line]");
  return {};
}

Status AddReading(const EffectParams& effect, const Formula& formula, FormulaUnit unit,
                  Extension* extension) {
  if (const std::string other = formula.VariableOtherThan("xvpqtF"); !other.empty()) {
    return RefuseEffect(effect, "a reading over " + other, "a formula over x, v, p, q, t and F");
  }
  const auto sensors = Sensors(effect, unit, extension->params());
  if (!sensors.ok()) return sensors.error();
  for (const SensorPlace& at : sensors.value()) {
    extension->AddReading(at.cylinder, at.sensor, std::make_unique<FurtherReading>(formula));
  }
  return {};
}

}  // namespace phs::effects
