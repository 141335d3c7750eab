// One data set: a true rig off the declared one by 10–30 % in every free parameter, with nothing,
// one effect or two hidden in it, its motion, its record, and what is known about the truth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "declared_refit.h"
#include "hidden_effect.h"
#include "motion.h"

namespace rigdata {

enum class Grade { kStrong, kWeak };

struct EffectWish {
  std::string name;
  Grade grade = Grade::kStrong;
  double over_noise = 0;  // > 0: the size over noise to aim at, whatever the grade
};

struct SetWish {
  std::vector<EffectWish> effects;  // empty: a clean set
  uint64_t seed = 1;
  double duration = 126;     // s
  double final_step = 5e-5;  // s
  // Where given, the effects are scaled on this motion in place of a drawn one, …
  SampledMotion motion;
  // … and the record is made on this one.
  SampledMotion then;
};

struct HiddenTruth {
  std::string name, form;
  bool listed = true;
  Grade grade = Grade::kStrong;
  double size_over_noise = 0;  // RMS left by the best declared model / floor, worst channel
  NumberList numbers;
};

using ChannelNumbers = std::array<double, kChannels>;

struct RigSet {
  SetWish wish;
  DeclaredFactors base;  // factors on the declared values
  NoiseSet noise;
  Record record;
  Window estimation, validation;
  std::vector<HiddenTruth> hidden;
  // RMSE on the validation window:
  ChannelNumbers floor{};       // true model driven by the measured actuator motion
  ChannelNumbers noise_only{};  // true model driven by the true motion
  ChannelNumbers declared{};    // declared model refitted
};

RigSet MakeRigSet(const SetWish& wish);

}  // namespace rigdata
