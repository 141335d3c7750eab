#include "report/report_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/result_dir.h"
#include "holds.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using testing::Holds;
using testing::Lacks;

TEST(FormatNumber, DigitsSignsAndPowers) {
  EXPECT_EQ(FormatNumber(0), "0");
  EXPECT_EQ(FormatNumber(1.23456), "1.23");
  EXPECT_EQ(FormatNumber(-0.00123456), "−0.00123");
  EXPECT_EQ(FormatNumber(9.996), "10.0");
  EXPECT_EQ(FormatNumber(99.96), "100");
  EXPECT_EQ(FormatNumber(12345), "12345");
  EXPECT_EQ(FormatNumber(0.9994), "0.999");
  EXPECT_EQ(FormatNumber(0.99951), "1.00");
  EXPECT_EQ(FormatNumber(2e-4, 2), "2.0·10⁻⁴");
  EXPECT_EQ(FormatNumber(-3.2e12, 2), "−3.2·10¹²");
  EXPECT_EQ(FormatNumber(std::nan("")), "–");
}

TEST(ReportPage, TextsCannotBecomeMarkup) {
  ReportPage page("a <b> & \"c\"", "<script>x()</script>");
  page.Section("1 < 2");
  page.Paragraph("</p><img src=x>", "<i>");
  page.Add(
      DataTable{.caption = "<u>", .head = {"<h>"}, .rows = {{TableCell("<td>"), TableCell("&")}}});
  page.Add(SeriesPlot{.title = "</figure>",
                      .x_label = "</script><script>bad()</script>",
                      .curves = {{.label = "</script>", .x = {0, 1}, .y = {0, 1}}}});
  const std::string html = page.Html();
  for (const char* bad : {"<b>", "<script>x()", "<img", "<u>", "<h>", "bad()</script>"}) {
    EXPECT_TRUE(Lacks(html, bad));
  }
  EXPECT_TRUE(Holds(html, "a &lt;b&gt; &amp; &quot;c&quot;"));
}

TEST(ReportPage, TextsOfFiguresCannotEndTheScript) {
  ReportPage page("a", "b");
  page.AddFigure("plan", "c",
                 R"({"name":"</script><img src=x onerror=bad()> &amp; )"
                 "\xe2\x80\xa8\xe2\x80\xa9\xe2\x80\x93"
                 R"("})");
  const std::string html = page.Html();
  EXPECT_TRUE(Lacks(html, "<img"));
  EXPECT_TRUE(Lacks(html, "\xe2\x80\xa8"));
  EXPECT_TRUE(Holds(html, R"("\u003c/script\u003e\u003cimg src=x onerror=bad()\u003e \u0026amp; )"
                          "\\u2028\\u2029\xe2\x80\x93\""));
}

TEST(ReportPage, AsksNothingFromTheNetwork) {
  ReportPage page("t", "s");
  page.Section("x");
  page.Add(SeriesPlot{.title = "p", .curves = {{.label = "c", .x = {0, 1}, .y = {0, 1}}}});
  const std::string html = page.Html();
  for (const char* bad : {"src=\"http", "href=\"http", "@import", "url(http", "src='http"}) {
    EXPECT_TRUE(Lacks(html, bad));
  }
  EXPECT_TRUE(Holds(html, "default-src 'none'"));
  EXPECT_TRUE(Holds(html, "uPlot"));
}

TEST(ReportPage, BarsStandOnACommonZero) {
  ReportPage page("t", "s");
  page.Section("x");
  page.Add(BarChart{.title = "m",
                    .unit = "kN",
                    .categories = {""},
                    .bars = {{.label = "a", .values = {3}}, {.label = "b", .values = {-1}}}});
  const std::string html = page.Html();
  EXPECT_TRUE(Holds(html, "margin-left:25.000%;width:75.000%"));
  EXPECT_TRUE(Holds(html, "margin-left:0%;width:25.000%"));
}

TEST(ReportPage, EveryPlotHasItsData) {
  ReportPage page("t", "s");
  page.Section("x");
  page.Add(XyPlot{.title = "loop", .curves = {{.label = "c", .x = {0, 1, 0}, .y = {0, 1, 2}}}});
  page.Add(HeatMap{
      .title = "map", .x_edges = {0, 1, 2}, .y_edges = {0, 1}, .values = {{1, std::nan("")}}});
  const std::string html = page.Html();
  EXPECT_TRUE(Holds(html, "id=\"figure-1\" data-kind=\"xy\""));
  EXPECT_TRUE(Holds(html, "id=\"figure-2\" data-kind=\"heat\""));
  EXPECT_TRUE(Holds(html, "\"figure-1\":{"));
  EXPECT_TRUE(Holds(html, "[[1.0,null]]"));
}

TEST(ReportPage, SaysWhereItComesFrom) {
  const ScratchDir dir;
  std::ofstream(dir.File(kOriginFile)) << R"({"program":"phs 0.7.1","date":"2026-11-23T17:05:09Z",
    "command":"phs rig '<i>.yaml'","inputs":[{"path":"a&b.yaml","sha256":"0123abcd"}]})";
  ASSERT_TRUE(ReportPage("t", "s").Write(dir.File("report.html")).ok());
  const std::string html = ReadFile(dir.File("report.html")).value();
  EXPECT_TRUE(Holds(html, "Calculated by phs 0.7.1 on 2026-11-23, 17:05:09 UTC"));
  EXPECT_TRUE(Holds(html, "phs rig &#39;&lt;i&gt;.yaml&#39;"));
  EXPECT_TRUE(Holds(html, "a&amp;b.yaml</th><td>0123abcd</td>"));
  // Another page in that folder is no page of that result.
  ASSERT_TRUE(ReportPage("t", "s").Write(dir.File("contact.html")).ok());
  EXPECT_TRUE(Lacks(ReadFile(dir.File("contact.html")).value(), "0123abcd"));
  ReportPage own("t", "s");
  own.SetOrigin(Origin{.program = "phs 2", .command = "phs contact", .date = "x", .inputs = {}});
  ASSERT_TRUE(own.Write(dir.File("contact.html")).ok());
  EXPECT_TRUE(Holds(ReadFile(dir.File("contact.html")).value(), "phs contact"));
}

TEST(ReportPage, WithoutAnOriginItSaysSo) {
  const ScratchDir dir;
  ASSERT_TRUE(ReportPage("t", "s").Write(dir.File("report.html")).ok());
  EXPECT_TRUE(Holds(ReadFile(dir.File("report.html")).value(),
                    "its date and its inputs were not recorded"));
}

TEST(ReportPage, UnwritablePlaceIsAnError) {
  EXPECT_FALSE(ReportPage("t", "s").Write("/proc/no/such/place/report.html").ok());
}

}  // namespace
}  // namespace phs::report
