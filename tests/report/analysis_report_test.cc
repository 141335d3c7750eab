#include "report/analysis_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "base/result_dir.h"
#include "holds.h"
#include "report/moving_shape.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using testing::Holds;

class AnalysisReport : public ::testing::Test {
 protected:
  std::string File(const std::string& name) const { return directory_.File(name); }
  ScratchDir directory_;
};

/// What a page's script draws.
nlohmann::json Figures(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"figures\">";
  const size_t begin = html.find(open) + open.size();
  return nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// The moving shapes that a page carries.
std::vector<nlohmann::json> Shapes(const std::string& html) {
  std::vector<nlohmann::json> shapes;
  for (const auto& figure : Figures(html)) {
    if (figure.contains("lines")) shapes.push_back(figure);
  }
  return shapes;
}

/// Place of a point of the page at a phase: what the page's script draws.
std::array<double, 2> At(const nlohmann::json& p, double phase) {
  const auto moved = [&](const char* rest, const char* motion) {
    return p[rest].get<double>() + p[motion][0].get<double>() * std::cos(phase) -
           p[motion][1].get<double>() * std::sin(phase);
  };
  return {moved("x", "dx"), moved("y", "dy")};
}

TEST(MovingShape, PointOfABodyThatMovesAndTurns) {
  using std::complex;
  const complex<double> dx(0.1, 0), dy(0.2, 0.3), yaw(0, 0.4);
  const MovingPoint p = PointOfBody(1.5, 0.25, -0.75, dx, dy, yaw);
  EXPECT_EQ(p.x, 1.75);
  EXPECT_EQ(p.y, -0.75);
  // Turning to the left moves what lies to the right forwards, and what lies in front to the left.
  EXPECT_NEAR(std::abs(p.dx - complex<double>(0.1, 0.3)), 0, 1e-15);
  EXPECT_NEAR(std::abs(p.dy - complex<double>(0.2, 0.4)), 0, 1e-15);
}

TEST(MovingShape, TheLargestMotionIsDrawnAsAskedFor) {
  // An ellipse with half axes 3 and 1, turned by a phase: its reach is 3.
  const std::complex<double> turn = std::polar(1.0, 0.7);
  std::vector<MovingLine> lines(1);
  lines[0].from = {0, 0, 3.0 * turn, std::complex<double>(0, 1) * turn};
  lines[0].to = {0, 0, 1.0, 0.0};
  Enlarge(0.6, &lines);
  double reach = 0;
  for (double phase = 0; phase < 6.3; phase += 1e-3) {
    const std::complex<double> e = std::polar(1.0, phase);
    reach =
        std::max(reach, std::hypot((lines[0].from.dx * e).real(), (lines[0].from.dy * e).real()));
  }
  EXPECT_NEAR(reach, 0.6, 1e-6);
  EXPECT_NEAR(lines[0].to.dx.real(), 0.2, 1e-12);
  std::vector<MovingLine> still(1);
  Enlarge(0.6, &still);
  EXPECT_EQ(still[0].from.dx, 0.0);
}

TEST(MovingShape, RateAndGrowthInWords) {
  EXPECT_EQ(PlayedWords(2.5), "Played 10 times slower than it is: one period in 4 s, not 0.4 s.");
  EXPECT_EQ(PlayedPeriod(2.5), 4);
  EXPECT_EQ(PlayedPeriod(0.1), 10);
  EXPECT_EQ(PlayedWords(0.1), "Played as fast as it is.");
  EXPECT_EQ(PlayedWords(std::nan("")), "Played with one period in 4 s.");
  EXPECT_EQ(GrowthWords(1e-8, 3), "It neither grows nor dies out.");
  EXPECT_EQ(GrowthWords(-2 * std::log(2), 2),
            "Each period leaves 0.5 times its size; the picture keeps its size.");
  EXPECT_EQ(GrowthWords(2 * std::log(2), 2),
            "Each period leaves 2 times its size; the picture keeps its size.");
  EXPECT_EQ(GrowthWords(1, 0), "");
}

TEST_F(AnalysisReport, ModesOfTwoBogies) {
  std::ofstream(File("a.json")) << R"({"bogie":"phs","bending":{"stiffness_Nm_per_rad":12340,
      "small_amplitude":{"stiffness_Nm_per_rad":900000}},"traction":{"stiffness_N_per_m":5.5e7}})";
  std::ofstream(File("b.json"))
      << R"({"bogie":"rigid_link","bending":{"stiffness_Nm_per_rad":4.2e6}})";
  const Status status = WriteModesReport({File("a.json"), File("b.json")}, File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "<td>12.3</td><td>4200</td>"));
  EXPECT_TRUE(Holds(html, "<td>900</td><td>–</td>"));
  EXPECT_TRUE(Holds(html, "<td>55000</td><td>–</td>"));
  EXPECT_FALSE(WriteModesReport({File("none.json")}, File("r.html")).ok());
}

TEST_F(AnalysisReport, StabilityOverSpeed) {
  std::ofstream(File("s.json")) << R"({"critical_speed_m_s":50,"eigenvalues":[
      {"speed_m_s":40,"real_1_s":-0.5,"imag_rad_s":10},{"speed_m_s":60,"real_1_s":0.2,"imag_rad_s":14}]})";
  const Status status = WriteStabilityReport(File("s.json"), File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "<b>180</b>"));
  EXPECT_TRUE(Holds(html, "Least damping ratio"));
  EXPECT_TRUE(Shapes(html).empty());
}

