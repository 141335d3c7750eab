#include "identify/models/own_candidates.h"

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "identify/fit/form_starts.h"
#include "rigs/rig_model.h"

namespace phs::identify::search {
namespace {

using measurement::OwnCandidate;

/// Starts of one number: `count` values in the middle of equal parts of its range; of one that may
/// have either sign a tenth of its ends.
hydraulics::FormNumber Starts(const OwnCandidate::Number& number, bool by_factors, int count) {
  if (number.low < 0 && number.high > 0)
    return {number.name, 0.1 * number.low, 0.1 * number.high, 2};
  const double part = 0.5 / count;
  const auto at = [&](double share) {
    return by_factors ? number.low * std::pow(number.high / number.low, share)
                      : number.low + share * (number.high - number.low);
  };
  return {number.name, at(part), at(1 - part), count};
}

}  // namespace

Candidate MakeOwnCandidate(const OwnCandidate& own) {
  Candidate c;
  c.effect = own.effect.name, c.params = own.effect;
  const size_t n = own.numbers.size();
  const int count = n <= 2 ? 4 : n <= 4 ? 2 : 1;
  std::vector<hydraulics::FormNumber> starts;
  for (const OwnCandidate::Number& number : own.numbers) {
    FreeParameter p;
    p.name = "effects." + c.effect + "." + number.name;
    p.low = number.low, p.high = number.high;
    p.logarithmic = p.low > 0 && p.high > 20 * p.low;
    p.scale = (p.high - p.low) / 10;
    starts.push_back(Starts(number, p.logarithmic, count));
    c.free.push_back(p);
    c.none.push_back(0);
  }
  c.starts = GridOf(starts, std::vector<NumberScale>(n));
  return c;
}

void AddOwnCandidates(const std::vector<OwnCandidate>& own, const hydraulics::PhsParams& params,
                      std::vector<Candidate>* out) {
  for (const OwnCandidate& candidate : own) {
    if (!IsIn(params, candidate.effect.name)) out->push_back(MakeOwnCandidate(candidate));
  }
}

Status CheckOwnCandidates(const std::vector<OwnCandidate>& own,
                          const hydraulics::PhsParams& declared, rigs::RigKind kind,
                          const rigs::RigOptions& options) {
  for (const OwnCandidate& candidate : own) {
    if (IsIn(declared, candidate.effect.name)) continue;
    hydraulics::PhsParams with = declared;
    with.effects.push_back(candidate.effect);
    const Result<rigs::RigModel> made = rigs::RigModel::Create(kind, with, options);
    if (made.ok()) continue;
    Error error = made.error();
    const std::string prefix = "effects." + candidate.effect.name;
    if (error.where.starts_with(prefix)) error.where = error.where.substr(prefix.size());
    error.where = candidate.where + error.where;
    return error;
  }
  return {};
}

Status CheckAsked(const std::vector<std::string>& asked, const std::vector<std::string>& known,
                  const std::string& searched) {
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return Error{"candidates: " + name, "is no effect that " + searched + " is searched for",
                 JoinWords(known), DidYouMean(name, known)};
  }
  return {};
}

}  // namespace phs::identify::search
