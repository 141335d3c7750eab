#include "hydraulics/pipe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace phs::hydraulics {
namespace {

class SeriesFlow final : public FlowLaw {
 public:
  SeriesFlow(std::unique_ptr<FlowLaw> first, std::unique_ptr<FlowLaw> second)
      : first_(std::move(first)), second_(std::move(second)) {}
  double Drop(const FlowPlace& at, double flow, double* slope) const noexcept override {
    double slope2;
    const double drop = first_->Drop(at, flow, slope) + second_->Drop(at, flow, &slope2);
    *slope += slope2;
    return drop;
  }
  // Drops rise with flow: Newton from the smaller of the two single flows, inside [0, that].
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    double s1, s2;
    const double q1 = first_->Flow(at, dp, &s1), q2 = second_->Flow(at, dp, &s2);
    double outer = std::abs(q1) < std::abs(q2) ? q1 : q2, inner = 0, q = outer;
    double rise = 1;
    for (int i = 0; i < 60; ++i) {
      const double error = Drop(at, q, &rise) - dp;
      ((error > 0) == (dp > 0) ? outer : inner) = q;
      double next = q - error / rise;
      if ((next - inner) * (next - outer) > 0) next = 0.5 * (inner + outer);
      const double change = std::abs(next - q);
      q = next;
      if (change <= 1e-14 * std::abs(q)) break;
    }
    Drop(at, q, &rise);
    *slope = 1 / rise;
    return q;
  }
  double Inertance() const noexcept override { return first_->Inertance() + second_->Inertance(); }
  bool SolvedByDrop() const noexcept override { return true; }

 private:
  std::unique_ptr<FlowLaw> first_, second_;
};

}  // namespace

double CalcLaminarResistance(double viscosity_Pas, double length_m, double bore_m) {
  return 128 * viscosity_Pas * length_m / (M_PI * std::pow(bore_m, 4));
}

double CalcTurbulentResistance(double density_kg_m3, double length_m, double bore_m) {
  const double area = M_PI / 4 * bore_m * bore_m;
  return 0.03164 * density_kg_m3 * length_m / (2 * bore_m * area * area);
}

double CalcInertance(double density_kg_m3, double length_m, double bore_m) {
  return density_kg_m3 * length_m / (M_PI / 4 * bore_m * bore_m);
}

double PipeFlow::Drop(const FlowPlace& at, double flow, double* slope) const noexcept {
  const Resistance& r = flow >= 0 ? forward_ : backward_;
  const double laminar = at.viscosity * r.laminar;
  *slope = laminar + 2 * r.turbulent * std::abs(flow);
  return (laminar + r.turbulent * std::abs(flow)) * flow;
}

double PipeFlow::Flow(const FlowPlace& at, double dp, double* slope) const noexcept {
  const Resistance& r = dp >= 0 ? forward_ : backward_;
  const double laminar = at.viscosity * r.laminar;
  const double root = std::sqrt(laminar * laminar + 4 * r.turbulent * std::abs(dp));
  *slope = 1 / root;
  return 2 * dp / (laminar + root);
}

double GapFlow::Opening(double time) const {
  return std::clamp((time - start_) / kOpening, 0.0, 1.0);
}

double GapFlow::Conductance(const FlowPlace& at, double dp) const {
  const double own = dp < 0 ? return_ratio_ * conductance_ : conductance_;
  return at.viscosity == 1 ? own : own * std::pow(at.viscosity, -ViscousShare(exponent_));
}

double GapFlow::Flow(const FlowPlace& at, double dp, double* slope) const noexcept {
  const double G = Opening(at.time) * Conductance(at, dp);
  if (exponent_ == 1) {
    *slope = G;
    return G * dp;
  }
  constexpr double kSmooth = 2e3;  // [Pa]
  const double square = dp * dp + kSmooth * kSmooth;
  const double factor = std::pow(square / (kReference * kReference), 0.5 * (exponent_ - 1));
  *slope = G * factor * (1 + (exponent_ - 1) * dp * dp / square);
  return G * factor * dp;
}

// A leak has no inertia, so its drop is never asked for in a run; Newton, for completeness of the
// law: the flow rises with dp.
double GapFlow::Drop(const FlowPlace& at, double flow, double* slope) const noexcept {
  double dp =
      kReference *
      std::copysign(std::pow(std::abs(flow) / (Conductance(at, flow) * kReference), 1 / exponent_),
                    flow);
  const FlowPlace open{std::max(at.time, start_ + kOpening), at.warmer, at.viscosity};
  double rise = 1;
  for (int i = 0; i < 50; ++i) {
    const double error = Flow(open, dp, &rise) - flow;
    dp -= error / rise;
    if (std::abs(error) <= 1e-14 * std::abs(flow)) break;
  }
  *slope = 1 / rise;
  return dp;
}

std::unique_ptr<FlowLaw> InSeries(std::unique_ptr<FlowLaw> first, std::unique_ptr<FlowLaw> second) {
  return std::make_unique<SeriesFlow>(std::move(first), std::move(second));
}

}  // namespace phs::hydraulics
