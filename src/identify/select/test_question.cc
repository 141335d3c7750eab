#include "identify/select/test_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "base/words.h"
#include "effects/catalogue.h"
#include "identify/fit/accept.h"
#include "identify/fit/evidence.h"
#include "identify/fit/near_fit.h"
#include "identify/select/points.h"
#include "identify/select/trials.h"

namespace phs::identify::search {
namespace {

constexpr size_t kMostQuestions = 4;

/// The model with a number held at `value`, the others fitted.
FittedModel Held(const FitProblem& problem, const FreeModel& model,
                 const std::vector<double>& values, size_t held, double value) {
  FittedModel out{fmt::format("{} = {:.3g}", model.free[held].name, value),
                  WithHeld(model, held, value), values};
  out.values.erase(out.values.begin() + static_cast<long>(held));
  const FitResult fit =
      FitNear(problem, out.model, out.values, {}, {.max_steps = 4, .intervals = false});
  if (fit.ok) out.values = fit.values;
  return out;
}

/// An accepted effect exchanged for one that explains as much.
FittedModel Exchanged(const FitProblem& problem, const Identification& found, size_t effect,
                      const Rival& rival) {
  FittedModel out;
  out.name = rival.form.effect;
  out.values = ValuesWithout(found, effect, &out.model);
  out.model = WithCandidate(out.model, rival.form);
  out.values.insert(out.values.end(), rival.values.begin(), rival.values.end());
  const FitResult fit =
      FitNear(problem, out.model, out.values, {}, {.max_steps = 8, .intervals = false});
  if (fit.ok) out.values = fit.values;
  return out;
}

/// The model as found without the effects `names`, fitted anew where one of them was there.
FitResult FitWithout(const FitProblem& problem, const Identification& found,
                     const std::vector<std::string>& names, FreeModel* model) {
  Identification rest = found;
  for (size_t i = rest.effects.size(); i-- > 0;) {
    if (std::find(names.begin(), names.end(), rest.effects[i].candidate.effect) == names.end()) {
      continue;
    }
    rest.after.values = ValuesWithout(rest, i, &rest.corrected);
    rest.effects.erase(rest.effects.begin() + static_cast<long>(i));
  }
  *model = rest.corrected;
  if (rest.effects.size() == found.effects.size()) return found.after;
  return FitNear(problem, *model, rest.after.values, {}, {.max_steps = 8, .final_slopes = true});
}

/// "conductance 3.2e-13 m3/(Pa s)", of every amount of a form.
std::string AmountsOf(const Candidate& form, const FittedModel& fitted) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(form.params);
  const size_t first = fitted.values.size() - form.free.size();
  std::vector<std::string> amounts;
  for (size_t k = 0; k < static_cast<size_t>(form.mains); ++k) {
    const std::string& path = form.free[k].name;
    const std::string name = path.substr(path.rfind('.') + 1);
    std::string unit;
    for (size_t i = 0; info != nullptr && i < info->parameters.size(); ++i) {
      if (info->parameters[i].name == name) unit = info->parameters[i].unit;
    }
    amounts.push_back(fmt::format("{} {:.3g}{}", name, fitted.values[first + k],
                                  unit.empty() || unit == "1" ? "" : " " + unit));
  }
  return JoinWords(amounts);
}

/// The best form of an effect on top of a model, and what amount of it was taken.
Result<FittedModel> FitNamed(const FitProblem& problem, const FitProblem& coarse,
                             const FreeModel& base, const FitResult& fit,
                             const std::vector<Point>& points, const std::string& name,
                             const Effort& effort, const std::function<bool()>& go_on,
                             std::string* size) {
  std::vector<Candidate> list = problem.forward().Candidates(base.params);
  std::erase_if(list, [&](const Candidate& c) { return c.effect != name; });
  Effort whatever = effort;
  whatever.unpromising = true;  // it is asked for
  const std::vector<FullTrial> trials = TryEffects(problem, coarse, base, fit, points, list,
                                                   whatever, [&](double) { return go_on(); });
  const FullTrial* best = nullptr;
  const auto criterion = [&](const FullTrial& t) {
    return Criterion(problem, t.fit.score, t.fit.values.size());
  };
  for (const FullTrial& t : trials) {
    if (t.fit.ok && (best == nullptr || criterion(t) < criterion(*best))) best = &t;
  }
  if (best == nullptr) {
    return Error{name, "could not be fitted to this record", "", "see candidates in result.json"};
  }
  const FreeModel whole = WithCandidate(base, best->form);
  const bool told = IsThere(best->form, best->fit, base.free.size());
  FittedModel out{name, whole, best->fit.values};
  if (!told) out = LargestLeftOpen(problem, whole, best->fit, base.free.size());
  out.name = name;
  *size = fmt::format("{} with {}, {}", name, AmountsOf(best->form, out),
                      told ? "as fitted" : "the largest that this record leaves open");
  return out;
}

}  // namespace

