// What is put together from recorded channels stands as the simulated vehicle stood.
#include "view/pose.h"

#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "vehicle/scenario_file.h"
#include "view/magnify.h"
#include "view/shapes.h"
#include "view/view_model.h"

namespace phs::view {
namespace {

using ::testing::DoubleNear;

/// A run to the middle of the curve; the simulation keeps the state after its last row.
class PoseTest : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    auto scenario = vehicle::LoadScenario("curve_r300");
    ASSERT_TRUE(scenario.ok());
    scenario.value().duration_s = 16;
    scenario.value().record_interval_s = 0.1;
    vehicle::UseBogie(GetParam(), &scenario.value());
    auto simulation = vehicle::Simulation::Create(scenario.value());
    ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
    simulation_.emplace(std::move(simulation).value());
    auto run = simulation_->Run();
    ASSERT_TRUE(run.ok());
    ASSERT_EQ(run.value().status, "ok") << run.value().reason;
    recording_.scenario = scenario.value();
    recording_.channels = run.value().channels;
    recording_.columns = run.value().columns;
    recording_.time_column = recording_.Find("t_s");
    auto model = ViewModel::Create(recording_.scenario);
    ASSERT_TRUE(model.ok()) << model.error().Line();
    model_.emplace(std::move(model).value());
    data_.reset(mj_makeData(model_->model()));
    Poser(model_->model(), model_->binding(), recording_)
        .Pose(recording_.At(recording_.end_s()), data_.get());
  }

  double Joint(const mjModel* m, const mjData* d, const std::string& name) {
    const int id = mj_name2id(m, mjOBJ_JOINT, name.c_str());
    EXPECT_GE(id, 0) << name;
    return d->qpos[m->jnt_qposadr[id]];
  }

  std::optional<vehicle::Simulation> simulation_;
  Recording recording_;
  std::optional<ViewModel> model_;
  vehicle::DataPtr data_;
};

TEST_P(PoseTest, JointsAreThoseOfTheRun) {
  const mjModel* m = simulation_->model();
  const mjData* d = simulation_->data();
  for (const std::string axle : {"lead", "trail"}) {
    const auto own = [&](const char* joint) {
      return Joint(model_->model(), data_.get(), axle + joint);
    };
    const auto true_value = [&](const char* joint) { return Joint(m, d, axle + joint); };
    EXPECT_THAT(own("_yaw"), DoubleNear(true_value("_yaw"), 5e-6)) << axle;
    EXPECT_THAT(own("_x"), DoubleNear(true_value("_x"), 0.1e-3)) << axle;
    EXPECT_THAT(own("_y"), DoubleNear(true_value("_y"), 0.3e-3)) << axle;
    EXPECT_THAT(own("_z"), DoubleNear(true_value("_z"), 0.3e-3)) << axle;
    EXPECT_THAT(own("_roll"), DoubleNear(true_value("_roll"), 0.3e-3)) << axle;
  }
  EXPECT_THAT(Joint(model_->model(), data_.get(), "body_y"),
              DoubleNear(Joint(m, d, "body_y"), 1e-3));
  EXPECT_GT(std::abs(Joint(m, d, "lead_yaw")), 1e-5) << "there is something to be found";
}

TEST_P(PoseTest, WheelsetsStandWhereTheyStood) {
  const mjModel* m = simulation_->model();
  const mjData* d = simulation_->data();
  const rail::Track& track = model_->binding().track();
  for (const char* name : {"lead_wheelset", "trail_wheelset"}) {
    const auto place = [&](const mjModel* of, const mjData* at, double* lateral, double* height,
                           double* roll) {
      const int body = mj_name2id(of, mjOBJ_BODY, name);
      const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3d>(at->xpos + 3 * body);
      const rail::TrackFrame frame = track.FrameAt(track.Project({p.x(), p.y(), p.z()}));
      const Eigen::Vector3d off = p - ToEigen(frame.origin);
      *lateral = off.dot(ToEigen(frame.left));
      *height = off.dot(ToEigen(frame.up));
      const mjtNum* r = at->xmat + 9 * body;
      *roll = Eigen::Vector3d(r[1], r[4], r[7]).dot(ToEigen(frame.up));
    };
    double own[3], run[3];
    place(model_->model(), data_.get(), own, own + 1, own + 2);
    place(m, d, run, run + 1, run + 2);
    EXPECT_THAT(own[0], DoubleNear(run[0], 0.02e-3)) << name;
    // The engine's wheels sink into the rails by Hertz's approach and the rails yield.
    EXPECT_THAT(own[1], DoubleNear(run[1], 0.3e-3)) << name;
    EXPECT_THAT(own[2], DoubleNear(run[2], 0.5e-3)) << name;
  }
}

TEST_P(PoseTest, MagnifiedIsWhatDeviatesFromTheTrack) {
  mjModel* m = model_->model();
  const rail::Track& track = model_->binding().track();
  const int body = mj_name2id(m, mjOBJ_BODY, "lead_wheelset");
  const auto yaw = [&] {
    const mjtNum* p = data_->xpos + 3 * body;
    const rail::TrackFrame frame = track.FrameAt(track.Project({p[0], p[1], p[2]}));
    const mjtNum* r = data_->xmat + 9 * body;
    const Eigen::Vector3d axle(r[1], r[4], r[7]);
    return std::atan2(-axle.dot(ToEigen(frame.forward)), axle.dot(ToEigen(frame.left)));
  };
  const double attack =
      recording_.Value("lead_angle_of_attack_rad", recording_.At(recording_.end_s()));
  EXPECT_THAT(yaw(), DoubleNear(attack, 2e-5));
  Magnify(m, track, Eigen::Vector3d::Zero(), {10, 1}, data_.get());
  EXPECT_THAT(yaw(), DoubleNear(10 * attack, 2e-4));
}

INSTANTIATE_TEST_SUITE_P(Bogies, PoseTest, ::testing::Values("phs", "rigid_link"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace phs::view
