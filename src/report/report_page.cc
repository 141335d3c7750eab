#include "report/report_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/result_dir.h"
#include "report/decimation.h"
#include "report/page_assets.h"

namespace phs::report {
namespace {

using nlohmann::json;

/// JSON that may stand inside an HTML script element; numbers that are not finite become null.
std::string Dump(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

json PackedJson(const std::vector<double>& values) {
  const PackedValues packed = Pack(values);
  return {{"least", packed.least}, {"greatest", packed.greatest}, {"packed", packed.base64}};
}

json CurveJson(const Curve& curve) {
  return {{"label", curve.label},
          {"colour", curve.colour},
          {"dash", curve.dash},
          {"points", curve.points}};
}

json LevelsJson(const std::vector<Level>& levels) {
  json list = json::array();
  for (const Level& level : levels)
    list.push_back({{"value", level.value}, {"label", level.label}});
  return list;
}

json BandsJson(const std::vector<Band>& bands) {
  json list = json::array();
  for (const Band& band : bands) {
    list.push_back({{"begin", band.begin},
                    {"end", band.end},
                    {"label", band.label},
                    {"strength", band.strength}});
  }
  return list;
}

/// The grid that covers all curves of a plot.
Grid CommonGrid(const SeriesPlot& plot) {
  Grid grid{.begin = std::numeric_limits<double>::infinity(),
            .end = -std::numeric_limits<double>::infinity(),
            .points = plot.max_points / 2 * 2};
  for (const Curve& curve : plot.curves) {
    for (double x : curve.x) {
      if (!std::isfinite(x)) continue;
      grid.begin = std::min(grid.begin, x);
      grid.end = std::max(grid.end, x);
    }
  }
  if (grid.begin > grid.end) grid.begin = grid.end = 0;
  return grid;
}

/// True when all curves have the same few abscissae, which are then kept as they are.
bool KeepsRows(const SeriesPlot& plot) {
  for (const Curve& curve : plot.curves) {
    if (static_cast<int>(curve.x.size()) > plot.max_points) return false;
    if (curve.x != plot.curves.front().x) return false;
  }
  return !plot.curves.empty() &&
         std::is_sorted(plot.curves.front().x.begin(), plot.curves.front().x.end());
}

std::string Tag(const std::string& tag, const std::string& text, const std::string& style = "") {
  return "<" + tag + (style.empty() ? "" : " class=\"" + style + "\"") + ">" + EscapeHtml(text) +
         "</" + tag + ">";
}

/// Replaces each mark of the template by its text (marks do not occur in the texts put in before).
std::string Fill(std::string text, const std::string& mark, const std::string& filling) {
  const std::size_t at = text.find(mark);
  PHS_CHECK(at != std::string::npos);
  return text.replace(at, mark.size(), filling);
}

/// "2.0e-04" as "2.0·10⁻⁴".
std::string PowerOfTen(const std::string& text) {
  static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t at = text.find('e');
  const int power = std::stoi(text.substr(at + 1));
  std::string raised = power < 0 ? "⁻" : "";
  for (char digit : std::to_string(std::abs(power))) raised += kRaised[digit - '0'];
  return text.substr(0, at) + "·10" + raised;
}

}  // namespace

std::string EscapeHtml(const std::string& text) {
  std::string safe;
  safe.reserve(text.size());
  for (char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string FormatNumber(double value, int significant) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  const double size = std::abs(value);
  char buffer[40];
  if (size < 1e-3 || size >= 1e6) {
    std::snprintf(buffer, sizeof buffer, "%.*e", significant - 1, size);
    return (value < 0 ? "−" : "") + PowerOfTen(buffer);
  } else {
    // The decimals that leave `significant` digits after rounding (9.996 → 10.0 with three).
    const double rounded_up = size * (1 + 0.5 * std::pow(10.0, -significant));
    const int decimals = significant - 1 - static_cast<int>(std::floor(std::log10(rounded_up)));
    std::snprintf(buffer, sizeof buffer, "%.*f", std::max(0, decimals), size);
  }
  return (value < 0 ? "−" : "") + std::string(buffer);
}

ReportPage::ReportPage(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void ReportPage::Section(const std::string& title) {
  if (num_sections_ > 0) body_ += "</section>\n";
  const std::string id = "section-" + std::to_string(++num_sections_);
  contents_ += "<li><a href=\"#" + id + "\">" + EscapeHtml(title) + "</a></li>\n";
  body_ += "<section id=\"" + id + "\">\n" + Tag("h2", title) + "\n";
}

void ReportPage::Heading(const std::string& text) { body_ += Tag("h3", text) + "\n"; }

void ReportPage::Paragraph(const std::string& text, const std::string& lead) {
  body_ += "<p>" + (lead.empty() ? "" : Tag("strong", lead) + " ") + EscapeHtml(text) + "</p>\n";
}

void ReportPage::List(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += Tag("li", item) + "\n";
  body_ += "</ul>\n";
}

void ReportPage::Note(const std::string& text) { body_ += Tag("p", text, "note") + "\n"; }

void ReportPage::Warning(const std::string& text) {
  body_ += "<p class=\"warning\" role=\"alert\">" + EscapeHtml(text) + "</p>\n";
}

void ReportPage::Preformatted(const std::string& text) {
  body_ += "<pre tabindex=\"0\">" + EscapeHtml(text) + "</pre>\n";
}

void ReportPage::KeyFigures(const std::vector<KeyFigure>& figures) {
  body_ += "<dl class=\"key-figures\">\n";
  for (const KeyFigure& figure : figures) {
    body_ += "<div><dt>" + EscapeHtml(figure.label) + "</dt><dd><b>" + EscapeHtml(figure.value) +
             "</b> " + Tag("span", figure.unit, "unit") + "</dd>" +
             (figure.remark.empty() ? "" : Tag("dd", figure.remark, "remark")) + "</div>\n";
  }
  body_ += "</dl>\n";
}

void ReportPage::SharedLegend(const std::string& group, const std::vector<Curve>& names) {
  body_ += "<div class=\"legend\" data-group=\"" + EscapeHtml(group) + "\">";
  for (const Curve& name : names) {
    body_ += "<button type=\"button\" aria-pressed=\"true\" class=\"key c" +
             std::to_string(name.colour) + " d" + std::to_string(name.dash) + "\" data-label=\"" +
             EscapeHtml(name.label) + "\"><i></i>" + EscapeHtml(name.label) + "</button>";
  }
  body_ += "</div>\n";
}

void ReportPage::ZoomButtons(const std::string& group, const std::vector<Band>& ranges) {
  body_ += "<div class=\"zoom\" data-group=\"" + EscapeHtml(group) +
           "\"><span>Zoom:</span><button type=\"button\">all</button>";
  for (const Band& range : ranges) {
    body_ += "<button type=\"button\" data-begin=\"" + std::to_string(range.begin) +
             "\" data-end=\"" + std::to_string(range.end) + "\">" + EscapeHtml(range.label) +
             "</button>";
  }
  body_ += "</div>\n";
}

void ReportPage::BeginGrid(int columns) {
  body_ += "<div class=\"grid columns-" + std::to_string(columns) + "\">\n";
}
void ReportPage::EndGrid() { body_ += "</div>\n"; }

void ReportPage::BeginBeside() { body_ += "<div class=\"beside\"><div>\n"; }
void ReportPage::Next() { body_ += "</div><div>\n"; }
void ReportPage::EndBeside() { body_ += "</div></div>\n"; }

void ReportPage::BeginDetails(const std::string& summary) {
  body_ += "<details>" + Tag("summary", summary) + "\n";
}
void ReportPage::EndDetails() { body_ += "</details>\n"; }

void ReportPage::Add(const DataTable& table) {
  const std::string id = "table-" + std::to_string(++num_tables_);
  body_ += "<p class=\"caption\" id=\"" + id + "\">" + EscapeHtml(table.caption) +
           "</p><div class=\"scroll\" tabindex=\"0\"><table aria-labelledby=\"" + id +
           "\">\n<thead><tr>";
  for (const std::string& title : table.head)
    body_ += "<th scope=\"col\">" + EscapeHtml(title) + "</th>";
  body_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<TableCell>& row : table.rows) {
    body_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string style = row[i].strong ? " class=\"strong\"" : "";
      if (row.size() == 1) {
        body_ += "<th class=\"group\" colspan=\"" + std::to_string(table.head.size()) + "\">" +
                 EscapeHtml(row[i].text) + "</th>";
      } else if (i == 0) {
        body_ += "<th scope=\"row\">" + EscapeHtml(row[i].text) + "</th>";
      } else {
        body_ += "<td" + style + ">" + EscapeHtml(row[i].text) + "</td>";
      }
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void ReportPage::Add(const BarChart& chart) {
  double least = 0;
  double greatest = 0;
  for (const BarChart::Bars& bars : chart.bars) {
    for (double value : bars.values) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  const double span = greatest > least ? greatest - least : 1;
  const auto percent = [](double part) { return FormatNumber(100 * part, 5) + "%"; };
  body_ += "<figure class=\"bars\">" +
           Tag("figcaption", chart.title + (chart.unit.empty() ? "" : " [" + chart.unit + "]")) +
           "\n<table><colgroup><col class=\"name\"><col><col class=\"value\"></colgroup>\n";
  for (std::size_t row = 0; row < chart.categories.size(); ++row) {
    if (!chart.categories[row].empty()) {
      body_ += "<tr><th class=\"category\" colspan=\"3\">" + EscapeHtml(chart.categories[row]) +
               "</th></tr>\n";
    }
    for (const BarChart::Bars& bars : chart.bars) {
      const double value =
          row < bars.values.size() ? bars.values[row] : std::numeric_limits<double>::quiet_NaN();
      body_ += "<tr><th scope=\"row\">" + EscapeHtml(bars.label) + "</th><td class=\"bar\">";
      if (std::isfinite(value)) {
        const double from = (std::min(value, 0.0) - least) / span;
        body_ += "<div class=\"c" + std::to_string(bars.colour) +
                 "\" style=\"margin-left:" + percent(from) +
                 ";width:" + percent(std::abs(value) / span) + "\"></div>";
        if (least < 0) body_ += "<s style=\"left:" + percent(-least / span) + "\"></s>";
      }
      body_ += "</td><td>" + FormatNumber(value, chart.significant) + "</td></tr>\n";
    }
  }
  body_ += "</table></figure>\n";
}

void ReportPage::Add(const SeriesPlot& plot) {
  json spec = {{"x_label", plot.x_label},
               {"y_label", plot.y_label},
               {"group", plot.group},
               {"least_span", plot.least_span},
               {"from_zero", plot.from_zero},
               {"steps", plot.steps},
               {"ordinate", plot.ordinate_greatest > plot.ordinate_least
                                ? json{plot.ordinate_least, plot.ordinate_greatest}
                                : json()},
               {"height", plot.height_px},
               {"bands", BandsJson(plot.bands)},
               {"levels", LevelsJson(plot.levels)},
               {"curves", json::array()}};
  const bool keep = KeepsRows(plot);
  const Grid grid = CommonGrid(plot);
  if (keep) {
    spec["x"] = plot.curves.front().x;
  } else {
    spec["grid"] = {{"begin", grid.begin}, {"end", grid.end}, {"points", grid.points}};
  }
  for (const Curve& curve : plot.curves) {
    PHS_CHECK(curve.x.size() == curve.y.size());
    json one = CurveJson(curve);
    one["y"] = PackedJson(keep ? curve.y : PutOnGrid(curve.x, curve.y, grid));
    spec["curves"].push_back(std::move(one));
  }
  AddFigure("series", plot.title, Dump(spec));
}

void ReportPage::Add(const XyPlot& plot) {
  json spec = {{"x_label", plot.x_label},
               {"y_label", plot.y_label},
               {"height", plot.height_px},
               {"levels", LevelsJson(plot.levels)},
               {"curves", json::array()}};
  for (const Curve& curve : plot.curves) {
    PHS_CHECK(curve.x.size() == curve.y.size());
    json one = CurveJson(curve);
    one["x"] = PackedJson(curve.x);
    one["y"] = PackedJson(curve.y);
    spec["curves"].push_back(std::move(one));
  }
  AddFigure("xy", plot.title, Dump(spec));
}

void ReportPage::Add(const HeatMap& map) {
  PHS_CHECK(map.y_edges.size() == map.values.size() + 1);
  const json spec = {{"x_label", map.x_label},         {"y_label", map.y_label},
                     {"value_label", map.value_label}, {"x_edges", map.x_edges},
                     {"y_edges", map.y_edges},         {"values", map.values},
                     {"diverging", map.diverging},     {"full_scale", map.full_scale}};
  AddFigure("heat", map.title, Dump(spec));
}

void ReportPage::AddFigure(const std::string& kind, const std::string& title,
                           const std::string& spec) {
  const std::string id = "figure-" + std::to_string(++num_figures_);
  body_ += "<figure class=\"plot " + kind + "\" id=\"" + id + "\" data-kind=\"" + kind + "\">" +
           Tag("figcaption", title) + "<div class=\"drawing\"></div></figure>\n";
  if (!figures_.empty()) figures_ += ",\n";
  figures_ += "\"" + id + "\":" + spec;
}

std::string ReportPage::Html() const {
  std::string html = kPageTemplate;
  html = Fill(std::move(html), "@SCRIPT@", kPageScript);
  html = Fill(std::move(html), "@STYLE@", kPageStyle);
  html = Fill(std::move(html), "@LICENCE@", EscapeHtml(kPlotLibraryLicence));
  html = Fill(std::move(html), "@FIGURES@", "{" + figures_ + "}");
  html = Fill(std::move(html), "@BODY@", body_ + (num_sections_ > 0 ? "</section>\n" : ""));
  html = Fill(std::move(html), "@CONTENTS@", contents_);
  html = Fill(std::move(html), "@SUBTITLE@", EscapeHtml(subtitle_));
  html = Fill(std::move(html), "@HEADING@", EscapeHtml(title_));
  return Fill(std::move(html), "@TITLE@", EscapeHtml(title_));
}

Status ReportPage::Write(const std::string& path) const {
  return WriteFileAtomically(path, Html());
}

}  // namespace phs::report
