// A PHS as readers of results see it.
#include "plugin/binding.h"

namespace phs::plugin {

PhsState Binding::CalcPhs(const mjModel*, const mjData* d, int index) const {
  const PhsBinding& p = phs_[index];
  PhsState s;
  for (int i = 0; i < p.system->num_cylinders(); ++i) {
    const size_t at = static_cast<size_t>(i);
    s.displacement.push_back(d->actuator_length[p.cylinder[at]] - p.length0[at]);
    s.speed.push_back(d->userdata[p.speeds_at + i]);
  }
  for (int i = 0; i < p.system->num_states(); ++i) s.state.push_back(d->userdata[p.states_at + i]);
  for (auto* v : {&s.force, &s.pressure_force, &s.friction_force, &s.piston, &s.p_bore, &s.p_rod}) {
    v->resize(p.cylinder.size());
  }
  s.pressure.resize(p.system->num_lines());
  hydraulics::PhsOutputs out{s.force.data(),  s.pressure_force.data(), s.friction_force.data(),
                             s.piston.data(), s.p_bore.data(),         s.p_rod.data(),
                             nullptr,         s.pressure.data()};
  p.system->Calc(d->time, s.displacement.data(), s.speed.data(), s.state.data(), &out);
  s.stored_energy = out.stored_energy;
  s.lost_power = out.lost_power;
  return s;
}

}  // namespace phs::plugin
