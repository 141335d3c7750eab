// Effects as candidates, made from what their rows say (hydraulics/effect_forms.h): which of their
// numbers are free, from which values a fit may start, on which lines they may act. Several
// variants of one effect may be tried; the best stands for it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"
#include "identify/fit/search_fit.h"
#include "rigs/rig_model.h"

namespace phs::identify::search {

/// Numbers of an effect that may be freed on top of its core: another physical form of it.
struct EffectOption {
  std::vector<FreeParameter> free;
  std::vector<std::vector<double>> starts;
  bool of_sides = false;  ///< not where one place alone is meant
};

struct Candidate {
  std::string effect;
  hydraulics::EffectParams params;          ///< with fixed values set
  std::vector<FreeParameter> free;          ///< names with "effects." prefix
  std::vector<std::vector<double>> starts;  ///< one value per free parameter
  std::vector<EffectOption> options;        ///< what its form may take on beyond that
  int mains = 1;                            ///< the first so many numbers are its amounts
  bool shows_at_place = false;              ///< of one cylinder alone, told by its own load cell
  /// Values at which its own numbers, without options, do nothing; 0 of a logarithmic one: nowhere.
  std::vector<double> none;
};

/// What the numbers of a form are measured in.
struct FormScale {
  /// Of a number of this unit; empty: SI.
  std::function<double(const std::string& unit)> size;
  std::optional<double> declared;  ///< what is declared of the first number
};

/// A time of the record at which something begins or ends: `name` ends with .start_s or .stop_s.
bool IsInstant(const std::string& name);

/// One form of an effect, its starts and options.
Candidate MakeCandidate(const hydraulics::EffectInfo& info, const hydraulics::EffectForm& form,
                        const FormScale& scale);

/// All candidates for a model of these lines, leaving out effects already in it. On the full rig
/// every effect of cylinders is among them for each cylinder alone too.
std::vector<Candidate> ListCandidates(const hydraulics::PhsParams& params, rigs::RigKind kind);

/// True if the model has the effect already.
bool IsIn(const hydraulics::PhsParams& params, const std::string& effect);

/// Names of the effects that ListCandidates can give, and that of a formula.
std::vector<std::string> CandidateNames();

/// The candidate with one of its options free as well; it and others with a number in common go off
/// the list of its options.
Candidate WithOption(const Candidate& candidate, size_t option);

/// Numbers of its effect that its form holds at other than their defaults: an orifice has exponent
/// 0.5. Empty for formulas and laws of one's own.
std::map<std::string, double> HeldNumbers(const Candidate& candidate);

/// Targets and free numbers, for people: "L2,oil_share".
std::string VariantName(const Candidate& candidate);

/// Whether two candidates are one effect on different parts.
bool IsElsewhere(const Candidate& a, const Candidate& b);

/// What a candidate is called beside another: "gas_volume on L2" beside the same effect elsewhere.
std::string NameBeside(const Candidate& candidate, const Candidate& other);

/// The model with the candidate switched on, its parameters free after those of the model.
FreeModel WithCandidate(const FreeModel& model, const Candidate& candidate);

/// In a list of what was tried: the accepted record of an effect gets another verdict.
template <typename Record>
void Withdraw(const std::string& effect, const std::string& verdict, std::vector<Record>* records) {
  for (Record& r : *records) {
    if (r.effect == effect && r.verdict == "accepted") r.verdict = verdict;
  }
}

}  // namespace phs::identify::search
