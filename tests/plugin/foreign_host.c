/* A program that knows MuJoCo alone: loads a model, starts from the key "test" as mujoco-testspeed
   does, steps, prints the final state with every digit. Run it with and without the plugin
   preloaded. Usage: foreign_host MODEL STEPS [MANNER]
     copy      steps a copy of the model, whose original was deleted before
     save      steps the model after mj_saveModel and mj_loadModel
     replace   sets its own mjcb_passive after loading, without calling what it found
     coarse    steps by 50 ms, far too much
     chain     sets its own mjcb_passive after loading, which calls what it found, loads again
   With a callback of its own it fails if that was not called once per step. */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long calls = 0;
static mjfGeneric found = NULL;

static void own_callback(const mjModel* m, mjData* d) {
  ++calls;
  if (found != NULL) found(m, d);
}

static mjModel* load(const char* path) {
  char error[1000] = "";
  mjModel* m = mj_loadXML(path, NULL, error, sizeof error);
  if (m == NULL) {
    printf("refused: %s\n", error);
    exit(1);
  }
  return m;
}

static mjModel* saved_and_loaded(mjModel* m) {
  char path[] = "/tmp/foreign_host_XXXXXX";
  if (mkstemp(path) < 0) exit(2);
  mj_saveModel(m, path, NULL, 0);
  mj_deleteModel(m);
  m = mj_loadModel(path, NULL);
  remove(path);
  return m;
}

int main(int argc, char** argv) {
  const char* manner = argc > 3 ? argv[3] : "";
  mjModel* m;
  mjData* d;
  int key, i, steps;
  if (argc < 3) return 2;
  m = load(argv[1]);
  steps = atoi(argv[2]);
  if (strcmp(manner, "copy") == 0) {
    mjModel* original = m;
    m = mj_copyModel(NULL, original);
    mj_deleteModel(original);
  } else if (strcmp(manner, "save") == 0) {
    m = saved_and_loaded(m);
  } else if (strcmp(manner, "coarse") == 0) {
    m->opt.timestep = 0.05;
  } else if (strcmp(manner, "replace") == 0) {
    mjcb_passive = own_callback;
  } else if (strcmp(manner, "chain") == 0) {
    found = mjcb_passive;
    mjcb_passive = own_callback;
    mj_deleteModel(m);
    m = load(argv[1]);
  }
  d = mj_makeData(m);
  key = mj_name2id(m, mjOBJ_KEY, "test");
  if (key >= 0) mj_resetDataKeyframe(m, d, key);
  calls = 0;
  for (i = 0; i < steps; ++i) mj_step(m, d);
  if (calls != (strcmp(manner, "replace") == 0 || strcmp(manner, "chain") == 0 ? steps : 0))
    return 3;
  for (i = 0; i < m->nq; ++i) printf("%.17g\n", d->qpos[i]);
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
