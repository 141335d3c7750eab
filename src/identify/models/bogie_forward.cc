#include "identify/models/bogie_forward.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "identify/fit/thread_budget.h"
#include "identify/models/bogie_candidates.h"
#include "identify/models/bogie_theories.h"
#include "vehicle/running_effects.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::identify::search {

using measurement::FitData;
using measurement::MeasuredChannel;
namespace {

using hydraulics::EffectParams;
using hydraulics::PhsParams;
using vehicle::RunOutcome;
using vehicle::Scenario;
using vehicle::Simulation;

/// All that a run depends on. What theories move is in no file, so not in its text either.
std::string KeyOf(const Scenario& s, size_t samples) {
  return fmt::format("{} {} {}\n{}", samples, s.track_errors.cant_m, s.track_errors.widening_m,
                     vehicle::ToYaml(s));
}

/// True of what shows in forces and pressures at the ways of the pistons: not of wheel and track,
/// which stand in the same list of effects, nor of what lies behind the pistons.
bool IsAtPistons(const EffectParams& effect) {
  if (vehicle::FindRunningEffect(effect.name) != nullptr) return false;
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(effect);
  return info == nullptr || info->family != "mounting";
}

PhsParams PhsAtPistons(PhsParams params) {
  std::erase_if(params.effects, [](const EffectParams& effect) { return !IsAtPistons(effect); });
  return params;
}

}  // namespace

bool KeptRuns::Find(const std::string& key, Channels* out) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [name, run] : runs_) {
    if (name != key) continue;
    *out = run;
    return true;
  }
  return false;
}

void KeptRuns::Keep(const std::string& key, const Channels& run) {
  constexpr size_t kMost = 64;
  const std::lock_guard<std::mutex> lock(mutex_);
  runs_.emplace_front(key, run);
  if (runs_.size() > kMost) runs_.pop_back();
}

BogieForward::BogieForward(const FitData& data, BogieModel model, int stride)
    : RecordForward(data, stride),
      data_(data),
      model_(std::move(model)),
      stride_(stride),
      kept_(std::make_shared<KeptRuns>()) {
  if (!model_.by_measured_ways) return;
  const PhsParams phs = PhsAtPistons(model_.phs);
  ways_ = MeasuredWays::Of(data, FindPhsOutputs(model_, data), phs, stride);
}

size_t BogieForward::Samples(Span span) const {
  if (span == Span::kWhole) return data_.time_s.size();
  const auto end = std::lower_bound(data_.time_s.begin(), data_.time_s.end(), data_.estimation[1]);
  return static_cast<size_t>(end - data_.time_s.begin());
}

Status BogieForward::RunKept(Scenario scenario, Span span, Channels* out) const {
  const size_t samples = Samples(span);
  const bool longer = span == Span::kEstimation && model_.fit_step_s > 0;
  const double own_step_s = scenario.timestep_s;
  if (longer) scenario.timestep_s = model_.fit_step_s;
  const std::string key = KeyOf(scenario, samples);
  if (kept_->Find(key, out)) return {};
  Status done = Simulate(scenario, samples, out);
  if (!done.ok() && longer) {  // too stiff for the longer step
    scenario.timestep_s = own_step_s;
    done = Simulate(scenario, samples, out);
  }
  if (done.ok()) kept_->Keep(key, *out);
  return done;
}

Status BogieForward::RunScenario(Scenario scenario, Span span, Channels* out) const {
  if (Status s = RunKept(std::move(scenario), span, out); !s.ok()) return s;
  if (span == Span::kWhole || stride_ == 1) return {};
  const size_t samples = Samples(span);
  const auto by = static_cast<size_t>(stride_);
  for (std::vector<double>& row : *out) {
    size_t k = 0;
    for (; k * by < samples; ++k) row[k] = row[k * by];
    row.resize(k);
  }
  return {};
}

