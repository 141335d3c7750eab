#include "truth.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../random_source.h"

namespace bogie_curve {
namespace {

struct Curve {
  const char* name;
  double tangent, transition, arc, last_tangent, radius, cant, speed_km_h;
};
// models/scenarios/curve_NAME.yaml and its track.
constexpr Curve kCurves[] = {{"r250", 70, 50, 220, 50, 250, 0.045, 50},
                             {"r300", 70, 50, 220, 50, 300, 0.045, 55},
                             {"r550", 80, 60, 300, 60, 550, 0.060, 80}};

constexpr double kConicity = 0.15, kHead = 0.10;  // the pair "cone": [1], [m]

template <size_t line>
void Leak(double value, Truth* t) {
  t->steering.line[line].leak = value;
}
template <size_t line>
void Gas(double value, Truth* t) {
  t->steering.line[line].gas *= value;
}

}  // namespace

const std::vector<Hideable>& HideableList() {
  static const std::vector<Hideable> list = {
      {"leak_L1", "line L1 leaks [m3/(Pa s)]", Leak<0>},
      {"leak_L2", "line L2 leaks [m3/(Pa s)]", Leak<1>},
      {"leak_L3", "line L3 leaks [m3/(Pa s)]", Leak<2>},
      {"leak_L4", "line L4 leaks [m3/(Pa s)]", Leak<3>},
      {"gas_L2", "gas of L2 over what it was", Gas<1>},
      {"gas_L3", "gas of L3 over what it was", Gas<2>},
      {"seal_1", "seal friction of cylinder 1 over the others'",
       [](double v, Truth* t) { t->steering.seal.scale[0] *= v; }},
      {"seals", "seal friction of every cylinder over what it was",
       [](double v, Truth* t) {
         for (double& scale : t->steering.seal.scale) scale *= v;
       }},
      {"viscous", "viscous friction of every seal beside the declared [N s/m]",
       [](double v, Truth* t) { t->steering.seal.viscous = v; }},
      {"cant", "cant of the curve beyond the declared [m]",
       [](double v, Truth* t) { t->design.cant += v; }},
      {"box_spring", "springs of the leading left box over the others'",
       [](double v, Truth* t) { t->bogie.box_spring = v; }},
      {"wheel_larger", "radius of the leading left wheel beyond the others' [m]",
       [](double v, Truth* t) { t->bogie.wheel_larger = v; }},
      {"rail_friction", "friction of wheel on rail", [](double v, Truth* t) { t->friction = v; }},
  };
  return list;
}

std::vector<std::string> CurveNames() {
  std::vector<std::string> names;
  for (const Curve& c : kCurves) names.push_back(c.name);
  return names;
}

Truth DeclaredTruth(const std::string& curve) {
  for (const Curve& c : kCurves) {
    if (curve != c.name) continue;
    Truth truth;
    truth.curve = curve;
    truth.design.tangent = c.tangent, truth.design.transition = c.transition;
    truth.design.arc = c.arc, truth.design.last_tangent = c.last_tangent;
    truth.design.radius = c.radius, truth.design.cant = c.cant;
    truth.bogie.speed = c.speed_km_h / 3.6;
    return truth;
  }
  throw std::invalid_argument("no curve '" + curve + "'");
}

void DrawOffDeclared(uint64_t seed, Truth* truth) {
  rigdata::RandomSource random(seed, "off declared");
  const auto factor = [&] { return 1 + random.Sign() * random.Uniform(0.05, 0.15); };
  truth->seed = seed;
  truth->seal_factor = factor(), truth->gas_factor = factor(), truth->oil_factor = factor();
  for (double& scale : truth->steering.seal.scale) scale *= truth->seal_factor;
  for (LineNumbers& line : truth->steering.line) {
    line.gas *= truth->gas_factor;
    line.oil *= truth->oil_factor;
  }
  truth->bogie.speed *= 1 + random.Uniform(-0.005, 0.005);
}

void Hide(const std::string& name, double value, Truth* truth) {
  std::string known;
  for (const Hideable& h : HideableList()) {
    if (name == h.name) {
      h.apply(value, truth);
      truth->hidden.emplace_back(name, value);
      return;
    }
    known += std::string(known.empty() ? "" : ", ") + h.name;
  }
  throw std::invalid_argument("'" + name + "' cannot be hidden; what can: " + known);
}

BogieMotion MakeBogie(const Truth& truth, const TrackLine& track, const std::string& profiles) {
  WheelRailPair pair;
  if (truth.pair == "cone") {
    pair.wheel = Section::Cone(kConicity);
    pair.rail = Section::Arc(kHead);
  } else {
    pair.wheel = Section::Read(profiles + "/S1002.prw", false);
    pair.rail = Section::Read(profiles + "/UIC60.prr", true);
  }
  pair.friction = truth.friction;
  return {truth.bogie, track, WheelOnRail(pair), SteeringOil(truth.steering)};
}

std::string TruthJson(const Truth& truth, const std::string& command) {
  nlohmann::ordered_json json;
  json["command"] = command;
  json["rig"] = "bogie";
  json["curve"] = truth.curve;
  json["pair"] = truth.pair;
  json["phs"] = truth.phs;
  json["seed"] = truth.seed;
  json["effects"] = nlohmann::ordered_json::array();
  for (const auto& [name, value] : truth.hidden) {
    json["effects"].push_back({{"name", name}, {"value", value}});
  }
  json["factors_on_declared"] = {{"friction.scale", truth.seal_factor},
                                 {"lines.gas_volume_m3", truth.gas_factor},
                                 {"lines.oil_volume_m3", truth.oil_factor}};
  json["speed_m_s"] = truth.bogie.speed;
  json["cant_m"] = truth.design.cant;
  return json.dump(1) + "\n";
}

}  // namespace bogie_curve
