#include "identify/select/test_evidence.h"

#include <algorithm>
#include <cmath>

#include "identify/fit/acceptance.h"
#include "identify/fit/effect_variants.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {
namespace {

/// What one model answers, as if it had been measured.
class AsMeasured final : public ForwardModel {
 public:
  AsMeasured(std::shared_ptr<const ForwardModel> driven, const RecordNoise& noise,
             const Channels& answers)
      : driven_(std::move(driven)) {
    for (size_t b = 0; b < driven_->Measured().size(); ++b) {
      MeasuredBlock& block = measured_.emplace_back(driven_->Measured()[b]);
      const auto c = std::find(noise.channels.begin(), noise.channels.end(), block.channel);
      block.values = answers[b];
      block.noise = noise.deviation[static_cast<size_t>(c - noise.channels.begin())];
    }
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const hydraulics::PhsParams& params, Span span, Channels* out) const override {
    return driven_->Run(params, span, out);
  }
  Status Uncertainty(const hydraulics::PhsParams&, Span, Channels* deviation) const override {
    deviation->clear();
    for (const MeasuredBlock& b : measured_) deviation->emplace_back(b.values.size(), 0.0);
    return {};
  }
  FreeModel Declared(const hydraulics::PhsParams& declared) const override {
    return driven_->Declared(declared);
  }
  std::vector<Candidate> Candidates(const hydraulics::PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Coarse(double) const override { return nullptr; }

 private:
  std::shared_ptr<const ForwardModel> driven_;
  std::vector<MeasuredBlock> measured_;
};

/// Powers of noise and discrepancy in the bands of `problem`, whose clock is `step_s`.
BandPowers NoisePowers(const FitProblem& problem, const RecordNoise& noise, double step_s) {
  const int later = std::max(0, static_cast<int>(std::lround(std::log2(step_s / noise.step_s))));
  BandPowers out;
  for (size_t b = 0; b < static_cast<size_t>(problem.num_blocks()); ++b) {
    const auto c = static_cast<size_t>(
        std::find(noise.channels.begin(), noise.channels.end(), problem.block_name(b)) -
        noise.channels.begin());
    std::vector<double>& row = out.rows().emplace_back();
    const int last = static_cast<int>(noise.powers[c].size()) - 1;
    for (int k = 0; k < problem.likelihood().bands(b).num_bands(); ++k) {
      row.push_back(noise.powers[c][static_cast<size_t>(std::min(k + later, last))]);
    }
  }
  return out;
}

/// V of the header.
double Variance(const FitProblem& problem, const BandPowers& noise, const BandPowers& missed) {
  double sum = 0;
  for (size_t b = 0; b < noise.rows().size(); ++b) {
    for (int k = 0; k < static_cast<int>(noise.rows()[b].size()); ++k) {
      const double n = noise(b, k), d = missed(b, k);
      sum += problem.likelihood().Worth(b, k) * (4 * d * n + 2 * d * d) / ((n + d) * (n + d));
    }
  }
  return sum;
}

/// No force beyond the limit, no pressure below vacuum.
bool IsBearable(const ForwardModel& driven, const Channels& answers, double force_N) {
  for (size_t b = 0; b < answers.size(); ++b) {
    const std::string& channel = driven.Measured()[b].channel;
    for (const double y : answers[b]) {
      if (!std::isfinite(y)) return false;
      if (channel.ends_with("_N") && std::abs(y) > force_N) return false;
      if (channel.ends_with("_Pa") && y <= 0) return false;
    }
  }
  return true;
}

}  // namespace

RecordNoise NoiseOf(const FitProblem& problem, const FitResult& fit, double step_s) {
  RecordNoise out;
  out.rule = problem.rule();
  out.step_s = step_s;
  for (size_t b = 0; b < static_cast<size_t>(problem.num_blocks()); ++b) {
    const std::string& channel = problem.block_name(b);
    if (std::find(out.channels.begin(), out.channels.end(), channel) != out.channels.end()) {
      continue;
    }
    double information = 0, count = 0;  // what a sample says in the mean
    for (const double w : problem.weights()[b]) information += w * w, count += w > 0;
    out.channels.push_back(channel);
    out.deviation.push_back(std::sqrt(std::max(count, 1.0) / std::max(information, 1e-300)));
    std::vector<double>& row = out.powers.emplace_back(fit.powers.rows()[b]);
    for (double& power : row) power = std::max(1.0, power);
  }
  return out;
}

double TestEvidence::probability() const {
  return 0.5 * std::erfc(-margin / (deviation * std::sqrt(2.0)));
}

TestEvidence Expect(std::shared_ptr<const ForwardModel> driven, double step_s,
                    const RecordNoise& noise, double force_N, const FittedModel& truth,
                    const FittedModel& rival, int steps) {
  TestEvidence out;
  const hydraulics::PhsParams params = ParamsOf(truth.model, truth.values);
  Channels answers;
  if (!driven->Run(params, ForwardModel::Span::kEstimation, &answers).ok()) return out;
  if (!IsBearable(*driven, answers, force_N)) return out;
  Result<FitProblem> problem = FitProblem::Create(
      std::make_shared<const AsMeasured>(std::move(driven), noise, answers), params, noise.rule);
  if (!problem.ok()) return out;
  const FitResult refit = FitNear(problem.value(), rival.model, rival.values, {},
                                  {.max_steps = steps, .intervals = false});
  if (!refit.ok) return out;
  const Likelihood& likelihood = problem.value().likelihood();
  const BandPowers alone = NoisePowers(problem.value(), noise, step_s);
  BandPowers both = alone;
  for (size_t b = 0; b < both.rows().size(); ++b) {
    for (size_t k = 0; k < both.rows()[b].size(); ++k) {
      both.rows()[b][k] += refit.powers.rows()[b][k];
    }
  }
  out.expected = likelihood.MinusTwoLog(both) - likelihood.MinusTwoLog(alone);
  const double numbers =
      static_cast<double>(rival.values.size()) - static_cast<double>(truth.values.size());
  out.margin = out.expected + numbers * std::log(likelihood.Count()) +
               2 * std::log(problem.value().rule().accept.false_alarms);
  out.deviation = std::sqrt(std::max(1e-12, Variance(problem.value(), alone, refit.powers)));
  return out;
}

}  // namespace phs::identify::search
