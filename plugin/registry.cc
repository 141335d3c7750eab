#include "plugin/registry.h"

#include <atomic>
#include <mutex>
#include <unordered_map>

#include "plugin/settle.h"

namespace phs::plugin {
namespace {

struct State {
  std::mutex mutex;
  std::unordered_map<const mjModel*, std::unique_ptr<Binding>> bindings;
  std::atomic<uint64_t> version{1};
  bool installed = false;
  mjfGeneric previous_passive = nullptr;
  mjfGeneric previous_control = nullptr;
  mjfAct previous_act_dyn = nullptr;
  mjfAct previous_bias = nullptr;
};

/// Never destroyed: models may be stepped while the process ends.
State& Global() {
  static State* state = new State;
  return *state;
}

void PassiveCallback(const mjModel* m, mjData* d) {
  if (Global().previous_passive != nullptr) Global().previous_passive(m, d);
  if (const Binding* binding = Find(m)) binding->Passive(m, d);
}

void ControlCallback(const mjModel* m, mjData* d) {
  if (Global().previous_control != nullptr) Global().previous_control(m, d);
  if (const Binding* binding = Find(m)) binding->Control(m, d);
}

mjtNum ActDynCallback(const mjModel* m, const mjData* d, int id) {
  const Binding* binding = Find(m);
  if (binding != nullptr && binding->Owns(id)) return binding->ActDyn(m, d, id);
  return Global().previous_act_dyn != nullptr ? Global().previous_act_dyn(m, d, id) : 0;
}

mjtNum BiasCallback(const mjModel* m, const mjData* d, int id) {
  const Binding* binding = Find(m);
  if (binding != nullptr && binding->Owns(id)) return binding->Bias(d, id);
  return Global().previous_bias != nullptr ? Global().previous_bias(m, d, id) : 0;
}

/// Installs ours in front of `*slot` unless already there.
template <typename Callback>
void Chain(Callback* slot, Callback ours, Callback* previous) {
  if (*slot == ours) return;
  *previous = *slot;
  *slot = ours;
}

void InstallCallbacks(State* state) {
  Chain(&mjcb_passive, &PassiveCallback, &state->previous_passive);
  Chain(&mjcb_control, &ControlCallback, &state->previous_control);
  Chain(&mjcb_act_dyn, &ActDynCallback, &state->previous_act_dyn);
  Chain(&mjcb_act_bias, &BiasCallback, &state->previous_bias);
}

/// Gives the callbacks back once nobody needs them, if nobody has chained after us.
void UninstallCallbacks(State* state) {
  if (mjcb_passive == &PassiveCallback) mjcb_passive = state->previous_passive;
  if (mjcb_control == &ControlCallback) mjcb_control = state->previous_control;
  if (mjcb_act_dyn == &ActDynCallback) mjcb_act_dyn = state->previous_act_dyn;
  if (mjcb_act_bias == &BiasCallback) mjcb_act_bias = state->previous_bias;
}

void Erase(const mjModel* m) {
  State& state = Global();
  const std::lock_guard<std::mutex> lock(state.mutex);
  if (state.bindings.erase(m) == 0) return;
  ++state.version;
  if (state.bindings.empty()) UninstallCallbacks(&state);
}

}  // namespace

const Binding* Find(const mjModel* m) noexcept {
  struct Last {
    const mjModel* model = nullptr;
    const Binding* binding = nullptr;
    uint64_t version = 0;
  };
  thread_local Last last;
  State& state = Global();
  const uint64_t version = state.version.load(std::memory_order_acquire);
  if (last.model == m && last.version == version) return last.binding;
  const std::lock_guard<std::mutex> lock(state.mutex);
  const auto found = state.bindings.find(m);
  last = {m, found == state.bindings.end() ? nullptr : found->second.get(), version};
  return last.binding;
}

Status Attach(mjModel* m, const AttachOptions& options) {
  Detach(m);
  auto created = Binding::Create(m, options);
  if (!created.ok()) return created.error();
  const Binding* binding = created.value().get();
  State& state = Global();
  {
    const std::lock_guard<std::mutex> lock(state.mutex);
    InstallCallbacks(&state);
    state.bindings[m] = std::move(created).value();
    ++state.version;
  }
  if (Status s = PrepareStart(m, *binding); !s.ok()) {
    Detach(m);
    return s;
  }
  return {};
}

void Detach(mjModel* m) { Erase(m); }

void Forget(const mjModel* m) { Erase(m); }

}  // namespace phs::plugin
