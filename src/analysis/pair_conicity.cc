#include "analysis/pair_conicity.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/gravity.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReach = 10e-3;  ///< to either side [m]
constexpr double kRigidStep = 0.1e-3;
constexpr double kLoadedStep = 0.5e-3;  ///< elastic bodies change smoothly

std::string FileName(const std::string& path) {
  return path.find(':') < path.find('/') ? path : std::filesystem::path(path).filename().string();
}

Json DescribePair(const rail::WheelRailParams& p) {
  return {{"wheel", FileName(p.wheel_profile)},
          {"worn_depth_m", p.wear.depth_m},
          {"rail", FileName(p.rail_profile)},
          {"rail_inclination_rad", p.rail_cant},
          {"gauge_m", p.gauge},
          {"gauge_depth_m", p.gauge_height},
          {"flange_back_distance_m", p.flange_back_distance},
          {"wheel_radius_m", p.wheel_radius}};
}

Json CurveJson(const ConicityCurve& curve) {
  Json amplitude = Json::array(), value = Json::array();
  for (const rail::Conicity& c : curve.points) {
    amplitude.push_back(c.amplitude);
    value.push_back(c.value);
  }
  return {{"wheel_load_N", curve.wheel_load_N}, {"amplitude_m", amplitude}, {"equivalent", value}};
}

}  // namespace

PairConicity CalcConicity(const rail::WheelRail& pair, double wheel_load_N) {
  PairConicity out{"", pair.params()};
  if (pair.wheel_profile() == nullptr || pair.rail_profile() == nullptr) {
    const auto& linear = pair.params().linear;
    out.missing = "this run has no wheel and rail profiles: numbers stand for them" +
                  (linear ? fmt::format(", a conicity of {:g} at every amplitude", linear->conicity)
                          : std::string());
    return out;
  }
  for (const auto& [load, step] :
       {std::pair{0.0, kRigidStep}, std::pair{wheel_load_N, kLoadedStep}}) {
    if (load == 0 && !out.curves.empty()) continue;
    const auto functions = rail::CalcContactFunctions(pair, pair, kReach, step, load);
    if (!functions.ok()) {
      out.missing = functions.error().Line();
      return out;
    }
    if (functions.value().conicity.empty()) {
      out.missing = "the wheelset swings freely at no amplitude from 1 mm on";
      return out;
    }
    out.curves.push_back({load, functions.value().conicity});
  }
  return out;
}

PairConicity CalcConicity(const vehicle::Simulation& simulation) {
  const auto& binding = simulation.binding();
  const double wheels = 2.0 * static_cast<double>(binding.wheelsets().size());
  const double load = simulation.model()->body_subtreemass[0] * kGravity / wheels;
  return CalcConicity(binding.wheel_rail(), load);
}

Json ConicityJson(const PairConicity& conicity) {
  if (!conicity.missing.empty()) return {{"missing", conicity.missing}};
  Json json = DescribePair(conicity.pair);
  Json& curves = json["curves"] = Json::array();
  for (const ConicityCurve& curve : conicity.curves) curves.push_back(CurveJson(curve));
  return json;
}

}  // namespace phs::analysis
