#include "effects/external_leakage.h"

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

Status InstallExternalLeakage(const EffectParams& effect, Extension* extension) {
  const double G = LeakAtModelTemperature(effect, extension->params());
  const double out = effect.values.at("film_out_m2"), in = effect.values.at("film_in_m2");
  for (int line : TargetLines(effect, extension->params())) {
    const double factor = LineFactor(effect, extension->params(), line);
    const int cylinder = CylinderOf(extension->params(), line);
    const auto add = [&](const char* name, std::unique_ptr<hydraulics::FlowLaw> law) {
      extension->AddFlow(Port::kLine, Port::kAtmosphere, cylinder, line, name, std::move(law));
    };
    if (G > 0) {
      auto gap =
          std::make_unique<GapFlow>(G * factor, effect.values.at("exponent"),
                                    effect.values.at("start_s"), 1, effect.values.at("opening_Pa"));
      add("external_leakage",
          AtPlace(std::move(gap), effect.values.at("from_m"), effect.values.at("edge_m")));
    }
    if (out != 0 || in != 0) {
      add("external_leakage_film", std::make_unique<FilmFlow>(factor * out, factor * in));
    }
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
          {"from_m", "m", 0, -1, 1, -5e-3, 5e-3, "x_1: the piston stands beyond it; with edge_m"},
          {"edge_m", "m", 0, -1, 1, -2e-3, 2e-3, "w; < 0: it leaks below x_1; 0: everywhere"},
          {"film_out_m2", "m2", 0, -1e-3, 1e-3, 0, 1e-5, "h_out: carried out in extension"},
          {"film_in_m2", "m2", 0, -1e-3, 1e-3, 0, 1e-5, "h_in: carried in in retraction"},
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
                  // What comes in is not sought: it would stand for a valve that feeds the line.
                  {.free = {{"film_out_m2", 1e-7}},
                   .held = {{"conductance_m3_per_Pas", 0}},
                   .places = Places::kAlone},
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
                  {.free = {{"from_m", -1e-3, 1e-3, 3}, {"edge_m", -3e-4, 3e-4, 2}},
                   .with = "conductance_m3_per_Pas"},
                  {.free = {{"film_out_m2", 1e-8}}},
              },
          .over = {"m3_per_s", "p", true},
      }};
  return info;
}

}  // namespace phs::effects
