#include "identify/discrepancy/driven_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "effects/unlisted.h"
#include "identify/discrepancy/line_formula.h"
#include "identify/fit/accept.h"
#include "identify/fit/fit_intervals.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {

namespace {

/// The channel that shows a force on the piston.
std::string ForceChannel(const FitProblem& problem) {
  return problem.FindOutput("force_N") >= 0 ? "force_N" : "load_cell_N";
}

/// A formula for what one channel shows beyond the model: as a force, or as its sensor's reading.
FoundFormula SearchChannelFormula(const FitProblem& problem, const FreeModel& model,
                                  const FitResult& fit, const std::string& name,
                                  const FormulaLimits& limits, bool reading, char own = 0) {
  const int channel = problem.FindOutput(name);
  if (channel < 0) return {};
  Result<FormulaFrame> framed = problem.forward().Frame(problem.Params(model, fit.values), name);
  if (!framed.ok()) return {};
  const FormulaFrame& frame = framed.value();
  FormulaData data;
  // All channels: what the model's own numbers could do for the load cell shows in the pressures.
  if (!problem.Linearise(model, fit.values, 0, &data.residual, &data.jacobian)) return {};
  data.places = frame.places;
  data.column = [&](const Channels& values) { return problem.Weighted(name, frame.rows(values)); };
  data.independent = [&](const Eigen::VectorXd& r) {
    return IndependentSamples(r, problem.likelihood().blocks());
  };
  data.has_pressure = frame.has_pressure, data.has_rod_pressure = frame.has_rod_pressure;
  data.has_temperature = frame.has_temperature;
  data.has_friction = frame.has_friction, data.has_speed = frame.has_speed;
  if (reading) data.has_friction = false, data.has_load = frame.has_load, data.own = own;
  data.has_time_waves = frame.has_time_waves;
  data.first_row = problem.block(static_cast<size_t>(channel)).begin;
  return SearchFormula(data, limits);
}

}  // namespace

FoundFormula SearchForceFormula(const FitProblem& problem, const FreeModel& model,
                                const FitResult& fit, const FormulaLimits& limits) {
  return SearchChannelFormula(problem, model, fit, ForceChannel(problem), limits, false);
}

FoundFormula SearchReadingFormula(const FitProblem& problem, const FreeModel& model,
                                  const FitResult& fit, double noise, const FormulaLimits& limits) {
  if (model.params.cylinders.empty()) return {};
  const auto& cylinder = model.params.cylinders.front();
  struct Sensor {
    const char *channel, *unit;
    std::vector<std::string> targets;
    bool is_load = false;
    char own = 0;
  };
  const Sensor sensors[] = {{"piston_m", "m", {}},
                            {"load_cell_N", "N", {}, true},
                            {"p_bore_Pa", "Pa", {cylinder.bore_line}, false, 'p'},
                            {"p_rod_Pa", "Pa", {cylinder.rod_line}, false, 'q'}};
  FoundFormula found[std::size(sensors)];
  problem.ForEach(static_cast<int>(std::size(sensors)), [&](int k) {
    const int channel = problem.FindOutput(sensors[k].channel);
    if (channel < 0 || fit.channel_ms[static_cast<size_t>(channel)] < noise) return;
    found[k] =
        SearchChannelFormula(problem, model, fit, sensors[k].channel, limits, true, sensors[k].own);
    // What does not hang on the force that a load cell carries is a force itself.
    if (sensors[k].is_load && found[k].text.find('F') == std::string::npos) found[k] = {};
    found[k].unit = sensors[k].unit, found[k].targets = sensors[k].targets;
  });
  return *std::max_element(std::begin(found), std::end(found),
                           [](const auto& a, const auto& b) { return a.gain < b.gain; });
}

