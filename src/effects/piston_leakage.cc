#include "effects/piston_leakage.h"

#include <memory>
#include <utility>

#include "effects/leak_place.h"
#include "effects/targets.h"
#include "hydraulics/pipe.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::GapFlow;
using hydraulics::Places;
using hydraulics::Port;

Status InstallPistonLeakage(const EffectParams& effect, Extension* extension) {
  const double G = LeakAtModelTemperature(effect, extension->params());
  if (G <= 0) return {};
  for (int i : TargetCylinders(effect, extension->params())) {
    auto gap =
        std::make_unique<GapFlow>(G, effect.values.at("exponent"), effect.values.at("start_s"),
                                  effect.values.at("return_ratio"));
    extension->AddFlow(
        Port::kBore, Port::kRod, i, -1, "piston_leakage",
        AtPlace(std::move(gap), effect.values.at("from_m"), effect.values.at("edge_m")));
  }
  return {};
}

}  // namespace

const EffectInfo& PistonLeakageInfo() {
  static const EffectInfo info = {
      "piston_leakage",
      "hydraulic",
      "cylinders",
      "q = G d (|d|/5 MPa)^(n-1), d = p_bore - p_rod, past the piston seal from start_s on",
      {
          {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-13, 0, 1e-6, 1e-17, 1e-11,
           "conductance of the gap at 5 MPa and 20 °C"},
          // A gap that opens in proportion: q ~ h^3 d ~ d^4.
          {"exponent", "-", 1, 0.2, 5, 0.4, 4, "n: 1 laminar, 1/2 orifice, > 1 widening gap"},
          {"return_ratio", "-", 1, 1e-4, 1e4, 5e-3, 200,
           "conductance from rod to bore over that from bore to rod: a lip lifts one way"},
          {"start_s", "s", -1e12, -1e12, 1e12, 0, 1e6, "the seal fails at this time"},
          {"from_m", "m", 0, -1, 1, -5e-3, 5e-3, "x_1: the piston stands beyond it; with edge_m"},
          {"edge_m", "m", 0, -1, 1, -2e-3, 2e-3, "w; < 0: it leaks below x_1; 0: everywhere"},
      },
      InstallPistonLeakage,
      {
          .rig =
              {
                  {.free = {{"conductance_m3_per_Pas", 1e-16, 1e-13, 4}}, .places = Places::kEach},
                  {.free = {{"conductance_m3_per_Pas", 3e-16, 1e-14, 2}},
                   .held = {{"exponent", 0.5}},
                   .places = Places::kEach},
                  {.free = {{"conductance_m3_per_Pas", 1e-15, 1e-14, 2}},
                   .held = {{"return_ratio", 0.02}},
                   .places = Places::kEach},
                  {.free = {{"conductance_m3_per_Pas", 2e-17, 2e-16, 2}},
                   .held = {{"return_ratio", 50}},
                   .places = Places::kEach},
              },
          .bogie =
              {
                  {.free = {{"conductance_m3_per_Pas", 1e-13, 3e-12, 2}}},
              },
          .options =
              {
                  {.free = {{"exponent", 0.6, 1.6, 2}}},
                  {.free = {{"return_ratio", 0.3, 3, 2}}},
                  {.free = {{"start_s", 15, 60, 3}}},
                  {.free = {{"from_m", -1e-3, 1e-3, 3}, {"edge_m", -3e-4, 3e-4, 2}}},
              },
          .over = {"m3_per_s", "p"},
      }};
  return info;
}

}  // namespace phs::effects