TEST_F(AnalysisReport, TheMapOfHuntingIsBrinkWhereTheSpeedFallsAndHuntingWhereItRises) {
  std::ofstream(File("s.json")) << R"({"eigenvalues":[],"hunting_map":{"harmonics":5,
      "least":{"speed_m_s":15,"amplitude_m":0.005},"points":[
      {"speed_m_s":50,"amplitude_m":0.001},{"speed_m_s":50.01,"amplitude_m":0.002},
      {"speed_m_s":60,"amplitude_m":0.003},{"speed_m_s":20,"amplitude_m":0.0047},
      {"speed_m_s":15,"amplitude_m":0.005},{"speed_m_s":25,"amplitude_m":0.006}]}})";
  ASSERT_TRUE(WriteStabilityReport(File("s.json"), File("r.html")).ok());
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "lowest speed of the map of hunting"));
  EXPECT_TRUE(Holds(html, "<b>54.0</b>"));
  const nlohmann::json curves = Figures(html).back()["curves"];
  ASSERT_EQ(curves.size(), 3);
  for (const auto& [label, slowest, fastest] :
       {std::tuple{"hunting", 180, 216}, {"brink", 54, 216}, {"hunting (2)", 54, 90}}) {
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&](const auto& curve) { return curve["label"] == label; });
    ASSERT_NE(found, curves.end()) << label;
    EXPECT_NEAR((*found)["x"]["least"].get<double>(), slowest, 1e-9) << label;
    EXPECT_NEAR((*found)["x"]["greatest"].get<double>(), fastest, 1e-9) << label;
  }
}

TEST_F(AnalysisReport, HuntingSwings) {
  std::ofstream(File("s.json")) << R"({"critical_mode":{"speed_m_s":50,"frequency_Hz":2.5,
      "real_1_s":0,"damping_ratio":0,"bodies":[
      {"name":"lead","wheelset":true,"x_m":1.5,"lateral":{"amplitude_m":1,"phase_rad":0},
       "yaw":{"amplitude_rad":0.5,"phase_rad":1.5707963267948966}},
      {"name":"frame","x_m":0,"lateral":{"amplitude_m":2,"phase_rad":-1.5707963267948966}}]}})";
  const Status status = WriteStabilityReport(File("s.json"), File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "Played 10 times slower than it is"));
  const auto shapes = Shapes(html);
  ASSERT_EQ(shapes.size(), 1);
  EXPECT_EQ(shapes[0]["period_s"], 4);
  // The frame's 2 m are drawn as 0.35 m: 0.175 of everything.
  bool frame = false, axle = false;
  for (const auto& line : shapes[0]["lines"]) {
    const auto& p = line["from"];
    if (line["name"] == "frame" && p["y"] == 0) {
      frame = true;
      EXPECT_NEAR(At(p, 0)[1], 0, 1e-12);
      EXPECT_NEAR(At(p, M_PI / 2)[1], 0.35, 1e-12);  // a quarter period behind the wheelset
    }
    if (line["name"] == "lead" && line["trace"]) {  // its right end, 0.9 m from the middle
      axle = true;
      EXPECT_NEAR(At(p, 0)[0], 1.5, 1e-12);
      EXPECT_NEAR(At(p, 0)[1], -0.9 + 0.175, 1e-12);
      // Yaw a quarter period ahead: greatest to the left a quarter before the greatest place.
      EXPECT_NEAR(At(p, -M_PI / 2)[0], 1.5 + 0.175 * 0.5 * 0.9, 1e-12);
      EXPECT_NEAR(At(p, -M_PI / 2)[1], -0.9, 1e-12);
    }
  }
  EXPECT_TRUE(frame);
  EXPECT_TRUE(axle);
}

TEST_F(AnalysisReport, AxleModesSwing) {
  std::ofstream(File("m.json")) << R"({"bogie":"phs","frequency_Hz":0.5,
      "plan":{"axles":[{"name":"lead","x_m":1.5},{"name":"trail","x_m":-1.5}],
      "cylinders":[{"name":"1","from_m":[1.1,0.9],"to_m":[1.5,0.9]}]},
      "bending":{"at_greatest_displacement":{"cylinders":[{"name":"1","stroke_m":-0.002}]}}})";
  const Status status = WriteModesReport({File("m.json")}, File("r.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("r.html")).value();
  EXPECT_TRUE(Holds(html, "Played 2 times slower than it is"));
  const auto shapes = Shapes(html);
  ASSERT_EQ(shapes.size(), 4);
  // Leading and trailing axle along the track at their left ends, as signs: bending, shear by
  // opposite and equal yaw; traction, anti-phase by equal and opposite travel.
  const int signs[4][2] = {{-1, 1}, {-1, -1}, {1, 1}, {1, -1}};
  for (int mode = 0; mode < 4; ++mode) {
    for (const auto& line : shapes[mode]["lines"]) {
      const int axle = line["name"] == "lead" ? 0 : line["name"] == "trail" ? 1 : -1;
      if (axle >= 0) {
        EXPECT_NEAR(At(line["to"], 0)[0] - line["to"]["x"].get<double>(), 0.25 * signs[mode][axle],
                    1e-12);
        EXPECT_NEAR(At(line["to"], M_PI / 2)[0], line["to"]["x"].get<double>(), 1e-12);
      } else if (line["name"] == "cylinder 1") {
        EXPECT_EQ(line["to"]["dx"][0].get<double>() > 0, signs[mode][0] > 0);
        EXPECT_EQ(line["from"]["dx"][0], 0);
        EXPECT_EQ(line["stroke"][0], mode == 0 ? -0.002 : 0);
      } else {
        EXPECT_EQ(line["from"]["dx"], nlohmann::json({0.0, 0.0}));
      }
    }
  }
}

}  // namespace
}  // namespace phs::report
