/* A program that knows MuJoCo alone: loads a model, starts from the key "test" as mujoco-testspeed
   does, steps, prints the final state with every digit. Run it with and without the plugin
   preloaded. Usage: foreign_host MODEL STEPS */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  char error[1000] = "";
  mjModel* m;
  mjData* d;
  int key, i;
  if (argc < 3) return 2;
  m = mj_loadXML(argv[1], NULL, error, sizeof error);
  if (m == NULL) {
    printf("refused: %s\n", error);
    return 1;
  }
  d = mj_makeData(m);
  key = mj_name2id(m, mjOBJ_KEY, "test");
  if (key >= 0) mj_resetDataKeyframe(m, d, key);
  for (i = 0; i < atoi(argv[2]); ++i) mj_step(m, d);
  for (i = 0; i < m->nq; ++i) printf("%.17g\n", d->qpos[i]);
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
