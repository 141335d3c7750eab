// The figures of a page: plots as JSON for the page's own script.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/check.h"
#include "report/decimation.h"
#include "report/page_assets.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

/// Numbers that are not finite become null.
std::string Dump(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// JSON that may stand inside an HTML script element: '<', '>', '&' and the line ends U+2028,
/// U+2029 only occur in its texts, and there they may be written by their numbers.
std::string ScriptSafe(const std::string& text) {
  constexpr std::string_view kLineEnds = "\xe2\x80";
  std::string safe;
  safe.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool line_end = text.compare(i, 2, kLineEnds) == 0 && i + 2 < text.size() &&
                          (text[i + 2] == '\xa8' || text[i + 2] == '\xa9');
    if (c == '<' || c == '>' || c == '&') {
      safe += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : "\\u0026";
    } else if (line_end) {
      safe += text[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += c;
    }
  }
  return safe;
}

nlohmann::json PackedJson(const std::vector<double>& values) {
  const PackedValues packed = Pack(values);
  return {{"least", packed.least}, {"greatest", packed.greatest}, {"packed", packed.base64}};
}

nlohmann::json CurveJson(const Curve& curve) {
  return {{"label", curve.label},
          {"colour", curve.colour},
          {"dash", curve.dash},
          {"points", curve.points}};
}

nlohmann::json LevelsJson(const std::vector<Level>& levels) {
  nlohmann::json list = nlohmann::json::array();
  for (const Level& level : levels)
    list.push_back({{"value", level.value}, {"label", level.label}});
  return list;
}

nlohmann::json BandsJson(const std::vector<Band>& bands) {
  nlohmann::json list = nlohmann::json::array();
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

}  // namespace

void ReportPage::Add(const SeriesPlot& plot) {
  nlohmann::json spec = {
      {"x_label", plot.x_label},
      {"y_label", plot.y_label},
      {"group", plot.group},
      {"least_span", plot.least_span},
      {"from_zero", plot.from_zero},
      {"steps", plot.steps},
      {"ordinate", plot.ordinate_greatest > plot.ordinate_least
                       ? nlohmann::json{plot.ordinate_least, plot.ordinate_greatest}
                       : nlohmann::json()},
      {"height", plot.height_px},
      {"bands", BandsJson(plot.bands)},
      {"levels", LevelsJson(plot.levels)},
      {"curves", nlohmann::json::array()}};
  const bool keep = KeepsRows(plot);
  const Grid grid = CommonGrid(plot);
  if (keep) {
    spec["x"] = plot.curves.front().x;
  } else {
    spec["grid"] = {{"begin", grid.begin}, {"end", grid.end}, {"points", grid.points}};
  }
  for (const Curve& curve : plot.curves) {
    PHS_CHECK(curve.x.size() == curve.y.size());
    nlohmann::json one = CurveJson(curve);
    one["y"] = PackedJson(keep ? curve.y : PutOnGrid(curve.x, curve.y, grid));
    spec["curves"].push_back(std::move(one));
  }
  AddFigure("series", plot.title, Dump(spec));
}

void ReportPage::Add(const XyPlot& plot) {
  nlohmann::json spec = {{"x_label", plot.x_label},
                         {"y_label", plot.y_label},
                         {"height", plot.height_px},
                         {"levels", LevelsJson(plot.levels)},
                         {"curves", nlohmann::json::array()}};
  for (const Curve& curve : plot.curves) {
    PHS_CHECK(curve.x.size() == curve.y.size());
    nlohmann::json one = CurveJson(curve);
    one["x"] = PackedJson(curve.x);
    one["y"] = PackedJson(curve.y);
    spec["curves"].push_back(std::move(one));
  }
  AddFigure("xy", plot.title, Dump(spec));
}

void ReportPage::Add(const HeatMap& map) {
  PHS_CHECK(map.y_edges.size() == map.values.size() + 1);
  const nlohmann::json spec = {{"x_label", map.x_label},         {"y_label", map.y_label},
                               {"value_label", map.value_label}, {"x_edges", map.x_edges},
                               {"y_edges", map.y_edges},         {"values", map.values},
                               {"diverging", map.diverging},     {"full_scale", map.full_scale}};
  AddFigure("heat", map.title, Dump(spec));
}

void ReportPage::SetFilm(const std::string& film) {
  // As text: it is run by the page's script once everything else is drawn.
  film_ = "<script type=\"application/json\" id=\"film\">" + ScriptSafe(film) +
          "</script>\n<script type=\"text/plain\" id=\"scene\">" + kSceneScript + "</script>\n";
}

void ReportPage::AddFigure(const std::string& kind, const std::string& title,
                           const std::string& spec) {
  const std::string id = "figure-" + std::to_string(++num_figures_);
  body_ += "<figure class=\"plot " + kind + "\" id=\"" + id + "\" data-kind=\"" + kind + "\">" +
           "<figcaption>" + EscapeHtml(title) +
           "</figcaption><div class=\"drawing\"></div></figure>\n";
  if (!figures_.empty()) figures_ += ",\n";
  figures_ += "\"" + id + "\":" + ScriptSafe(spec);
}

}  // namespace phs::report
