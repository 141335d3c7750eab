#include "hydraulics/pipe.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace phs::hydraulics {
namespace {

/// Term of Zielke's weight.
struct WallTerm {
  double n, m;
};
/// Those of a line; faster ones (n > 1e4: beyond a kilohertz in a hose) follow at once what a line
/// does and are the rest of a third of the inertance.
constexpr WallTerm kWall[] = {{26.3744, 1.0},     {72.8033, 1.16725}, {187.424, 2.20064},
                              {536.626, 3.92861}, {1570.60, 6.78788}, {4618.13, 11.6761}};

/// Inertance of the faster terms over the oil's own.
double FasterTerms() {
  double rest = 1.0 / 3;
  for (const WallTerm& term : kWall) rest -= 4 * term.m / term.n;
  return rest;
}

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
  double Flow(const FlowPlace& at, double dp, double* slope) const noexcept override {
    return first_->SolvedByDrop() ? FlowByFlow(at, dp, slope) : FlowByDrop(at, dp, slope);
  }
  double Inertance() const noexcept override { return first_->Inertance() + second_->Inertance(); }
  int num_lags() const noexcept override { return first_->num_lags() + second_->num_lags(); }
  FlowLag Lag(const FlowPlace& at, int lag) const noexcept override {
    const int own = first_->num_lags();
    return lag < own ? first_->Lag(at, lag) : second_->Lag(at, lag - own);
  }
  bool SolvedByDrop() const noexcept override { return true; }

 private:
  static constexpr int kMostSteps = 60;

