#include "report/sweep_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/result_dir.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using ::testing::HasSubstr;
using testing::Holds;

class SweepReport : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream csv(File("sweep.csv"));
    csv << "bogie,track_radius_m,friction,speed_m_s,status,lead_angle_of_attack_rad,max_Y_N\n";
    for (const char* bogie : {"phs", "rigid_link"}) {
      for (int radius : {250, 400, 550}) {
        for (double friction : {0.2, 0.3, 0.4}) {
          const bool lost = radius == 250 && friction > 0.35;
          csv << bogie << ',' << radius << ',' << friction << ",16.7," << (lost ? "derailed" : "ok")
              << ',' << 1.6 / radius << ',' << 8e6 / radius * friction << '\n';
        }
      }
    }
  }
  std::string File(const std::string& name) const { return directory_.File(name); }
  ScratchDir directory_;
};

TEST_F(SweepReport, PlotsEveryResultOverTheVariedParameters) {
  const Status status = WriteSweepReport({.table = File("sweep.csv")}, File("report.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("report.html")).value();
  EXPECT_TRUE(Holds(html, "Sweep over track radius, friction"));  // the speed does not vary
  EXPECT_TRUE(Holds(html, "2 of 18 runs did not end well"));
  EXPECT_TRUE(Holds(html, "lead angle of attack, rigid_link"));
  EXPECT_TRUE(Holds(html, "phs, friction 0.200"));
}

TEST_F(SweepReport, WorstCasesCarryTheCommandThatRepeatsThem) {
  const Status status =
      WriteSweepReport({.table = File("sweep.csv"), .study = "study.yaml"}, File("report.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("report.html")).value();
  // Largest Y: R = 250 m with the greater friction that did not derail, of either bogie.
  EXPECT_TRUE(Holds(html, "phs sweep study.yaml --only 1 --out run_1"));
  EXPECT_TRUE(Holds(html, "phs sweep study.yaml --only 10 --out run_10"));
  EXPECT_TRUE(Holds(html, "phs sweep study.yaml --only 2 --out run_2"));  // derailed
}

TEST_F(SweepReport, IsDrawnAgainFromWhatWasKept) {
  const SweepReportInput input{
      .table = File("sweep.csv"),
      .parameters = {"track_radius_m", "friction"},
      .outputs = {"max_Y_N"},
      .sampled = true,
      .indices = {{"max_Y_N", {0.7, 0.1}, {0.8, 0.2}, {0.01, 0.02}, {0.03, 0.04}}},
      .study = "study.yaml"};
  ASSERT_TRUE(WriteSweepReport(input, File("report.html")).ok());
  const std::string page = ReadFile(File("report.html")).value();
  EXPECT_TRUE(Holds(page, "Which parameter matters"));
  ASSERT_TRUE(KeepSweepReportInput(input).ok());
  std::filesystem::remove(File("report.html"));
  const Status again = RemakeSweepReport(directory_.path());
  ASSERT_TRUE(again.ok()) << again.error().Line();
  EXPECT_TRUE(ReadFile(File("report.html")).value() == page);
  std::ofstream(File("sweep_report.json")) << "{\"table\": 3}";
  EXPECT_FALSE(RemakeSweepReport(directory_.path()).ok());
}

TEST_F(SweepReport, MoreSeriesOfSamplesThanColoursAreSaid) {
  std::ofstream csv(File("many.csv"));
  csv << "run,bogie,x_m,status,result_N\n";
  for (int i = 0; i < 40; ++i) {
    csv << i << ",bogie" << i % 10 << ',' << 0.1 * i << ",ok," << i << "\n";
  }
  csv.close();
  const Status status =
      WriteSweepReport({.table = File("many.csv"), .sampled = true}, File("report.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  EXPECT_TRUE(Holds(ReadFile(File("report.html")).value(), "(the first 8 of 10 series)"));
}

TEST_F(SweepReport, SamplesAreShownOverTheParameterThatMattersMost) {
  std::ofstream csv(File("samples.csv"));
  csv << "run,weak_m,strong_m,status,result_N\n";
  for (int i = 0; i < 20; ++i) {
    csv << i << ',' << (i * 7) % 20 << ',' << i * i << ",ok," << -3 * i << '\n';
  }
  csv.close();
  SweepReportInput input;
  input.table = File("samples.csv");
  input.parameters = {"weak_m", "strong_m"};
  input.outputs = {"result_N"};
  input.sampled = true;
  input.indices = {{"result_N", {0.1, 0.8}, {0.2, 0.9}, {0.01, 0.02}, {0.03, 0.02}}};
  const Status status = WriteSweepReport(input, File("report.html"));
  ASSERT_TRUE(status.ok()) << status.error().Line();
  const std::string html = ReadFile(File("report.html")).value();
  EXPECT_TRUE(Holds(html, "-1.00"));  // Spearman: falls always, however curved
  EXPECT_TRUE(Holds(html, "Sobol indices"));
  EXPECT_TRUE(Holds(html, "first order"));
  EXPECT_TRUE(Holds(html, "0.800 (0.761 … 0.839)")) << "1.96 standard errors to each side";
}

TEST_F(SweepReport, UnknownColumnsAreNamed) {
  const Status status = WriteSweepReport(
      {.table = File("sweep.csv"), .parameters = {"radius"}, .outputs = {"max_Y_N"}},
      File("report.html"));
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().Line(), HasSubstr("'radius'"));
  EXPECT_THAT(status.error().Line(), HasSubstr("track_radius_m"));
}

}  // namespace
}  // namespace phs::report
