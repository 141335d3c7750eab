// One self-contained HTML page: texts, tables, bar charts, plots. It loads nothing from anywhere.
//
// Texts, tables and bar charts are plain HTML; plots are drawn by the page's own script from data
// that the page carries. Use:
//   ReportPage page("Curving run", "R = 550 m, 60 km/h");
//   page.Section("Along the track");
//   page.Paragraph("…");
//   page.Add(SeriesPlot{.title = "Angle of attack", …});
//   return page.Write(path);
// All texts are plain text (the page escapes them and takes the machine's folders out of them,
// shown_paths.h); quantities carry their unit in the label.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/origin.h"
#include "base/result.h"

namespace phs::report {

/// Colours are numbers 0–7 of one palette that colour-blind readers can tell apart, in light and
/// dark; dash patterns 0 (solid) – 3 tell curves apart in print.
struct Curve {
  std::string label = {};
  int colour = 0;
  int dash = 0;
  std::vector<double> x = {};
  std::vector<double> y = {};
  bool points = false;  ///< markers instead of a line
};

/// A shaded part of the abscissa, e.g. a circular arc.
struct Band {
  double begin = 0;
  double end = 0;
  std::string label = {};
  int strength = 1;  ///< 1 faint, 2 stronger
};

/// A horizontal line, e.g. a limit.
struct Level {
  double value = 0;
  std::string label = {};
};

/// Curves over one growing abscissa (time, distance), zoomed and read together with every other
/// plot of the same `group`. Long curves are thinned out to `max_points` (see decimation.h).
struct SeriesPlot {
  std::string title = {};
  std::string x_label = {};  ///< "distance [m]"
  std::string y_label = {};  ///< "Y [kN]"
  std::vector<Curve> curves = {};
  std::vector<Band> bands = {};
  std::vector<Level> levels = {};
  std::string group = "x";
  double ordinate_least = 0;     ///< with ordinate_greatest > ordinate_least: the ordinate's range
  double ordinate_greatest = 0;  ///< while nothing is zoomed, e.g. equal for plots to be compared
  double least_span = 0;         ///< the ordinate never shows less than this, so noise stays small
  bool from_zero = false;
  bool steps = false;  ///< values hold until the next one (counts)
  int max_points = 2000;
  int height_px = 240;
};

/// Curves or point clouds in a plane: loops, scatter, root loci.
struct XyPlot {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  std::vector<Curve> curves = {};
  std::vector<Level> levels = {};
  int height_px = 360;
};

/// Values over a rectangular grid of cells; NaN cells stay empty.
struct HeatMap {
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};
  std::string value_label = {};
  std::vector<double> x_edges = {};              ///< ascending, one more than columns
  std::vector<double> y_edges = {};              ///< ascending, one more than rows
  std::vector<std::vector<double>> values = {};  ///< [row][column]
  double full_scale = 0;  ///< magnitude at the end of diverging colours; 0 = the largest value
  bool diverging = true;  ///< zero in the middle of the colours
};

/// Horizontal bars; categories one below the other, one bar per name.
struct BarChart {
  std::string title = {};
  std::string unit = {};  ///< shown in the title; may be empty
  std::vector<std::string> categories = {};
  struct Bars {
    std::string label;
    int colour = 0;
    std::vector<double> values = {};  ///< one per category, NaN = none
  };
  std::vector<Bars> bars = {};
  int significant = 3;
};

struct TableCell {
  std::string text = {};
  bool strong = false;
  std::string link = {};  ///< address relative to the page (page_links.h: Address); empty = none
  bool bad = false;       ///< set in the colour of warnings
  TableCell(std::string t, bool s = false) : text(std::move(t)), strong(s) {}  // NOLINT
  TableCell(const char* t) : text(t) {}                                        // NOLINT
};
struct DataTable {
  std::string caption = {};
  std::vector<std::string> head = {};  ///< first column = row names
  std::vector<std::vector<TableCell>> rows =
      {};              ///< a row with one cell is a heading across the table
  bool words = false;  ///< cells hold words: set from the left and broken into lines
};

/// One big number at the top of a page.
struct KeyFigure {
  std::string value = {};
  std::string unit = {};
  std::string label = {};
  std::string remark = {};
};

class ReportPage {
 public:
  ReportPage(std::string title, std::string subtitle);

  /// Starts a section; it is listed in the contents at the top.
  void Section(const std::string& title);
  void Heading(const std::string& text);
  /// `lead` is set in bold in front of the text.
  void Paragraph(const std::string& text, const std::string& lead = "");
  void List(const std::vector<std::string>& items);
  /// What the page says above all, in one sentence. `tone`: 0 good, 1 in doubt, 2 bad.
  void Verdict(const std::string& sentence, int tone);
  void Note(const std::string& text);     ///< set off from the text
  void Warning(const std::string& text);  ///< something is wrong with the run
  void Preformatted(const std::string& text);
  void KeyFigures(const std::vector<KeyFigure>& figures);
  /// Colours and names shared by the plots that follow; a click hides a curve everywhere.
  void SharedLegend(const std::string& group, const std::vector<Curve>& names);
  /// Buttons that zoom all plots of a group; the whole range is always the first.
  void ZoomButtons(const std::string& group, const std::vector<Band>& ranges);

  /// Figures, tables and charts between these two stand side by side where there is room.
  void BeginGrid(int columns);
  void EndGrid();
  /// A narrower and a wider part side by side where there is room; Next() goes to the wider one.
  void BeginBeside();
  void Next();
  void EndBeside();
  /// Folded content.
  void BeginDetails(const std::string& summary);
  void EndDetails();

  void Add(const DataTable& table);
  void Add(const BarChart& chart);
  void Add(const SeriesPlot& plot);
  void Add(const XyPlot& plot);
  void Add(const HeatMap& map);
  /// A figure drawn by the page script's painter `kind` from `json`, whatever its texts hold.
  void AddFigure(const std::string& kind, const std::string& title, const std::string& json);

  /// Where the numbers come from. Without it Write() looks for origin.json beside a report.html.
  void SetOrigin(const std::optional<Origin>& origin) { origin_ = origin; }
  /// HTML that stands above the page, e.g. links (page_links.h).
  void SetLinks(const std::string& html) { links_ = html; }
  /// Data of the painters `replay` and `profiles`, apart from those of the figures: read after them,
  /// as is the library that draws them in three dimensions.
  void SetFilm(const std::string& json);

  std::string Html() const;
  /// The page with a last section on where it comes from and a link to the index above it, if there
  /// is one.
  Status Write(const std::string& path) const;

 private:
  std::string title_ = {};
  std::string subtitle_ = {};
  std::string contents_ = {};  ///< HTML list of the sections
  std::string body_ = {};      ///< HTML
  std::string figures_ = {};   ///< JSON members "id": {…}
  std::string links_ = {};     ///< HTML
  std::optional<Origin> origin_ = {};
  std::string film_ = {};  ///< HTML of the script elements of SetFilm
  int num_sections_ = 0;
  int num_figures_ = 0;
  int num_tables_ = 0;
};

/// Text with the characters of HTML replaced.
std::string EscapeHtml(const std::string& text);
/// A number for reading: `significant` digits, no exponent between 1e-3 and 1e6; "–" for NaN.
std::string FormatNumber(double value, int significant = 3);

}  // namespace phs::report
