#include "effects/catalogue.h"

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
#include "effects/gas_loss.h"
#include "effects/gas_thermal.h"
#include "effects/gas_volume.h"
#include "effects/hose_expansion.h"
#include "effects/line_inertance.h"
#include "effects/line_resistance.h"
#include "effects/load_flexibility.h"
#include "effects/makeup_valve.h"
#include "effects/mount_compliance.h"
#include "effects/moving_mass.h"
#include "effects/oil_stiffening.h"
#include "effects/own_law.h"
#include "effects/piston_leakage.h"
#include "effects/position_friction.h"
#include "effects/presliding.h"
#include "effects/pressure_area.h"
#include "effects/pressure_friction.h"
#include "effects/reservoir_drag.h"
#include "effects/seal_friction.h"
#include "effects/seal_shuttle.h"
#include "effects/sensor_clock.h"
#include "effects/sensor_creep.h"
#include "effects/sensor_crosstalk.h"
#include "effects/sensor_delay.h"
#include "effects/sensor_drift.h"
#include "effects/sensor_gain.h"
#include "effects/sensor_hysteresis.h"
#include "effects/sensor_offset.h"
#include "effects/sensor_saturation.h"
#include "effects/sensor_slew.h"
#include "effects/sensor_supply.h"
#include "effects/snap_through.h"
#include "effects/stribeck.h"
#include "effects/temperature_drift.h"
#include "effects/temperature_friction.h"
#include "effects/throttle.h"
#include "effects/unlisted.h"
#include "effects/viscous_friction.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;

class Table final : public hydraulics::EffectTable {
 public:
  Table()
      : effects_{
            // hydraulic
            PistonLeakageInfo(), ExternalLeakageInfo(), LineResistanceInfo(), LineInertanceInfo(),
            CheckRestrictionInfo(), ThrottleInfo(), EntrainedAirInfo(), HoseExpansionInfo(),
            GasVolumeInfo(), GasThermalInfo(), GasLossInfo(), AccumulatorPrechargeInfo(),
            DiaphragmStopInfo(), CavitationInfo(), OilStiffeningInfo(), SealShuttleInfo(),
            SnapThroughInfo(), ReservoirDragInfo(), MakeupValveInfo(),
            // friction
            SealFrictionInfo(), StribeckInfo(), PreslidingInfo(), PressureFrictionInfo(),
            PositionFrictionInfo(), DwellFrictionInfo(), ViscousFrictionInfo(),
            AsymmetricFrictionInfo(), TemperatureFrictionInfo(),
            // mounting
            BacklashInfo(), MountComplianceInfo(), BushViscoelasticInfo(),
            // instrument
            SensorOffsetInfo(), SensorDriftInfo(), SensorDelayInfo(), SensorGainInfo(),
            SensorCreepInfo(), SensorHysteresisInfo(), SensorSlewInfo(), SensorSaturationInfo(),
            SensorCrosstalkInfo(), SensorClockInfo(), SensorSupplyInfo(),
            // environment
            TemperatureDriftInfo(),
            // a part on a bench
            PressureAreaInfo(), MovingMassInfo(), LoadFlexibilityInfo(),
            // found in data
            UnlistedInfo()} {}
  const std::vector<EffectInfo>& effects() const override { return effects_; }
  const EffectInfo* own() const override { return &OwnLawInfo(); }

 private:
  std::vector<EffectInfo> effects_;
};

}  // namespace

const hydraulics::EffectTable& Catalogue() {
  static const Table table;
  return table;
}

}  // namespace phs::effects
