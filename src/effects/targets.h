// Which cylinders or lines an effect acts on.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hydraulics/extension.h"
#include "hydraulics/oil.h"
#include "hydraulics/pipe.h"

namespace phs::effects {

/// Indices of the targets; all when none is named. Names were checked before.
inline std::vector<int> TargetCylinders(const hydraulics::EffectParams& effect,
                                        const hydraulics::PhsParams& params) {
  std::vector<int> out;
  for (size_t i = 0; i < params.cylinders.size() && effect.targets.empty(); ++i) {
    out.push_back(static_cast<int>(i));
  }
  for (const std::string& name : effect.targets) out.push_back(params.FindCylinder(name));
  return out;
}

inline std::vector<int> TargetLines(const hydraulics::EffectParams& effect,
                                    const hydraulics::PhsParams& params) {
  std::vector<int> out;
  for (size_t i = 0; i < params.lines.size() && effect.targets.empty(); ++i) {
    out.push_back(static_cast<int>(i));
  }
  for (const std::string& name : effect.targets) out.push_back(params.FindLine(name));
  return out;
}

/// Static pressure of a line; atmosphere where there is none [Pa].
inline double StaticPressure(const std::string& name, const hydraulics::Extension& extension) {
  const auto& params = extension.params();
  const int line = params.FindLine(name);
  return line >= 0 ? params.lines[static_cast<size_t>(line)].static_pressure_Pa
                   : hydraulics::kAtmosphere;
}

/// Laminar resistance at the model's static temperature, from its value at 20 °C.
inline double AtModelTemperature(double laminar_20C, const hydraulics::PhsParams& params) {
  return laminar_20C * hydraulics::CalcViscosityRatio(params.temperature_K);
}

/// Conductance of a leak at the model's static temperature, from its value at 20 °C: viscous flow
/// (exponent 1 and above) follows the viscosity, an orifice (1/2) does not.
inline double LeakAtModelTemperature(const hydraulics::EffectParams& effect,
                                     const hydraulics::PhsParams& params) {
  const double viscous = hydraulics::GapFlow::ViscousShare(effect.values.at("exponent"));
  return effect.values.at("conductance_m3_per_Pas") *
         std::pow(hydraulics::CalcViscosityRatio(params.temperature_K), -viscous);
}

/// True if the line is one of rod chambers: cross lines as against diagonals.
inline bool IsRodLine(const hydraulics::PhsParams& params, int line) {
  for (const auto& cylinder : params.cylinders) {
    if (cylinder.rod_line == params.lines[static_cast<size_t>(line)].name) return true;
  }
  return false;
}
/// What an amount is multiplied by on this line: `rod_ratio` on lines of rod chambers, else 1.
inline double LineFactor(const hydraulics::EffectParams& effect,
                         const hydraulics::PhsParams& params, int line) {
  return IsRodLine(params, line) ? effect.values.at("rod_ratio") : 1;
}

/// How often an effect is listed.
inline long CountOf(const std::string& effect, const hydraulics::PhsParams& params) {
  return std::count_if(params.effects.begin(), params.effects.end(),
                       [&](const auto& other) { return other.name == effect; });
}

/// A part on a bench: one cylinder without lines.
inline bool IsBenchPart(const hydraulics::PhsParams& params) {
  return params.cylinders.size() == 1 && params.lines.empty();
}
inline Status NotABenchPart(const std::string& effect) {
  return Error{"effects." + effect, "acts on a part on a bench only",
               "a model of one cylinder without lines (rig: element)", "take it out here"};
}

}  // namespace phs::effects
