// Pictures and films as a user gets them: by the program, without a display.
#include <gmock/gmock.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/base/execute.h"
#include "vehicle/result_files.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::screen {
namespace {

using ::testing::AllOf;
using ::testing::Eq;
using ::testing::HasSubstr;

struct Png {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  /// Share of pixels near a colour.
  double Share(int r, int g, int b, int off) const {
    int count = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) {
      count += std::abs(rgb[i] - r) < off && std::abs(rgb[i + 1] - g) < off &&
                       std::abs(rgb[i + 2] - b) < off
                   ? 1
                   : 0;
    }
    return 3.0 * count / static_cast<double>(rgb.size());
  }
};

Png ReadPng(const std::string& path) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  Png png;
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0) return png;
  header.format = PNG_FORMAT_RGB;
  png.rgb.resize(PNG_IMAGE_SIZE(header));
  png_image_finish_read(&header, nullptr, png.rgb.data(), 0, nullptr);
  png.width = static_cast<int>(header.width);
  png.height = static_cast<int>(header.height);
  return png;
}

/// A result of `compare`: both bogies for some seconds, written once for all tests.
class VideoTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dir_ = new std::string(::testing::TempDir() + "/phs_video_" + std::to_string(getpid()));
    std::filesystem::create_directories(*dir_ + "/result");
    auto scenario = vehicle::LoadScenario("curve_r150");
    ASSERT_TRUE(scenario.ok());
    scenario.value().duration_s = 16;
    scenario.value().record_interval_s = 0.02;
    std::vector<std::pair<std::string, nlohmann::ordered_json>> summaries;
    std::string track;
    for (const char* bogie : {"phs", "rigid_link"}) {
      vehicle::UseBogie(bogie, &scenario.value());
      auto simulation = vehicle::Simulation::Create(scenario.value());
      ASSERT_TRUE(simulation.ok());
      auto run = simulation.value().Run();
      ASSERT_TRUE(run.ok());
      summaries.emplace_back(
          bogie, vehicle::SummaryJson(vehicle::Summarise(simulation.value(), run.value())));
      ASSERT_TRUE(
          vehicle::WriteTimeSeries(run.value(), *dir_ + "/result/" + bogie + "_timeseries", false)
              .ok());
      if (summaries.size() == 2) {
        std::ofstream(*dir_ + "/result/compare.json")
            << vehicle::Compare(summaries, scenario.value(), simulation.value().binding().track());
      }
    }
  }
  static void TearDownTestSuite() {
    std::filesystem::remove_all(*dir_);
    delete dir_;
  }
  static std::string Result() { return *dir_ + "/result"; }
  static std::string Out(const std::string& name) { return *dir_ + "/" + name; }
  static Output Video(const std::string& rest) {
    return Execute(std::string("env -u DISPLAY ") + PHS_VIEW_PROGRAM + " video " + rest);
  }
  static std::string* dir_;
};
std::string* VideoTest::dir_ = nullptr;

TEST_F(VideoTest, ASingleBogieAsPictureTheSameTwice) {
  for (const char* name : {"a.png", "b.png"}) {
    const Output ran =
        Video(Result() + " " + Out(name) + " --bogies phs --from 14 --width 640 --height 360");
    ASSERT_EQ(ran.code, 0) << ran.text;
  }
  const Png png = ReadPng(Out("a.png"));
  ASSERT_EQ(png.width, 640);
  ASSERT_EQ(png.height, 360);
  EXPECT_EQ(png.rgb, ReadPng(Out("b.png")).rgb);
  EXPECT_GT(png.Share(225, 160, 30, 45), 0.002) << "coil springs";
  EXPECT_GT(png.Share(140, 144, 150, 30), 0.02) << "wheels";
  EXPECT_GT(png.Share(45, 65, 95, 28), 0.02) << "frame";
}

TEST_F(VideoTest, SeveralBogiesStandBesideEachOther) {
  const Output ran = Video(Result() + " " + Out("c.png") +
                           " --from 14 --width 640 --height 360 --camera plan --magnify-yaw 20 "
                           "--no-forces");
  ASSERT_EQ(ran.code, 0) << ran.text;
  const Png png = ReadPng(Out("c.png"));
  // The rigid bogie's half is another picture: its axles stand askew.
  size_t differ = 0;
  for (int y = 60; y < 300; ++y) {
    for (int x = 0; x < 320; ++x) {
      const size_t a = 3 * (640 * static_cast<size_t>(y) + static_cast<size_t>(x));
      differ += std::abs(png.rgb[a] - png.rgb[a + 960]) > 30 ? 1 : 0;
    }
  }
  EXPECT_GT(differ, 5000u);
}

