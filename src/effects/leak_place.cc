#include "effects/leak_place.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace phs::effects {
namespace {

using hydraulics::FlowLaw;
using hydraulics::FlowPlace;

class PlacedFlow final : public FlowLaw {
 public:
  PlacedFlow(std::unique_ptr<FlowLaw> law, double from, double edge)
      : law_(std::move(law)), from_(from), edge_(edge) {}
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    const double share = 0.5 * (1 + std::tanh((at.piston - from_) / edge_));
    const double flow = share * law_->Flow(at, dp, slope);
    *slope *= share;
    return flow;
  }

 private:
  std::unique_ptr<FlowLaw> law_;
  double from_, edge_;
};

}  // namespace

std::unique_ptr<FlowLaw> AtPlace(std::unique_ptr<FlowLaw> law, double from, double edge) {
  if (edge == 0) return law;
  return std::make_unique<PlacedFlow>(std::move(law), from, edge);
}

int CylinderOf(const hydraulics::PhsParams& params, int line) {
  if (line < 0) return -1;
  const std::string& name = params.lines[static_cast<size_t>(line)].name;
  const auto& all = params.cylinders;
  const auto has = [&](const auto& c) { return c.bore_line == name || c.rod_line == name; };
  const auto found = std::find_if(all.begin(), all.end(), has);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

double FilmFlow::Flow(const FlowPlace& at, double, double* slope) const noexcept {
  *slope = 0;
  return at.speed * (at.speed > 0 ? out_m2_ : in_m2_);
}

}  // namespace phs::effects
