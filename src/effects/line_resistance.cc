#include "effects/line_resistance.h"

#include "effects/restriction.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Port;

Status InstallLineResistance(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      const double factor = chamber == Port::kRod ? effect.values.at("rod_ratio") : 1;
      const RestrictionWay r{factor * effect.values.at("laminar_Pas_per_m3"),
                             factor * effect.values.at("turbulent_Pas2_per_m6"),
                             factor * effect.values.at("cracking_Pa")};
      extension->SplitChamber(
          chamber, i, effect.values.at("oil_share"), "line_resistance",
          MakeRestriction(r, r, effect.values.at("exponent"), extension->params()));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& LineResistanceInfo() {
  static const EffectInfo info = {
      "line_resistance",
      "hydraulic",
      "cylinders",
      "p_chamber - p_line = R q (|q|/(1e-5 m3/s))^(1/n - 1) + K q|q| + P sat(q)",
      {
          {"laminar_Pas_per_m3", "Pa s/m3", 1e9, 1e3, 1e16, 1e5, 1e12, "R at 20 °C"},
          {"exponent", "-", 1, 1, 5, 1, 4, "n: 1 a pipe, > 1 a plate or reed that the flow lifts"},
          {"turbulent_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e16, "K"},
          {"cracking_Pa", "Pa", 0, 0, 1e8, 0, 2e6, "P: a spring holds the valve shut"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.02, 50,
           "resistance of the rod side over that of the bore side"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber",
           true},
      },
      InstallLineResistance,
      {
          .rig =
              {
                  {.free = {{"laminar_Pas_per_m3", 2e8, 2e10, 3}}},
                  {.free = {{"turbulent_Pas2_per_m6", 1e12, 1e14, 3}},
                   .held = {{"laminar_Pas_per_m3", 3e7}}},
                  // In the chamber of one side alone, as good as none in the other.
                  {.free = {{"laminar_Pas_per_m3", 3e7, 3e8, 2}}, .held = {{"rod_ratio", 50}}},
                  {.free = {{"laminar_Pas_per_m3", 1e9, 1e10, 2}}, .held = {{"rod_ratio", 0.02}}},
                  {.free = {{"turbulent_Pas2_per_m6", 4e10, 4e11, 2}},
                   .held = {{"laminar_Pas_per_m3", 1e6}, {"rod_ratio", 50}}},
                  {.free = {{"turbulent_Pas2_per_m6", 2e12, 2e13, 2}},
                   .held = {{"laminar_Pas_per_m3", 3e7}, {"rod_ratio", 0.02}}},
              },
          .bogie =
              {
                  {.free = {{"laminar_Pas_per_m3", 2e9, 2e10, 2}}},
              },
          .options =
              {
                  {.free = {{"laminar_Pas_per_m3", 6e7, 3e9, 3}}},
                  {.free = {{"turbulent_Pas2_per_m6", 1e12, 1e14, 3}}},
                  {.free = {{"exponent", 1.3, 2, 2}}},
                  {.free = {{"cracking_Pa", 3e4}}},
                  {.free = {{"oil_share", 0.2}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
              },
      }};
  return info;
}

}  // namespace phs::effects
