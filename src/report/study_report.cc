#include "report/study_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/json_fields.h"
#include "report/page_links.h"
#include "report/readable_name.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostCurves = 8;

std::string LabelOf(const std::string& column) {
  const ReadableName name = Readable(column);
  return name.words + (name.unit.empty() || name.unit == "–" ? "" : " [" + name.unit + "]");
}

void AddParts(const Json& study, ReportPage* page) {
  DataTable table{.caption = "Parts", .head = {"part", "what it does", "result", "command"}};
  table.words = true;
  for (const Json& part : study.at("parts")) {
    TableCell name(part.at("name").get<std::string>());
    if (part.at("report").is_string()) name.link = Address(part.at("report"));
    TableCell result(part.at("result").get<std::string>());
    result.bad = part.at("status") != "ok";
    table.rows.push_back(
        {name, part.at("text").get<std::string>(), result, part.at("command").get<std::string>()});
  }
  page->Add(table);
}

void AddPlot(const Json& plot, ReportPage* page) {
  const ReadableName x = Readable(plot.at("x")), y = Readable(plot.at("y"));
  XyPlot drawn{.title = plot.at("title").get<std::string>(),
               .x_label = LabelOf(plot.at("x")),
               .y_label = LabelOf(plot.at("y")),
               .height_px = 300};
  if (drawn.title.empty()) drawn.title = y.words + " over " + x.words;
  for (const Json& curve : plot.at("curves")) {
    const int n = static_cast<int>(drawn.curves.size());
    if (n == kMostCurves) {
      drawn.title += fmt::format(" (the first {} of {})", n, plot.at("curves").size());
      break;
    }
    Curve made{.label = curve.at("label").get<std::string>(), .colour = n, .dash = n % 4};
    if (made.label.empty()) made.label = "all runs";
    for (const Json& value : curve.at("x")) made.x.push_back(x.factor * AsNumber(value));
    for (const Json& value : curve.at("y")) made.y.push_back(y.factor * AsNumber(value));
    drawn.curves.push_back(std::move(made));
  }
  page->Add(drawn);
}

void AddSpread(const Json& spread, ReportPage* page) {
  const ReadableName name = Readable(spread.at("of")[0]);
  const bool wanted = spread.at("within_factor").is_number();
  DataTable table{.caption = spread.at("title").get<std::string>(),
                  .head = {"group", "runs", "without a number", "least [" + name.unit + "]",
                           "largest [" + name.unit + "]", "largest / least"}};
  for (const Json& group : spread.at("groups")) {
    table.rows.push_back({group.at("name").get<std::string>(),
                          fmt::format("{}", group.at("runs").get<int>()),
                          fmt::format("{}", group.at("lacking").get<int>()),
                          FormatNumber(name.factor * NumberOf(group, "least")),
                          FormatNumber(name.factor * NumberOf(group, "largest")),
                          FormatNumber(NumberOf(group, "factor"))});
    if (wanted && group.at("kept").get<bool>()) {
      for (TableCell& cell : table.rows.back()) cell.strong = true;
    }
  }
  page->Add(table);
  if (!wanted) return;
  page->Paragraph(fmt::format("{} of {} keep within a factor of {:g} in all runs.",
                              spread.at("kept").get<int>(), spread.at("groups").size(),
                              NumberOf(spread, "within_factor")));
}

void AddPart(const Json& part, ReportPage* page) {
  if (part.at("plots").empty() && part.at("spreads").empty()) return;
  page->Section(part.at("name"));
  if (!part.at("text").get<std::string>().empty()) page->Paragraph(part.at("text"));
  page->BeginGrid(2);
  for (const Json& plot : part.at("plots")) AddPlot(plot, page);
  page->EndGrid();
  for (const Json& spread : part.at("spreads")) AddSpread(spread, page);
}

}  // namespace

Status WriteStudyReport(const std::string& folder, const std::string& path) {
  const std::string file = (std::filesystem::path(folder) / "study.json").string();
  const Result<Json> read = ReadJsonObject(file);
  if (!read.ok()) return read.error();
  return MakeGuarded(file, [&]() -> Status {
    const Json& study = read.value();
    ReportPage page("Study: " + study.at("study").get<std::string>(),
                    fmt::format("{} parts", study.at("parts").size()));
    page.Section("Question");
    if (!study.at("question").get<std::string>().empty()) page.Paragraph(study.at("question"));
    if (study.at("status") != "ok") page.Warning("A part did not end well.");
    AddParts(study, &page);
    for (const Json& part : study.at("parts")) AddPart(part, &page);
    return page.Write(path);
  });
}

}  // namespace phs::report
