#include "effects/external_leakage.h"

#include <memory>

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

Status InstallExternalLeakage(const EffectParams& effect, Extension* extension) {
  const double G = LeakAtModelTemperature(effect, extension->params());
  if (G <= 0) return {};
  for (int line : TargetLines(effect, extension->params())) {
    extension->AddFlow(
        Port::kLine, Port::kAtmosphere, -1, line, "external_leakage",
        std::make_unique<GapFlow>(G * LineFactor(effect, extension->params(), line),
                                  effect.values.at("exponent"), effect.values.at("start_s"), 1,
                                  effect.values.at("opening_Pa")));
  }
  return {};
}

}  // namespace

const EffectInfo& ExternalLeakageInfo() {
  static const EffectInfo info = {
      "external_leakage",
      "hydraulic",
      "lines",
      "q = G d (d/5 MPa)^(n-1), d = p - p_atmosphere - p_o, out of the line from start_s on",
      {
          {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-14, 0, 1e-3, 1e-18, 1e-11,
           "conductance at 5 MPa and 20 °C"},
          // A gap that opens in proportion: q ~ h^3 d ~ d^4.
          {"exponent", "-", 1, 0.2, 5, 0.4, 4, "n: 1 laminar, 1/2 orifice, > 1 widening gap"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "leak of rod lines over that of bore lines"},
          {"start_s", "s", 0, -1e12, 1e12, 0, 1e6, "the leak opens at this time"},
          {"opening_Pa", "Pa", 0, 0, 1e9, 1e5, 2e7, "p_o: it opens beyond it; 0: at any pressure"},
      },
      InstallExternalLeakage,
      {
          .rig =
              {
                  {.free = {{"conductance_m3_per_Pas", 1e-17, 1e-14, 4}}, .places = Places::kEach},
                  {.free = {{"conductance_m3_per_Pas", 3e-17, 1e-15, 2}},
                   .held = {{"exponent", 0.5}},
                   .places = Places::kEach},
                  {.free = {{"conductance_m3_per_Pas", 1e-15, 3e-14, 2},
                            {"opening_Pa", 2.5e6, 7e6, 2}},
                   .places = Places::kEach},
              },
          .bogie =
              {
                  {.free = {{"conductance_m3_per_Pas", 1e-13, 5e-12, 3}}, .places = Places::kAlone},
              },
          .options =
              {
                  {.free = {{"exponent", 0.6, 1.6, 2}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
                  {.free = {{"start_s", 15, 60, 3}}},
              },
          .over = {"m3_per_s", "p", true},
      }};
  return info;
}

}  // namespace phs::effects
