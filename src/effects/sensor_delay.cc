#include "effects/sensor_delay.h"

#include <cmath>
#include <memory>
#include <utility>

#include "effects/formula_laws.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Sensor;
using hydraulics::Walk;

class Delay final : public hydraulics::ReadingLaw {
 public:
  explicit Delay(double delay_s) : delay_s_(delay_s) {}
  // Between samples linear; before the first sample the first value holds.
  void Lag(double step, std::vector<double>* values) const override {
    std::vector<double>& y = *values;
    const double shift = delay_s_ / step;
    for (size_t i = y.size(); i-- > 0;) {
      const double at = static_cast<double>(i) - shift;
      if (at <= 0) {
        y[i] = y[0];
        continue;
      }
      const size_t k = static_cast<size_t>(at);
      const double part = at - static_cast<double>(k);
      y[i] = part > 0 ? y[k] + part * (y[k + 1] - y[k]) : y[k];
    }
  }

 private:
  double delay_s_;
};

/// Lags of first order one behind the other, exact where the signal is straight between samples. Of a
/// broken number of them the mean of both filters about it.
class Filter final : public hydraulics::ReadingLaw {
 public:
  Filter(double delay_s, double poles) : delay_s_(delay_s), poles_(std::max(poles, 1.0)) {}
  void Lag(double step, std::vector<double>* values) const override {
    const double fewer = std::floor(poles_), part = poles_ - fewer;
    std::vector<double> more = *values;
    Lag(step, fewer, values);
    if (part == 0) return;
    Lag(step, fewer + 1, &more);
    for (size_t i = 0; i < more.size(); ++i) (*values)[i] += part * (more[i] - (*values)[i]);
  }

 private:
  void Lag(double step, double poles, std::vector<double>* values) const {
    // y' = (u - y)/T over a step: y = u - T u' + (y_0 - u_0 + T u') exp(-step/T).
    const double time = delay_s_ / poles, fade = std::exp(-step / time);
    for (int pole = 0; pole < poles; ++pole) {
      double before = values->empty() ? 0 : values->front(), shown = before;
      for (double& u : *values) {
        const double behind = time * (u - before) / step;
        shown = u - behind + (shown - before + behind) * fade;
        before = u, u = shown;
      }
    }
  }
  double delay_s_, poles_;
};

/// T² y'' + 2 D T y' + y = u, D < 1, exact where u is straight between samples. Behind a bubble T
/// goes with the pressure that is shown; over a step it is that of its middle. Of what it rings by
/// a share is shown.
class Ringing final : public hydraulics::ReadingLaw {
 public:
  Ringing(double time_s, double damping, double bubble, double share)
      : time_(time_s), damping_(damping), bubble_(bubble), share_(share) {}
  void Lag(double step, std::vector<double>* values) const override {
    Swing swing = Over(step, time_);
    double before = values->empty() ? 0 : values->front(), shown = before, rate = 0;
    for (double& u : *values) {
      if (bubble_ != 0) swing = Over(step, At(shown + 0.5 * step * rate));
      // On u = u_0 + u' t it goes after u - 2 D T u'; what it is off by, e, rings out.
      const double rise = (u - before) / step, behind = 2 * damping_ * swing.time * rise;
      const double e = shown - (before - behind), de = rate - rise;
      shown = u - behind + e * (swing.cosine + swing.decay * swing.sine) + de * swing.sine;
      rate = rise - e * swing.sine / (swing.time * swing.time) +
             de * (swing.cosine - swing.decay * swing.sine);
      before = u, u += share_ * (shown - u);
    }
  }

 private:
  struct Swing {
    double time, decay;   ///< T, D/T
    double cosine, sine;  ///< exp(-D h/T) cos(w h), exp(-D h/T) sin(w h)/w, w = √(1 - D²)/T
  };
  Swing Over(double step, double time) const {
    const double w = std::sqrt(1 - damping_ * damping_) / time, decay = damping_ / time;
    const double fade = std::exp(-decay * step);
    return {time, decay, fade * std::cos(w * step), fade * std::sin(w * step) / w};
  }
  double At(double pressure) const {
    constexpr double kStatedAt = 2e6, kLeast = 1e4;  // Pa
    return time_ * std::pow(std::max(pressure, kLeast) / kStatedAt, -bubble_);
  }
  double time_, damping_, bubble_, share_;
};

