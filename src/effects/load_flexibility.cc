#include "effects/load_flexibility.h"

#include <cmath>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::Walk;

/// d = y - x of the flexible part: d" + 2 zeta w d' + w² d = -x", over samples of constant x".
class Oscillator {
 public:
  Oscillator(double frequency, double damping, double h) : w_(frequency), damping_(damping) {
    // exp([0 1; -w² -c] h) by a Taylor series over h/2^n, squared n times.
    int halvings = 0;
    double part = h;
    while (part * (w_ + damping_) > 0.1 && halvings < 60) part *= 0.5, ++halvings;
    double term[4] = {1, 0, 0, 1};
    for (int k = 1; k <= 8; ++k) {
      const double a = term[0], b = term[1], c = term[2], d = term[3];
      const double f = part / k;
      term[0] = -b * w_ * w_ * f, term[1] = (a - b * damping_) * f;
      term[2] = -d * w_ * w_ * f, term[3] = (c - d * damping_) * f;
      for (int i = 0; i < 4; ++i) step_[i] += term[i];
    }
    for (int k = 0; k < halvings; ++k) {
      const double a = step_[0], b = step_[1], c = step_[2], d = step_[3];
      step_[0] = a * a + b * c, step_[1] = b * (a + d);
      step_[2] = c * (a + d), step_[3] = b * c + d * d;
    }
  }
  /// Force of spring and damper on the drive, per mass [m/s2].
  double Pull() const { return -(w_ * w_ * d_ + damping_ * rate_); }
  void Advance(double acceleration) {
    // Around the particular solution d = -a/w².
    const double rest = -acceleration / (w_ * w_), e = d_ - rest;
    d_ = rest + step_[0] * e + step_[1] * rate_;
    rate_ = step_[2] * e + step_[3] * rate_;
  }

 private:
  double w_, damping_;
  double step_[4] = {1, 0, 0, 1};
  double d_ = 0, rate_ = 0;
};

class FlexiblePart final : public hydraulics::LoadLaw {
 public:
  explicit FlexiblePart(const EffectParams& effect)
      : mass_kg_(effect.values.at("mass_kg")),
        frequency_(2 * M_PI * effect.values.at("frequency_Hz")),
        damping_(2 * effect.values.at("damping_ratio") * frequency_) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    const std::vector<double>& a = motion.acceleration;
    Oscillator part(frequency_, damping_, motion.step_s);
    for (size_t i = 0; i < force->size(); ++i) {
      (*force)[i] += mass_kg_ * (part.Pull() - a[i]);
      if (i + 1 < force->size()) part.Advance(0.5 * (a[i] + a[i + 1]));
    }
  }

 private:
  double mass_kg_, frequency_, damping_;
};

Status InstallLoadFlexibility(const EffectParams& effect, Extension* extension) {
  if (!IsBenchPart(extension->params())) return NotABenchPart(effect.name);
  if (CountOf(effect.name, extension->params()) > 1) {
    return Error{"effects." + effect.name, "a second flexible part", "one"};
  }
  extension->AddLoad(std::make_unique<FlexiblePart>(effect));
  return {};
}

}  // namespace

const EffectInfo& LoadFlexibilityInfo() {
  static const EffectInfo info = {
      "load_flexibility",
      "element",
      "",
      "part of the mass behind a spring",
      {{"mass_kg", "kg", 1, 1e-9, 1e6, 1e-3, 1e4, "m_f"},
       {"frequency_Hz", "Hz", 20, 1e-3, 1e6, 0.5, 1e3, "f"},
       {"damping_ratio", "-", 0.05, 0, 10, 2e-3, 1, "zeta"}},
      InstallLoadFlexibility,
      {
          .bench =
              {
                  {.free = {{"mass_kg", 0.1, 0, 1, Walk::kEach, 1e-4, 2},
                            {"frequency_Hz", 8, 60, 3, Walk::kEach, 1, 400, true},
                            {"damping_ratio", 0.05, 0.3, 2, Walk::kEach, 2e-3, 2, true}},
                   .needs = {"element.mass"}},
              },
      }};
  return info;
}

}  // namespace phs::effects
