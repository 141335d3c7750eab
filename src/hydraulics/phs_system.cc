#include "hydraulics/phs_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hydraulics/oil.h"
#include "hydraulics/phs_system_impl.h"
#include "hydraulics/solve_node.h"

namespace phs::hydraulics {

PhsSystem::PhsSystem(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PhsSystem::PhsSystem(PhsSystem&&) noexcept = default;
PhsSystem& PhsSystem::operator=(PhsSystem&&) noexcept = default;
PhsSystem::~PhsSystem() = default;

int PhsSystem::num_cylinders() const { return static_cast<int>(impl_->cylinders.size()); }
int PhsSystem::num_lines() const { return static_cast<int>(impl_->line_names.size()); }
int PhsSystem::num_states() const { return impl_->num_states(); }
int PhsSystem::num_friction_states() const { return impl_->first_slow; }
bool PhsSystem::has_mounts() const { return impl_->has_mounts; }
bool PhsSystem::has_flows() const { return !impl_->paths.empty(); }
bool PhsSystem::has_split_lines() const {
  return std::any_of(impl_->paths.begin(), impl_->paths.end(),
                     [](const Path& path) { return path.part >= 0; });
}
const std::vector<std::string>& PhsSystem::cylinder_names() const { return impl_->cylinder_names; }
const std::vector<std::string>& PhsSystem::line_names() const { return impl_->line_names; }
const std::vector<std::string>& PhsSystem::state_names() const { return impl_->state_names; }
const std::string& PhsSystem::name() const { return impl_->params.name; }
const PhsParams& PhsSystem::params() const { return impl_->params; }
const ReadingLaws& PhsSystem::readings(int cylinder, Sensor sensor) const {
  return impl_->cylinders[cylinder].readings[static_cast<size_t>(sensor)];
}
const Friction& PhsSystem::friction(int cylinder) const {
  return impl_->cylinders[cylinder].friction;
}

const Mount& PhsSystem::mount(int cylinder) const { return impl_->cylinders[cylinder].mount; }
double PhsSystem::Ambient(double time) const { return impl_->Ambient(time); }
const LoadLaws& PhsSystem::loads() const { return impl_->loads; }

const ExtraSeries* PhsSystem::extra() const { return impl_->extra.get(); }

void CompiledPhs::SetTime(double time, Instant* at) const {
  at->time = time;
  SetWarmth(time, at);
  if (extra) extra->At(time, at->extra);
}

double CompiledPhs::Ambient(double time) const {
  double T = params.temperature_K;
  for (const auto& law : ambient) T += law->Rise(time);
  return T;
}

void CompiledPhs::SetWarmth(double time, Instant* at) const {
  at->ambient = Ambient(time);
  const bool thinner = at->ambient != params.temperature_K && !paths.empty();
  at->viscosity =
      thinner ? CalcViscosityRatio(at->ambient) / CalcViscosityRatio(params.temperature_K) : 1;
}

void CompiledPhs::CalcPushed(const double* state, Instant* at) const {
  CalcDisplaced(*at, at->pushed);
  AddPassed(state, at->pushed);
}

void CompiledPhs::CalcDisplaced(const Instant& at, double* pushed) const {
  const double warmer = at.ambient - params.temperature_K;
  for (size_t n = 0; n < nodes.size(); ++n)
    pushed[n] = nodes[n].oil_volume * (nodes[n].expansion * warmer);
  for (size_t i = 0; i < cylinders.size(); ++i) {
    const CompiledCylinder& c = cylinders[i];
    if (c.bore != kOpen) pushed[c.bore] -= c.bore_area * at.piston[i];
    if (c.rod != kOpen) pushed[c.rod] += c.rod_area * at.piston[i];
  }
}

void CompiledPhs::AddPassed(const double* state, double* pushed) const {
  for (const Path& path : paths) {
    if (path.from != kOpen) pushed[path.from] -= state[path.volume];
    if (path.to != kOpen) pushed[path.to] += state[path.volume];
  }
}

void CompiledPhs::SolveNodes(const double* state, Instant* at, const Instant* near) const {
  for (size_t n = 0; n < nodes.size(); ++n) {
    at->node[n] = near != nullptr ? near->node[n] : NodeState{};
    SolveNodeAt(nodes[n], at->pushed[n], at->ambient, state, &at->node[n]);
  }
}

FrictionPlace CompiledPhs::Place(const Instant& at, int cylinder, const double* state) const {
  const CompiledCylinder& c = cylinders[cylinder];
  FrictionPlace place;
  place.piston = at.piston[cylinder];
  if (c.friction.depends_on_pressure()) {
    place.bore_rise = Pressure(at, c.bore) - c.bore_p0;
    place.rod_rise = Pressure(at, c.rod) - c.rod_p0;
  }
  place.time = at.time;
  place.warmer = at.ambient - params.temperature_K;
  if (c.memory >= 0) place.memory = state + c.memory;
  if (extra) place.extra = at.extra;
  return place;
}

double CalcPressureForce(const CompiledPhs& sys, const Instant& at, int cylinder) {
  const CompiledCylinder& c = sys.cylinders[cylinder];
  if (c.bore == kOpen && c.rod == kOpen) return 0;
  return sys.Pressure(at, c.rod) * c.rod_area - sys.Pressure(at, c.bore) * c.bore_area;
}

namespace {

// Forces and energies of one cylinder at an instant whose pressures are known.
void CalcCylinder(const CompiledPhs& sys, const Instant& at, int i, double piston_speed,
                  const double* state, PhsOutputs* out) {
  const CompiledCylinder& c = sys.cylinders[i];
  const double y = at.piston[i];
  const EndStopForce stop = CalcEndStop(c.stop, y, piston_speed);
  const double pressure_force = CalcPressureForce(sys, at, i);
  const double z = c.bristle >= 0 ? state[c.bristle] : 0;
  const FrictionPlace place = sys.Place(at, i, state);
  const FrictionForce friction = c.friction.Calc(piston_speed, z, place);
  double force = pressure_force + stop.force + friction.force;
  double friction_force = friction.force;
  if (out->energy) {
    out->stored_energy += stop.energy + c.friction.Energy(z);
    out->lost_power += stop.lost_power + friction.lost_power;
  }
  if (out->damping) {
    out->damping[i] = stop.damper + c.friction.Damping(friction.force, piston_speed, z, place);
  }
  if (c.mount_state >= 0) {
    const double u = state[c.mount_state];
    const double* q = c.Branches(state);
    double slope;
    force = c.mount.Force(u, q, 0, &slope);
    friction_force = force - pressure_force - stop.force;
    if (out->damping) out->damping[i] = 0;  // the mounting stands between
    if (out->energy) {
      out->stored_energy += c.mount.Energy(u, q);
      out->lost_power += c.mount.Loss(u, q);
    }
  }
  if (out->force) out->force[i] = force;
  if (out->pressure_force) out->pressure_force[i] = pressure_force;
  if (out->friction_force) out->friction_force[i] = friction_force;
  if (out->piston) out->piston[i] = y;
  if (out->p_bore) out->p_bore[i] = sys.Pressure(at, c.bore);
  if (out->p_rod) out->p_rod[i] = sys.Pressure(at, c.rod);
}

void PlacePistons(const CompiledPhs& sys, double time, const double* x, const double* state,
                  Instant* at) {
  sys.SetTime(time, at);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    const int mount = sys.cylinders[i].mount_state;
    at->piston[i] = mount >= 0 ? x[i] - state[mount] : x[i];
  }
}

// Pistons and every pressure, from those of `at` if it has been solved before.
void SolveInstant(const CompiledPhs& sys, double time, const double* x, const double* state,
                  Instant* at) {
  PlacePistons(sys, time, x, state, at);
  sys.CalcPushed(state, at);
  sys.SolveNodes(state, at, at);
}

// Pistons and the pressures of their chambers; other nodes stay unknown.
void PlaceKnown(const CompiledPhs& sys, double time, const double* x, const double* state,
                const double* p_bore, const double* p_rod, Instant* at) {
  PlacePistons(sys, time, x, state, at);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    if (c.bore != kOpen) at->node[c.bore].p = p_bore[i];
    if (c.rod != kOpen) at->node[c.rod].p = p_rod[i];
  }
}

void CalcCylinderFrictionRate(const CompiledPhs& sys, const Instant& at, int cylinder, double h,
                              double speed, const double* state, double* rate) {
  const CompiledCylinder& c = sys.cylinders[cylinder];
  if (c.bristle < 0 && c.memory < 0) return;
  FrictionPlace place = sys.Place(at, cylinder, state);
  place.piston += 0.5 * h * speed;
  if (c.bristle >= 0) {
    const double z = state[c.bristle];
    rate[c.bristle] = h > 0 ? (c.friction.Advance(h, speed, z, place) - z) / h
                            : c.friction.Calc(speed, z, place).bristle_speed;
  }
  if (c.memory < 0) return;
  const double z = c.bristle >= 0 ? state[c.bristle] : 0;
  if (h <= 0) return c.friction.CalcMemoryRates(speed, z, place, rate + c.memory);
  const double* now = state + c.memory;
  double next[kMaxStates];
  std::copy(now, now + c.friction.num_memories(), next);
  c.friction.AdvanceMemories(h, speed, z, place, next);
  for (int k = 0; k < c.friction.num_memories(); ++k) rate[c.memory + k] = (next[k] - now[k]) / h;
}

// Whether rates of states ask for pressures.
bool NeedsPressures(const CompiledPhs& sys) {
  return sys.friction_needs_pressure || sys.num_states() > sys.first_slow;
}

// Speed at the end of a step whose mean is `now`, after one of the same length with mean `before`;
// what stands or is about to turn does not turn.
double GoneOn(double before, double now) {
  const double end = now + 0.5 * (now - before);
  return end * now > 0 ? end : 0;
}

}  // namespace

