// C API of the plugin: for any program that has an mjModel. Link libphs_mujoco.so (or preload it).
//
//   mjModel* m = mj_loadXML("phs.xml", NULL, error, sizeof error);
//   if (phs_attach(m, "speed_m_s=20;track=curve_r400") != 0) puts(phs_last_error());
//   mjData* d = mj_makeData(m);
//   phs_reset(m, d);                 // settled on the track, rolling
//   while (d->time < 10) mj_step(m, d);
//   phs_detach(m);                   // before mj_deleteModel
//
// Threads: attach and detach while nobody steps the model; stepping is free of locks.
// All functions return 0 on success, -1 on error with the text in phs_last_error().
//
// Callbacks of others are chained: those installed before are called first, those installed later
// may call what they found; each is called once per engine call, whatever is attached, copied or
// detached meanwhile. A callback that replaces ours without calling it switches the plugin off:
// phs_outputs says so, phs_reset puts the plugin in front again (and calls the other one). Where
// the library is preloaded or linked before MuJoCo, mj_step does that by itself.
//
// Copies: a model made by mj_copyModel from an attached one is attached too, with the same physics,
// and stays so when the original is detached or deleted. Where the library is linked after MuJoCo
// it learns of a copy at its first step: take one before the original goes. A model saved by
// mj_saveModel is the user's own; attach it after loading. Detach copies too, before they go.
#ifndef PHS_MUJOCO_H_
#define PHS_MUJOCO_H_

#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32)
#define PHS_API
#else
#define PHS_API __attribute__((visibility("default")))
#endif

/// Binds a model whose <custom> section names wheelsets or PHS systems (plugin/README.md).
/// `options`: NULL, or "key=value;key=value" with the keys track, wheel, rail, creep, phs,
/// friction, flange_friction, speed_m_s, start_s_m; they override the model's <custom> values; and
/// failures=KIND:LINE:AT_S,… (KIND as in docs/failures.md).
PHS_API int phs_attach(mjModel* m, const char* options);
/// Forgets the model and undoes the changes to it; the key "test" keeps the running start. Unknown
/// models are ignored.
PHS_API void phs_detach(mjModel* m);
/// Version of the library, "MAJOR.MINOR.PATCH" (semver.org). Programs that were built with a library
/// of the same file name libphs_mujoco.so.N run with this one.
PHS_API const char* phs_version(void);
/// Text of the last error on this thread; "" if none.
PHS_API const char* phs_last_error(void);
/// Resets `d` to the settled running start on the track; the plugin stands in front of the
/// callbacks from then on.
PHS_API int phs_reset(const mjModel* m, mjData* d);
/// Number of named outputs, or -1 if the model is not attached.
PHS_API int phs_num_outputs(const mjModel* m);
/// Name with unit of an output (e.g. "lead_left_Y_N"), or NULL.
PHS_API const char* phs_output_name(const mjModel* m, int index);
/// All outputs at the state of `d` (after mj_forward or mj_step); `values` has phs_num_outputs. An
/// error if a callback was replaced since, so that the forces told here do not act.
PHS_API int phs_outputs(const mjModel* m, const mjData* d, double* values);

#ifdef __cplusplus
}
#endif

#endif  // PHS_MUJOCO_H_
