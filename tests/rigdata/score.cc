#include "score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace rigdata {
namespace {

using Json = nlohmann::json;

bool Has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool IsUnlisted(const std::string& name) { return name.rfind("unlisted", 0) == 0; }

std::string Format(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string Join(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& s : list) text += (text.empty() ? "" : ", ") + s;
  return text.empty() ? "–" : text;
}

// √ mean of (after / reference)² over the channels that both have.
double ErrorRatio(const Json& channels, const char* phase, const Json& reference) {
  double sum = 0;
  int count = 0;
  for (const auto& [name, level] : reference.items()) {
    if (!channels.contains(name)) continue;
    const double ratio = channels.at(name).at(phase).at("rmse").get<double>() / level.get<double>();
    sum += ratio * ratio;
    ++count;
  }
  if (count == 0) throw std::runtime_error("no channel in common with the truth");
  return std::sqrt(sum / count);
}

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

Threshold Share(const std::string& what, double limit, bool at_most) {
  Threshold t;
  t.what = what;
  t.limit = limit;
  t.at_most = at_most;
  return t;
}

std::string SummaryTable(const SuiteScore& score) {
  std::string text = "| measure | reached | 95 % interval | asked | |\n|---|---|---|---|---|\n";
  for (const Threshold& t : score.thresholds) {
    std::string reached = "no such sets";
    if (t.measured) {
      reached = t.of > 0 ? Format("%.1f %%", 100 * t.Value()) + " (" + std::to_string(t.good) +
                               " of " + std::to_string(t.of) + ")"
                         : Format("%.3f", t.value);
    }
    std::string interval;
    if (t.measured && t.of > 0) {
      const auto [low, high] = ShareInterval(t.good, t.of);
      interval = Format("%.0f", 100 * low) + " … " + Format("%.0f %%", 100 * high);
    }
    const std::string asked =
        std::string(t.at_most ? "≤ " : "≥ ") +
        (t.limit <= 1.0 ? Format("%.0f %%", 100 * t.limit) : Format("%.2f", t.limit));
    text += "| " + t.what + " | " + reached + " | " + interval + " | " + asked + " | " +
            (!t.measured  ? "not measured"
             : t.Passed() ? "met"
                          : "**missed**") +
            " |\n";
  }
  return text;
}

std::string EffectTable(const SuiteScore& score) {
  std::map<std::string, std::map<std::string, const SetScore*>> rows;
  for (const SetScore& s : score.sets) {
    if (s.kind == "single") rows[s.hidden[0]][s.grades[0]] = &s;
  }
  if (rows.empty()) return "";
  std::string text =
      "\n| hidden effect | strong: accepted | error ratio | weak: accepted | error ratio |\n"
      "|---|---|---|---|---|\n";
  for (const auto& [name, grades] : rows) {
    text += "| `" + name + "`";
    for (const char* grade : {"strong", "weak"}) {
      const auto found = grades.find(grade);
      if (found == grades.end()) {
        text += " | | ";
        continue;
      }
      const SetScore& s = *found->second;
      text += " | " +
              std::string(s.Exact()        ? "✓ "
                          : s.FirstRight() ? "(✓) "
                                           : "✗ ") +
              (s.answered ? Join(s.accepted) : s.problem) + " | " +
              (s.answered ? Format("%.2f", s.error_ratio) : "");
    }
    text += " |\n";
  }
  return text;
}

std::string SetTable(const SuiteScore& score) {
  std::string text =
      "\n| set | kind | hidden | accepted | declared / true | after / true | after / true motion | "
      "s |\n|---|---|---|---|---|---|---|---|\n";
  for (const SetScore& s : score.sets) {
    std::vector<std::string> hidden;
    for (size_t i = 0; i < s.hidden.size(); ++i) {
      hidden.push_back(s.hidden[i] + (s.grades[i] == "weak" ? " (weak)" : ""));
    }
    text += "| " + s.set + " | " + s.kind + " | " + Join(hidden) + " | " +
            (s.answered ? Join(s.accepted) : "*" + s.problem + "*") + " | " +
            Format("%.2f", s.declared_ratio) + " | " + Format("%.3f", s.error_ratio) + " | " +
            Format("%.3f", s.strict_ratio) + " | " + Format("%.0f", s.seconds) + " |\n";
  }
  return text;
}

}  // namespace

bool SetScore::FirstRight() const { return !accepted.empty() && Has(hidden, accepted[0]); }
bool SetScore::Exact() const {
  return answered && std::set<std::string>(hidden.begin(), hidden.end()) ==
                         std::set<std::string>(accepted.begin(), accepted.end());
}
bool SetScore::Complete() const {
  return answered && std::all_of(hidden.begin(), hidden.end(),
                                 [&](const std::string& h) { return Has(accepted, h); });
}
bool SetScore::FalseAlarm() const { return hidden.empty() && !accepted.empty(); }
bool SetScore::Described() const {
  return std::any_of(accepted.begin(), accepted.end(), IsUnlisted);
}
bool SetScore::Bent() const {
  return kind == "off_list" &&
         std::any_of(accepted.begin(), accepted.end(),
                     [](const std::string& name) { return !IsUnlisted(name); });
}

