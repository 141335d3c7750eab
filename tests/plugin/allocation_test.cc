// The callbacks allocate nothing: operator new is counted while the model steps.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/plugin/attached_model.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// Both sides are replaced here; GCC looks at one of them only.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace phs::plugin {
namespace {

TEST(AllocationTest, SteppingThroughACurveAllocatesNothing) {
  EngineGuard guard;
  for (const char* bogie : {"phs", "rigid_link"}) {
    const ModelPtr m = LoadFile(BogiePath(bogie));
    AttachOptions options;
    options.track = "curve_r250";
    options.speed_m_s = 15;
    options.start_s_m = 60;
    ASSERT_TRUE(Attach(m.get(), options).ok());
    const DataPtr d(mj_makeData(m.get()));
    ResetToStart(m.get(), d.get());
    mj_step(m.get(), d.get());  // the thread looks its model up once
    const long before = allocations;
    for (int i = 0; i < 3000; ++i) mj_step(m.get(), d.get());
    EXPECT_EQ(allocations - before, 0) << bogie;
  }
}

TEST(AllocationTest, ElementsBetweenBodiesAllocateNothing) {
  EngineGuard guard;
  const ModelPtr m = LoadText(
      "<mujoco><size nuserdata='96'/><worldbody><site name='a' pos='0 0 2'/><body><joint/>"
      "<geom size='0.2' pos='0.3 0 0'/><site name='b' pos='0.5 0 0'/></body></worldbody><custom>"
      "<tuple name='damper:d'><element objtype='site' objname='a'/><element objtype='site' "
      "objname='b'/></tuple><text name='damper:d' data='damping_Ns_per_m=10 relief_N=5'/></custom>"
      "</mujoco>");
  ASSERT_TRUE(Attach(m.get(), {}).ok());
  const DataPtr d(mj_makeData(m.get()));
  mj_step(m.get(), d.get());
  const long before = allocations;
  for (int i = 0; i < 1000; ++i) mj_step(m.get(), d.get());
  EXPECT_EQ(allocations - before, 0);
}

TEST(AllocationTest, TheCounterCounts) {
  const long before = allocations;
  int* volatile held = new int(3);  // volatile: the pair may not be left out
  delete held;
  // NOLINTNEXTLINE(clang-analyzer-unix.Malloc): the analyser sees malloc in our operator new
  EXPECT_GT(allocations - before, 0);
}

}  // namespace
}  // namespace phs::plugin
