#include "identify/fit/effect_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/words.h"
#include "effects/catalogue.h"
#include "effects/unlisted.h"
#include "identify/fit/form_starts.h"

namespace phs::identify::search {
namespace {

using hydraulics::EffectForm;
using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::FormNumber;
using hydraulics::FormOption;
using hydraulics::PhsParams;
using hydraulics::Places;

const EffectParameter& ParameterOf(const EffectInfo& info, const std::string& name) {
  for (const EffectParameter& p : info.parameters) {
    if (p.name == name) return p;
  }
  PHS_CHECK(false);
  return info.parameters.front();
}

/// Where a number does nothing: as declared, at zero, or (a gain, a ratio) at its default.
double Nothing(const EffectParameter& p, const std::optional<double>& declared) {
  if (declared) return *declared;
  return p.low <= 0 && p.high >= 0 ? 0 : p.otherwise;
}

/// Bounds: of the form, or the plausible range; logarithmic where they span more than a factor 20.
/// A plausible range that begins at zero begins, for a number whose starts are positive, at 1/300
/// of the smallest.
FreeParameter MakeFree(const EffectInfo& info, const FormNumber& number, double unit,
                       double smallest) {
  const EffectParameter& p = ParameterOf(info, number.name);
  const bool bounded = std::isfinite(number.low);
  FreeParameter free;
  free.name = "effects." + info.name + "." + number.name;
  free.low = std::max(bounded ? number.low * unit : p.low, p.min);
  free.high = std::min(bounded ? number.high * unit : p.high, p.max);
  if (!bounded && free.low == 0 && smallest > 0) free.low = smallest / 300;
  free.logarithmic = free.low > 0 && (free.high / free.low > 20 || p.by_factors);
  free.scale = !bounded       ? (free.high - free.low) / (free.low > 0 ? 1 : 10)
               : number.in_si ? std::max(std::abs(number.from), std::abs(number.to))
                              : unit;
  return free;
}

/// Free numbers and their starts, inside the bounds.
void Free(const EffectInfo& info, const std::vector<FormNumber>& numbers, const FormScale& scale,
          std::vector<FreeParameter>* free, std::vector<std::vector<double>>* starts) {
  std::vector<NumberScale> scales;
  for (const FormNumber& number : numbers) {
    const EffectParameter& p = ParameterOf(info, number.name);
    const bool declared = scales.empty() && scale.declared.has_value();
    scales.push_back({scale.size && !number.in_si ? scale.size(p.unit) : 1,
                      Nothing(p, declared ? scale.declared : std::nullopt), declared});
  }
  *starts = GridOf(numbers, scales);
  for (size_t i = 0; i < numbers.size(); ++i) {
    double smallest = starts->front()[i];
    for (const auto& start : *starts) smallest = std::min(smallest, start[i]);
    free->push_back(MakeFree(info, numbers[i], scales[i].unit, smallest));
    for (auto& start : *starts) {
      start[i] = std::clamp(start[i], free->back().low, free->back().high);
    }
  }
}

void AddOptions(const EffectInfo& info, const EffectForm& form, Candidate* candidate) {
  const auto is_free = [&](const std::string& name) {
    return std::any_of(form.free.begin(), form.free.end(),
                       [&](const FormNumber& free) { return free.name == name; });
  };
  const auto is_held = [&](const std::string& name) {
    return std::any_of(form.held.begin(), form.held.end(),
                       [&](const auto& held) { return held.first == name; });
  };
  for (const FormOption& option : info.search.options) {
    const bool known = std::any_of(option.free.begin(), option.free.end(),
                                   [&](const FormNumber& n) { return is_free(n.name); });
    if (known || (option.of_sides && is_held(option.free.front().name))) continue;
    if (!option.with.empty() && !is_free(option.with)) continue;
    if (!option.without.empty() && is_free(option.without)) continue;
    EffectOption& added = candidate->options.emplace_back();
    added.of_sides = option.of_sides;
    Free(info, option.free, {}, &added.free, &added.starts);
  }
}

/// Cylinders or lines that an effect may stand at.
std::vector<std::string> OptionPlaces(const EffectInfo& info, const PhsParams& params) {
  std::vector<std::string> places;
  if (info.targets == "lines") {
    for (const auto& line : params.lines) places.push_back(line.name);
  } else if (!info.targets.empty()) {
    for (const auto& cylinder : params.cylinders) places.push_back(cylinder.name);
  }
  return places;
}

/// A form in all places and, as far as it may stand there and `full` has several, in each alone.
void AddForm(const EffectInfo& info, const EffectForm& form, const PhsParams& params, bool full,
             std::vector<Candidate>* out) {
  FormScale scale;
  if (info.search.declared != nullptr) {
    scale.declared = info.search.declared(params);
    if (*scale.declared == 0) return;  // there is nothing that could be otherwise
  }
  Candidate candidate = MakeCandidate(info, form, scale);
  AddOptions(info, form, &candidate);
  if (form.places != Places::kAlone) out->push_back(candidate);
  const std::vector<std::string> places = OptionPlaces(info, params);
  candidate.shows_at_place = form.places == Places::kAll;
  const bool shown = full && info.targets != "lines";
  if ((candidate.shows_at_place && !shown) || places.size() < 2) return;
  std::erase_if(candidate.options, [](const EffectOption& option) { return option.of_sides; });
  for (const std::string& place : places) {
    candidate.params.targets = {place};
    out->push_back(candidate);
  }
}

}  // namespace

bool IsInstant(const std::string& name) {
  return name.ends_with(".start_s") || name.ends_with(".stop_s");
}

Candidate MakeCandidate(const EffectInfo& info, const EffectForm& form, const FormScale& scale) {
  Candidate candidate;
  candidate.effect = candidate.params.name = info.name;
  for (const EffectParameter& p : info.parameters) candidate.params.values[p.name] = p.otherwise;
  for (const auto& [name, value] : form.held) {
    const EffectParameter& p = ParameterOf(info, name);
    const double unit = scale.size ? scale.size(p.unit) : 1;
    candidate.params.values[name] = std::clamp(value * unit, p.min, p.max);
  }
  Free(info, form.free, scale, &candidate.free, &candidate.starts);
  for (size_t i = 0; i < form.free.size(); ++i) {
    const double nothing =
        Nothing(ParameterOf(info, form.free[i].name), i == 0 ? scale.declared : std::nullopt);
    const bool nowhere = candidate.free[i].logarithmic && !(i == 0 && scale.declared);
    candidate.none.push_back(nowhere ? 0 : nothing);
  }
  candidate.mains = form.amounts;
  return candidate;
}

bool IsIn(const PhsParams& params, const std::string& effect) {
  return std::any_of(params.effects.begin(), params.effects.end(),
                     [&](const auto& present) { return present.name == effect; });
}

std::vector<Candidate> ListCandidates(const PhsParams& params, rigs::RigKind kind) {
  std::vector<Candidate> out;
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    if (IsIn(params, info.name)) continue;
    for (const EffectForm& form : info.search.rig) {
      AddForm(info, form, params, kind == rigs::RigKind::kFull, &out);
    }
  }
  return out;
}