Status BogieForward::Simulate(const Scenario& of, size_t samples, Channels* out,
                              double* largest_step_s) const {
  Scenario scenario = of;
  const std::vector<double>& place = data_.motion.front().position;
  const double last = *std::max_element(place.begin(), place.begin() + static_cast<long>(samples));
  scenario.duration_s = (last - model_.start_m) / scenario.speed_m_s * 1.02 + 0.3;
  scenario.record_interval_s =
      std::clamp(0.5 * data_.step_s, scenario.timestep_s, scenario.record_interval_s);
  const auto check =
      largest_step_s != nullptr ? vehicle::StepCheck::kLargest : vehicle::StepCheck::kHolds;
  auto simulation = Simulation::Create(scenario, check);
  if (!simulation.ok()) return simulation.status();
  if (largest_step_s != nullptr) *largest_step_s = simulation.value().largest_stable_step();
  auto done = simulation.value().Run();
  if (!done.ok()) return done.status();
  const RunOutcome& run = done.value();
  if (run.status != "ok") return Error{scenario.name, run.status + ": " + run.reason, "", ""};
  const std::vector<double>& s = run.columns[static_cast<size_t>(run.Find("s_m"))];
  out->assign(data_.outputs.size(), std::vector<double>(samples));
  std::vector<const std::vector<double>*> column;
  for (const MeasuredChannel& channel : data_.outputs) {
    column.push_back(
        &run.columns[static_cast<size_t>(run.Find(RunChannelOf(model_, channel.name)))]);
  }
  for (size_t k = 0; k < samples; ++k) {
    const double at = std::clamp(place[k], s.front(), s.back());
    const auto above = std::upper_bound(s.begin() + 1, s.end() - 1, at);
    const auto i = static_cast<size_t>(above - s.begin());
    const double part = (at - s[i - 1]) / (s[i] - s[i - 1]);
    for (size_t c = 0; c < column.size(); ++c) {
      (*out)[c][k] = (1 - part) * (*column[c])[i - 1] + part * (*column[c])[i];
    }
  }
  return {};
}

Result<double> BogieForward::FitStep(const PhsParams& params) const {
  constexpr double kBelowLimit = 0.95, kOfNoise = 0.1;
  auto scenario = ScenarioWith(model_, params);
  if (!scenario.ok()) return scenario.error();
  const size_t samples = Samples(Span::kEstimation);
  Channels own, longer;
  double most = 0;
  if (Status s = Simulate(scenario.value(), samples, &own, &most); !s.ok()) return s.error();
  const double step = kBelowLimit * most;
  if (step < 1.2 * scenario.value().timestep_s) return 0.0;
  scenario.value().timestep_s = step;
  if (!Simulate(scenario.value(), samples, &longer).ok()) return 0.0;
  for (size_t c = 0; c < own.size(); ++c) {
    double square = 0;
    for (size_t k = 0; k < samples; ++k) square += std::pow(longer[c][k] - own[c][k], 2);
    const double rms = std::sqrt(square / static_cast<double>(samples));
    if (rms > kOfNoise * data_.outputs[c].noise) return 0.0;
  }
  return step;
}

Status BogieForward::RunSpan(const PhsParams& params, Span span, Channels* out) const {
  auto scenario = ScenarioWith(model_, OfVehicle(params, span));
  if (!scenario.ok()) return scenario.status();
  return RunTheory(std::move(scenario).value(), params, span, out);
}

std::shared_ptr<const ForwardModel> BogieForward::About(const PhsParams& params) const {
  if (ways_ == nullptr) return nullptr;
  auto out = std::make_shared<BogieForward>(*this);
  out->held_ = std::make_shared<const PhsParams>(params);
  return out;
}

