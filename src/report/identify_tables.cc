// Tables of the identification report: errors, effects with intervals, candidates.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/identify_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

struct Measure {
  const char* key;
  const char* label;
  bool has_unit;      ///< in the channel's unit
  double factor = 1;  ///< from the number in the file to the one shown
};
constexpr Measure kMeasures[] = {
    {"rmse", "RMSE", true},
    {"nrmse", "NRMSE", false},
    {"bias", "bias", true},
    {"max", "largest", true},
    {"m_re_percent", "m%RE [%]", false},
    {"share_below_12_percent", "samples with error below 12 % [%]", false, 100}};

/// One row per channel and measure, with columns before, after and after/before.
void AddScores(const json& channels, bool has_before, const std::string& caption,
               ReportPage* page) {
  DataTable table{.caption = caption};
  table.head = has_before ? std::vector<std::string>{"Error", "declared, fitted", "corrected",
                                                     "corrected / declared"}
                          : std::vector<std::string>{"Error", "model"};
  for (const auto& [channel, scores] : channels.items()) {
    const ReadableName name = Readable(channel);
    table.rows.push_back({TableCell(name.words)});
    for (const Measure& measure : kMeasures) {
      const double factor = measure.has_unit ? name.factor : measure.factor;
      const std::string label = measure.has_unit ? fmt::format("{} [{}]", measure.label, name.unit)
                                                 : std::string(measure.label);
      const std::string key = std::string("/") + measure.key;
      if (!has_before) {
        const double value = factor * NumberAt(scores, key);
        if (std::isfinite(value)) table.rows.push_back({label, TableCell(FormatNumber(value))});
        continue;
      }
      const double before = factor * NumberAt(scores, "/before" + key);
      const double after = factor * NumberAt(scores, "/after" + key);
      if (!std::isfinite(before) && !std::isfinite(after)) continue;
      const double ratio = std::abs(after / before);
      table.rows.push_back({label, TableCell(FormatNumber(before)),
                            TableCell(FormatNumber(after), true), TableCell(FormatNumber(ratio))});
    }
  }
  page->Add(table);
}

std::string Interval(const json& parameter, double factor) {
  const double low = factor * NumberAt(parameter, "/low");
  const double high = factor * NumberAt(parameter, "/high");
  if (!std::isfinite(low) || !std::isfinite(high)) return "–";
  const int figures = FiguresOf(parameter);
  return FormatNumber(low, figures) + " … " + FormatNumber(high, figures);
}

/// Text of any JSON value for a table cell.
std::string CellText(const json& value) {
  if (value.is_number()) return FormatNumber(value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_null()) return "–";
  if (value.is_array()) {
    std::string text;
    for (const json& item : value) text += (text.empty() ? "" : ", ") + CellText(item);
    return text.empty() ? "–" : text;
  }
  std::string text;
  for (const auto& [key, item] : value.items()) {
    text += (text.empty() ? "" : "; ") + key + " " + CellText(item);
  }
  return text;
}