  // Of what is sought between `inner` and `outer`; false once it is found.
  static bool Step(double error, double rise, double dp, double* inner, double* outer, double* x) {
    ((error > 0) == (dp > 0) ? *outer : *inner) = *x;
    double next = *x - error / rise;
    if ((next - *inner) * (next - *outer) > 0) next = 0.5 * (*inner + *outer);
    const double change = std::abs(next - *x);
    *x = next;
    return change > 1e-14 * std::abs(*x);
  }
  // Drops rise with flow: Newton from the smaller of the two single flows, inside [0, that].
  double FlowByFlow(const FlowPlace& at, double dp, double* slope) const noexcept {
    double s1, s2;
    const double q1 = first_->Flow(at, dp, &s1), q2 = second_->Flow(at, dp, &s2);
    double outer = std::abs(q1) < std::abs(q2) ? q1 : q2, inner = 0, q = outer;
    double rise = 1;
    for (int i = 0; i < kMostSteps; ++i) {
      const double error = Drop(at, q, &rise) - dp;
      if (!Step(error, rise, dp, &inner, &outer, &q)) break;
    }
    Drop(at, q, &rise);
    *slope = 1 / rise;
    return q;
  }
  // The first has no closed drop, but a closed flow: Newton for its share of the drop, in [0, dp].
  double FlowByDrop(const FlowPlace& at, double dp, double* slope) const noexcept {
    double outer = dp, inner = 0, share = dp;
    double light, rise;
    for (int i = 0; i < kMostSteps; ++i) {
      const double flow = first_->Flow(at, share, &light);
      const double error = share + second_->Drop(at, flow, &rise) - dp;
      if (!Step(error, 1 + rise * light, dp, &inner, &outer, &share)) break;
    }
    const double flow = first_->Flow(at, share, &light);
    second_->Drop(at, flow, &rise);
    *slope = light / (1 + rise * light);
    return flow;
  }
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

PipeFlow::PipeFlow(Resistance forward, Resistance backward, double inertance, double unsteady)
    : forward_(forward),
      backward_(backward),
      oil_inertance_(inertance),
      inertance_(inertance * (1 + unsteady * FasterTerms())),
      unsteady_(unsteady) {}

int PipeFlow::num_lags() const noexcept {
  return unsteady_ > 0 && inertance_ > 0 ? static_cast<int>(std::size(kWall)) : 0;
}

FlowLag PipeFlow::Lag(const FlowPlace& at, int lag) const noexcept {
  const double laminar = at.viscosity * forward_.laminar;
  const WallTerm& term = kWall[lag];
  return {term.n * laminar / (8 * oil_inertance_), unsteady_ * term.m * laminar / 2};
}

// [Pa] Below that a gap's flow is about linear.
constexpr double kSmooth = 2e3;

double GapFlow::Opening(double time) const {
  return std::clamp((time - start_) / kOpening, 0.0, 1.0);
}

double GapFlow::Conductance(const FlowPlace& at, double dp) const {
  const double own = dp < 0 ? return_ratio_ * conductance_ : conductance_;
  return at.viscosity == 1 ? own : own * std::pow(at.viscosity, -ViscousShare(exponent_));
}

double GapFlow::Flow(const FlowPlace& at, double dp, double* slope) const noexcept {
  if (opening_Pa_ > 0 && dp <= opening_Pa_) return *slope = 0;
  return FlowBeyond(at, dp - opening_Pa_, slope);
}

double GapFlow::FlowBeyond(const FlowPlace& at, double dp, double* slope) const {
  const double G = Opening(at.time) * Conductance(at, dp);
  if (exponent_ == 1) {
    *slope = G;
    return G * dp;
  }
  const double square = dp * dp + kSmooth * kSmooth;
  const double factor = std::pow(square / (kReference * kReference), 0.5 * (exponent_ - 1));
  *slope = G * factor * (1 + (exponent_ - 1) * dp * dp / square);
  return G * factor * dp;
}

// With L = ln|d| the law is n L + (n-1)/2 ln(1 + s²/d²) = ln(|q|/G) + (n-1) ln p_ref, between two
// straight lines: that of a d far beyond s, and of one far below. Newton from the nearer of them
// meets it from one side, mostly in two steps.
double GapFlow::Drop(const FlowPlace& at, double flow, double* slope) const noexcept {
  const double G = Conductance(at, flow), n1 = exponent_ - 1;
  double each = 1 / (G * std::pow(kSmooth / kReference, n1));  // d over q, at rest
  double log_d = -INFINITY, square = 0;
  if (flow != 0) {
    const double known = std::log(std::abs(flow) / G) + n1 * std::log(kReference);
    const double far = known / exponent_, near = known - n1 * std::log(kSmooth);
    log_d = n1 < 0 ? std::max(far, near) : std::min(far, near);
    for (int i = 0; i < 20; ++i) {
      square = std::exp(2 * log_d);
      const double both = square + kSmooth * kSmooth;
      const double error = log_d + 0.5 * n1 * std::log(both) - known;
      const double step = error / (1 + n1 * square / both);
      log_d -= step;
      if (std::abs(step) < 1e-8) break;  // the next would be its square
    }
    each = std::exp(log_d) / std::abs(flow);
  }
  *slope = each / (1 + n1 * square / (square + kSmooth * kSmooth));
  return opening_Pa_ + each * flow;
}

double PoppetFlow::Drop(const FlowPlace&, double flow, double* slope) const noexcept {
  const double P = flow >= 0 ? forward_ : backward_, root = std::hypot(flow, lifted_);
  *slope = P * lifted_ * lifted_ / (root * root * root);
  return P * flow / root;
}

// d = dp/P: q = q0 d/sqrt(1 - d²), short of d = 1 kept finite.
double PoppetFlow::Flow(const FlowPlace&, double dp, double* slope) const noexcept {
  constexpr double kMost = 1 - 1e-12;
  const double P = dp >= 0 ? forward_ : backward_;
  const double d = P > 0 ? std::clamp(dp / P, -kMost, kMost) : std::copysign(kMost, dp);
  const double left = 1 - d * d;
  *slope = lifted_ / (std::max(P, 1e-6) * left * std::sqrt(left));
  return lifted_ * d / std::sqrt(left);
}

std::unique_ptr<FlowLaw> InSeries(std::unique_ptr<FlowLaw> first, std::unique_ptr<FlowLaw> second) {
  return std::make_unique<SeriesFlow>(std::move(first), std::move(second));
}

}  // namespace phs::hydraulics