void PhsSystem::Solve(double time, const double* x, const double* state,
                      Instant* at) const noexcept {
  SolveInstant(*impl_, time, x, state, at);
}

void PhsSystem::Calc(double time, const double* x, const double* v, const double* state,
                     PhsOutputs* out) const noexcept {
  Instant at;
  SolveInstant(*impl_, time, x, state, &at);
  CalcAt(at, x, v, state, out);
}

void PhsSystem::CalcAt(const Instant& at, const double* x, const double* v, const double* state,
                       PhsOutputs* out) const noexcept {
  const CompiledPhs& sys = *impl_;
  out->stored_energy = out->lost_power = 0;
  double speed[kMaxCylinders];
  double rate[kMaxStates];
  std::copy(v, v + sys.cylinders.size(), speed);
  if (sys.has_mounts && out->energy) {
    CalcMountRates(sys, at.time, 0, x, v, state, &at, speed, rate);
  }
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    CalcCylinder(sys, at, static_cast<int>(i), speed[i], state, out);
  }
  if (out->pressure) {
    for (size_t n = 0; n < sys.line_names.size(); ++n) out->pressure[n] = at.node[n].p;
  }
  if (!out->energy) return;
  out->lost_power += CalcHydraulicLoss(sys, at.time, at, state);
  if (!out->stored) {
    out->stored_energy = 0;
    return;
  }
  for (size_t n = 0; n < sys.nodes.size(); ++n) {
    out->stored_energy += CalcNodeEnergy(sys.nodes[n], at.node[n].p, at.ambient, state);
  }
  out->stored_energy += CalcPathEnergy(sys, state);
}

