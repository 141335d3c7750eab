#include "identify/effect_variants.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "identify/effect_options.h"
#include "identify/effect_recipes.h"

namespace phs::identify::search {
namespace {

using hydraulics::EffectInfo;
using hydraulics::PhsParams;

/// Bounds: the plausible range of the catalogue; logarithmic where it spans
/// more than a factor 20. A range that begins at zero begins, for a number
/// whose starts are positive, at 1/300 of `start`, its smallest start.
FreeParameter FreeNumber(const EffectInfo& info, const std::string& name, double start) {
  for (const auto& p : info.parameters) {
    if (p.name != name) continue;
    FreeParameter free;
    free.name = "effects." + info.name + "." + name;
    free.low = std::max(p.low, p.min), free.high = std::min(p.high, p.max);
    if (free.low == 0 && start > 0) free.low = start / 300;
    free.logarithmic = free.low > 0 && (free.high / free.low > 20 || name == "oil_share");
    free.scale = (free.high - free.low) / (free.low > 0 ? 1 : 10);
    return free;
  }
  PHS_CHECK(false);
  return {};
}

void AddOptions(const EffectInfo& info, const Recipe& recipe, Candidate* candidate) {
  const auto is_free = [&](const char* name) {
    return std::any_of(recipe.free.begin(), recipe.free.end(),
                       [&](const char* free) { return std::string(free) == name; });
  };
  for (const OptionRow& row : Options()) {
    if (info.name != row.effect) continue;
    if (std::any_of(row.free.begin(), row.free.end(), is_free)) continue;
    // Air that does not dissolve has no lag in it.
    const std::string first = row.free[0];
    if (first == "dissolving_time_s" && !is_free("saturation_Pa")) continue;
    // A wave has no beginning.
    if (first == "start_s" && is_free("period_s")) continue;
    // What stands for one side alone stays there.
    const bool one_side = std::any_of(recipe.fixed.begin(), recipe.fixed.end(), [](const auto& f) {
      return std::string(f.first) == "rod_ratio";
    });
    if (one_side && first == "rod_ratio") continue;
    EffectOption option{{}, row.starts};
    for (size_t i = 0; i < row.free.size(); ++i) {
      double smallest = row.starts[0][i];
      for (const auto& start : row.starts) smallest = std::min(smallest, start[i]);
      option.free.push_back(FreeNumber(info, row.free[i], smallest));
    }
    candidate->options.push_back(std::move(option));
  }
}

/// The starts of a precharge stand for a declared one of 15 MPa.
void ScalePrecharge(const PhsParams& params, Candidate* candidate) {
  constexpr double kWritten_Pa = 15e6;
  double declared = 0;
  for (const auto& line : params.lines) {
    if (line.accumulator.volume_m3 > 0) {
      declared = std::max(declared, line.accumulator_precharge_Pa);
    }
  }
  if (declared == 0) return;
  const FreeParameter& p = candidate->free[0];
  for (std::vector<double>& start : candidate->starts) {
    start[0] = std::clamp(start[0] * declared / kWritten_Pa, p.low, p.high);
  }
}

void AddVariants(const Recipe& recipe, const PhsParams& params, rigs::RigKind kind,
                 std::vector<Candidate>* out) {
  const EffectInfo* info = effects::Catalogue().Find(recipe.effect);
  if (info == nullptr) return;
  Candidate candidate = MakeCandidate(*info, recipe.free, recipe.starts, recipe.fixed);
  AddOptions(*info, recipe, &candidate);
  if (candidate.effect == "accumulator_precharge") ScalePrecharge(params, &candidate);
  if (recipe.spread != Spread::kAlone) out->push_back(candidate);
  std::vector<std::string> places;
  if (info->targets == "lines") {
    for (const auto& line : params.lines) places.push_back(line.name);
  } else {
    for (const auto& cylinder : params.cylinders) places.push_back(cylinder.name);
  }
  candidate.shows_at_place = recipe.spread == Spread::kAll;
  const bool full = kind == rigs::RigKind::kFull && info->targets != "lines";
  if ((candidate.shows_at_place && !full) || places.size() < 2) return;
  std::erase_if(candidate.options, [](const EffectOption& option) {
    return option.free[0].name.ends_with(".rod_ratio");
  });
  for (const std::string& place : places) {
    candidate.params.targets = {place};
    out->push_back(candidate);
  }
}

}  // namespace

Candidate MakeCandidate(const EffectInfo& info, const std::vector<const char*>& free,
                        const std::vector<std::vector<double>>& starts,
                        const std::vector<std::pair<const char*, double>>& fixed) {
  Candidate candidate;
  candidate.effect = info.name;
  candidate.params.name = info.name;
  for (const auto& p : info.parameters) candidate.params.values[p.name] = p.otherwise;
  for (const auto& [name, value] : fixed) candidate.params.values[name] = value;
  for (size_t i = 0; i < free.size(); ++i) {
    double smallest = starts[0][i];
    for (const auto& start : starts) smallest = std::min(smallest, start[i]);
    candidate.free.push_back(FreeNumber(info, free[i], smallest));
  }
  candidate.starts = starts;
  // One of two directions (or sides, or parts of a wave) may have none of it.
  const bool two = candidate.free.size() > 1 &&
                   (info.name == "check_restriction" || info.name == "viscous_friction" ||
                    info.name == "pressure_friction" ||
                    candidate.free[1].name.find("_cosine") != std::string::npos);
  // A hose that never stiffens is oil volume, which is free already.
  const bool stiffens =
      candidate.free.size() > 1 && candidate.free[1].name.ends_with("stiffening_Pa");
  candidate.mains = two || stiffens ? 2 : 1;
  candidate.hydraulic = info.family == "hydraulic";
  candidate.has_onset = candidate.hydraulic || info.family == "mounting" ||
                        info.name == "presliding" || info.name == "dwell_friction" ||
                        candidate.free.back().name.ends_with(".start_s");
  return candidate;
}

std::vector<Candidate> ListCandidates(const PhsParams& params, rigs::RigKind kind) {
  std::vector<Candidate> out;
  for (const auto* rows : {&Hydraulic(), &FrictionAndMounting(), &InstrumentAndEnvironment()}) {
    if (kind == rigs::RigKind::kElement && rows == &Hydraulic()) continue;
    for (const Recipe& recipe : *rows) {
      const bool present = std::any_of(params.effects.begin(), params.effects.end(),
                                       [&](const auto& e) { return e.name == recipe.effect; });
      if (!present) AddVariants(recipe, params, kind, &out);
    }
  }
  return out;
}

std::vector<std::string> CandidateNames() {
  std::vector<std::string> names;
  for (const auto* rows : {&Hydraulic(), &FrictionAndMounting(), &InstrumentAndEnvironment()}) {
    for (const Recipe& recipe : *rows) {
      if (names.empty() || names.back() != recipe.effect) names.emplace_back(recipe.effect);
    }
  }
  names.emplace_back("unlisted");
  return names;
}

Candidate WithOption(const Candidate& candidate, size_t option) {
  Candidate out = candidate;
  for (const FreeParameter& p : candidate.options[option].free) out.free.push_back(p);
  const auto is_free = [&](const FreeParameter& p) {
    return std::any_of(out.free.begin(), out.free.end(),
                       [&](const FreeParameter& free) { return free.name == p.name; });
  };
  std::erase_if(out.options, [&](const EffectOption& other) {
    return std::any_of(other.free.begin(), other.free.end(), is_free);
  });
  return out;
}

FreeModel WithCandidate(const FreeModel& model, const Candidate& candidate) {
  FreeModel out = model;
  out.params.effects.push_back(candidate.params);
  out.free.insert(out.free.end(), candidate.free.begin(), candidate.free.end());
  return out;
}

std::string VariantName(const Candidate& candidate) {
  std::string name;
  for (const auto& t : candidate.params.targets) name += (name.empty() ? "" : ",") + t;
  for (const auto& p : candidate.free) {
    name += (name.empty() ? "" : ",") + p.name.substr(p.name.rfind('.') + 1);
  }
  return name;
}

}  // namespace phs::identify::search
