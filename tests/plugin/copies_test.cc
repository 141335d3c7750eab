// Copies and saved files of attached models, and what others' callbacks do to them.
#include <gmock/gmock.h>

#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include "plugin/model_mark.h"
#include "plugin/phs_mujoco.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

using testing::HasSubstr;

AttachOptions InACurve() {
  AttachOptions options;
  options.track = "curve_r400";
  options.speed_m_s = 15;
  options.start_s_m = 60;
  return options;
}

class CopiesTest : public testing::Test {
 protected:
  void SetUp() override {
    model_ = LoadFile(BogiePath("phs"));
    ASSERT_TRUE(Attach(model_.get(), InACurve()).ok());
  }
  static std::vector<double> Run(const mjModel* m, int steps) {
    const DataPtr d(mj_makeData(m));
    ResetToStart(m, d.get());
    return Continue(m, d.get(), steps);
  }
  static std::vector<double> Continue(const mjModel* m, mjData* d, int steps) {
    for (int i = 0; i < steps; ++i) mj_step(m, d);
    std::vector<double> state(d->qpos, d->qpos + m->nq);
    state.insert(state.end(), d->qvel, d->qvel + m->nv);
    state.insert(state.end(), d->act, d->act + m->na);
    return state;
  }
  ModelPtr Copy() const { return ModelPtr(mj_copyModel(nullptr, model_.get())); }

  ModelPtr model_;

 private:
  EngineGuard guard_;
};

TEST_F(CopiesTest, ACopyRunsAsTheOriginalToTheLastBit) {
  const std::vector<double> expected = Run(model_.get(), 600);
  const ModelPtr copy = Copy();
  EXPECT_EQ(Run(copy.get(), 600), expected);
  const ModelPtr copy_of_copy(mj_copyModel(nullptr, copy.get()));
  EXPECT_EQ(Run(copy_of_copy.get(), 600), expected);
  EXPECT_EQ(Run(model_.get(), 600), expected);
}

TEST_F(CopiesTest, ACopyOutlivesTheOriginal) {
  const std::vector<double> expected = Run(model_.get(), 600);
  const ModelPtr copy = Copy();
  const DataPtr d(mj_makeData(copy.get()));
  ResetToStart(copy.get(), d.get());
  Continue(copy.get(), d.get(), 300);
  model_.reset();
  EXPECT_EQ(Continue(copy.get(), d.get(), 300), expected);
}

TEST_F(CopiesTest, ACopyCanBeAttachedDifferently) {
  const std::vector<double> expected = Run(model_.get(), 300);
  const ModelPtr copy = Copy();
  AttachOptions faster = InACurve();
  faster.speed_m_s = 18;
  ASSERT_TRUE(Attach(copy.get(), faster).ok());
  EXPECT_NE(Run(copy.get(), 300), expected);
  EXPECT_EQ(Run(model_.get(), 300), expected);
  EXPECT_EQ(Find(copy.get())->target_speed(), 18);
  EXPECT_EQ(Find(model_.get())->target_speed(), 15);
}

TEST_F(CopiesTest, AnotherModelAtTheSamePlaceInMemoryIsNotTakenForTheOld) {
  const ModelPtr plain = LoadFile(BogiePath("rigid_link"));
  mjModel* place = Copy().release();
  EXPECT_NE(Find(place), nullptr);
  mj_copyModel(place, model_.get());
  EXPECT_NE(Find(place), nullptr);
  const int slot = MarkSlot(place);
  place->tuple_objprm[slot] = 0;  // as the memory of a model that was never attached
  EXPECT_EQ(Find(place), nullptr);
  mj_deleteModel(place);
  EXPECT_EQ(Find(plain.get()), nullptr);
}

TEST_F(CopiesTest, AnOrphanSaysWhatItIs) {
  const ModelPtr copy = Copy();  // never stepped: nobody knows it
  model_.reset();
  EXPECT_EQ(Find(copy.get()), nullptr);
  EXPECT_EQ(phs_num_outputs(copy.get()), -1);
  EXPECT_THAT(phs_last_error(), HasSubstr("copied or saved"));
  ASSERT_EQ(phs_attach(copy.get(), "track=curve_r400;speed_m_s=15;start_s_m=60"), 0)
      << phs_last_error();
  EXPECT_GT(phs_num_outputs(copy.get()), 0);
}

TEST_F(CopiesTest, ASavedModelAttachedAgainGivesTheSameBits) {
  const std::vector<double> expected = Run(model_.get(), 600);
  const std::string path = ScratchFile("saved.mjb");
  mj_saveModel(model_.get(), path.c_str(), nullptr, 0);
  model_.reset();
  const ModelPtr loaded(mj_loadModel(path.c_str(), nullptr));
  std::remove(path.c_str());
  ASSERT_NE(loaded, nullptr);
  EXPECT_TRUE(WasAttached(loaded.get()));
  ASSERT_TRUE(Attach(loaded.get(), InACurve()).ok());
  EXPECT_EQ(Run(loaded.get(), 600), expected);
  Detach(loaded.get());
  for (int i = 0; i < loaded->ntupledata; ++i) EXPECT_EQ(loaded->tuple_objprm[i], 0);
}

