#include "effects/check_restriction.h"

#include "effects/restriction.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Port;
using hydraulics::Walk;

Status InstallCheckRestriction(const EffectParams& effect, Extension* extension) {
  for (int i : TargetCylinders(effect, extension->params())) {
    for (Port chamber : {Port::kBore, Port::kRod}) {
      const double factor = chamber == Port::kRod ? effect.values.at("rod_ratio") : 1;
      const RestrictionWay out{factor * effect.values.at("out_Pas_per_m3"),
                               factor * effect.values.at("turbulent_out_Pas2_per_m6"),
                               factor * effect.values.at("cracking_out_Pa")};
      const RestrictionWay in{factor * effect.values.at("in_Pas_per_m3"),
                              factor * effect.values.at("turbulent_in_Pas2_per_m6"),
                              factor * effect.values.at("cracking_in_Pa")};
      extension->SplitChamber(
          chamber, i, effect.values.at("oil_share"), "check_restriction",
          MakeRestriction(out, in, effect.values.at("exponent"), extension->params()));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& CheckRestrictionInfo() {
  static const EffectInfo info = {
      "check_restriction",
      "hydraulic",
      "cylinders",
      "p_chamber - p_line = R q (|q|/(1e-5 m3/s))^(1/n - 1) + K q|q| + P sat(q), by direction",
      {
          {"out_Pas_per_m3", "Pa s/m3", 1e10, 1e3, 1e16, 1e6, 1e13,
           "R at 20 °C for flow out of the chamber"},
          {"in_Pas_per_m3", "Pa s/m3", 1e9, 1e3, 1e16, 1e6, 1e13,
           "R at 20 °C for flow into the chamber"},
          {"exponent", "-", 1, 1, 5, 1, 4, "n: 1 a pipe, > 1 a plate or reed that the flow lifts"},
          {"turbulent_out_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e17, "K out of the chamber"},
          {"turbulent_in_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e17, "K into the chamber"},
          {"cracking_out_Pa", "Pa", 0, 0, 1e8, 0, 2e6,
           "P for flow out of the chamber: a spring holds the valve shut"},
          {"cracking_in_Pa", "Pa", 0, 0, 1e8, 0, 2e6, "P for flow into the chamber"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.02, 50,
           "resistance of the rod side over that of the bore side"},
          {"oil_share", "-", 0.2, 0.02, 0.45, 0.1, 0.4, "share of the line's oil at the chamber",
           true},
      },
      InstallCheckRestriction,
      {
          .rig =
              {
                  {.free = {{"out_Pas_per_m3", 1e9, 1e11, 4},
                            {"in_Pas_per_m3", 1e11, 1e9, 4, Walk::kInStep}},
                   .amounts = 2},
                  {.free = {{"turbulent_out_Pas2_per_m6", 1e13, 1e14, 2}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}}},
                  {.free = {{"turbulent_in_Pas2_per_m6", 1e13, 1e14, 2}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}}},
                  // In the chamber of one side alone, as good as none in the other.
                  {.free = {{"out_Pas_per_m3", 2e7, 2e8, 2},
                            {"in_Pas_per_m3", 2e8, 2e7, 2, Walk::kInStep}},
                   .held = {{"rod_ratio", 50}},
                   .amounts = 2},
                  {.free = {{"out_Pas_per_m3", 1e9, 1e10, 2},
                            {"in_Pas_per_m3", 1e10, 1e9, 2, Walk::kInStep}},
                   .held = {{"rod_ratio", 0.02}},
                   .amounts = 2},
                  {.free = {{"turbulent_out_Pas2_per_m6", 2e11, 2e12, 2}},
                   .held = {{"out_Pas_per_m3", 1e6}, {"in_Pas_per_m3", 1e6}, {"rod_ratio", 50}}},
                  {.free = {{"turbulent_out_Pas2_per_m6", 1e13, 1e14, 2}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}, {"rod_ratio", 0.02}}},
                  {.free = {{"turbulent_in_Pas2_per_m6", 2e11, 2e12, 2}},
                   .held = {{"out_Pas_per_m3", 1e6}, {"in_Pas_per_m3", 1e6}, {"rod_ratio", 50}}},
                  {.free = {{"turbulent_in_Pas2_per_m6", 1e13, 1e14, 2}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}, {"rod_ratio", 0.02}}},
                  // Held shut by a spring: the rod side's P is rod_ratio times these.
                  {.free = {{"cracking_out_Pa", 2e5, 2e4, 2},
                            {"cracking_in_Pa", 2e4, 2e5, 2, Walk::kInStep}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}},
                   .amounts = 2},
                  {.free = {{"cracking_out_Pa", 2e5, 2e4, 2},
                            {"cracking_in_Pa", 2e4, 2e5, 2, Walk::kInStep}},
                   .held = {{"out_Pas_per_m3", 3e7}, {"in_Pas_per_m3", 3e7}, {"rod_ratio", 0.02}},
                   .amounts = 2},
                  {.free = {{"cracking_out_Pa", 4e3, 4e2, 2},
                            {"cracking_in_Pa", 4e2, 4e3, 2, Walk::kInStep}},
                   .held = {{"out_Pas_per_m3", 1e6}, {"in_Pas_per_m3", 1e6}, {"rod_ratio", 50}},
                   .amounts = 2},
              },
          .options =
              {
                  {.free = {{"cracking_out_Pa", 3e4}}},
                  {.free = {{"cracking_in_Pa", 3e4}}},
                  {.free = {{"out_Pas_per_m3", 2e7, 1e9, 2}}},
                  {.free = {{"in_Pas_per_m3", 2e7, 1e9, 2}}},
                  {.free = {{"turbulent_out_Pas2_per_m6", 2e11, 1e13, 2}}},
                  {.free = {{"turbulent_in_Pas2_per_m6", 2e11, 1e13, 2}}},
                  {.free = {{"exponent", 1.3, 2, 2}}},
                  {.free = {{"oil_share", 0.2}}},
                  {.free = {{"rod_ratio", 1}}, .of_sides = true},
              },
          .contains = {"line_resistance"},
      }};
  return info;
}

}  // namespace phs::effects
