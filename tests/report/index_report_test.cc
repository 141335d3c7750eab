#include "report/index_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/result_dir.h"
#include "holds.h"
#include "report/page_links.h"
#include "report/report_page.h"
#include "report/result_summary.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using ::testing::HasSubstr;
using testing::Holds;
using testing::Lacks;

namespace fs = std::filesystem;

class IndexReport : public ::testing::Test {
 protected:
  std::string File(const std::string& name) const { return directory_.File(name); }
  void Put(const std::string& name, const std::string& text) {
    fs::create_directories(fs::path(File(name)).parent_path());
    std::ofstream(File(name)) << text;
  }
  void PutReport(const std::string& folder) {
    fs::create_directories(File(folder));
    ASSERT_TRUE(ReportPage("r", "s").Write(File(folder + "/report.html")).ok());
  }
  /// Two results with reports and one without.
  void PutThree() {
    Put("b/compare.json", R"({"bogies":{"phs":{"status":"ok","steady_curve":{"wheelsets":[
        {"angle_of_attack_rad":-6.7e-5}]},"run":{"T_gamma_total_J":5480,"max_Y_over_Q":0.21}},
        "rigid_link":{"status":"derailed"}}})");
    Put("b/origin.json", R"({"program":"phs 1","command":"phs x","date":"2026-11-23T17:05:09Z"})");
    PutReport("b");
    Put("deep/a 1#%/result.json", R"({"rig":"quarter","declared":"setup2","verdict":"explained",
        "verdict_text":"explained by backlash","effects":[{"name":"backlash"}],
        "channels":{"load_cell_N":{"before":{"nrmse":0.031},"after":{"nrmse":0.0016}}}})");
    PutReport("deep/a 1#%");
    Put("c/loads.json", R"({"bogie":"phs","cases":[1,2,3]})");
  }
  std::string Index() const { return ReadFile(File("index.html")).value(); }
  Error Fault() const {
    const auto written = WriteIndex(directory_.path());
    EXPECT_FALSE(written.ok());
    return written.ok() ? Error{} : written.error();
  }
  ScratchDir directory_;
};

TEST_F(IndexReport, ListsEveryResultWithNumbersStatusDateAndLink) {
  PutThree();
  const auto written = WriteIndex(directory_.path());
  ASSERT_TRUE(written.ok()) << written.error().Line();
  EXPECT_EQ(written.value().results, 3);
  EXPECT_EQ(written.value().reports, 2);
  EXPECT_EQ(written.value().older, 0);
  const std::string html = Index();
  EXPECT_TRUE(Holds(html, "<a href=\"b/report.html\">b</a>"));
  EXPECT_TRUE(
      Holds(html,
            "phs: angle of attack of the leading axle 0.0670 mrad, T-gamma 5.48 kJ, Y/Q at most "
            "0.210\nrigid_link: derailed<"));
  EXPECT_TRUE(Holds(html, "<td class=\"bad\">1 of 2 not ok (derailed)</td>"));
  EXPECT_TRUE(Holds(html, "<td>2026-11-23 17:05</td>"));
  EXPECT_TRUE(Holds(html, "<a href=\"deep/a%201%23%25/report.html\">deep/a 1#%</a>"));
  EXPECT_TRUE(Holds(html, "explained by backlash"));
  EXPECT_TRUE(Holds(html,
                    "error of load cell force: 0.160 % of its standard deviation, 3.10 % as "
                    "declared and fitted"));
  EXPECT_TRUE(Holds(html, "c (no report)"));
  EXPECT_TRUE(Holds(html, "3 load cases"));
}