std::vector<std::string> CandidateNames() {
  std::vector<std::string> names;
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    if (!info.search.rig.empty()) names.push_back(info.name);
  }
  names.push_back(effects::UnlistedInfo().name);
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

std::map<std::string, double> HeldNumbers(const Candidate& candidate) {
  std::map<std::string, double> held;
  const EffectInfo* info = effects::Catalogue().FindFor(candidate.params);
  if (info == nullptr) return held;
  for (const EffectParameter& p : info->parameters) {
    const auto value = candidate.params.values.find(p.name);
    const bool is_free = std::any_of(
        candidate.free.begin(), candidate.free.end(),
        [&](const FreeParameter& f) { return f.name == "effects." + info->name + "." + p.name; });
    if (is_free || value == candidate.params.values.end() || value->second == p.otherwise) continue;
    held[p.name] = value->second;
  }
  return held;
}

bool IsElsewhere(const Candidate& a, const Candidate& b) {
  const auto &here = a.params.targets, &there = b.params.targets;
  return a.effect == b.effect && !here.empty() && !there.empty() &&
         std::none_of(here.begin(), here.end(), [&](const std::string& part) {
           return std::find(there.begin(), there.end(), part) != there.end();
         });
}

std::string NameBeside(const Candidate& candidate, const Candidate& other) {
  if (!IsElsewhere(candidate, other)) return candidate.effect;
  return candidate.effect + " on " + JoinWords(candidate.params.targets);
}

std::string VariantName(const Candidate& candidate) {
  std::string name;
  for (const auto& t : candidate.params.targets) name += (name.empty() ? "" : ",") + t;
  for (const auto& p : candidate.free) {
    name += (name.empty() ? "" : ",") + p.name.substr(p.name.rfind('.') + 1);
  }
  for (const auto& [held, value] : HeldNumbers(candidate)) {
    name += fmt::format(",{}={:.4g}", held, value);
  }
  return name;
}

}  // namespace phs::identify::search