void PhsSystem::CalcStateRate(double time, double h, const double* x, const double* v,
                              const double* state, double* rate,
                              const double* before) const noexcept {
  Instant at;
  if (NeedsPressures(*impl_)) {
    SolveInstant(*impl_, time, x, state, &at);
  } else {
    PlacePistons(*impl_, time, x, state, &at);
  }
  CalcStateRateAt(at, h, x, v, state, rate, before);
}

void PhsSystem::CalcStateRateAt(const Instant& at, double h, const double* x, const double* v,
                                const double* state, double* rate, const double* before,
                                double* piston_way) const noexcept {
  const CompiledPhs& sys = *impl_;
  double speed[kMaxCylinders];
  std::copy(v, v + sys.cylinders.size(), speed);
  if (sys.has_mounts) {
    const Instant* near = NeedsPressures(sys) ? &at : nullptr;
    CalcMountRates(sys, at.time, h, x, v, state, near, speed, rate, piston_way);
  }
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    CalcCylinderFrictionRate(sys, at, static_cast<int>(i), h, speed[i], state, rate);
  }
  if (sys.num_states() == sys.first_slow) return;
  double end[kMaxCylinders] = {};
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    end[i] = before != nullptr ? GoneOn(before[i], speed[i]) : speed[i];
  }
  StageMemory memory = at.stages;
  CalcHydraulicRates(sys, at.time, h, at, {speed, end}, state, &memory, rate);
}

bool PhsSystem::BalanceBody(const Instant& at, double h, const double* x, const double* v,
                            const double* state, const CarriedBody& body, double* piston_way,
                            double* body_way) const noexcept {
  const Instant* near = NeedsPressures(*impl_) ? &at : nullptr;
  return hydraulics::BalanceBody(*impl_, at.time, h, x, v, state, near, body, piston_way, body_way);
}

void PhsSystem::CalcHydraulics(double time, double h, const double* x, const StepSpeeds& v,
                               const double* state, Instant* instant, double* rate, double* p_bore,
                               double* p_rod) const noexcept {
  const CompiledPhs& sys = *impl_;
  Instant& at = *instant;
  PlacePistons(sys, time, x, state, &at);
  sys.CalcPushed(state, &at);
  sys.SolveNodes(state, &at, &at);
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    p_bore[i] = sys.Pressure(at, sys.cylinders[i].bore);
    p_rod[i] = sys.Pressure(at, sys.cylinders[i].rod);
  }
  if (sys.num_states() > sys.first_slow) {
    StageMemory memory = at.stages;
    CalcHydraulicRates(sys, time, h, at, v, state, &memory, rate);
    at.stages = memory;
  }
}

void PhsSystem::CalcForces(double time, const double* x, const double* v, const double* state,
                           const double* p_bore, const double* p_rod,
                           PhsOutputs* out) const noexcept {
  const CompiledPhs& sys = *impl_;
  Instant at;
  PlaceKnown(sys, time, x, state, p_bore, p_rod, &at);
  out->energy = false;
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    CalcCylinder(sys, at, static_cast<int>(i), v[i], state, out);
  }
}

void PhsSystem::CalcFrictionRate(double time, double h, const double* x, const double* v,
                                 const double* state, const double* p_bore, const double* p_rod,
                                 double* rate) const noexcept {
  Instant at;
  PlaceKnown(*impl_, time, x, state, p_bore, p_rod, &at);
  for (size_t i = 0; i < impl_->cylinders.size(); ++i) {
    CalcCylinderFrictionRate(*impl_, at, static_cast<int>(i), h, v[i], state, rate);
  }
}

}  // namespace phs::hydraulics
