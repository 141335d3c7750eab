/* The doors of a program of one's own: loads a bogie, steps, writes every recorded row of every
   output. Built twice:
     host_c        links libphs_mujoco and attaches by the C API: host_c MODEL OUT STEPS EVERY OPTIONS
     host_preload  knows MuJoCo alone and finds the outputs, if somebody has loaded the library:
                   LD_PRELOAD=libphs_mujoco.so PHS_OPTIONS=… host_preload MODEL OUT STEPS EVERY
   A further argument `zero` brings callbacks of the program's own that add zero.
   OUT: the names on one line, then the rows as doubles; t_s is the time at the start of the step. */
#define _GNU_SOURCE
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef HOST_LINKS
#include "plugin/phs_mujoco.h"
#else
#include <dlfcn.h>
#endif

typedef int (*num_function)(const mjModel*);
typedef const char* (*name_function)(const mjModel*, int);
typedef int (*outputs_function)(const mjModel*, const mjData*, double*);

static mjfGeneric found_passive, found_control;
static long calls = 0;

static void zero_force(const mjModel* m, mjData* d) {
  int i;
  ++calls;
  if (found_passive != NULL) found_passive(m, d);
  for (i = 0; i < 6 * m->nbody; ++i) d->xfrc_applied[i] = 0;
  for (i = 0; i < m->nv; ++i) d->qfrc_passive[i] += 0.0;
}

static void zero_control(const mjModel* m, mjData* d) {
  if (found_control != NULL) found_control(m, d);
}

static void fail(const char* what, const char* why) {
  fprintf(stderr, "host: %s: %s\n", what, why);
  exit(1);
}

int main(int argc, char** argv) {
  char error[1000] = "";
  const int zero = argc > 1 && strcmp(argv[argc - 1], "zero") == 0;
  num_function count;
  name_function name;
  outputs_function outputs;
  FILE* out;
  mjModel* m;
  mjData* d;
  double* row;
  int n, i, steps, every, time_at = -1;
  if (argc < 5) return 2;
  steps = atoi(argv[3]);
  every = atoi(argv[4]);
  m = mj_loadXML(argv[1], NULL, error, sizeof error);
  if (m == NULL) fail(argv[1], error);
#ifdef HOST_LINKS
  if (argc < 6 || phs_attach(m, argv[5]) != 0) fail("attach", phs_last_error());
  count = phs_num_outputs;
  name = phs_output_name;
  outputs = phs_outputs;
#else
  *(void**)&count = dlsym(RTLD_DEFAULT, "phs_num_outputs");
  *(void**)&name = dlsym(RTLD_DEFAULT, "phs_output_name");
  *(void**)&outputs = dlsym(RTLD_DEFAULT, "phs_outputs");
  if (count == NULL || name == NULL || outputs == NULL) fail("outputs", "nobody offers them");
#endif
  if (zero) {
    found_passive = mjcb_passive;
    found_control = mjcb_control;
    mjcb_passive = zero_force;
    mjcb_control = zero_control;
  }
  d = mj_makeData(m);
  mj_resetDataKeyframe(m, d, mj_name2id(m, mjOBJ_KEY, "test"));
  n = count(m);
  row = malloc((size_t)n * sizeof *row);
  out = fopen(argv[2], "wb");
  if (out == NULL || row == NULL || n <= 0) fail(argv[2], "cannot begin");
  for (i = 0; i < n; ++i) {
    fprintf(out, "%s%s", i > 0 ? "," : "", name(m, i));
    if (strcmp(name(m, i), "t_s") == 0) time_at = i;
  }
  fputc('\n', out);
  for (i = 0; i <= steps; ++i) {
    const double time = d->time;
    mj_step(m, d);
    if (i % every != 0) continue;
    if (outputs(m, d, row) != 0) fail("outputs", "refused");
    if (time_at >= 0) row[time_at] = time;
    fwrite(row, sizeof *row, (size_t)n, out);
  }
  if (zero && calls < steps) fail("callback", "was not called");
  if (fclose(out) != 0) fail(argv[2], "cannot be written");
  free(row);
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
