// A small record of the quarter rig, made with the rig model itself, and the search on it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>

#include "identify/models/rig_forward.h"
#include "identify/select/effect_search.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

/// 60 s at 100 Hz of the motion x(t); white sensor noise.
inline measurement::FitData RecordOf(const hydraulics::PhsParams& truth,
                                     const std::function<double(double t)>& x) {
  measurement::FitData data;
  data.step_s = 0.01;
  data.estimation = {0, 40};
  data.validation = {40, 60};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  rigs::RigMotion motion{0, data.step_s, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 6000; ++i) {
    const double t = i * data.step_s;
    data.time_s.push_back(t);
    motion.position_m[0].push_back(x(t));
  }
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, truth);
  rigs::RigPrediction clean;
  EXPECT_TRUE(rig.value().Run(motion, &clean).ok());
  data.inputs.push_back({"actuator_m", motion.position_m[0], 5e-7});
  for (double& x : data.inputs[0].values) x += 5e-7 * normal(random);
  data.motion.push_back(measurement::SmoothPosition(data.inputs[0].values, {}, data.step_s, 5e-7));
  const double noise[] = {1.5e-6, 40, 1e4, 1e4};
  for (size_t c = 0; c < 4; ++c) {
    data.outputs.push_back({rig.value().output_names()[c], clean.channels[c], noise[c]});
    for (double& y : data.outputs.back().values) y += noise[c] * normal(random);
  }
  return data;
}

/// Sines of two speeds, holds at rest (or not: they begin at once, from full speed).
inline measurement::FitData Record(const hydraulics::PhsParams& truth, bool holds = true) {
  return RecordOf(truth, [holds](double t) {
    const double phase = std::fmod(t, 20.0);
    return phase < 16 || !holds
               ? 2e-3 * std::sin(2 * M_PI * phase / 4) + 4e-4 * std::sin(2 * M_PI * phase)
               : 0;
  });
}

/// What the search without formulas finds for the quarter rig of setup 2.
inline Identification FoundBy(std::shared_ptr<const ForwardModel> forward) {
  const hydraulics::PhsParams declared = phs_model::FindPhsParams("quarter_setup2").value();
  auto problem = FitProblem::Create(std::move(forward), declared);
  EXPECT_TRUE(problem.ok());
  SearchOptions options;
  options.formula = false;
  auto found = Identify(&problem.value(), declared, options, {});
  EXPECT_TRUE(found.ok());
  return found.value();
}

/// `data` must outlive it.
inline Result<FitProblem> ProblemOf(const measurement::FitData& data,
                                    const hydraulics::PhsParams& declared) {
  auto rig = RigForward::Create(data, declared);
  if (!rig.ok()) return rig.error();
  return FitProblem::Create(rig.value(), declared);
}

inline Channels PredictWhole(const measurement::FitData& data,
                             const hydraulics::PhsParams& params) {
  Channels out;
  const auto rig = RigForward::Create(data, params);
  EXPECT_TRUE(rig.ok() && rig.value()->Run(params, ForwardModel::Span::kWhole, &out).ok());
  return out;
}

inline Identification Find(const hydraulics::PhsParams& declared, const measurement::FitData& data,
                           const SearchOptions& options = {}) {
  auto problem = ProblemOf(data, declared);
  auto found = Identify(&problem.value(), declared, options, nullptr);
  EXPECT_TRUE(found.ok());
  return found.value();
}

/// The same, with these effects offered; with PHS_LONG_TESTS set, the whole catalogue.
inline Identification FindAmong(std::vector<std::string> offered, measurement::FitData data,
                                const SearchOptions& options = {}) {
  const hydraulics::PhsParams declared = phs_model::FindPhsParams("quarter_setup2").value();
  if (std::getenv("PHS_LONG_TESTS") == nullptr) data.candidates = std::move(offered);
  return Find(declared, data, options);
}

/// What was found, for messages.
inline std::string Said(const Identification& found) {
  std::string out;
  for (const AcceptedEffect& e : found.effects) {
    out += e.candidate.effect + " " + VariantName(e.candidate) + " " + e.candidate.params.formula +
           " delta BIC " + std::to_string(e.evidence.delta_bic) + "\n";
  }
  for (const CandidateRecord& r : found.candidates) {
    if (r.verdict == "screened out" && r.screening_gain < 0) continue;
    out += std::to_string(r.round) + " " + r.effect + " " + r.variant + " " +
           std::to_string(r.screening_gain) + " " + r.verdict + "\n";
  }
  for (size_t i = 0; i < found.corrected.free.size(); ++i) {
    out += found.corrected.free[i].name + " = " + std::to_string(found.after.values[i]) + "\n";
  }
  return out;
}

inline hydraulics::PhsParams Declared() {
  return phs_model::FindPhsParams("quarter_setup2").value();
}

inline hydraulics::PhsParams OffDeclared() {
  hydraulics::PhsParams truth = Declared();
  truth.lines[0].oil_volume_m3 *= 1.2, truth.lines[1].gas_volume_m3 *= 0.8;
  truth.friction.scale = 0.85;
  return truth;
}

/// Value of a free number after the search; NaN where it was not freed.
inline double ValueOf(const Identification& found, const std::string& name) {
  for (size_t i = 0; i < found.corrected.free.size(); ++i) {
    if (found.corrected.free[i].name == name) return found.after.values[i];
  }
  return std::nan("");
}

/// What is found where this one is hidden, which is to be found alone, and these are offered too.
inline Identification FindAlone(const hydraulics::EffectParams& hidden,
                                std::vector<std::string> offered) {
  hydraulics::PhsParams truth = OffDeclared();
  truth.effects.push_back(hidden);
  offered.push_back(hidden.name);
  const Identification found = FindAmong(std::move(offered), Record(truth));
  EXPECT_EQ(found.effects.size(), 1u) << Said(found);
  if (!found.effects.empty()) {
    EXPECT_EQ(found.effects[0].candidate.effect, hidden.name);
  }
  return found;
}

/// The rig of the records, off its declared numbers, with a formula on no list.
inline hydraulics::PhsParams WithUnlisted(const std::string& formula,
                                          const std::string& coefficient, double value,
                                          std::vector<std::string> targets) {
  hydraulics::PhsParams truth = OffDeclared();
  hydraulics::EffectParams effect{"unlisted", std::move(targets), {{coefficient, value}}};
  effect.formula = formula;
  truth.effects.push_back(effect);
  return truth;
}

/// Of the load cell: mean square over its noise, with the wobble of friction about standstill.
inline double LeftOnACleanRecord() {
  static const double left =
      Find(phs_model::FindPhsParams("quarter_setup2").value(), Record(OffDeclared()))
          .after.channel_ms[1];
  return left;
}

}  // namespace phs::identify::search
