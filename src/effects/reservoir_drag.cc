#include "effects/reservoir_drag.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::FlowPlace;
using hydraulics::Places;

class DragFlow final : public hydraulics::FlowLaw {
 public:
  DragFlow(double friction, double resistance, double turbulent)
      : friction_(friction), resistance_(resistance), turbulent_(turbulent) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    const double beyond = std::abs(dp) - friction_;
    if (!(beyond > 0)) return *slope = 0;
    const double R = Resistance(at), root = std::sqrt(R * R + 4 * turbulent_ * beyond);
    *slope = 1 / root;
    return std::copysign(2 * beyond / (R + root), dp);
  }
  double Drop(const FlowPlace& at, double flow, double* slope) const noexcept override {
    const double R = Resistance(at), size = std::abs(flow);
    *slope = R + 2 * turbulent_ * size;
    const double dragged = flow != 0 ? std::copysign(friction_, flow) : 0;
    return dragged + (R + turbulent_ * size) * flow;
  }
  bool SolvedByDrop() const noexcept override { return turbulent_ > 0; }
  bool Sticks() const noexcept override { return friction_ > 0; }

 private:
  double Resistance(const FlowPlace& at) const { return resistance_ * at.viscosity; }
  double friction_, resistance_, turbulent_;
};

Status InstallReservoirDrag(const EffectParams& effect, Extension* extension) {
  const double R = AtModelTemperature(effect.values.at("laminar_Pas_per_m3"), extension->params());
  for (const int line : TargetLines(effect, extension->params())) {
    extension->SplitReservoir(
        line, "reservoir_drag",
        std::make_unique<DragFlow>(effect.values.at("friction_Pa"), R,
                                   effect.values.at("turbulent_Pas2_per_m6")));
  }
  return {};
}

}  // namespace

const EffectInfo& ReservoirDragInfo() {
  static const EffectInfo info = {
      "reservoir_drag",
      "hydraulic",
      "lines",
      "p_line - p_gas = P_f sign(q) + R q + K q|q|: the reservoir's gas behind a piston that drags "
      "or a neck",
      {
          {"friction_Pa", "Pa", 5e4, 0, 1e7, 1e3, 2e6, "P_f"},
          // 1e7: 100 Pa at 1e-5 m3/s, less than any gauge shows.
          {"laminar_Pas_per_m3", "Pa s/m3", 1e7, 1e6, 1e14, 1e7, 1e12, "R at 20 °C"},
          {"turbulent_Pas2_per_m6", "Pa s2/m6", 0, 0, 1e20, 0, 1e16, "K"},
      },
      InstallReservoirDrag,
      {
          .rig =
              {
                  {.free = {{"friction_Pa", 2e4, 2e5, 2}}, .places = Places::kEach},
                  {.free = {{"laminar_Pas_per_m3", 1e9, 3e10, 2}},
                   .held = {{"friction_Pa", 0}},
                   .places = Places::kEach},
                  {.free = {{"turbulent_Pas2_per_m6", 1e12, 3e13, 2}},
                   .held = {{"friction_Pa", 0}},
                   .places = Places::kEach},
              },
          .options =
              {
                  {.free = {{"laminar_Pas_per_m3", 3e9}}},
                  {.free = {{"friction_Pa", 3e4}}, .without = "turbulent_Pas2_per_m6"},
                  {.free = {{"turbulent_Pas2_per_m6", 3e12}}, .without = "friction_Pa"},
              },
      }};
  return info;
}

}  // namespace phs::effects
