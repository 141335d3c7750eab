#include "rig_truth.h"

#include <cmath>

#include "motion.h"

namespace rigdata {
namespace {

constexpr double kOilExpansion = 6.6e-4;      // 1/K, oil less steel
constexpr double kComplianceGrowth = 4.0e-3;  // 1/K

class RigRun {
 public:
  RigRun(const RigParams& params, const ActuatorInput& actuator, double step)
      : params_(params),
        actuator_(actuator),
        h_(step),
        bore_(params.bore),
        rod_(params.rod),
        friction_(params.friction),
        mount_(params.mount) {
    state_.bore = bore_.Initial();
    state_.rod = rod_.Initial();
    state_.actuator = state_.piston = actuator_.position(0);
  }

  void Step(double t_end);
  void Record(double t, RigSignals* out) const;

 private:
  struct State {
    LineState bore, rod;
    FrictionState friction;
    MountState mount;
    double actuator = 0, piston = 0, speed = 0, load = 0, friction_force = 0;
  };

  Surroundings At(double t) const;
  // Force of the cylinder with everything in line with it: piston at x with speed v.
  double CylinderForce(double x, double v, double t, const Surroundings& s, State* next) const;
  double Excess(double v, double t, const Surroundings& s, State* next) const;
  double SolveSpeed(double t, const Surroundings& s, State* next) const;

  RigParams params_;
  const ActuatorInput& actuator_;
  double h_;
  LineTruth bore_, rod_;
  FrictionTruth friction_;
  MountTruth mount_;
  State state_;
};

Surroundings RigRun::At(double t) const {
  const EnvironmentParams& e = params_.environment;
  double warming = 0;
  switch (e.form) {
    case WarmingForm::kNone:
      return {};
    case WarmingForm::kRamp:
      warming = e.warming * t / 120.0;
      break;
    case WarmingForm::kSettling:
      warming = e.warming * (1.0 - std::exp(-t / e.tau));
      break;
    case WarmingForm::kWave:
      warming = e.warming * std::sin(kTwoPi * t / (4.0 * e.tau));
      break;
  }
  return {kT0 + e.gas_share * warming, kOilExpansion * warming, kComplianceGrowth * warming};
}

double RigRun::CylinderForce(double x, double v, double t, const Surroundings& s,
                             State* next) const {
  next->piston = x;
  next->speed = v;
  next->bore = bore_.Solve(state_.bore, x, h_, s);
  next->rod = rod_.Solve(state_.rod, x, h_, s);
  const FrictionInput in{x, v, (v - state_.speed) / h_, next->bore.p_chamber, next->rod.p_chamber};
  next->friction_force = friction_.Force(state_.friction, in, h_, &next->friction);
  double force = in.p_rod * kRodArea * (1.0 + params_.rod_area_error) -
                 in.p_bore * kBoreArea * (1.0 + params_.bore_area_error) + next->friction_force;
  const RippleParams& r = params_.ripple;
  if (r.amplitude != 0) {
    const double cycles = r.wavelength > 0 ? x / r.wavelength : r.frequency * t;
    force += r.amplitude * std::sin(kTwoPi * cycles + r.phase);
  }
  return force;
}

double RigRun::Excess(double v, double t, const Surroundings& s, State* next) const {
  const double force = CylinderForce(state_.piston + h_ * v, v, t, s, next);
  next->load = mount_.Force(state_.mount, next->actuator - next->piston, h_, &next->mount);
  return next->load - force;
}

// The excess falls monotonically with v: bracket from the last speed, then Illinois' rule.
double RigRun::SolveSpeed(double t, const Surroundings& s, State* next) const {
  double a = state_.speed, fa = Excess(a, t, s, next);
  double width = 1e-5;
  double b = a, fb = fa;
  for (int i = 0; i < 60 && fa * fb > 0; ++i) {
    a = b;
    fa = fb;
    b = a + (fa > 0 ? width : -width);
    fb = Excess(b, t, s, next);
    width *= 3;
  }
  for (int i = 0; i < 100; ++i) {
    if (std::abs(b - a) < 1e-12) break;
    double c = (fa == fb) ? 0.5 * (a + b) : (fa * b - fb * a) / (fa - fb);
    if (i % 8 == 7) c = 0.5 * (a + b);
    const double fc = Excess(c, t, s, next);
    if (std::abs(fc) < 1e-5) return c;
    if (fc * fb < 0) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = c;
    fb = fc;
  }
  Excess(b, t, s, next);
  return b;
}

void RigRun::Step(double t_end) {
  State next = state_;
  next.actuator = actuator_.position(t_end);
  const Surroundings s = At(t_end);
  if (mount_.rigid()) {
    const double v =
        actuator_.speed ? actuator_.speed(t_end) : (next.actuator - state_.piston) / h_;
    next.load = CylinderForce(next.actuator, v, t_end, s, &next);
  } else {
    SolveSpeed(t_end, s, &next);
  }
  const double cross = params_.piston_leak.Flow(next.bore.p_chamber - next.rod.p_chamber);
  bore_.Advance(next.bore, state_.bore, h_, cross, s);
  rod_.Advance(next.rod, state_.rod, h_, -cross, s);
  state_ = next;
}

void RigRun::Record(double t, RigSignals* out) const {
  out->t.push_back(t);
  out->actuator.push_back(state_.actuator);
  out->piston.push_back(state_.piston);
  out->speed.push_back(state_.speed);
  out->load.push_back(state_.load);
  out->p_bore.push_back(state_.bore.p_chamber);
  out->p_rod.push_back(state_.rod.p_chamber);
  out->friction.push_back(state_.friction_force);
}

}  // namespace

RigParams NominalRig() {
  RigParams rig;
  rig.bore.area = -kBoreArea;
  rig.bore.p0 = 1.8e6;
  rig.rod.area = kRodArea;
  rig.rod.p0 = 1.8e6 * kBoreArea / kRodArea;
  rig.rod.blow_off_volume = 0.75e-3;
  return rig;
}

RigSignals Simulate(const RigParams& params, const ActuatorInput& actuator,
                    const Integration& integration) {
  const long per_sample = std::lround(1.0 / (integration.rate * integration.step));
  const double h = 1.0 / (integration.rate * static_cast<double>(per_sample));
  const long samples = std::lround(integration.duration * integration.rate);
  RigRun run(params, actuator, h);
  RigSignals out;
  // The first sample is taken after one step at rest, so that every channel is defined.
  run.Step(0);
  run.Record(0, &out);
  for (long i = 1; i < samples; ++i) {
    for (long k = 1; k <= per_sample; ++k) {
      run.Step(static_cast<double>((i - 1) * per_sample + k) * h);
    }
    run.Record(static_cast<double>(i) / integration.rate, &out);
  }
  return out;
}

}  // namespace rigdata
