// Adds a reading law to those sensors of an effect's cylinders that its parameters name.
#pragma once

#include <initializer_list>
#include <memory>

#include "effects/targets.h"

namespace phs::effects {

struct SensorKey {
  hydraulics::Sensor sensor;
  const char* key;  ///< of the parameter
};

/// Law(value, further…) at every sensor whose parameter is not `neutral`.
template <typename Law, typename... Further>
void AddReadings(const hydraulics::EffectParams& effect, std::initializer_list<SensorKey> keys,
                 double neutral, hydraulics::Extension* extension, Further... further) {
  for (int i : TargetCylinders(effect, extension->params())) {
    for (const SensorKey& key : keys) {
      const double value = effect.values.at(key.key);
      if (value == neutral) continue;
      extension->AddReading(i, key.sensor, std::make_unique<Law>(value, further...));
    }
  }
}

}  // namespace phs::effects
