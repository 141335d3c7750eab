// Writes example reports for the browser test: make_example_reports DIR.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "example_results.h"
#include "report/curving_report.h"
#include "report/identify_report.h"
#include "report/sweep_report.h"

namespace {

int Make(const std::filesystem::path& directory,
         const phs::report::testing::ExampleOptions& options) {
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  phs::report::testing::WriteExampleResults(directory.string(), options);
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
  return failed > 0 ? 1 : 0;
}
