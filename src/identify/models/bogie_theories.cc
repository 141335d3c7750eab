#include "identify/models/bogie_theories.h"

#include <map>
#include <string>
#include <utility>

#include "identify/models/bogie_model.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using hydraulics::PhsParams;
using vehicle::Scenario;

std::vector<Theory> OtherTheories(const Scenario& own, const PhsParams& params,
                                  bool stiffness_free) {
  constexpr double kSofter = 0.5, kElsewhere_m = 4e-4;
  std::vector<Theory> others(2, {own, params});
  others[0].scenario.creep = own.creep == "polach" ? "fastsim" : "polach";
  others[1].scenario.track_errors.widening_m += kElsewhere_m;
  if (params.friction.model == hydraulics::FrictionModel::kPresliding) {
    const double softer = stiffness_free ? 1 : kSofter;
    Theory& seals = others.emplace_back(Theory{own, params});
    std::map<std::string, double>& numbers = seals.scenario.phs_changes.parameters;
    for (const auto& [name, factor] : {std::pair{"friction.stiffness_N_per_m", softer},
                                       std::pair{"friction.breakaway_ratio", 0.0}}) {
      auto value = phs_model::GetParameter(params, name);
      if (!value.ok()) continue;
      numbers[name] = factor * value.value();
      PHS_CHECK(phs_model::SetParameter(&seals.phs, name, numbers[name]).ok());
    }
  }
  return others;
}

void AddOtherPlaces(const Scenario& own, const PhsParams& params, std::vector<Theory>* others) {
  for (const auto& [name, factor] :
       {std::pair{"friction.scale", 0.92}, std::pair{"lines.gas_volume_m3", 1.2}}) {
    Theory other{own, params};
    bool any = false;
    for (const std::string& number : TakenApart(params, {name})) {
      auto value = phs_model::GetParameter(params, number);
      if (!value.ok()) continue;
      other.scenario.phs_changes.parameters[number] = factor * value.value(), any = true;
    }
    if (any) others->push_back(std::move(other));
  }
}

}  // namespace phs::identify::search
