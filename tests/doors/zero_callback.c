/* Preloaded into `phs simulate`: callbacks of somebody else that were there first and add zero.
   With ZERO_CALLBACK_CALLS=FILE it notes there how often it was called. */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

static long calls = 0;

static void zero(const mjModel* m, mjData* d) {
  int i;
  ++calls;
  for (i = 0; i < m->nv; ++i) d->qfrc_passive[i] += 0.0;
}

__attribute__((constructor)) static void install(void) { mjcb_passive = zero; }

__attribute__((destructor)) static void tell(void) {
  const char* path = getenv("ZERO_CALLBACK_CALLS");
  FILE* file = path != NULL ? fopen(path, "w") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", calls);
  fclose(file);
}
