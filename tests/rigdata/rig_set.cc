#include "rig_set.h"

#include <algorithm>
#include <cmath>

namespace rigdata {
namespace {

constexpr double kLevelStep = 1e-3;   // s, for the noise levels only
constexpr double kRecordRate = 2000;  // Hz, before the measuring chain
constexpr double kFloorStep = 5e-4;   // s

double OffByTenToThirty(RandomSource& random) {
  return 1.0 + random.Sign() * random.Uniform(0.10, 0.30);
}

// The displacement at which a line of the rig reaches a pressure.
double DisplacementAt(const LineParams& params, double pressure) {
  const LineTruth line(params);
  return line.Volume(pressure, line.Initial(), 1.0, Surroundings{}, nullptr) / params.area;
}

MotionRange DrawRange(const RigParams& rig, bool deep, double duration, RandomSource random) {
  MotionRange range;
  range.duration = duration * random.Uniform(0.96, 1.03);
  range.estimation_share = random.Uniform(0.58, 0.66);
  range.low = DisplacementAt(rig.bore, random.Uniform(13.5e6, 16.5e6));
  const double blow_off = DisplacementAt(rig.rod, rig.rod.blow_off_precharge);
  range.high = blow_off + random.Uniform(0.1e-3, 0.4e-3);
  range.deep = range.high + random.Uniform(0.2e-3, 0.8e-3);
  if (deep || random.Uniform() < 0.25) {
    range.deep = std::max(range.deep, DisplacementAt(rig.bore, random.Uniform(0.30e6, 0.36e6)));
  }
  return range;
}

// What calibration and the final run share.
class SetBuilder {
 public:
  explicit SetBuilder(const SetWish& wish);
  RigSet Build();

 private:
  // RMS that the refitted declared model leaves, over the floor, in the worst channel.
  double SizeOverNoise(const TrueRig& rig, double step) const;
  double Calibrate(const HiddenEffect& effect, double target) const;
  void EstimateLevels();
  void MoveBy(const SampledMotion& motion);
  Record Readings(const TrueRig& rig, const ActuatorInput& input, double step, double rate) const;
  ChannelNumbers Rmse(const Record& a, const Record& b) const;
  void MeasureFloors(const TrueRig& rig, const Record& readings);

  RigSet set_;
  TrueRig base_;
  std::vector<HiddenEffect> effects_;
  DrawnMotion drawn_;
  ActuatorInput input_;
  ChannelNumbers level_{};
};

SetBuilder::SetBuilder(const SetWish& wish) {
  set_.wish = wish;
  RandomSource base(wish.seed, "base");
  set_.base = {OffByTenToThirty(base), OffByTenToThirty(base), OffByTenToThirty(base),
               OffByTenToThirty(base), OffByTenToThirty(base)};
  base_.rig = DeclaredRig(set_.base);
  set_.noise = DrawNoise(RandomSource(wish.seed, "noise level"));
  bool deep = false;
  TrueRig sized = base_;
  for (const EffectWish& e : wish.effects) {
    effects_.push_back(DrawEffect(e.name, RandomSource(wish.seed, e.name)));
    deep = deep || effects_.back().wants_deep;
    // These two decide how far the actuator may go before a pressure leaves the sensor's range.
    if (e.name == "accumulator_precharge" || e.name == "diaphragm_stop") {
      effects_.back().apply(1.0, &sized);
    }
  }
  const MotionRange range =
      DrawRange(sized.rig, deep, wish.duration, RandomSource(wish.seed, "range"));
  drawn_ = DrawMotion(range, RandomSource(wish.seed, "motion"));
  input_.position = [this](double t) { return drawn_.motion.Position(t); };
  set_.estimation = {0, drawn_.split};
  set_.validation = {drawn_.split, drawn_.duration};
  if (!wish.motion.position.empty()) MoveBy(wish.motion);
}

void SetBuilder::MoveBy(const SampledMotion& motion) {
  input_.position = [motion](double t) { return motion.Position(t); };
  drawn_.duration = motion.Duration();
  drawn_.split = 0.75 * drawn_.duration;
  set_.estimation = {0, drawn_.split};
  set_.validation = {drawn_.split, drawn_.duration};
}

Record SetBuilder::Readings(const TrueRig& rig, const ActuatorInput& input, double step,
                            double rate) const {
  const RigSignals signals = Simulate(rig.rig, input, {step, rate, drawn_.duration});
  return Read(signals, rig.sensors, rate);
}

ChannelNumbers SetBuilder::Rmse(const Record& a, const Record& b) const {
  ChannelNumbers sum{};
  long count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a.t[i] < set_.validation.begin || a.t[i] >= set_.validation.end) continue;
    ++count;
    for (int c = 0; c < kChannels; ++c) {
      const double e = a.channel[c][i] - b.channel[c][i];
      sum[c] += e * e;
    }
  }
  for (double& s : sum) s = std::sqrt(s / static_cast<double>(std::max(1L, count)));
  return sum;
}

