#include "effects/catalogue.h"

#include "base/data_path.h"
#include "effects/accumulator_precharge.h"
#include "effects/asymmetric_friction.h"
#include "effects/backlash.h"
#include "effects/bush_viscoelastic.h"
#include "effects/cavitation.h"
#include "effects/check_restriction.h"
#include "effects/diaphragm_stop.h"
#include "effects/dwell_friction.h"
#include "effects/entrained_air.h"
#include "effects/external_leakage.h"
#include "effects/gas_thermal.h"
#include "effects/hose_expansion.h"
#include "effects/line_inertance.h"
#include "effects/line_resistance.h"
#include "effects/load_flexibility.h"
#include "effects/mount_compliance.h"
#include "effects/moving_mass.h"
#include "effects/piston_leakage.h"
#include "effects/position_friction.h"
#include "effects/presliding.h"
#include "effects/pressure_area.h"
#include "effects/pressure_friction.h"
#include "effects/sensor_delay.h"
#include "effects/sensor_drift.h"
#include "effects/sensor_gain.h"
#include "effects/sensor_offset.h"
#include "effects/stribeck.h"
#include "effects/temperature_drift.h"
#include "effects/temperature_friction.h"
#include "effects/unlisted.h"
#include "effects/viscous_friction.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::ParameterInfo;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

class Table final : public hydraulics::EffectTable {
 public:
  Table()
      : effects_{// hydraulic
                 PistonLeakageInfo(), ExternalLeakageInfo(), LineResistanceInfo(),
                 LineInertanceInfo(), CheckRestrictionInfo(), EntrainedAirInfo(),
                 HoseExpansionInfo(), GasThermalInfo(), AccumulatorPrechargeInfo(),
                 DiaphragmStopInfo(), CavitationInfo(),
                 // friction
                 StribeckInfo(), PreslidingInfo(), PressureFrictionInfo(), PositionFrictionInfo(),
                 DwellFrictionInfo(), ViscousFrictionInfo(), AsymmetricFrictionInfo(),
                 TemperatureFrictionInfo(),
                 // mounting
                 BacklashInfo(), MountComplianceInfo(), BushViscoelasticInfo(),
                 // instrument
                 SensorOffsetInfo(), SensorDriftInfo(), SensorDelayInfo(), SensorGainInfo(),
                 // environment
                 TemperatureDriftInfo(),
                 // a part on a bench
                 PressureAreaInfo(), MovingMassInfo(), LoadFlexibilityInfo(),
                 // found in data
                 UnlistedInfo()} {}
  const std::vector<EffectInfo>& effects() const override { return effects_; }

 private:
  std::vector<EffectInfo> effects_;
};

}  // namespace

const hydraulics::EffectTable& Catalogue() {
  static const Table table;
  return table;
}

Result<PhsParams> FindPhsParams(const std::string& name_or_path) {
  Result<std::string> path = FindData("PHS model", "models/phs", name_or_path, {".yaml"});
  if (!path.ok()) return path.error();
  return hydraulics::LoadPhsParams(path.value());
}

Result<PhsSystem> LoadPhsSystem(const std::string& path) {
  return PhsSystem::Load(path, &Catalogue());
}

Result<PhsSystem> CreatePhsSystem(const PhsParams& params) {
  return PhsSystem::Create(params, &Catalogue());
}

Status AddEffect(PhsParams* params, const std::string& effect) {
  const EffectInfo* info = Catalogue().Find(effect);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const EffectInfo& known : Catalogue().effects()) names.push_back(known.name);
    const std::string nearest = NearestWord(effect, names);
    return Error{effect, "no such effect", "",
                 nearest.empty() ? "" : "did you mean " + nearest + "?"};
  }
  for (const EffectParams& present : params->effects) {
    if (present.name == effect) return Error{effect, "this effect is switched on already"};
  }
  EffectParams added;
  added.name = effect;
  for (const EffectParameter& p : info->parameters) added.values[p.name] = p.otherwise;
  params->effects.push_back(std::move(added));
  return {};
}

std::vector<ParameterInfo> ListAllParameters(const PhsParams& params) {
  std::vector<ParameterInfo> out = hydraulics::ListParameters(params);
  for (const EffectParams& effect : params.effects) {
    const EffectInfo* info = Catalogue().Find(effect.name);
    if (info == nullptr) continue;
    for (const EffectParameter& p : info->parameters) {
      auto found = effect.values.find(p.name);
      const double value = found == effect.values.end() ? p.otherwise : found->second;
      out.push_back({"effects." + effect.name + "." + p.name, p.unit, value, p.low, p.high});
    }
  }
  return out;
}

}  // namespace phs::effects
