#include "vehicle/own_inputs.h"

#include <algorithm>

#include "vehicle/engine.h"

namespace phs::vehicle {

OwnInputsInRun::OwnInputsInRun(const mjModel* m, mjData* d, const plugin::Observer* observer,
                               const OwnInputs& inputs)
    : observer_(observer),
      inputs_(&inputs),
      channels_(observer->channels().size()),
      start_control_(d->ctrl, d->ctrl + m->nu),
      guest_(m, d, [this](const mjModel* model, mjData* data) { Set(model, data); }) {
  // The channels of the start, on data of their own: the run's stay as they are.
  const DataPtr start(mj_copyData(nullptr, m, d));
  mj_forward(m, start.get());
  observer_->Observe(m, start.get(), channels_.data());
}

void OwnInputsInRun::AfterStep(const mjModel* m, const mjData* d) {
  observer_->Observe(m, d, channels_.data());
}

void OwnInputsInRun::Set(const mjModel* m, mjData* d) {
  if (!going_on_) return;
  values_.controls.clear();
  values_.wrenches.clear();
  going_on_ = (*inputs_)({m, d, channels_.data()}, &values_);
  std::copy(start_control_.begin(), start_control_.end(), d->ctrl);
  std::fill(d->xfrc_applied, d->xfrc_applied + 6 * m->nbody, 0.0);
  for (const auto& [actuator, control] : values_.controls) {
    d->ctrl[actuator] = control;
    guest_.Take(actuator);
  }
  for (const OwnValues::Wrench& w : values_.wrenches) {
    mjtNum* applied = d->xfrc_applied + 6 * w.body;
    for (int i = 0; i < 3; ++i) {
      applied[i] += w.force[i];
      applied[3 + i] += w.moment[i];
    }
  }
}

}  // namespace phs::vehicle
