// Writes example reports for the browser test: make_example_reports DIR.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/origin.h"
#include "example_results.h"
#include "report/analysis_report.h"
#include "report/curving_report.h"
#include "report/identify_report.h"
#include "report/index_report.h"
#include "report/sweep_report.h"

namespace {

/// With an origin, as the program writes it.
void WriteOriginExample(const std::filesystem::path& directory) {
  std::ofstream(directory / phs::kOriginFile)
      << R"({"program":"phs 0.7.1","command":"phs compare curve_r550 --bogies phs,rigid_link",)"
      << R"("date":"2026-11-23T17:05:09Z","inputs":[{"path":"models/tracks/curve_r550.yaml",)"
      << R"("sha256":"9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"}]})";
}

int Make(const std::filesystem::path& directory,
         const phs::report::testing::ExampleOptions& options) {
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  phs::report::testing::WriteExampleResults(directory.string(), options);
  WriteOriginExample(directory);
  const phs::Status status =
      phs::report::WriteCurvingReport(directory.string(), (directory / "report.html").string());
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

int MakeIdentification(const std::filesystem::path& directory) {
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  phs::report::testing::WriteExampleIdentification(directory.string());
  const auto file = [&](const char* name) { return (directory / name).string(); };
  const phs::Status status = phs::report::WriteIdentifyReport({.result = file("result.json"),
                                                               .measured = file("measured.csv"),
                                                               .predicted = file("predicted.csv"),
                                                               .baseline = file("baseline.csv")},
                                                              file("report.html"));
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

int MakeIndex(const std::filesystem::path& root) {
  const auto written = phs::report::WriteIndex(root.string());
  if (!written.ok()) std::fprintf(stderr, "%s\n", written.error().Line().c_str());
  return written.ok() ? 0 : 1;
}

int MakeSweep(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  std::ofstream csv(directory / "sweep.csv");
  csv << "bogie,track_radius_m,friction,status,lead_angle_of_attack_rad,wear_T_gamma_N\n";
  for (const char* bogie : {"phs", "rigid_link"}) {
    for (int radius : {150, 250, 300, 400, 550, 800}) {
      for (double friction : {0.2, 0.3, 0.4}) {
        const double attack = (bogie[0] == 'p' ? 0.3 : 1.0) * 1.55 / radius * (0.8 + friction);
        csv << bogie << ',' << radius << ',' << friction << ",ok," << attack << ','
            << 2e5 * attack * friction << '\n';
      }
    }
  }
  csv.close();
  const phs::Status status = phs::report::WriteSweepReport(
      {.table = (directory / "sweep.csv").string()}, (directory / "report.html").string());
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

/// The one arc of a track: curves of a single point.
int MakeOneCurve(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  const std::string file = (directory / "curving.json").string();
  const char* row = R"([{"radius_m":550,"hand":"right","status":"ok","angle_of_attack_lead_rad":)";
  std::ofstream(file) << R"({"bogies":{"phs":)" << row
                      << R"(-2.5e-5,"largest_Y_N":9550,"sum_Y_lead_N":-5340,"T_gamma_N":22.7}],)"
                      << R"("rigid_link":)" << row
                      << R"(4.57e-3,"largest_Y_N":38770,"sum_Y_lead_N":-10040,"T_gamma_N":582}]}})";
  const phs::Status status =
      phs::report::WriteSteadyCurvingReport(file, (directory / "report.html").string());
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

/// A bogie that hunts: the trailing wheelset half a radian behind, yaw a quarter period ahead.
int MakeStability(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  const std::string file = (directory / "stability.json").string();
  std::ofstream(file) << R"({"bogie":"phs","critical_speed_m_s":68,
    "eigenvalues":[{"speed_m_s":40,"real_1_s":-3,"imag_rad_s":14},
      {"speed_m_s":68,"real_1_s":0,"imag_rad_s":21},{"speed_m_s":90,"real_1_s":2,"imag_rad_s":27}],
    "critical_mode":{"speed_m_s":68,"real_1_s":0,"imag_rad_s":21.36,"frequency_Hz":3.4,
      "damping_ratio":0,"wavelength_m":20,"bodies":[
      {"name":"frame","x_m":0,"lateral":{"amplitude_m":0.9,"phase_rad":-0.3},
       "yaw":{"amplitude_rad":0.28,"phase_rad":1.3}},
      {"name":"lead_wheelset","wheelset":true,"x_m":1.55,
       "lateral":{"amplitude_m":1,"phase_rad":0},"yaw":{"amplitude_rad":0.3,"phase_rad":1.57}},
      {"name":"lead_boxes","x_m":1.55,
       "lateral":{"amplitude_m":1,"phase_rad":0},"yaw":{"amplitude_rad":0.3,"phase_rad":1.57}},
      {"name":"trail_wheelset","wheelset":true,"x_m":-1.55,
       "lateral":{"amplitude_m":0.7,"phase_rad":-0.5},"yaw":{"amplitude_rad":0.3,"phase_rad":1.1}},
      {"name":"half_body","x_m":0,"lateral":{"amplitude_m":0.2,"phase_rad":-2}}]}})";
  const phs::Status status =
      phs::report::WriteStabilityReport(file, (directory / "report.html").string());
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

int MakeModes(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  const std::string file = (directory / "modes.json").string();
  std::ofstream json(file);
  json << R"({"bogie":"phs","frequency_Hz":0.5,"plan":{
    "axles":[{"name":"lead","x_m":1.55},{"name":"trail","x_m":-1.55}],"cylinders":[
    {"name":"1","from_m":[1.15,0.9],"to_m":[1.55,0.9]},
    {"name":"2","from_m":[1.15,-0.9],"to_m":[1.55,-0.9]},
    {"name":"3","from_m":[-1.15,-0.9],"to_m":[-1.55,-0.9]},
    {"name":"4","from_m":[-1.15,0.9],"to_m":[-1.55,0.9]}]})";
  // Extension of each cylinder by the pattern's geometry.
  const char* strokes[4][2] = {
      {"bending", "-++-"}, {"shear", "-+-+"}, {"traction", "++--"}, {"antiphase", "++++"}};
  for (const auto& [mode, signs] : strokes) {
    json << ",\"" << mode << R"(":{"stiffness_Nm_per_rad":1e6,"stiffness_N_per_m":1e8,
      "loop":{"displacement_rad":[0,0.002,0,-0.002],"displacement_m":[0,0.002,0,-0.002],
      "moment_Nm":[900,2000,-900,-2000],"force_N":[9000,20000,-9000,-20000]},
      "at_greatest_displacement":{"cylinders":[)";
    for (int i = 0; i < 4; ++i) {
      json << (i ? "," : "") << R"({"name":")" << i + 1 << R"(","stroke_m":)"
           << (signs[i] == '-' ? "-" : "") << R"(0.002,"force_N":1500})";
    }
    json << "]}}";
  }
  json << "}";
  json.close();
  const phs::Status status =
      phs::report::WriteModesReport({file}, (directory / "report.html").string());
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.error().Line().c_str());
  return status.ok() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_example_reports DIR\n");
    return 2;
  }
  const std::filesystem::path root = argv[1];
  int failed = Make(root / "compare", {});
  failed += Make(root / "single", {.bogies = {"phs"}, .hand = -1, .single = true});
  failed += Make(root / "locomotive", {.bogies = {"phs", "rigid_link"}, .locomotive = true});
  failed += Make(root / "derailed", {.derailed = true});
  failed += MakeIdentification(root / "identify");
  failed += MakeSweep(root / "sweep");
  failed += MakeStability(root / "stability");
  failed += MakeOneCurve(root / "one_curve");
  failed += MakeModes(root / "modes");
  failed += MakeIndex(root);
  return failed > 0 ? 1 : 0;
}