PhsParams BogieForward::OfVehicle(const PhsParams& params, Span span) const {
  if (held_ == nullptr || span == Span::kWhole) return params;
  PhsParams out = *held_;
  std::erase_if(out.effects, [](const EffectParams& effect) { return !IsAtPistons(effect); });
  for (const EffectParams& effect : params.effects) {
    if (!IsAtPistons(effect)) out.effects.push_back(effect);
  }
  return out;
}

Status BogieForward::RunTheory(Scenario scenario, const PhsParams& params, Span span,
                               Channels* out) const {
  const Status done = RunScenario(std::move(scenario), span, out);
  return done.ok() && ways_ != nullptr ? ways_->Put(PhsAtPistons(params), span, out) : done;
}

Channels BogieForward::NoErrors(Span span) const {
  const size_t by = span == Span::kWhole ? 1 : static_cast<size_t>(stride_);
  return Channels(data_.outputs.size(), std::vector<double>((Samples(span) + by - 1) / by, 0.0));
}

Status BogieForward::InputErrorsSpan(const PhsParams& params, Span span,
                                     std::vector<Channels>* draws) const {
  draws->clear();
  if (ways_ == nullptr) return {};
  return ways_->Errors(PhsAtPistons(params), span, NoErrors(span), draws);
}

Status BogieForward::UncertaintySpan(const PhsParams& params, Span span,
                                     Channels* deviation) const {
  *deviation = NoErrors(span);
  return ways_ != nullptr ? ways_->PutUncertainty(PhsAtPistons(params), span, deviation) : Status();
}

Status BogieForward::TheorySpan(const PhsParams& params, Span span,
                                std::vector<Channels>* differences) const {
  auto scenario = ScenarioWith(model_, params);
  if (!scenario.ok()) return scenario.status();
  Channels own;
  if (Status s = RunTheory(scenario.value(), params, span, &own); !s.ok()) return s;
  const bool stiffness_free = std::find(model_.free.begin(), model_.free.end(),
                                        "friction.stiffness_N_per_m") != model_.free.end();
  std::vector<Theory> others = OtherTheories(scenario.value(), params, stiffness_free);
  if (ways_ != nullptr) AddOtherPlaces(scenario.value(), params, &others);
  differences->assign(others.size(), {});
  std::vector<Status> ran(others.size());
  ThreadBudget(model_.threads).ForEach(static_cast<int>(others.size()), [&](int i) {
    const auto k = static_cast<size_t>(i);
    ran[k] = RunTheory(std::move(others[k].scenario), others[k].phs, span, &(*differences)[k]);
  });
  if (ways_ != nullptr) {
    Channels of_vehicle;
    ran.push_back(RunKept(scenario.value(), span, &of_vehicle));
    differences->push_back(own);
    if (ran.back().ok()) {
      ran.back() =
          ways_->PutTrembling(PhsAtPistons(params), span, of_vehicle, &differences->back());
    }
  }
  for (size_t i = 0; i < ran.size(); ++i) {
    if (!ran[i].ok()) return ran[i];
    Channels& out = (*differences)[i];
    for (size_t c = 0; c < own.size(); ++c) {
      for (size_t k = 0; k < own[c].size(); ++k) out[c][k] -= own[c][k];
    }
  }
  return {};
}

FreeModel BogieForward::Declared(const PhsParams& declared) const {
  return DeclaredModel(declared, model_.free);
}

std::vector<Candidate> BogieForward::Candidates(const PhsParams& params) const {
  std::vector<Candidate> out;
  for (Candidate& c : ListBogieCandidates(params, model_.free, model_.declared)) {
    const auto& asked = model_.candidates;
    if (!asked.empty() && std::find(asked.begin(), asked.end(), c.effect) == asked.end()) continue;
    out.push_back(std::move(c));
  }
  return out;
}

std::shared_ptr<const ForwardModel> BogieForward::Coarse(double step_s) const {
  auto coarse = std::make_shared<BogieForward>(data_, model_, StrideOf(step_s));
  coarse->kept_ = kept_;
  return coarse;
}

}  // namespace phs::identify::search
