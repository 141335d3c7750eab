// The effects of the catalogue as candidates: which of their numbers are free, from which values a
// fit may start, on which lines they may act. Several variants of one effect may be tried; the best
// stands for it.
#pragma once

#include <string>
#include <vector>

#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

/// Numbers of an effect that may be freed on top of its core: another physical form of it.
struct EffectOption {
  std::vector<FreeParameter> free;
  std::vector<std::vector<double>> starts;
};

struct Candidate {
  std::string effect;
  hydraulics::EffectParams params;          ///< with fixed values set
  std::vector<FreeParameter> free;          ///< names with "effects." prefix
  std::vector<std::vector<double>> starts;  ///< one value per free parameter
  std::vector<EffectOption> options;        ///< what its form may take on beyond that
  int mains = 1;                            ///< the first so many numbers are its amounts
  bool hydraulic = false;                   ///< can have bent the baseline's volumes
  bool has_onset = false;                   ///< far from linear in its own numbers
  bool shows_at_place = false;              ///< of one cylinder alone, told by its own load cell
};

/// One way of switching an effect on: its free numbers, values of these from which a fit starts,
/// and numbers held at other than their default values.
Candidate MakeCandidate(const hydraulics::EffectInfo& info, const std::vector<const char*>& free,
                        const std::vector<std::vector<double>>& starts,
                        const std::vector<std::pair<const char*, double>>& fixed = {});

/// All candidates for a model of these lines, leaving out effects already in it. On the full rig
/// every effect of cylinders is among them for each cylinder alone too.
std::vector<Candidate> ListCandidates(const hydraulics::PhsParams& params, rigs::RigKind kind);

/// Names of the effects that ListCandidates can give, and `unlisted`.
std::vector<std::string> CandidateNames();

/// The candidate with one of its options free as well; it and others with a number in common go off
/// the list of its options.
Candidate WithOption(const Candidate& candidate, size_t option);

/// Targets and free numbers, for people: "L2,oil_share".
std::string VariantName(const Candidate& candidate);

/// The model with the candidate switched on, its parameters free after those of the model.
FreeModel WithCandidate(const FreeModel& model, const Candidate& candidate);

/// In a list of what was tried: the accepted record of an effect gets another verdict.
template <typename Record>
void Withdraw(const std::string& effect, const char* verdict, std::vector<Record>* records) {
  for (Record& r : *records) {
    if (r.effect == effect && r.verdict == "accepted") r.verdict = verdict;
  }
}

}  // namespace phs::identify::search