// The floor before anything is hidden: noise, and what noise on the actuator does to the rest.
void SetBuilder::EstimateLevels() {
  const Record readings = Readings(base_, input_, kLevelStep, 1.0 / kLevelStep);
  const Record noisy =
      AddNoise(readings, set_.noise, RandomSource(set_.wish.seed, "noise for levels"));
  const MotionEstimate motion =
      EstimateMotion(noisy.channel[kActuator], 200, NoiseLevel(set_.noise[kActuator]), 2.0);
  level_ = DeclaredError(set_.base, noisy, motion, set_.validation);
}

double SetBuilder::SizeOverNoise(const TrueRig& rig, double step) const {
  const double rate = 1000;
  const RigSignals signals = Simulate(rig.rig, input_, {step, rate, drawn_.duration});
  const Record readings = Read(signals, rig.sensors, rate);
  MotionEstimate motion;
  for (size_t i = 0; i < readings.size(); ++i) {
    const size_t k = i * static_cast<size_t>(rate / motion.rate);
    const double before = k > 0 ? signals.actuator[k - 1] : signals.actuator[k];
    motion.x.push_back(signals.actuator[k]);
    motion.v.push_back((signals.actuator[k] - before) * rate);
  }
  const DeclaredFactors fitted = FitDeclared(readings, motion, set_.estimation, level_);
  const ChannelNumbers left = DeclaredError(fitted, readings, motion, set_.validation);
  double worst = 0;
  for (const Channel c : {kPiston, kLoad, kPBore, kPRod}) {
    worst = std::max(worst, left[c] / level_[c]);
  }
  return worst;
}

// Secant in logarithms for the size whose effect is `target` times the floor.
double SetBuilder::Calibrate(const HiddenEffect& effect, double target) const {
  const auto measure = [&](double size) {
    TrueRig rig = base_;
    effect.apply(size, &rig);
    return std::log(std::max(1e-6, SizeOverNoise(rig, effect.calibration_step)) / target);
  };
  const double lowest = std::log(effect.smallest), highest = std::log(effect.largest);
  double a = std::clamp(0.0, lowest, highest), fa = measure(std::exp(a));
  double b = std::clamp(a - fa, lowest, highest);
  for (int i = 0; i < 6 && std::abs(fa) > 0.08 && b != a; ++i) {
    const double fb = measure(std::exp(b));
    // The slope is near 1; keep it sane where the effect saturates or the refit swallows it.
    const double slope = std::clamp((fb - fa) / (b - a), 0.35, 3.0);
    a = b;
    fa = fb;
    b = std::clamp(a - fa / slope, lowest, highest);
  }
  return std::exp(a);
}

void SetBuilder::MeasureFloors(const TrueRig& rig, const Record& readings) {
  set_.noise_only = Rmse(readings, set_.record);
  bool first = true;
  for (const double confidence : {1.2, 2.0, 3.0}) {
    MotionEstimate motion = EstimateMotion(set_.record.channel[kActuator], 200,
                                           NoiseLevel(set_.noise[kActuator]), confidence);
    if (!rig.rig.mount.rigid && confidence > 1.5) motion.MakeConsistent(0.01 * confidence);
    const Record predicted = Readings(rig, motion.Input(), kFloorStep, 1.0 / kFloorStep);
    const ChannelNumbers error = Rmse(predicted, set_.record);
    for (int c = 0; c < kChannels; ++c) {
      set_.floor[c] = first ? error[c] : std::min(set_.floor[c], error[c]);
    }
    first = false;
  }
  const MotionEstimate motion =
      EstimateMotion(set_.record.channel[kActuator], 200, NoiseLevel(set_.noise[kActuator]), 2.0);
  const DeclaredFactors fitted = FitDeclared(set_.record, motion, set_.estimation, level_);
  set_.declared = DeclaredError(fitted, set_.record, motion, set_.validation);
}

RigSet SetBuilder::Build() {
  EstimateLevels();
  RandomSource grade(set_.wish.seed, "grade");
  TrueRig rig = base_;
  for (size_t i = 0; i < effects_.size(); ++i) {
    const HiddenEffect& effect = effects_[i];
    HiddenTruth truth;
    truth.name = effect.name;
    truth.form = effect.form;
    truth.listed = effect.listed;
    truth.grade = set_.wish.effects[i].grade;
    const double asked = set_.wish.effects[i].over_noise;
    const double target = asked > 0 ? asked
                          : truth.grade == Grade::kStrong
                              ? grade.LogUniform(effect.strong_low, effect.strong_high)
                              : grade.Uniform(0.9, 1.9);
    const double size = Calibrate(effect, target);
    TrueRig alone = base_;
    effect.apply(size, &alone);
    truth.size_over_noise = SizeOverNoise(alone, effect.calibration_step);
    truth.numbers = effect.apply(size, &rig);
    set_.hidden.push_back(truth);
  }
  if (!set_.wish.then.position.empty()) MoveBy(set_.wish.then);
  const Record readings = Readings(rig, input_, set_.wish.final_step, kRecordRate);
  set_.record = AddNoise(readings, set_.noise, RandomSource(set_.wish.seed, "noise"));
  MeasureFloors(rig, readings);
  return set_;
}

}  // namespace

RigSet MakeRigSet(const SetWish& wish) { return SetBuilder(wish).Build(); }

}  // namespace rigdata