TEST_F(CopiesTest, DetachingRestoresTheModelExactly) {
  const ModelPtr fresh = LoadFile(BogiePath("phs"));
  Detach(model_.get());
  const mjModel* a = fresh.get();
  const mjModel* b = model_.get();
  ASSERT_EQ(a->nbuffer, b->nbuffer);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bytes themselves are meant
  EXPECT_EQ(std::memcmp(&a->opt, &b->opt, sizeof a->opt), 0);
  EXPECT_EQ(std::memcmp(a->dof_damping, b->dof_damping, sizeof(mjtNum) * a->nv), 0);
  EXPECT_EQ(std::memcmp(a->tuple_objprm, b->tuple_objprm, sizeof(mjtNum) * a->ntupledata), 0);
  // Byte for byte, but for the key named "test", which keeps the running start.
  const int key = mj_name2id(b, mjOBJ_KEY, "test");
  ASSERT_GE(key, 0);
  mju_copy(model_->key_qpos + key * a->nq, a->key_qpos + key * a->nq, a->nq);
  mju_copy(model_->key_qvel + key * a->nv, a->key_qvel + key * a->nv, a->nv);
  mju_copy(model_->key_act + key * a->na, a->key_act + key * a->na, a->na);
  EXPECT_EQ(std::memcmp(a->buffer, b->buffer, static_cast<size_t>(a->nbuffer)), 0);
}

TEST_F(CopiesTest, ModelsComeAndGoWhileOthersAreStepped) {
  const std::vector<double> expected = Run(model_.get(), 400);
  std::vector<std::vector<double>> results(2);
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&] {
      const ModelPtr copy = Copy();
      result = Run(copy.get(), 400);
    });
  }
  const ModelPtr other = LoadFile(BogiePath("rigid_link"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(Attach(other.get(), InACurve()).ok());
    Detach(other.get());
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

mjfGeneric saved = nullptr;
std::atomic<int> user_calls{0};

TEST_F(CopiesTest, AUserThatChainsToOursLivesThroughASecondLoad) {
  const std::vector<double> expected = Run(model_.get(), 200);
  saved = mjcb_passive;
  mjcb_passive = [](const mjModel* m, mjData* d) {
    ++user_calls;
    saved(m, d);
  };
  const ModelPtr second = LoadFile(BogiePath("rigid_link"));
  ASSERT_TRUE(Attach(second.get(), InACurve()).ok());
  user_calls = 0;
  EXPECT_EQ(Run(model_.get(), 200), expected);
  EXPECT_EQ(user_calls, 200);
  mjcb_passive = saved;
  EXPECT_EQ(Run(model_.get(), 200), expected);
  EXPECT_EQ(user_calls, 200);
}

TEST_F(CopiesTest, ACallbackSetLaterDoesNotSwitchUsOffWithoutAWord) {
  const DataPtr d(mj_makeData(model_.get()));
  ASSERT_EQ(phs_reset(model_.get(), d.get()), 0);
  mj_forward(model_.get(), d.get());
  std::vector<double> values(static_cast<size_t>(phs_num_outputs(model_.get())));
  ASSERT_EQ(phs_outputs(model_.get(), d.get(), values.data()), 0);

  // One that calls ours is none that switches us off, even before the first step.
  saved = mjcb_passive;
  mjcb_passive = [](const mjModel* m, mjData* data) { saved(m, data); };
  EXPECT_EQ(phs_outputs(model_.get(), d.get(), values.data()), 0) << phs_last_error();

  mjcb_passive = [](const mjModel*, mjData*) { ++user_calls; };
  mj_forward(model_.get(), d.get());
  EXPECT_EQ(phs_outputs(model_.get(), d.get(), values.data()), -1);
  EXPECT_THAT(phs_last_error(), HasSubstr("mjcb_passive was replaced"));
  EXPECT_THAT(phs_last_error(), HasSubstr("contact"));

  user_calls = 0;
  ASSERT_EQ(phs_reset(model_.get(), d.get()), 0);
  mj_forward(model_.get(), d.get());
  EXPECT_EQ(phs_outputs(model_.get(), d.get(), values.data()), 0) << phs_last_error();
  EXPECT_EQ(user_calls, 1);

  mjcb_control = nullptr;
  EXPECT_EQ(phs_outputs(model_.get(), d.get(), values.data()), -1);
  EXPECT_THAT(phs_last_error(), HasSubstr("speed hold"));
  ASSERT_EQ(phs_reset(model_.get(), d.get()), 0);
  EXPECT_EQ(phs_outputs(model_.get(), d.get(), values.data()), 0) << phs_last_error();
  model_.reset();
  mjcb_passive = nullptr;
}

}  // namespace
}  // namespace phs::plugin
