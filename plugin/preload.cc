// LD_PRELOAD=libphs_mujoco.so any-mujoco-program bogie.xml
//
// MuJoCo 2.2.2 has no plugin loading, so the shared library stands in front of the functions that
// load, copy and delete models: a model that names wheelsets or PHS systems is attached as it is
// loaded. It also stands in front of the functions that evaluate it, to stay in the callbacks if
// the program sets its own later. Only libphs_mujoco.so contains this file.
//
// PHS_OPTIONS="speed_m_s=20;track=curve_r400" overrides as in phs_attach. PHS_TRACE=FILE writes
// time and qpos of every step of the first mjData to a CSV with every digit.
#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "plugin/binding.h"
#include "plugin/phs_mujoco.h"
#include "plugin/registry.h"
#include "plugin/scene_marks.h"

namespace {

using Evaluate = void (*)(const mjModel*, mjData*);

template <typename Function>
Function Next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Attaches what concerns us; a model that cannot be attached is refused with the reason.
mjModel* AttachLoaded(mjModel* m, char* error, int error_size) {
  if (m == nullptr || !phs::plugin::Binding::Concerns(m)) return m;
  if (phs_attach(m, std::getenv("PHS_OPTIONS")) == 0) return m;
  std::fprintf(stderr, "%s\n", phs_last_error());
  if (error != nullptr && error_size > 0) {
    std::snprintf(error, static_cast<size_t>(error_size), "%s", phs_last_error());
  }
  Next<void (*)(mjModel*)>("mj_deleteModel")(m);
  return nullptr;
}

/// Says once if MuJoCo reset the data of a run that diverged; it goes on without a word.
void TellReset(const mjModel* m, const mjData* d, double time) {
  static std::atomic<bool> told{false};
  bool reset = false;
  for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    reset = reset || d->warning[kind].number > 0;
  }
  if (!reset || phs::plugin::Find(m) == nullptr || told.exchange(true)) return;
  std::fprintf(stderr,
               "phs: the run diverged at t = %g s and MuJoCo reset it; make the step smaller "
               "(timestep = %g s)\n",
               time, m->opt.timestep);
}

/// Writes the trajectory of the first mjData that steps, if PHS_TRACE asks for it.
class Trace {
 public:
  static Trace& Get() {
    static Trace trace;
    return trace;
  }
  void Step(const mjModel* m, const mjData* d) {
    if (file_ == nullptr || phs::plugin::Find(m) == nullptr) return;
    const mjData* expected = nullptr;
    if (!data_.compare_exchange_strong(expected, d) && expected != d) return;
    std::fprintf(file_, "%.17g", d->time);
    for (int i = 0; i < m->nq; ++i) std::fprintf(file_, ",%.17g", d->qpos[i]);
    std::fputc('\n', file_);
  }

 private:
  Trace() {
    const char* path = std::getenv("PHS_TRACE");
    if (path != nullptr) file_ = std::fopen(path, "w");
  }
  ~Trace() {
    if (file_ != nullptr) std::fclose(file_);
  }
  std::FILE* file_ = nullptr;
  std::atomic<const mjData*> data_{nullptr};
};

}  // namespace

extern "C" {

PHS_API mjModel* mj_loadXML(const char* filename, const mjVFS* vfs, char* error, int error_size) {
  using Load = mjModel* (*)(const char*, const mjVFS*, char*, int);
  return AttachLoaded(Next<Load>("mj_loadXML")(filename, vfs, error, error_size), error,
                      error_size);
}

PHS_API mjModel* mj_loadModel(const char* filename, const mjVFS* vfs) {
  using Load = mjModel* (*)(const char*, const mjVFS*);
  return AttachLoaded(Next<Load>("mj_loadModel")(filename, vfs), nullptr, 0);
}

PHS_API void mj_deleteModel(mjModel* m) {
  phs::plugin::Forget(m);
  Next<void (*)(mjModel*)>("mj_deleteModel")(m);
}

PHS_API mjModel* mj_copyModel(mjModel* dest, const mjModel* src) {
  using Copy = mjModel* (*)(mjModel*, const mjModel*);
  mjModel* copy = Next<Copy>("mj_copyModel")(dest, src);
  phs::plugin::Find(copy);  // from here on the copy stands for itself
  return copy;
}

// Callbacks that the program has set since come behind ours: nothing is lost, no step is bare.
PHS_API void mj_step(const mjModel* m, mjData* d) {
  static const Evaluate next = Next<Evaluate>("mj_step");
  phs::plugin::StandInFront(m);
  const double time = d->time;
  next(m, d);
  TellReset(m, d, time);
  Trace::Get().Step(m, d);
}

// Viewers fill their scene by this: they show track and forces, too.
PHS_API void mjv_updateScene(const mjModel* m, mjData* d, const mjvOption* opt,
                             const mjvPerturb* pert, mjvCamera* cam, int catmask, mjvScene* scn) {
  using Update = void (*)(const mjModel*, mjData*, const mjvOption*, const mjvPerturb*, mjvCamera*,
                          int, mjvScene*);
  static const Update next = Next<Update>("mjv_updateScene");
  next(m, d, opt, pert, cam, catmask, scn);
  const phs::plugin::Binding* binding = phs::plugin::Find(m);
  if (binding != nullptr && (catmask & mjCAT_DECOR) != 0) {
    phs::plugin::AddSceneMarks(m, d, *binding, scn);
  }
}

PHS_API void mj_step1(const mjModel* m, mjData* d) {
  static const Evaluate next = Next<Evaluate>("mj_step1");
  phs::plugin::StandInFront(m);
  next(m, d);
}

PHS_API void mj_step2(const mjModel* m, mjData* d) {
  static const Evaluate next = Next<Evaluate>("mj_step2");
  phs::plugin::StandInFront(m);
  next(m, d);
}

PHS_API void mj_forward(const mjModel* m, mjData* d) {
  static const Evaluate next = Next<Evaluate>("mj_forward");
  phs::plugin::StandInFront(m);
  next(m, d);
}

}  // extern "C"
