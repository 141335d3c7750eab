// Laws of the user's own as candidates (measurement/own_candidate.h).
#pragma once

#include <vector>

#include "identify/fit/effect_variants.h"
#include "measurement/own_candidate.h"

namespace phs::identify::search {

/// Free numbers in the ranges of the file; starts are a grid over them.
Candidate MakeOwnCandidate(const measurement::OwnCandidate& own);

/// Adds those that are not in the model yet.
void AddOwnCandidates(const std::vector<measurement::OwnCandidate>& own,
                      const hydraulics::PhsParams& params, std::vector<Candidate>* out);

/// An error where the model refuses one of them: it names its place in the file.
Status CheckOwnCandidates(const std::vector<measurement::OwnCandidate>& own,
                          const hydraulics::PhsParams& declared, rigs::RigKind kind,
                          const rigs::RigOptions& options);

/// An error where one of the names of the catalogue that were asked for is none of `known`.
Status CheckAsked(const std::vector<std::string>& asked, const std::vector<std::string>& known,
                  const std::string& searched);

}  // namespace phs::identify::search
