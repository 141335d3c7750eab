/* A viewer that knows the engine and nothing of ours, but for the picture: run under the preload
   library it must find track and forces in its scene. scene_host MODEL.xml */
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>

static int fail(const char* what) {
  printf("%s\n", what);
  return 1;
}

int main(int argc, char** argv) {
  char error[500] = "";
  mjModel* m = argc > 1 ? mj_loadXML(argv[1], NULL, error, sizeof error) : NULL;
  if (m == NULL) return fail(error);
  mjData* d = mj_makeData(m);
  const int key = mj_name2id(m, mjOBJ_KEY, "test");
  if (key < 0) return fail("no key 'test'");
  mj_resetDataKeyframe(m, d, key);
  for (int i = 0; i < 20; ++i) mj_step(m, d);
  mjvScene scene;
  mjvCamera camera;
  mjvOption option;
  mjv_defaultScene(&scene);
  mjv_makeScene(m, &scene, 2000);
  mjv_defaultFreeCamera(m, &camera);
  mjv_defaultOption(&option);
  mjv_updateScene(m, d, &option, NULL, &camera, mjCAT_STATIC | mjCAT_DYNAMIC, &scene);
  const int bare = scene.ngeom;
  mjv_updateScene(m, d, &option, NULL, &camera, mjCAT_ALL, &scene);
  int rails = 0, sleepers = 0;
  double load = 0;
  for (int i = 0; i < scene.ngeom; ++i) {
    const mjvGeom* g = scene.geoms + i;
    if (g->category != mjCAT_DECOR) continue;
    rails += g->type == mjGEOM_CAPSULE && fabs(g->size[0] - 0.036) < 1e-6;
    sleepers += g->type == mjGEOM_BOX;
    /* Arrows that point upwards: 4e-6 m per newton. */
    if (g->type == mjGEOM_ARROW && g->mat[8] > 0.99f && g->rgba[2] > 0.8f) load += g->size[2] / 4e-6;
  }
  double mass = 0;
  for (int i = 0; i < m->nbody; ++i) mass += m->body_mass[i];
  printf("%d geoms of the model, %d pieces of rail, %d sleepers, %.0f kN on the wheels\n", bare,
         rails, sleepers, load / 1e3);
  if (rails < 100) return fail("no rails");
  if (sleepers < 80) return fail("no sleepers");
  if (fabs(load - 9.81 * mass) > 0.02 * 9.81 * mass) return fail("the arrows do not carry the weight");
  mjv_freeScene(&scene);
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