namespace {

/// Fits the formula together with all numbers of the model, from `values` of these and a `part`
/// of the formula: the linear estimate of a strong law may lie beyond where the model
/// holds.
FormulaTrial FitFormula(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                        const std::vector<double>& values, const FoundFormula& found, double most,
                        double part = 0.01) {
  FormulaTrial out;
  if (found.empty()) return out;
  out.found = found;
  out.candidate = FormulaCandidate(found, most);
  out.model = WithCandidate(model, out.candidate);
  std::vector<double> start = values;
  for (const double c : out.candidate.starts[0]) start.push_back(part * c);
  out.fit = FitNear(
      problem, out.model, start, fit.slopes,
      {.first_own = static_cast<int>(values.size()), .max_steps = 15, .final_slopes = true});
  if (out.fit.ok) out.evidence = Compare(problem, fit, out.fit, kTermsTried);
  return out;
}

bool Better(const FitProblem& problem, const FormulaTrial& a, const FormulaTrial& b) {
  if (!a.fit.ok || !b.fit.ok) return a.fit.ok;
  return Criterion(problem, a.fit.score, a.fit.values.size()) <
         Criterion(problem, b.fit.score, b.fit.values.size());
}

/// A law of a line: sought at the fit and, as a strong law bends the columns themselves, again
/// about the model that has it.
FormulaTrial TryLineFormula(const FitProblem& problem, const FitProblem& coarse,
                            const FreeModel& model, const FitResult& fit,
                            const FormulaLimits& limits) {
  constexpr double kMostOil = 1e-3;  // [m3], [m3/s]
  constexpr int kRounds = 3;
  const size_t base = fit.values.size();
  FormulaTrial best = FitFormula(problem, model, fit, fit.values,
                                 SearchLineFormula(coarse, model, fit.values, limits), kMostOil);
  const auto has_room = [](const FoundFormula& found) {  // for the coefficient of one more term
    return found.coefficients.size() < effects::kFormulaCoefficients;
  };
  for (int round = 0; round < kRounds && best.fit.ok && has_room(best.found); ++round) {
    const FormulaTrial about = best;
    const std::vector<double> values(about.fit.values.begin(),
                                     about.fit.values.begin() + static_cast<long>(base));
    FormulaTrial trials[2];
    problem.ForEach(2, [&](int thresholds_only) {
      const FoundFormula anew = SearchAnew(coarse, about.model, about.fit.values, base, about.found,
                                           thresholds_only != 0, limits);
      if (anew.text == about.found.text) return;
      trials[thresholds_only] = FitFormula(problem, model, fit, values, anew, kMostOil, 1);
    });
    for (FormulaTrial& trial : trials) {
      if (Better(problem, trial, best)) best = std::move(trial);
    }
    if (best.found.text == about.found.text) break;
  }
  best.channel_gain = best.evidence.best_channel_gain;
  return best;
}

}  // namespace

FormulaTrial TryFormula(const FitProblem& problem, const FitProblem& coarse, const FreeModel& model,
                        const FitResult& fit, const FormulaLimits& limits) {
  constexpr double kNoise = 1.1, kMostForce_N = 1e5, kMostReading_m = 1e-2, kMostReading_Pa = 1e7;
  double pressures = 0, load = 0;
  for (int c = 0; c < problem.num_blocks(); ++c) {
    const std::string& name = problem.block_name(static_cast<size_t>(c));
    double& worst = name.ends_with("_Pa") ? pressures : load;
    if (name != "piston_m") worst = std::max(worst, fit.channel_ms[static_cast<size_t>(c)]);
  }
  FormulaTrial force, line, reading;
  const auto try_force = [&] {
    if (load <= kNoise) return;
    force = FitFormula(problem, model, fit, fit.values,
                       SearchForceFormula(problem, model, fit, limits), kMostForce_N);
    if (!force.fit.ok) return;
    const auto c = static_cast<size_t>(problem.FindOutput(ForceChannel(problem)));
    force.channel_gain = 1 - std::sqrt(force.fit.channel_ms[c] / fit.channel_ms[c]);
  };
  const auto try_line = [&] {
    if (pressures <= kNoise || !problem.forward().TellsLines()) return;
    line = TryLineFormula(problem, coarse, model, fit, limits);
  };
  const auto try_reading = [&] {
    if (!limits.readings) return;
    const FoundFormula shown = SearchReadingFormula(problem, model, fit, kNoise, limits);
    const double most = shown.unit == "m"   ? kMostReading_m
                        : shown.unit == "N" ? kMostForce_N
                                            : kMostReading_Pa;
    reading = FitFormula(problem, model, fit, fit.values, shown, most);
    reading.channel_gain = reading.evidence.best_channel_gain;
  };
  const std::function<void()> searches[] = {try_line, try_force, try_reading};
  problem.ForEach(3, [&](int k) { searches[k](); });
  FormulaTrial& best = Better(problem, line, force) ? line : force;
  // What a sensor says beyond the truth gives way to a physical cause that explains as much.
  const bool ahead =
      !best.fit.ok || (Better(problem, reading, best) &&
                       IsBeyondChance(problem.rule(), best.fit.score - reading.fit.score, 1));
  return reading.fit.ok && ahead ? reading : best;
}

Candidate FormulaCandidate(const FoundFormula& found, double most) {
  Candidate c;
  c.effect = c.params.name = effects::UnlistedInfo().name;
  c.params.formula = found.text;
  c.params.targets = found.targets;
  c.starts = {{}};
  // Of a term of two parts either may be nothing.
  if (!found.terms.empty() && !found.terms.front().second.empty()) c.mains = 2;
  for (size_t k = 0; k < found.coefficients.size(); ++k) {
    const std::string name = fmt::format("c{}_{}", k + 1, found.unit);
    FreeParameter p;
    p.name = "effects." + c.effect + "." + name;
    p.start = found.coefficients[k];
    p.low = -most, p.high = most;
    p.scale = p.start != 0 ? std::abs(p.start) : 1e-3 * most;
    c.free.push_back(p);
    c.none.push_back(0);
    c.starts[0].push_back(p.start);
    c.params.values[name] = 0;
  }
  return c;
}

}  // namespace phs::identify::search
