#include "identify/select/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/words.h"

namespace phs::identify {
namespace {

constexpr double kMost = 0.5;  // of the mean square beyond the noise
constexpr double kFar = 1.5;   // factor that a declared number may be off by, as measured rigs are

/// Mean square over that of the noise that the model lacks.
double Lacking(const ChannelLeft& c) {
  const double beyond = c.after * c.after - 1;
  return c.comes_and_goes ? beyond : std::min(beyond, c.following);
}

const ChannelLeft* Worst(const VerdictFacts& facts) {
  const auto worst = std::max_element(
      facts.channels.begin(), facts.channels.end(),
      [](const ChannelLeft& a, const ChannelLeft& b) { return Lacking(a) < Lacking(b); });
  return worst == facts.channels.end() ? nullptr : &*worst;
}

std::string Left(const ChannelLeft& c) {
  constexpr double kRunsAway = 1000;
  if (!(c.after < kRunsAway)) {
    return fmt::format(
        "{} runs away in the {} window, beyond {:g} times its noise: the corrected model does not "
        "hold where it was not fitted",
        c.channel, c.window, kRunsAway);
  }
  return fmt::format(
      "{}{} is left with {:.1f} times its noise and uncertainty, {:.1f} % of its standard "
      "deviation",
      c.window == "validation" ? "" : "in the " + c.window + " window ", c.channel, c.after,
      100 * c.of_sigma);
}

/// Channels with more than their white noise, of which no more than that follows what the rig did.
void AddColoured(const VerdictFacts& facts, std::vector<std::string>* reasons) {
  for (const ChannelLeft& c : facts.channels) {
    if (c.after * c.after - 1 <= kAsLargeAsNoise || c.following > kAsLargeAsNoise) continue;
    if (c.comes_and_goes) continue;
    reasons->push_back(Left(c) +
                       "; no more than the noise follows what the rig did, the rest is noise "
                       "with a colour");
  }
}

/// What goes to and fro between two readings.
void AddJumping(const ChannelLeft& c, std::vector<std::string>* reasons) {
  reasons->push_back(fmt::format(
      "what {} is left with stands on two levels, {:.2g} times the noise apart, and jumps {} times "
      "between them in the {} window: look for a loose plug, a range that changes, a current that "
      "is switched",
      c.channel, c.levels_apart, c.jumps, c.window));
}

/// What shakes the rig from beside it: what follows the rig, or drifts, is loud in some parts, too.
void AddComing(const ChannelLeft& c, std::vector<std::string>* reasons) {
  if (!c.comes_and_goes || c.following > kAsLargeAsNoise) return;
  if (c.quiet_at_rest) {
    reasons->push_back(
        "what " + c.channel +
        " is left with is quiet where the rig stands still: its motion makes it; look "
        "for what squeals or rattles");
    return;
  }
  reasons->push_back(
      "what " + c.channel + " is left with comes and goes: for parts of the " + c.window +
      " window it is as good as quiet; look for what runs or strikes beside the rig");
}

/// What swings at a frequency of its own.
void AddSwinging(const ChannelLeft& c, std::vector<std::string>* reasons) {
  if (!(c.swings_Hz > 0)) return;
  reasons->push_back(fmt::format(
      "most of what {} is left with swings at {:.3g} Hz, where the motion hardly does: look for a "
      "pump, a frame, mains or a squeal of that pitch",
      c.channel, c.swings_Hz));
}

/// Declared numbers that the fit has driven to an end, or far away: said in any case.
void AddNumbers(const VerdictFacts& facts, bool at_end, std::vector<std::string>* reasons) {
  for (const FittedNumber& n : facts.numbers) {
    if (n.at_end != at_end) continue;
    const double factor = n.declared != 0 ? n.fitted / n.declared : 0;
    if (at_end) {
      reasons->push_back(fmt::format("{} ends at the edge of its range ({:.3g}, declared {:.3g})",
                                     n.name, n.fitted, n.declared));
    } else if (n.told && factor > 0 && std::max(factor, 1 / factor) > kFar) {
      reasons->push_back(
          fmt::format("{} is fitted to {:.2g} times its declared value: is it known "
                      "so badly, or does it stand for something else?",
                      n.name, factor));
    }
  }
}

/// Of a record that nothing describes: what would, were its amount plausible.
void AddBeyond(const VerdictFacts& facts, std::vector<std::string>* reasons) {
  if (facts.beyond) {
    reasons->push_back(
        fmt::format("{} would take {:.0f} % of what {} shows beyond its noise, but ends at the "
                    "edge of what is plausible in {}: "
                    "is it that large here, or does it stand for something else?",
                    facts.beyond->effect, 100 * facts.beyond->share, facts.beyond->channel,
                    JoinWords(facts.beyond->amounts)));
  } else if (facts.effects.empty()) {
    reasons->push_back(
        facts.tried ? "nothing that was tried explains it"
                    : "no effect was tried: none promised to explain it, or none was asked for");
  }
}

Verdict Undescribed(const VerdictFacts& facts, std::vector<std::string> reasons) {
  AddNumbers(facts, false, &reasons);
  return {"not_described", std::move(reasons)};
}

}  // namespace

std::vector<ChannelLeft> BothWindows(std::vector<ChannelLeft> validation,
                                     const std::vector<ChannelLeft>& estimation) {
  for (ChannelLeft c : estimation) {
    if (Lacking(c) <= kAsLargeAsNoise) continue;
    c.window = "estimation";
    validation.push_back(std::move(c));
  }
  return validation;
}

namespace {

Verdict WithoutQuestions(const VerdictFacts& facts) {
  std::vector<std::string> reasons = facts.faults;
  if (!reasons.empty()) return Undescribed(facts, std::move(reasons));
  const ChannelLeft* worst = Worst(facts);
  const bool noise = worst == nullptr || Lacking(*worst) <= kAsLargeAsNoise;
  AddNumbers(facts, true, &reasons);
  if (!reasons.empty()) {
    if (!noise) reasons.push_back(Left(*worst));
    return Undescribed(facts, std::move(reasons));
  }
  if (!noise) {
    reasons.push_back(Left(*worst));
    if (worst->jumps > 0) {
      AddJumping(*worst, &reasons);
    } else {
      AddComing(*worst, &reasons);
    }
    AddSwinging(*worst, &reasons);
    const double excess = worst->before * worst->before - 1;
    const double removed =
        excess > 0 ? (worst->before * worst->before - worst->after * worst->after) / excess : 0;
    if (!facts.effects.empty()) {
      reasons.push_back(fmt::format("the effects take {:.0f} % of what it showed beyond its noise",
                                    100 * std::max(0.0, removed)));
    }
    if (facts.effects.empty() || removed <= kMost) {
      AddBeyond(facts, &reasons);
      return Undescribed(facts, std::move(reasons));
    }
  }
  for (const NamedEffect& effect : facts.effects) {
    if (!effect.special_case_of.empty()) {
      reasons.push_back(effect.name + " is a special case of " + JoinWords(effect.special_case_of) +
                        ", for which this record does not ask");
    }
    if (!effect.own_form.empty()) {
      reasons.push_back(effect.name + " has another form than the listed ones: beside them " +
                        effect.own_form);
    }
    if (!effect.at_end.empty()) {
      reasons.push_back(
          fmt::format("{} ends at the edge of what is plausible in {}: it may lie beyond, or the "
                      "law be another one",
                      effect.name, JoinWords(effect.at_end)));
    }
    if (effect.rivals.empty()) continue;
    reasons.push_back(effect.name + " explains no more than " + JoinWords(effect.rivals));
  }
  const bool rivals = std::any_of(facts.effects.begin(), facts.effects.end(),
                                  [](const NamedEffect& e) { return !e.rivals.empty(); });
  AddNumbers(facts, false, &reasons);
  AddColoured(facts, &reasons);
  if (rivals) return {"undecidable", std::move(reasons)};
  if (!facts.effects.empty()) return {"explained", std::move(reasons)};
  const auto most = std::max_element(
      facts.channels.begin(), facts.channels.end(),
      [](const ChannelLeft& a, const ChannelLeft& b) { return a.after < b.after; });
  if (most != facts.channels.end() && most->after * most->after - 1 <= kAsLargeAsNoise) {
    reasons.insert(reasons.begin(), Left(*most));
  }
  return {"sufficient", std::move(reasons)};
}

}  // namespace

Verdict Judge(const VerdictFacts& facts) {
  Verdict verdict = WithoutQuestions(facts);
  if (verdict.word == "sufficient" || !facts.faults.empty()) return verdict;
  verdict.reasons.insert(verdict.reasons.end(), facts.questions.begin(), facts.questions.end());
  return verdict;
}

std::string VerdictSentence(const Verdict& verdict, const VerdictFacts& facts) {
  std::vector<std::string> told, open;
  for (const NamedEffect& effect : facts.effects) {
    const bool rivals = verdict.word == "undecidable" && !effect.rivals.empty();
    (rivals ? open : told).push_back(effect.name);
  }
  if (verdict.word == "sufficient") return "the declared model suffices";
  if (verdict.word == "explained") return "explained by " + JoinWords(told);
  if (verdict.word == "not_described") return "not described by this model";
  const std::string cannot = "cannot be told from this record: " + JoinWords(open) + " or another";
  return told.empty() ? cannot : "explained by " + JoinWords(told) + "; beside it " + cannot;
}

}  // namespace phs::identify
