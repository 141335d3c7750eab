#include "plugin/registry.h"

#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "plugin/callback_chain.h"
#include "plugin/guest.h"
#include "plugin/model_mark.h"
#include "plugin/settle.h"

namespace phs::plugin {
namespace {

/// One attachment: the model and its copies, as far as they have been seen.
struct Attachment {
  std::shared_ptr<const Binding> binding;
  double user_prm = 0;  ///< what stood where the mark is
  std::set<const mjModel*> models;
};

struct State {
  std::mutex mutex;
  std::map<double, Attachment> attachments;  ///< by mark
  std::atomic<uint64_t> version{1};
};

/// Never destroyed: models may be stepped while the process ends.
State& Global() {
  static State* state = new State;
  return *state;
}

struct PassiveHook {
  using Function = mjfGeneric;
  static Function* Slot() { return &mjcb_passive; }
  template <typename Previous>
  static void Serve(const Previous& previous, const mjModel* m, mjData* d) {
    previous();
    const Binding* binding = Find(m);
    if (binding == nullptr) return;
    Guest::Call(m, d);
    binding->Passive(m, d);
  }
};

struct ControlHook {
  using Function = mjfGeneric;
  static Function* Slot() { return &mjcb_control; }
  template <typename Previous>
  static void Serve(const Previous& previous, const mjModel* m, mjData* d) {
    previous();
    if (const Binding* binding = Find(m)) binding->Control(m, d);
  }
};

/// Our actuators are ours alone; others are asked for theirs only.
struct ActDynHook {
  using Function = mjfAct;
  static Function* Slot() { return &mjcb_act_dyn; }
  template <typename Previous>
  static mjtNum Serve(const Previous& previous, const mjModel* m, const mjData* d, int id) {
    const Binding* binding = Find(m);
    return binding != nullptr && binding->Owns(id) ? binding->ActDyn(m, d, id) : previous();
  }
};

struct BiasHook {
  using Function = mjfAct;
  static Function* Slot() { return &mjcb_act_bias; }
  template <typename Previous>
  static mjtNum Serve(const Previous& previous, const mjModel* m, const mjData* d, int id) {
    const Binding* binding = Find(m);
    return binding != nullptr && binding->Owns(id) ? binding->Bias(d, id) : previous();
  }
};

using PassiveChain = CallbackChain<PassiveHook>;
using ControlChain = CallbackChain<ControlHook>;
using ActDynChain = CallbackChain<ActDynHook>;
using BiasChain = CallbackChain<BiasHook>;

bool InstallCallbacks() {
  return PassiveChain::Install() && ControlChain::Install() && ActDynChain::Install() &&
         BiasChain::Install();
}

/// Gives the callbacks back once nobody needs them, as far as nobody has chained after us.
void UninstallCallbacks() {
  PassiveChain::Uninstall();
  ControlChain::Uninstall();
  ActDynChain::Uninstall();
  BiasChain::Uninstall();
}

/// Forgets that `m` is served; an attachment without models goes. The mutex is held.
void Drop(State* state, const mjModel* m) {
  for (auto it = state->attachments.begin(); it != state->attachments.end();) {
    if (it->second.models.erase(m) == 0 || !it->second.models.empty()) {
      ++it;
      continue;
    }
    it = state->attachments.erase(it);
    ++state->version;
    if (state->attachments.empty()) UninstallCallbacks();
  }
}

/// Notes that `m` is served by the attachment of this mark, and by no other (the memory of `m` may
/// have held another model before). Null if there is no such attachment. The mutex is held.
const Binding* Hold(State* state, const mjModel* m, double mark) {
  const auto found = state->attachments.find(mark);
  if (found == state->attachments.end()) return nullptr;
  if (!found->second.models.contains(m)) {
    Drop(state, m);
    found->second.models.insert(m);
  }
  return found->second.binding.get();
}

/// What `m` says about itself: where its mark stands and what it is.
struct Mark {
  int slot = -1;
  double value = 0;
};

Mark ReadMark(const mjModel* m) noexcept {
  if (m == nullptr) return {};
  const int slot = MarkSlot(m);
  if (slot < 0 || !IsMark(m->tuple_objprm[slot])) return {};
  return {slot, m->tuple_objprm[slot]};
}

/// Finds out whether the callbacks of others call ours: they are asked by the engine.
void AskTheEngine(const mjModel* m) {
  const std::unique_ptr<mjData, decltype(&mj_deleteData)> data(mj_makeData(m), &mj_deleteData);
  ResetToStart(m, data.get());
  mj_forward(m, data.get());
}

/// What each replaced callback leaves undone for this binding.
std::string Undone(const mjModel* m, const Binding& binding) {
  std::string text;
  const auto say = [&text](const char* name, const char* what) {
    if (!text.empty()) text += "; ";
    text += std::string(name) + " was replaced and the plugin is not called: " + what;
  };
  if ((m->opt.disableflags & mjDSBL_PASSIVE) != 0) return text;
  if (!PassiveChain::Reached()) say("mjcb_passive", "wheel-rail contact and PHS do not act");
  if (!binding.phs().empty() && (m->opt.disableflags & mjDSBL_ACTUATION) == 0) {
    if (!BiasChain::Reached()) say("mjcb_act_bias", "the PHS does not act");
    if (m->na > 0 && !ActDynChain::Reached()) say("mjcb_act_dyn", "PHS states stand still");
  }
  if (binding.has_rail() && binding.target_speed() > 0 && !ControlChain::Reached()) {
    say("mjcb_control", "the speed hold does not act (a speed of 0 switches it off)");
  }
  return text;
}

}  // namespace

const Binding* Find(const mjModel* m) noexcept {
  struct Last {
    const mjModel* model = nullptr;
    const Binding* binding = nullptr;
    Mark mark;
    uint64_t version = 0;
  };
  thread_local Last last;
  State& state = Global();
  const uint64_t version = state.version.load(std::memory_order_acquire);
  // The mark is read again: the memory may be another model's by now.
  if (m != nullptr && last.model == m && last.version == version &&
      last.mark.slot < m->ntupledata && m->tuple_objprm[last.mark.slot] == last.mark.value) {
    return last.binding;
  }
  const Mark mark = ReadMark(m);
  if (mark.slot < 0) return nullptr;
  const std::lock_guard<std::mutex> lock(state.mutex);
  const Binding* binding = Hold(&state, m, mark.value);
  if (binding != nullptr) last = {m, binding, mark, version};
  return binding;
}

bool WasAttached(const mjModel* m) noexcept { return ReadMark(m).slot >= 0 && Find(m) == nullptr; }

Status Attach(mjModel* m, const AttachOptions& options) {
  Detach(m);
  auto created = Binding::Create(m, options);
  if (!created.ok()) return created.error();
  const int slot = MarkSlot(m);
  if (slot < 0) {
    return Error{"MJCF <custom>", "names no wheelset and no PHS system",
                 "a tuple wheelset:NAME or phs:NAME with elements", "see plugin/README.md"};
  }
  const Binding* binding = created.value().get();
  const double mark = NewMark();
  State& state = Global();
  {
    const std::lock_guard<std::mutex> lock(state.mutex);
    if (!InstallCallbacks()) {
      return Error{"MuJoCo callbacks", "were taken by too many different functions",
                   std::to_string(PassiveChain::kLayers) + " in one process", ""};
    }
    state.attachments[mark] = {std::move(created).value(), m->tuple_objprm[slot], {m}};
    m->tuple_objprm[slot] = mark;
    ++state.version;
  }
  if (Status s = PrepareStart(m, *binding); !s.ok()) {
    Detach(m);
    return s;
  }
  return {};
}

void Detach(mjModel* m) {
  const Mark mark = ReadMark(m);
  if (mark.slot < 0) return;
  State& state = Global();
  const std::lock_guard<std::mutex> lock(state.mutex);
  // A mark that nobody knows is left from a model that was saved while attached.
  const auto found = state.attachments.find(mark.value);
  m->tuple_objprm[mark.slot] = found == state.attachments.end() ? 0 : found->second.user_prm;
  Drop(&state, m);
}

void Forget(const mjModel* m) {
  State& state = Global();
  const std::lock_guard<std::mutex> lock(state.mutex);
  Drop(&state, m);
}

std::string Bypassed(const mjModel* m) {
  const Binding* binding = Find(m);
  if (binding == nullptr || Undone(m, *binding).empty()) return "";
  AskTheEngine(m);
  return Undone(m, *binding);
}

void StandInFront(const mjModel* m) noexcept {
  if (PassiveChain::InFront() && ControlChain::InFront() && ActDynChain::InFront() &&
      BiasChain::InFront()) {
    return;
  }
  if (Find(m) == nullptr) return;
  const std::lock_guard<std::mutex> lock(Global().mutex);
  InstallCallbacks();
}

}  // namespace phs::plugin