TEST_F(IndexReport, ReportsLinkToTheIndexAndToEachOther) {
  PutThree();
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  const std::string b = ReadFile(File("b/report.html")).value();
  EXPECT_TRUE(Holds(b, "<a href=\"../index.html\">All results</a>"));
  EXPECT_TRUE(Holds(b, "<a href=\"../deep/a%201%23%25/report.html\">deep/a 1#% ›</a>"));
  const std::string a = ReadFile(File("deep/a 1#%/report.html")).value();
  EXPECT_TRUE(Holds(a, "<a href=\"../../index.html\">All results</a>"));
  EXPECT_TRUE(Holds(a, "<a href=\"../../b/report.html\">‹ b</a>"));
  // Again, with nothing new: not a byte changes. With another result: links follow.
  const std::string index = Index();
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  EXPECT_EQ(index, Index());
  EXPECT_EQ(b, ReadFile(File("b/report.html")).value());
  Put("e/modes.json", R"({"bogie":"phs","bending":{"stiffness_Nm_per_rad":1.2e6}})");
  PutReport("e");
  EXPECT_TRUE(Holds(ReadFile(File("e/report.html")).value(),
                    "<!--links--><a href=\"../index.html\">All results</a><!--/links-->"))
      << "a report made under an index links to it at once";
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  EXPECT_TRUE(Holds(ReadFile(File("deep/a 1#%/report.html")).value(), "e/report.html\">e ›</a>"));
  EXPECT_TRUE(Holds(Index(), "bending 1.20 MN m/rad"));
}

TEST_F(IndexReport, ManyReportsAreCountedNotDropped) {
  for (int i = 0; i < 60; ++i) {
    const std::string folder = "r" + std::to_string(100 + i);
    Put(folder + "/summary.json", R"({"status":"ok","bogie":"phs"})");
    PutReport(folder);
  }
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  const std::string first = ReadFile(File("r100/report.html")).value();
  EXPECT_TRUE(Holds(first, "60 reports of this folder"));
  EXPECT_TRUE(Holds(first, "../r125/report.html"));
  EXPECT_TRUE(Lacks(first, "../r126/report.html"));
  EXPECT_TRUE(Holds(first, "34 more in the index"));
}

TEST_F(IndexReport, NamesCannotBecomeMarkup) {
  const std::string folder = "<img src=x onerror=bad()>";
  Put(folder + "/summary.json",
      R"({"status":"<b>bad</b>","reason":"","bogie":"<script>x()</script>"})");
  PutReport(folder);
  PutReport("z");
  Put("z/summary.json", R"({"status":"ok"})");
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  for (const std::string& html : {Index(), ReadFile(File("z/report.html")).value()}) {
    for (const char* bad : {"<img", "<b>bad", "<script>x()"}) EXPECT_TRUE(Lacks(html, bad));
  }
  EXPECT_TRUE(Holds(Index(), "href=\"%3Cimg%20src%3Dx%20onerror%3Dbad%28%29%3E/report.html\""));
}

TEST_F(IndexReport, DamagedAndForeignFilesAreToldApart) {
  Put("broken/compare.json", "{\"bogies\": ");
  Put("odd/compare.json", R"({"bogies": [1, 2]})");
  Put("foreign/summary.json", R"({"something":"else"})");
  Put("sweep/sweep.csv", "run,radius_m,status,x\n0,300,ok,1\n1,400,derailed,\n");
  Put("sweep.unfinished/summary.json", R"({"status":"ok"})");
  Put(".hidden/summary.json", R"({"status":"ok"})");
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  const std::string html = Index();
  EXPECT_TRUE(Holds(html, "broken (no report)"));
  EXPECT_TRUE(Holds(html, "cannot be read: is not a JSON object"));
  EXPECT_TRUE(Holds(html, "odd (no report)"));
  EXPECT_TRUE(Holds(html, "2 runs over radius"));
  EXPECT_TRUE(Holds(html, "1 of 2 not ok (derailed)"));
  for (const char* none : {"foreign", "unfinished (", ".hidden ("}) EXPECT_TRUE(Lacks(html, none));
}

TEST_F(IndexReport, NothingOutsideTheFolderIsTouched) {
  const ScratchDir elsewhere;
  fs::create_directory(elsewhere.File("r"));
  std::ofstream(elsewhere.File("r/summary.json")) << R"({"status":"ok"})";
  ASSERT_TRUE(ReportPage("r", "s").Write(elsewhere.File("r/report.html")).ok());
  const std::string before = ReadFile(elsewhere.File("r/report.html")).value();
  PutThree();
  fs::create_directory_symlink(elsewhere.File("r"), File("link"));
  fs::create_directory(File("d"));
  Put("d/summary.json", R"({"status":"ok"})");
  fs::create_symlink(elsewhere.File("r/report.html"), File("d/report.html"));
  ASSERT_TRUE(WriteIndex(directory_.path()).ok());
  EXPECT_EQ(before, ReadFile(elsewhere.File("r/report.html")).value());
  EXPECT_TRUE(Lacks(Index(), "\"link/"));
  EXPECT_TRUE(fs::is_symlink(File("d/report.html")));
}

