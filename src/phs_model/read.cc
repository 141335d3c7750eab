// Reading model files (docs/phs_models.md).
#include <algorithm>
#include <map>

#include "hydraulics/phs_numbers.h"
#include "hydraulics/phs_validate.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/keys.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {

using hydraulics::BalanceMethod;
using hydraulics::CalcGas;
using hydraulics::CylinderParams;
using hydraulics::EffectParams;
using hydraulics::FrictionCurve;
using hydraulics::FrictionModel;
using hydraulics::FrictionParams;
using hydraulics::GasChargeParams;
using hydraulics::GasLawNames;
using hydraulics::GasVolume;
using hydraulics::LineParams;
using hydraulics::PhsParams;

namespace {

const Range kChargePressure{.min = 1e4, .max = 1e8};

int IndexOf(const std::string& word, const std::vector<std::string>& words) {
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return static_cast<int>(i);
  }
  return 0;
}

/// The maps inside a part's map, each opened once: "end_stop", "reservoir".
class Blocks {
 public:
  explicit Blocks(YamlMap* part) : part_(part) {}
  /// Null: the file has no such block.
  YamlMap* Find(const std::string& name) {
    if (name.empty()) return part_;
    if (!part_->Has(name)) return nullptr;
    return &open_.try_emplace(name, part_->Map(name)).first->second;
  }

 private:
  YamlMap* part_;
  std::map<std::string, YamlMap> open_;
};

/// Every number of the part that the file has.
template <typename Part>
void ReadNumbers(Blocks* blocks, Part* part) {
  for (const auto& row : hydraulics::Numbers<Part>()) {
    const std::string& where = row.info.where;
    const size_t dot = where.find('.');
    const bool inside = dot != std::string::npos;
    YamlMap* map = blocks->Find(inside ? where.substr(0, dot) : "");
    if (map == nullptr) continue;
    double& value = row.of(*part);
    value = map->Number(inside ? where.substr(dot + 1) : where, row.info.allowed, value);
  }
}

// Keys shared by `cylinder_defaults` and each entry of `cylinders`.
void ReadCylinder(YamlMap& map, CylinderParams* c) {
  Blocks blocks(&map);
  ReadNumbers(&blocks, c);
}

void ReadGasLaw(YamlMap* map, GasChargeParams* gas) {
  if (map == nullptr) return;
  gas->law = hydraulics::FindGasLaw(map->Word("law", GasLawNames(), gas->law->name));
}

// `charge_pressure_Pa`: the shell was filled with gas at this pressure and then brought to the
// static pressure by oil; slow, hence at the temperature of the surroundings.
double GasAfterCharging(const LineParams& line, double charge, double T) {
  GasVolume gas;
  // A law with a temperature of its own is isothermal once that is given.
  if (line.reservoir.law->capacity != nullptr) gas.law = line.reservoir.law;
  gas.reference_volume = line.reservoir.volume_m3;
  gas.reference_pressure = charge;
  gas.reference_temperature = T;
  gas.min_volume = 0;
  gas.max_volume = line.reservoir.volume_m3;
  gas.SetMass();
  return CalcGas(gas, line.static_pressure_Pa, T).volume;
}

// A charge given for all lines depends on each line's own static pressure, so it is kept in
// `charge` [Pa] and turned into a gas volume only by the lines themselves.
void ReadLine(YamlMap& map, LineParams* line, double* charge) {
  Blocks blocks(&map);
  ReadNumbers(&blocks, line);
  YamlMap* reservoir = blocks.Find("reservoir");
  ReadGasLaw(reservoir, &line->reservoir);
  ReadGasLaw(blocks.Find("accumulator"), &line->accumulator);
  if (reservoir == nullptr) return;
  if (reservoir->Has("charge_pressure_Pa") && reservoir->Has("gas_volume_m3")) {
    reservoir->Fail("gas_volume_m3", "given together with charge_pressure_Pa", "one of the two");
  }
  if (reservoir->Has("gas_volume_m3")) *charge = 0;
  *charge = reservoir->Number("charge_pressure_Pa", kChargePressure, *charge);
}

