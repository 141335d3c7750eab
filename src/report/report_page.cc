#include "report/report_page.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "report/page_assets.h"
#include "report/shown_paths.h"

namespace phs::report {
namespace {

/// A text for the page: escaped, without folders of the machine.
std::string Shown(const std::string& text) { return EscapeHtml(WithoutFolders(text)); }

std::string Tag(const std::string& tag, const std::string& text, const std::string& style = "") {
  return "<" + tag + (style.empty() ? "" : " class=\"" + style + "\"") + ">" + Shown(text) + "</" +
         tag + ">";
}

/// Replaces each mark of the template by its text (marks do not occur in the texts put in before).
std::string Fill(std::string text, const std::string& mark, const std::string& filling) {
  const std::size_t at = text.find(mark);
  PHS_CHECK(at != std::string::npos);
  return text.replace(at, mark.size(), filling);
}

}  // namespace

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
  body_ += "<p>" + (lead.empty() ? "" : Tag("strong", lead) + " ") + Shown(text) + "</p>\n";
}

void ReportPage::List(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += Tag("li", item) + "\n";
  body_ += "</ul>\n";
}

void ReportPage::Verdict(const std::string& sentence, int tone) {
  body_ += Tag("p", sentence, "verdict tone-" + std::to_string(tone)) + "\n";
}

void ReportPage::Note(const std::string& text) { body_ += Tag("p", text, "note") + "\n"; }

void ReportPage::Warning(const std::string& text) {
  body_ += "<p class=\"warning\" role=\"alert\">" + Shown(text) + "</p>\n";
}

void ReportPage::Preformatted(const std::string& text) {
  body_ += "<pre tabindex=\"0\">" + Shown(text) + "</pre>\n";
}

void ReportPage::KeyFigures(const std::vector<KeyFigure>& figures) {
  body_ += "<dl class=\"key-figures\">\n";
  for (const KeyFigure& figure : figures) {
    body_ += "<div><dt>" + Shown(figure.label) + "</dt><dd><b>" + EscapeHtml(figure.value) +
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
  // One box, so that a grid keeps the caption over its table.
  body_ += "<div><p class=\"caption\" id=\"" + id + "\">" + Shown(table.caption) +
           "</p><div class=\"scroll" + (table.words ? " words" : "") +
           "\" tabindex=\"0\"><table aria-labelledby=\"" + id + "\">\n<thead><tr>";
  for (const std::string& title : table.head)
    body_ += "<th scope=\"col\">" + EscapeHtml(title) + "</th>";
  body_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<TableCell>& row : table.rows) {
    body_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string style = row[i].bad      ? " class=\"bad\""
                                : row[i].strong ? " class=\"strong\""
                                                : "";
      const std::string words = Shown(row[i].text);
      const std::string text =
          row[i].link.empty() ? words
                              : "<a href=\"" + EscapeHtml(row[i].link) + "\">" + words + "</a>";
      if (row.size() == 1) {
        body_ += "<th class=\"group\" colspan=\"" + std::to_string(table.head.size()) + "\">" +
                 text + "</th>";
      } else if (i == 0) {
        body_ += "<th scope=\"row\">" + text + "</th>";
      } else {
        body_ += "<td" + style + ">" + text + "</td>";
      }
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div></div>\n";
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

std::string ReportPage::Html() const {
  std::string html = kPageTemplate;
  html = Fill(std::move(html), "@SCRIPT@", kPageScript);
  html = Fill(std::move(html), "@STYLE@", kPageStyle);
  html = Fill(std::move(html), "@FILM@", film_);
  std::string licence = kPlotLibraryLicence;
  if (!film_.empty()) licence += std::string("\n") + kSceneLibraryLicence;
  html = Fill(std::move(html), "@LICENCE@", EscapeHtml(licence));
  html = Fill(std::move(html), "@FIGURES@", "{" + figures_ + "}");
  html = Fill(std::move(html), "@BODY@", body_ + (num_sections_ > 0 ? "</section>\n" : ""));
  html = Fill(std::move(html), "@CONTENTS@", contents_);
  html = Fill(std::move(html), "@LINKS@", links_);
  html = Fill(std::move(html), "@SUBTITLE@", Shown(subtitle_));
  html = Fill(std::move(html), "@HEADING@", Shown(title_));
  return Fill(std::move(html), "@TITLE@", Shown(title_));
}

}  // namespace phs::report