SetScore JudgeSet(const std::string& set, const std::string& kind, const Json& truth,
                  const Json& result) {
  SetScore score;
  score.set = set;
  score.kind = kind;
  for (const Json& e : truth.at("effects")) {
    score.hidden.push_back(e.at("name").get<std::string>());
    score.grades.push_back(e.at("grade").get<std::string>());
  }
  try {
    for (const Json& e : result.at("effects")) {
      score.accepted.push_back(e.at("name").get<std::string>());
    }
    if (!score.accepted.empty() && result["effects"][0].contains("confusable_with")) {
      for (const Json& name : result["effects"][0]["confusable_with"]) {
        if (name.is_string()) score.confusable.push_back(name.get<std::string>());
      }
    }
    const Json& channels = result.at("channels");
    const Json& reference = truth.at("validation_rmse");
    score.declared_ratio = ErrorRatio(channels, "before", reference.at("true_model"));
    score.error_ratio = ErrorRatio(channels, "after", reference.at("true_model"));
    score.strict_ratio = ErrorRatio(channels, "after", reference.at("true_model_true_motion"));
    score.answered = true;
  } catch (const std::exception& e) {
    score.problem = std::string("result.json: ") + e.what();
    score.accepted.clear();
  }
  return score;
}

namespace {

// P(X <= k) of n draws, each with chance p.
double AtMost(int k, int n, double p) {
  double sum = 0;
  for (int i = 0; i <= k; ++i) {
    const double ways = std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0);
    sum += std::exp(ways + i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

}  // namespace

std::array<double, 2> ShareInterval(int good, int of) {
  // The p at which so many or fewer are as rare as `tail`; AtMost falls with p.
  const auto p_where = [&](int k, double tail) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double p = 0.5 * (low + high);
      (AtMost(k, of, p) > tail ? low : high) = p;
    }
    return 0.5 * (low + high);
  };
  return {good == 0 ? 0.0 : p_where(good - 1, 0.975), good == of ? 1.0 : p_where(good, 0.025)};
}

bool Threshold::Passed() const {
  return !measured || (at_most ? Value() <= limit + 1e-12 : Value() >= limit - 1e-12);
}

bool SuiteScore::Passed() const {
  return std::all_of(thresholds.begin(), thresholds.end(),
                     [](const Threshold& t) { return t.Passed(); });
}

SuiteScore JudgeSuite(std::vector<SetScore> sets) {
  Threshold first = Share("right effect first, single effects", 0.90, false);
  Threshold exact = Share("exact set, single effects", 0.80, false);
  Threshold alarms = Share("false alarms, clean sets", 0.05, true);
  Threshold pairs = Share("pairs found completely", 0.70, false);
  Threshold ratio = Share("validation error after / of the true model, mean over sets", 1.15, true);
  std::vector<double> ratios;
  for (const SetScore& s : sets) {
    if (s.kind == "single") {
      ++first.of;
      ++exact.of;
      first.good += s.FirstRight();
      exact.good += s.Exact();
    } else if (s.kind == "clean") {
      ++alarms.of;
      alarms.good += s.FalseAlarm() || !s.answered;
    } else if (s.kind == "pair") {
      ++pairs.of;
      pairs.good += s.Complete();
    }
    // A set without an answer has no error; the counts above already hold it against the program.
    if (s.kind != "off_list" && s.answered) ratios.push_back(s.error_ratio);
  }
  ratio.value = Mean(ratios);
  for (Threshold* t : {&first, &exact, &alarms, &pairs}) t->measured = t->of > 0;
  ratio.measured = !ratios.empty();
  SuiteScore score;
  score.sets = std::move(sets);
  score.thresholds = {first, exact, alarms, ratio, pairs};
  return score;
}

std::string ScoreMarkdown(const SuiteScore& score, const std::string& title) {
  std::vector<double> ratios, seconds;
  int off_list = 0, described = 0, bent = 0, within = 0, confusable = 0, silent = 0;
  double memory = 0;
  for (const SetScore& s : score.sets) {
    seconds.push_back(s.seconds);
    memory = std::max(memory, s.megabytes);
    silent += !s.answered;
    if (s.kind == "off_list") {
      ++off_list;
      described += s.Described();
      bent += s.Bent();
    } else if (s.answered) {
      ratios.push_back(s.error_ratio);
      within += s.error_ratio <= 1.15;
    }
    if (s.kind == "single" && !s.FirstRight() && Has(s.confusable, s.hidden[0])) ++confusable;
  }
  std::string text = "## " + title + "\n\n" + SummaryTable(score);
  text += '\n';
  text += std::to_string(score.sets.size()) + " sets. Error ratio: median " +
          Format("%.3f", Quantile(ratios, 0.5)) + ", 90 % of the sets below " +
          Format("%.3f", Quantile(ratios, 0.9)) + ", at or below 1.15 in " +
          std::to_string(within) + " of " + std::to_string(ratios.size()) + ". ";
  text +=
      "Wrong first effect that names the hidden one as confusable: " + std::to_string(confusable) +
      ". ";
  if (off_list > 0) {
    text += "Effects that no list holds: " + std::to_string(described) + " of " +
            std::to_string(off_list) + " described as unlisted, " + std::to_string(bent) +
            " put down to a listed effect. ";
  }
  if (silent > 0) text += "No answer: " + std::to_string(silent) + " sets. ";
  text += "Run time: median " + Format("%.0f s", Quantile(seconds, 0.5)) + ", longest " +
          Format("%.0f s", Quantile(seconds, 1.0)) + "; most memory " + Format("%.0f MB", memory) +
          ".\n";
  return text + EffectTable(score) + SetTable(score);
}

}  // namespace rigdata