TEST_F(VideoTest, FilmsHaveAsManyPicturesAsAsked) {
  for (const char* name : {"d.mp4", "d.gif"}) {
    const Output ran = Video(Result() + " " + Out(name) +
                             " --from 14 --to 15 --fps 5 --width 320 --height 180 --quiet");
    ASSERT_EQ(ran.code, 0) << ran.text;
    const Output probe = Execute(
        "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
        "stream=width,height,nb_read_frames -of csv=p=0 " +
        Out(name));
    EXPECT_THAT(probe.text, Eq("320,180,6\n")) << name;
  }
}

TEST_F(VideoTest, BadInputIsOneLineAndNothingIsWritten) {
  const struct {
    std::string arguments;
    std::vector<std::string> words;
    int code;
  } cases[] = {
      {Result() + " " + Out("e.avi"), {"e.avi", ".mp4, .gif, .png"}, 3},
      {Result() + " " + Out("no/e.png"), {"folder"}, 3},
      {Result() + " " + Out("a.png") + " --bogies ph", {"'ph'", "phs"}, 3},
      {Result() + " " + Out("e.png") + " --bogies ph", {"'ph'", "did you mean 'phs'?"}, 3},
      {Result() + " " + Out("e.mp4") + " --width 321", {"even numbers"}, 3},
      {Result() + " " + Out("e.png") + " --from 99", {"--from", "ends at"}, 3},
      {Result() + " " + Out("e.png") + " --camera moon", {"moon", "bogie"}, 2},
      {"no_such_scenario " + Out("e.png"), {"no_such_scenario"}, 3},
      {*dir_ + " " + Out("e.png"), {"no result", "phs simulate"}, 3},
  };
  std::filesystem::remove(Out("a.png"));
  for (const auto& bad : cases) {
    const Output ran = Video(bad.arguments);
    EXPECT_EQ(ran.code, bad.code) << bad.arguments << "\n" << ran.text;
    for (const std::string& word : bad.words) EXPECT_THAT(ran.text, HasSubstr(word));
    EXPECT_EQ(std::count(ran.text.begin(), ran.text.end(), '\n'), 1) << ran.text;
  }
  for (const auto& file : std::filesystem::directory_iterator(*dir_)) {
    EXPECT_THAT(file.path().filename().string(), ::testing::Not(HasSubstr("partial")));
    EXPECT_NE(file.path().stem(), "e");
  }
}

TEST_F(VideoTest, NothingIsReplacedUnasked) {
  std::ofstream(Out("mine.png")) << "mine";
  const std::string command =
      Result() + " " + Out("mine.png") + " --from 1 --width 320 --height 180";
  const Output refused = Video(command);
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.text, HasSubstr("--force"));
  EXPECT_EQ(Video(command + " --force").code, 0);
  EXPECT_EQ(ReadPng(Out("mine.png")).width, 320);
}

TEST_F(VideoTest, WithoutADisplayTheWindowSaysSo) {
  const Output ran =
      Execute(std::string("env -u DISPLAY ") + PHS_VIEW_PROGRAM + " view " + Result());
  EXPECT_EQ(ran.code, 3);
  EXPECT_THAT(ran.text, AllOf(HasSubstr("no display"), HasSubstr("phs video")));
}

/// On a screen in memory.
TEST_F(VideoTest, AWindowShowsPictureAndPlots) {
  if (Execute("command -v Xvfb").code != 0) GTEST_SKIP() << "no Xvfb here";
  const std::string script = Out("window.sh");
  std::ofstream(script)
      << "exec 3>" << Out("number") << "\n"
      << "Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp >/dev/null 2>&1 &\n"
      << "server=$!\n"
      << "for i in $(seq 100); do [ -s " << Out("number") << " ] && break; sleep 0.1; done\n"
      << "DISPLAY=:$(cat " << Out("number") << ") timeout 60 " << PHS_VIEW_PROGRAM << " view "
      << Result() << " --from 14 --screenshot " << Out("w.png")
      << "\ncode=$?\nkill $server\nexit $code\n";
  const Output ran = Execute("bash " + script);
  ASSERT_EQ(ran.code, 0) << ran.text;
  const Png png = ReadPng(Out("w.png"));
  ASSERT_GT(png.width, 1000);
  EXPECT_GT(png.Share(225, 160, 30, 45), 0.002) << "coil springs";
  EXPECT_GT(png.Share(255, 255, 255, 12), 0.10) << "panes of the plots";
}

}  // namespace
}  // namespace phs::screen