Status InstallSensorDelay(const EffectParams& effect, Extension* extension) {
  const double poles = effect.values.at("poles"), damping = effect.values.at("damping");
  if (poles > 0 && damping > 0) {
    return RefuseEffect(effect, "poles and damping", "one of them: a filter, or one that rings");
  }
  for (const int i : TargetCylinders(effect, extension->params())) {
    for (const auto& [sensor, key] : {std::pair(Sensor::kLoad, "load_s"),
                                      {Sensor::kBorePressure, "p_bore_s"},
                                      {Sensor::kRodPressure, "p_rod_s"},
                                      {Sensor::kPiston, "piston_s"}}) {
      const double time = effect.values.at(key);
      if (time == 0) continue;
      const bool gauge = sensor == Sensor::kBorePressure || sensor == Sensor::kRodPressure;
      std::unique_ptr<const hydraulics::ReadingLaw> law;
      if (damping > 0) {
        law = std::make_unique<Ringing>(time, damping, gauge ? effect.values.at("bubble") : 0,
                                        effect.values.at("share"));
      } else if (poles > 0) {
        law = std::make_unique<Filter>(time, poles);
      } else {
        law = std::make_unique<Delay>(time);
      }
      extension->AddReading(i, sensor, std::move(law));
    }
  }
  return {};
}

}  // namespace

const EffectInfo& SensorDelayInfo() {
  static const EffectInfo info = {
      "sensor_delay",
      "instrument",
      "cylinders",
      "shown(t) = true(t - delay), or as a filter with that delay of slow signals, or ringing",
      {
          {"load_s", "s", 0, 0, 100, 0, 0.2, "load cell"},
          {"p_bore_s", "s", 0, 0, 100, 0, 0.2, "bore pressure"},
          {"p_rod_s", "s", 0, 0, 100, 0, 0.2, "rod pressure"},
          {"piston_s", "s", 0, 0, 100, 0, 0.2, "piston"},
          {"poles", "-", 0, 0, 20, 0.8, 10,
           "of the filter, all alike, 1 at least; 0: a pure delay"},
          {"damping", "-", 0, 0, 0.99, 0.02, 0.8,
           "D of a channel that rings, T = its time: T² y'' + 2 D T y' + y = true; 0: it does not"},
          {"bubble", "-", 0, -2, 2, -0.2, 1, "n of a gauge that rings, T at 2 MPa: T ~ p^-n"},
          {"share", "-", 1, -10, 10, -2, 2, "of what a channel rings by; the rest follows"},
      },
      InstallSensorDelay,
      {
          .rig =
              {
                  {.free = {{"load_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_rod_s", 2e-3, 0.02, 2}}},
                  {.free = {{"p_bore_s", 2e-3, 0.02, 2},
                            {"p_rod_s", 2e-3, 0.02, 2, Walk::kInStep}}},
                  {.free = {{"piston_s", 2e-3, 0.02, 2}}},
                  {.free = {{"load_s", 4e-3, 0.05, 4}, {"damping", 0.3}}},
                  {.free = {{"load_s", 4e-3, 0.05, 4}, {"damping", 0.1}, {"share", -0.3, 0.3, 2}}},
                  {.free = {{"p_bore_s", 4e-3, 0.05, 4}, {"damping", 0.3}}},
                  {.free = {{"p_rod_s", 4e-3, 0.05, 4}, {"damping", 0.3}}},
              },
          .bench =
              {
                  {.free = {{"load_s", 1e-3, 0.01, 2, Walk::kEach, 0, 0.2, true}}},
              },
          .options =
              {
                  {.free = {{"poles", 2}}, .without = "damping"},
                  {.free = {{"bubble", 0.4}}, .with = "damping"},
              },
      }};
  return info;
}

}  // namespace phs::effects