void ReadFriction(YamlMap* map, FrictionParams* f) {
  if (map == nullptr) return;
  const std::string model = map->Word("model", kModels, kModels[static_cast<int>(f->model)]);
  f->model = static_cast<FrictionModel>(IndexOf(model, kModels));
  const std::string curve = map->Word("curve", kCurves, kCurves[static_cast<int>(f->curve)]);
  f->curve = static_cast<FrictionCurve>(IndexOf(curve, kCurves));
  f->speed_m_s = map->Numbers("speed_m_s", {}, f->speed_m_s);
  f->force_N = map->Numbers("force_N", {}, f->force_N);
}

/// The first name that is given twice; empty without.
std::string NamedTwice(const std::vector<std::string>& names) {
  for (size_t i = 0; i < names.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1) return names[i];
  }
  return {};
}

}  // namespace

std::vector<EffectParams> ReadEffects(YamlMap map) {
  std::vector<EffectParams> effects;
  for (const std::string& name : map.Keys()) {
    EffectParams effect;
    effect.name = name;
    YamlMap entry = map.Map(name);
    for (const std::string& key : entry.Keys()) {
      if (key == "targets") {
        effect.targets = entry.Texts("targets");
        if (const std::string twice = NamedTwice(effect.targets); !twice.empty()) {
          entry.Fail("targets", Quoted(twice) + " is given twice", "each name once");
        }
      } else if (key == "formula") {
        effect.formula = entry.Text("formula");
      } else {
        effect.values[key] = entry.Number(key, {});
      }
    }
    effects.push_back(std::move(effect));
  }
  return effects;
}

Result<PhsParams> ReadPhsParams(YamlMap& map) {
  PhsParams params;
  params.name = map.Text("name");
  params.description = map.Text("description", "");
  params.source = map.Text("source", "");
  Blocks blocks(&map);
  ReadNumbers(&blocks, &params);
  const std::string balance = map.Word("balance", kBalances, kBalances[0]);
  params.balance = static_cast<BalanceMethod>(IndexOf(balance, kBalances));
  CylinderParams cylinder;
  if (map.Has("cylinder_defaults")) {
    YamlMap defaults = map.Map("cylinder_defaults");
    ReadCylinder(defaults, &cylinder);
  }
  for (YamlMap entry : map.Maps("cylinders")) {
    CylinderParams c = cylinder;
    c.name = entry.Text("name");
    c.bore_line = entry.Text("bore_line", "");
    c.rod_line = entry.Text("rod_line", "");
    ReadCylinder(entry, &c);
    params.cylinders.push_back(c);
  }
  LineParams line;
  double default_charge = 0;
  if (map.Has("line_defaults")) {
    YamlMap defaults = map.Map("line_defaults");
    ReadLine(defaults, &line, &default_charge);
  }
  for (YamlMap entry : map.Maps("lines")) {
    LineParams l = line;
    double charge = default_charge;
    l.name = entry.Text("name");
    ReadLine(entry, &l, &charge);
    if (charge > 0 && l.static_pressure_Pa > 0) {
      l.gas_volume_m3 = GasAfterCharging(l, charge, params.FilledAt());
    }
    params.lines.push_back(l);
  }
  ReadFriction(blocks.Find("friction"), &params.friction);
  if (map.Has("effects")) params.effects = ReadEffects(map.Map("effects"));
  if (Status s = map.Finish(); !s.ok()) return s.error();
  if (Status s = Validate(params); !s.ok()) {
    Error error = s.error();
    error.where = map.path() + ": " + error.where;
    return error;
  }
  return params;
}

Result<PhsParams> LoadPhsParams(const std::string& path) {
  Result<YamlMap> map = YamlMap::Load(path);
  if (!map.ok()) return map.error();
  return ReadPhsParams(map.value());
}

}  // namespace phs::phs_model