Status CheckBetween(const ForwardModel& forward, const hydraulics::PhsParams& declared,
                    const std::vector<std::string>& between) {
  if (between.empty()) return {};
  std::set<std::string> names;
  for (const Candidate& c : forward.Candidates(declared)) names.insert(c.effect);
  const std::vector<std::string> known(names.begin(), names.end());
  if (between.size() != 2 || between[0] == between[1]) {
    return Error{"--between", "asks for two different effects",
                 "--between ONE,OTHER of " + JoinWords(known), ""};
  }
  for (const std::string& name : between) {
    if (names.contains(name)) continue;
    return Error{"--between", name + " is no effect that is tried on this record", JoinWords(known),
                 DidYouMean(name, known)};
  }
  return {};
}

FittedModel LargestLeftOpen(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                            size_t amount) {
  constexpr double kChance = 3.84;  // chi squared, one degree of freedom, 95 %
  constexpr int kHalvings = 5;
  const FreeParameter& p = model.free[amount];
  const double end = p.ToCoordinate(p.high);
  FittedModel out{p.name, model, fit.values};
  double inside = p.ToCoordinate(fit.values[amount]), outside = end;
  const auto is_open = [&](double coordinate) {
    const double value = p.FromCoordinate(coordinate);
    std::vector<double> others = out.values;
    others.erase(others.begin() + static_cast<long>(amount));
    const FitResult held = FitNear(problem, WithHeld(model, amount, value), others, {},
                                   {.max_steps = 4, .intervals = false});
    if (!held.ok || held.score > fit.score + kChance) return false;
    out.values = held.values;
    out.values.insert(out.values.begin() + static_cast<long>(amount), value);
    return true;
  };
  bool found_end = false;
  double step = std::clamp(fit.half_95[amount], (end - inside) / 256, (end - inside) / 8);
  for (; inside < end && !found_end; step *= 2) {
    const double next = std::min(end, inside + step);
    (is_open(next) ? inside : outside) = next;
    found_end = inside != next;
  }
  for (int k = 0; k < kHalvings && found_end; ++k) {
    const double middle = 0.5 * (inside + outside);
    (is_open(middle) ? inside : outside) = middle;
  }
  return out;
}

std::vector<Question> OpenQuestions(const FitProblem& problem, const Identification& found) {
  std::vector<Question> out;
  std::string name;
  for (const AcceptedEffect& effect : found.effects) {
    name += (name.empty() ? "" : "+") + effect.candidate.effect;
  }
  const FittedModel one{name, found.corrected, found.after.values};
  for (size_t i = 0; i < found.effects.size(); ++i) {
    for (const Rival& rival : found.effects[i].rivals) {
      Question q{one, Exchanged(problem, found, i, rival), false};
      const Candidate& taken = found.effects[i].candidate;
      q.one.name = NameBeside(taken, rival.form), q.other.name = NameBeside(rival.form, taken);
      const bool known = std::any_of(out.begin(), out.end(), [&](const Question& other) {
        return other.one.name == q.one.name && other.other.name == q.other.name;
      });
      if (!known && out.size() < kMostQuestions) out.push_back(std::move(q));
    }
  }
  for (size_t i = 0; i < found.declared.free.size(); ++i) {
    const FreeParameter& p = found.corrected.free[i];
    const double half = found.after.half_95[i];
    const double range = p.ToCoordinate(p.high) - p.ToCoordinate(p.low);
    if (2 * half < range || out.size() >= kMostQuestions) continue;
    if (IsAtEnd(p, found.after.values[i])) continue;  // not open: something else pulls at it
    out.push_back({Held(problem, found.corrected, found.after.values, i, p.low),
                   Held(problem, found.corrected, found.after.values, i, p.high), true});
  }
  return out;
}

Result<Question> AskedQuestion(const FitProblem& problem, const FitProblem& coarse,
                               const Identification& found, const std::vector<std::string>& between,
                               const Effort& effort, const std::function<bool()>& go_on) {
  FreeModel base;
  const FitResult fit = FitWithout(problem, found, between, &base);
  const std::vector<Point> points =
      fit.ok ? PointsAbout(coarse, base, fit, found.declared.free.size(), false)
             : std::vector<Point>();
  if (points.empty()) return Error{"--between", "what else was found cannot be fitted", "", ""};
  Question question;
  question.sizes.resize(2);
  std::vector<Result<FittedModel>> fitted(2, Error{"--between", "not fitted", "", ""});
  std::mutex mutex;
  const auto goes_on = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return !go_on || go_on();
  };
  ThreadBudget(effort.threads).ForEach(2, [&](int k) {
    const auto i = static_cast<size_t>(k);
    fitted[i] = FitNamed(problem, coarse, base, fit, points, between[i], effort, goes_on,
                         &question.sizes[i]);
  });
  for (const auto& f : fitted) {
    if (!f.ok()) return f.error();
  }
  question.one = std::move(fitted[0]).value(), question.other = std::move(fitted[1]).value();
  return question;
}

}  // namespace phs::identify::search
