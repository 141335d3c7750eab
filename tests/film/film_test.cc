// A film shows what was recorded: bodies where pose.h puts them, wheels on their rails as they lay.
#include "film/film.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "base/result_dir.h"
#include "film/contact_film.h"
#include "film/shots.h"
#include "jobs/curve_job.h"
#include "vehicle/scenario_file.h"

namespace phs::film {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Two bogies on their way into a curve of 300 m: the rigid one's flange rubs.
class FilmTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = fs::path(::testing::TempDir()) / ("phs_film_test_" + std::to_string(::getpid()));
    fs::remove_all(directory_);
    auto scenario = vehicle::LoadScenario("curve_r300");
    ASSERT_TRUE(scenario.ok());
    scenario.value().duration_s = 14;
    scenario.value().record_interval_s = 0.05;
    jobs::CurveRequest request;
    request.scenario = scenario.value();
    request.bogies = {"phs", "rigid_link"};
    auto curve = jobs::PrepareCurve(request);
    ASSERT_TRUE(curve.ok()) << curve.error().Line();
    auto ran = jobs::RunCurve(&curve.value(), {});
    ASSERT_TRUE(ran.ok() && ran.value());
    auto dir = ResultDir::Create(directory_.string(), true);
    ASSERT_TRUE(dir.ok()) << dir.error().Line();
    const Status written =
        jobs::WriteCurve(curve.value(), jobs::CurveFiles::kCompare, false, &dir.value());
    ASSERT_TRUE(written.ok()) << written.error().Line();
    ASSERT_TRUE(dir.value().Commit().ok());
  }
  static void TearDownTestSuite() { fs::remove_all(directory_); }

  static fs::path directory_;
};
fs::path FilmTest::directory_;

double At(const report::Course& course, size_t k) {
  return course.size() == 1 ? course[0] : course[k];
}

TEST_F(FilmTest, BodiesStandWhereThePoserPutsThemAndCarryTheirParts) {
  auto film = MakeFilm(directory_.string());
  ASSERT_TRUE(film.ok()) << film.error().Line();
  const report::Replay& replay = film.value();
  ASSERT_EQ(replay.bogies.size(), 2u);
  EXPECT_EQ(replay.bogies[0].name, "phs");
  auto recordings = view::LoadRecordings(directory_.string());
  ASSERT_TRUE(recordings.ok());
  auto stage = view::Stage::Create(recordings.value()[0]);
  ASSERT_TRUE(stage.ok());
  view::Look look;
  look.parts_only = true;
  const size_t k = replay.time.size() - 10;
  stage.value()->SetMoment(replay.time[k], look);
  const Instant instant = TakeApart(stage.value().get());
  // Every shape of this instant is found again in the film, moved by the body that carries it.
  const report::ReplayBogie& bogie = replay.bogies[0];
  int carried = 0;
  for (size_t i = 0; i < bogie.parts.size(); ++i) {
    const report::ReplayPart& part = bogie.parts[i];
    const Shot& shot = instant.shots[i];
    if (!shot.visible || shot.kind == "arrow") break;  // arrows that never stood are left out
    Eigen::Vector3d place(At(part.place[0][0], k), At(part.place[0][1], k),
                          At(part.place[0][2], k));
    if (part.body >= 0) {
      ++carried;
      const auto& body = bogie.bodies[0][static_cast<size_t>(part.body)];
      const Eigen::Quaterniond q(At(body[3], k), At(body[4], k), At(body[5], k), At(body[6], k));
      place = q * place + Eigen::Vector3d(At(body[0], k), At(body[1], k), At(body[2], k));
    }
    EXPECT_LT((place - shot.a).norm(), 1e-3) << i << " " << part.kind;
  }
  EXPECT_GT(carried, 40);
  int coils = 0;
  for (const report::ReplayPart& part : bogie.parts) {
    if (part.kind != "coil") continue;
    ++coils;
    EXPECT_EQ(part.alpha, 1);
    EXPECT_GT(At(replay.colours[static_cast<size_t>(part.colour)][0], k), 0.5) << "ochre";
  }
  EXPECT_GE(coils, 8);
  // Magnified it stands elsewhere.
  EXPECT_NE(bogie.bodies[0][1][6], bogie.bodies[1][1][6]);
}

TEST_F(FilmTest, WheelsLieAsTheyLayInTheRun) {
  auto recordings = view::LoadRecordings(directory_.string());
  ASSERT_TRUE(recordings.ok());
  double steepest = 0;
  for (const view::Recording& recording : recordings.value()) {
    auto stage = view::Stage::Create(recording);
    ASSERT_TRUE(stage.ok());
    const auto law = LawOfRun(*stage.value()->picture().model, recording.scenario);
    ASSERT_TRUE(law.ok()) << law.error().Line();
    view::Look look;
    look.parts_only = true;
    for (const double time : {2.0, 9.0, 13.5}) {
      stage.value()->SetMoment(time, look);
      for (const rail::Side side : {rail::Side::kLeft, rail::Side::kRight}) {
        const std::string wheel = side == rail::Side::kLeft ? "lead_left" : "lead_right";
        SCOPED_TRACE(recording.label + " " + wheel + " at " + std::to_string(time));
        const view::Picture& picture = stage.value()->picture();
        const WheelOnRail found =
            FindWheelsOnRails(picture, law.value(), 0)[static_cast<size_t>(side)];
        ASSERT_TRUE(found.found);
        EXPECT_NEAR(-found.forces.force[2], picture.Value(wheel + "_Q_N"), 100);
        const rail::ContactPatch* largest = &found.forces.patch[0];
        for (int i = 0; i < found.forces.count; ++i) {
          const rail::ContactPatch& patch = found.forces.patch[static_cast<size_t>(i)];
          if (patch.normal > largest->normal) largest = &patch;
        }
        EXPECT_NEAR(largest->wheel_y, picture.Value(wheel + "_contact_y_m"), 0.5e-3);
        EXPECT_NEAR(largest->angle, picture.Value(wheel + "_contact_angle_rad"), 0.02);
        EXPECT_GT(largest->peak_pressure, 0.5e9);
        steepest = std::max(steepest, largest->angle);
      }
    }
  }
  EXPECT_GT(steepest, 0.4) << "a flange was among them";
}

TEST_F(FilmTest, FewerInstantsWhereThePageHasNoRoom) {
  FilmOptions options;
  options.most_bytes = 0.9e6;
  auto film = MakeFilm(directory_.string(), options);
  ASSERT_TRUE(film.ok());
  EXPECT_LT(report::ReplayJson(film.value()).size(), 0.95e6);
  EXPECT_GE(film.value().time.size(), 20u);
}

TEST(Film, SaysWhyThereIsNone) {
  EXPECT_THAT(FilmOrReason("/nowhere").missing, HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace phs::film