/// One row per item, with whatever the items say of themselves as columns, numbers in front of
/// texts.
DataTable WideTable(const json& items, const std::string& caption, const std::string& what) {
  std::vector<std::string> numbers;
  std::vector<std::string> texts;
  for (const json& item : items) {
    for (const auto& [key, value] : item.items()) {
      if (key == "name" || key == "effects") continue;
      std::vector<std::string>& columns = value.is_number() ? numbers : texts;
      if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
    }
  }
  std::erase_if(texts, [&](const std::string& key) {
    return std::find(numbers.begin(), numbers.end(), key) != numbers.end();
  });
  std::vector<std::string> columns = numbers;
  columns.insert(columns.end(), texts.begin(), texts.end());
  DataTable table{.caption = caption, .head = {what}};
  for (const std::string& column : columns) table.head.push_back(Spaced(column));
  for (const json& item : items) {
    const json name = item.contains("name") ? item["name"] : item.value("effects", json("?"));
    std::vector<TableCell> row = {TableCell(Spaced(CellText(name)))};
    for (const std::string& column : columns) {
      row.emplace_back(item.contains(column) ? Spaced(CellText(item[column])) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

void AddNumbers(const json& parameters, DataTable* table) {
  for (const auto& [name, parameter] : parameters.items()) {
    const ReadableName readable = Readable(name);
    table->rows.push_back(
        {TableCell(readable.unit == "–" ? name : readable.words + " [" + readable.unit + "]"),
         TableCell(
             FormatNumber(readable.factor * NumberAt(parameter, "/value"), FiguresOf(parameter)),
             true),
         TableCell(Interval(parameter, readable.factor))});
  }
}

/// What the form of an effect holds at other than its default: an orifice has exponent 0.5.
void AddHeld(const json& held, DataTable* table) {
  for (const auto& [name, value] : held.items()) {
    const ReadableName readable = Readable(name);
    table->rows.push_back(
        {TableCell(readable.unit == "–" ? name : readable.words + " [" + readable.unit + "]"),
         TableCell(FormatNumber(readable.factor * value.get<double>()), true),
         TableCell("held by its form")});
  }
}

}  // namespace

int FiguresOf(const json& parameter) {
  constexpr int kLeast = 3, kMost = 8;
  const double value = NumberAt(parameter, "/value");
  const double half = (NumberAt(parameter, "/high") - NumberAt(parameter, "/low")) / 2;
  if (!(half > 0) || !std::isfinite(half) || !(std::abs(value) > half)) return kLeast;
  const double of_value = std::floor(std::log10(std::abs(value)));
  const double of_half = std::floor(std::log10(half));
  return std::clamp(static_cast<int>(of_value - of_half) + 1, kLeast, kMost);
}

void AddErrorFigures(const IdentifyResults& results, ReportPage* page) {
  const json channels = results.all.value("channels", json::object());
  constexpr size_t kMost = 4;
  std::vector<KeyFigure> figures;
  for (const auto& [channel, scores] : channels.items()) {
    if (figures.size() == kMost) {
      page->Note(fmt::format("Shown are the first {} of {} channels; all stand under Errors.",
                             kMost, channels.size()));
      break;
    }
    const std::string at = results.has_before ? "/after/nrmse" : "/nrmse";
    const double after = NumberAt(scores, at);
    if (!std::isfinite(after)) continue;
    const double before = NumberAt(scores, "/before/nrmse");
    figures.push_back({.value = FormatNumber(100 * after),
                       .unit = "%",
                       .label = "NRMSE of " + Readable(channel).words +
                                (results.has_before ? ", corrected model" : ""),
                       .remark = std::isfinite(before) ? "declared model, fitted: " +
                                                             FormatNumber(100 * before) + " %"
                                                       : ""});
  }
  if (!figures.empty()) page->KeyFigures(figures);
}

void AddErrorTable(const IdentifyResults& results, ReportPage* page) {
  const bool windows = !results.windows.empty();
  const bool steps = results.all.value("rig", "") == "steps";
  page->BeginGrid(2);
  AddScores(results.all.value("channels", json::object()), results.has_before,
            steps                           ? "Steps, each left out of its fit"
            : results.has_before || windows ? "Validation window (took no part in fit or choice)"
                                            : "Whole record",
            page);
  const json estimation = results.all.value("channels_estimation", json::object());
  if (!estimation.empty()) {
    AddScores(estimation, results.has_before, "Estimation window", page);
  }
  page->EndGrid();
  page->Note(
      "RMSE: root of the mean square of measured − predicted. NRMSE: RMSE over the standard "
      "deviation "
      "of the measured channel. m%RE: mean relative error capped at 100 %, which says little where "
      "the force is small. The models are driven by the measured motion alone.");
}

void AddEffectTable(const IdentifyResults& results, ReportPage* page) {
  const json effects = results.all.value("effects", json::array());
  if (effects.empty()) {
    page->Note("No effect was accepted: the declared model with fitted parameters suffices.");
    return;
  }
  DataTable table{.caption = "Accepted effects, strongest first",
                  .head = {"Effect, parameter", "value", "interval"}};
  json evidence = json::array();
  for (const json& effect : effects) {
    std::string title = DescribeEffect(effect);
    const json twins = effect.value("confusable_with", json::array());
    if (!twins.empty()) title += "; with these data not to be told from " + Spaced(CellText(twins));
    table.rows.push_back({TableCell(title)});
    const json parameters = effect.value("parameters", json::object());
    AddNumbers(parameters, &table);
    AddHeld(effect.value("held", json::object()), &table);
    if (const json form = effect.value("form", json::object()); !form.empty()) {
      table.rows.push_back({TableCell("its own form: " + form.value("formula", "?")), "", ""});
      AddNumbers(form.value("parameters", json::object()), &table);
    }
    if (parameters.empty()) table.rows.push_back({TableCell("no parameter"), "", ""});
    const json grounds = effect.value("evidence", json());
    if (!grounds.is_object() || grounds.empty()) continue;
    evidence.push_back({{"name", effect.value("name", "?")}});
    evidence.back().update(grounds);
  }
  page->Add(table);
  if (!evidence.empty()) page->Add(WideTable(evidence, "Evidence", "Effect"));
}

void AddCandidateTable(const IdentifyResults& results, ReportPage* page) {
  const json candidates = results.all.value("candidates", json::array());
  if (candidates.empty()) return;
  page->BeginDetails(fmt::format("All {} candidates with their scores", candidates.size()));
  page->Add(WideTable(candidates, "Every candidate that was tried", "Candidate"));
  page->EndDetails();
}

}  // namespace phs::report
