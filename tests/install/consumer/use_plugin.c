/* A bogie under MuJoCo with the installed plugin's C API. Usage: use_plugin MODEL STEPS */
#include <plugin/phs_mujoco.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  char error[1000] = "";
  mjModel* m;
  mjData* d;
  int i;
  if (argc < 3) return 2;
  m = mj_loadXML(argv[1], NULL, error, sizeof error);
  if (m == NULL || phs_attach(m, "speed_m_s=15") != 0) {
    printf("refused: %s%s\n", error, phs_last_error());
    return 1;
  }
  d = mj_makeData(m);
  if (phs_reset(m, d) != 0) {
    printf("refused: %s\n", phs_last_error());
    return 1;
  }
  for (i = 0; i < atoi(argv[2]); ++i) mj_step(m, d);
  printf("phs %s: outputs %d, time %.3f s\n", phs_version(), phs_num_outputs(m), d->time);
  mj_deleteData(d);
  phs_detach(m);
  mj_deleteModel(m);
  return 0;
}
