#include "effects/makeup_valve.h"

#include <memory>

#include "effects/leak_place.h"
#include "effects/targets.h"
#include "hydraulics/pipe.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::FlowPlace;
using hydraulics::GapFlow;
using hydraulics::Places;
using hydraulics::Port;

/// Out of the line, so that what is fed is below zero.
class Feed final : public hydraulics::FlowLaw {
 public:
  /// `opening` p_o, absolute [Pa].
  Feed(const GapFlow& gap, double opening)
      : gap_(gap), opening_(opening - hydraulics::kAtmosphere) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    if (dp >= opening_) return *slope = 0;
    return -gap_.Flow(at, opening_ - dp, slope);
  }

 private:
  GapFlow gap_;
  double opening_;
};

Status InstallMakeupValve(const EffectParams& effect, Extension* extension) {
  const double G = LeakAtModelTemperature(effect, extension->params());
  if (G == 0) return {};
  for (int line : TargetLines(effect, extension->params())) {
    const GapFlow gap(G * LineFactor(effect, extension->params(), line),
                      effect.values.at("exponent"));
    extension->AddFlow(Port::kLine, Port::kAtmosphere, CylinderOf(extension->params(), line), line,
                       "makeup_valve", std::make_unique<Feed>(gap, effect.values.at("opening_Pa")));
  }
  return {};
}

}  // namespace

const EffectInfo& MakeupValveInfo() {
  static const EffectInfo info = {
      "makeup_valve",
      "hydraulic",
      "lines",
      "q = G d (d/5 MPa)^(n-1) into the line, d = p_o - p > 0, from a supply",
      {
          {"conductance_m3_per_Pas", "m3/(Pa s)", 1e-14, 0, 1e-3, 1e-17, 1e-9,
           "conductance at 5 MPa and 20 °C"},
          {"opening_Pa", "Pa", 1e6, 1e2, 1e8, 1e5, 3e6, "p_o: it feeds below it, absolute"},
          {"exponent", "-", 1, 0.2, 5, 0.3, 3, "n: 1/2 an orifice, 1 a spring that yields"},
          {"rod_ratio", "-", 1, 1e-3, 1e3, 0.2, 5, "valve of rod lines over that of bore lines"},
      },
      InstallMakeupValve,
      {
          .rig =
              {
                  {.free = {{"conductance_m3_per_Pas", 1e-14, 1e-12, 2},
                            {"opening_Pa", 6e5, 1.5e6, 3}},
                   .places = Places::kAlone},
                  {.free = {{"conductance_m3_per_Pas", 3e-15, 3e-13, 2},
                            {"opening_Pa", 6e5, 1.5e6, 3}},
                   .held = {{"exponent", 0.5}},
                   .places = Places::kAlone},
              },
          .options =
              {
                  {.free = {{"exponent", 0.6, 1.6, 2}}},
              },
          .over = {"m3_per_s", "p", true, true},
      }};
  return info;
}

}  // namespace phs::effects
