#include "effects/line_inertance.h"

#include <memory>

#include "effects/targets.h"
#include "hydraulics/pipe.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::PipeFlow;
using hydraulics::Port;
using hydraulics::Walk;

/// A side with less than this share of the other's has as good as none.
constexpr double kNone = 0.05;

Status InstallLineInertance(const EffectParams& effect, Extension* extension) {
  const double ratio = effect.values.at("rod_ratio");
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      if (chamber == Port::kRod ? ratio < kNone : ratio * kNone > 1) continue;
      const double factor = chamber == Port::kRod ? ratio : 1;
      const PipeFlow::Resistance r{
          factor * AtModelTemperature(effect.values.at("laminar_Pas_per_m3"), extension->params()),
          0};
      const double inertance = factor * effect.values.at("inertance_kg_per_m4");
      extension->SplitChamber(
          chamber, i, effect.values.at("oil_share"), "line_inertance",
          std::make_unique<PipeFlow>(r, r, inertance, effect.values.at("unsteady_share")));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& LineInertanceInfo() {
  static const EffectInfo info = {
      "line_inertance",
      "hydraulic",
      "cylinders",
      "I dq/dt = p_chamber - p_line - R q, less the friction of laminar flow that changes",
      {
          {"inertance_kg_per_m4", "kg/m4", 1.6e7, 1, 1e12, 1e5, 1e9, "I = rho l/A"},
          {"laminar_Pas_per_m3", "Pa s/m3", 4e8, 1e3, 1e16, 1e5, 1e11, "R at 20 °C"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5,
           "resistance and inertance of the rod side over those of the bore side; below 1/20 and "
           "above 20 one side has none"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber",
           true},
          {"unsteady_share", "-", 0, 0, 10, 0, 3,
           "friction of the changing flow over that in a round pipe (Zielke): 0 none, 1 all"},
      },
      InstallLineInertance,
      {
          .rig =
              {
                  // A column that hardly rings down shows close to its own frequency only.
                  {.free = {{"inertance_kg_per_m4", 1e7, 6e8, 11},
                            {"laminar_Pas_per_m3", 2e8, 1e10, 11, Walk::kInStep}}},
                  {.free = {{"inertance_kg_per_m4", 1e7, 5e7, 2},
                            {"laminar_Pas_per_m3", 2e8, 8e8, 2, Walk::kInStep}},
                   .held = {{"rod_ratio", 0.02}}},
                  {.free = {{"inertance_kg_per_m4", 2e5, 1e6, 2},
                            {"laminar_Pas_per_m3", 4e6, 1.6e7, 2, Walk::kInStep}},
                   .held = {{"rod_ratio", 50}}},
              },
          .options =
              {
                  {.free = {{"oil_share", 0.2}}},
                  {.free = {{"rod_ratio", 0.7, 1.45, 5}}, .of_sides = true},
                  {.free = {{"unsteady_share", 1}}},
              },
          .contains = {"line_resistance"},
      }};
  return info;
}

}  // namespace phs::effects
