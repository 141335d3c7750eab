#include "rail/creep_law.h"

#include <cmath>

#include "base/words.h"
#include "rail/fastsim.h"

namespace phs::rail {
namespace {

Status InRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return Error{key, "is " + std::to_string(value),
               std::to_string(low) + " … " + std::to_string(high), ""};
}

Status CheckCreepLaw(const CreepLawParams& p) {
  const Status checks[] = {
      InRange("shear_modulus_Pa", p.material.shear_modulus_Pa, 1e9, 1e12),
      InRange("poisson_ratio", p.material.poisson_ratio, 0, 0.5),
      InRange("fastsim_strips", p.fastsim_strips, 2, Fastsim::kMaxStrips),
      InRange("fastsim_slices", p.fastsim_slices, 2, 1000),
      InRange("slope_reduction.k0", p.slope_reduction.k0, 1e-3, 1),
      InRange("slope_reduction.alpha", p.slope_reduction.alpha, 0, 1),
      InRange("slope_reduction.beta", p.slope_reduction.beta, 0, 1e3),
      InRange("polach_adhesion", p.polach_adhesion, 1e-3, 1),
      InRange("polach_slip", p.polach_slip, 1e-3, p.polach_adhesion),
  };
  for (const Status& check : checks) {
    if (!check.ok()) return check;
  }
  return {};
}

}  // namespace

CreepForce CreepLaw::CalcNear(const CreepInput& input, const CreepMemo&) const noexcept {
  return Calc(input);
}

CreepForce CreepLaw::CalcWithSlope(const CreepInput& input, CreepSlope* slope,
                                   CreepMemo*) const noexcept {
  constexpr double kShare = 1e-3;     // of the creepage
  constexpr double kSmallest = 1e-7;  // where there is none
  const CreepForce here = Calc(input);
  CreepInput moved = input;
  const double dxi = kSmallest + kShare * std::abs(input.xi);
  moved.xi += dxi;
  const CreepForce along = Calc(moved);
  moved.xi = input.xi;
  const double deta = kSmallest + kShare * std::abs(input.eta);
  moved.eta += deta;
  const CreepForce across = Calc(moved);
  *slope = {(along.x - here.x) / dxi, (across.x - here.x) / deta, (along.y - here.y) / dxi,
            (across.y - here.y) / deta};
  return here;
}

std::vector<std::string> CreepLawNames() {
  std::vector<std::string> names;
  for (const CreepLawRow& row : CreepLaws()) names.push_back(row.name);
  return names;
}

std::string DescribeCreepLaws() {
  std::vector<std::string> words;
  for (const CreepLawRow& row : CreepLaws()) words.push_back(row.name + " (" + row.text + ")");
  return JoinWords(words);
}

namespace {

const CreepLawRow* FindCreepLaw(const std::string& name) {
  for (const CreepLawRow& row : CreepLaws()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

Error UnknownLaw(const std::string& name) {
  return {"creep law", "'" + name + "' is not known", JoinWords(CreepLawNames()),
          DidYouMean(name, CreepLawNames())};
}

/// "a:N or b:N with N = …" of all laws that take an option; equal ones stand together.
std::string AllowedOptions() {
  std::vector<std::string> allowed, laws;
  for (const CreepLawRow& row : CreepLaws()) {
    if (row.option.read == nullptr) continue;
    const std::string name = row.name + ":" + row.option.form;
    if (!allowed.empty() && allowed.back() == row.option.allowed) {
      laws.back() += " or " + name;
    } else {
      allowed.push_back(row.option.allowed);
      laws.push_back(name);
    }
  }
  for (size_t i = 0; i < laws.size(); ++i) laws[i] += " with " + allowed[i];
  return JoinWords(laws);
}

}  // namespace

Status ChooseCreepLaw(const std::string& text, CreepLawParams* params) {
  const size_t colon = text.find(':');
  const std::string method = text.substr(0, colon);
  const CreepLawRow* row = FindCreepLaw(method);
  if (row == nullptr) return UnknownLaw(method);
  if (colon != std::string::npos) {
    CreepLawParams read = *params;
    if (row->option.read == nullptr || !row->option.read(text.substr(colon + 1), &read)) {
      return Error{"creep law", "'" + text + "' has no such option", AllowedOptions(), ""};
    }
    *params = read;
  }
  params->method = method;
  return {};
}

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params) {
  const Status valid = CheckCreepLaw(params);
  if (!valid.ok()) return valid.error();
  const CreepLawRow* row = FindCreepLaw(params.method);
  if (row == nullptr) return UnknownLaw(params.method);
  return row->make(params);
}

}  // namespace phs::rail