TEST_F(IndexReport, WhatPhsDidNotWriteStays) {
  PutThree();
  Put("index.html", "<html>mine</html>");
  EXPECT_THAT(Fault().Line(), HasSubstr("index.html: exists and was not written by phs"));
  EXPECT_EQ(Index(), "<html>mine</html>");
}

TEST_F(IndexReport, OlderReportsAreCounted) {
  PutThree();
  Put("b/report.html", "<html>an older page</html>");
  const auto written = WriteIndex(directory_.path());
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(written.value().older, 1);
  EXPECT_EQ(ReadFile(File("b/report.html")).value(), "<html>an older page</html>");
}

TEST_F(IndexReport, TheIndexOfAResultItselfDoesNotHinderForce) {
  const std::string path = File("result");
  auto dir = ResultDir::Create(path, false);
  ASSERT_TRUE(dir.ok());
  ASSERT_TRUE(WriteFileAtomically(dir.value().File("summary.json"), R"({"status":"ok"})").ok());
  ASSERT_TRUE(dir.value().Commit().ok());
  ASSERT_TRUE(WriteIndex(path + "/").ok());
  ASSERT_TRUE(WriteIndex(path).ok());
  EXPECT_TRUE(fs::exists(path + "/index.html"));
  EXPECT_TRUE(CheckFormerResult(path).ok());
}

TEST_F(IndexReport, BadFoldersAreOneClearLine) {
  EXPECT_THAT(Fault().Line(), HasSubstr("holds no result of phs"));
  fs::create_directory(File("results"));
  EXPECT_THAT(WriteIndex(File("resuts")).error().Line(),
              ::testing::AllOf(HasSubstr("no such folder"), HasSubstr("did you mean 'results'?")));
  Put("file", "x");
  EXPECT_THAT(WriteIndex(File("file")).error().Line(), HasSubstr("is a file"));
}

TEST(Address, WritesWhatHasAMeaningByItsNumber) {
  EXPECT_EQ(Address("../a/report.html"), "../a/report.html");
  EXPECT_EQ(Address("a b?c#d%\"<ä"), "a%20b%3Fc%23d%25%22%3C%C3%A4");
}

TEST_F(IndexReport, ReportsAreDrawnAgainFromEveryKind) {
  Put("m/modes.json", R"({"bogie":"a","bending":{"stiffness_Nm_per_rad":12340}})");
  Put("m/modes_1.json", R"({"bogie":"b","bending":{"stiffness_Nm_per_rad":4.2e6}})");
  Put("s/stability.json", R"({"critical_speed_m_s":50,"eigenvalues":[]})");
  Put("i/result.json", R"({"rig":"quarter","channels":{"load_cell_N":{"before":{"nrmse":0.01},
      "after":{"nrmse":0.01}}},"effects":[],"candidates":[]})");
  Put("c/curving.json", R"({"bogies":{"phs":[]}})");
  for (const auto& [folder, words] :
       std::vector<std::pair<std::string, std::string>>{{"m", "<td>12.3</td><td>4200</td>"},
                                                        {"s", "<b>180</b>"},
                                                        {"i", "No effect was accepted."},
                                                        {"c", "Curving over radius"}}) {
    const Status status = RemakeReport(File(folder));
    ASSERT_TRUE(status.ok()) << status.error().Line();
    EXPECT_TRUE(Holds(ReadFile(File(folder + "/report.html")).value(), words)) << folder;
  }
  EXPECT_THAT(RemakeReport(directory_.path()).error().Line(), HasSubstr("compare.json"));
}

}  // namespace
}  // namespace phs::report
