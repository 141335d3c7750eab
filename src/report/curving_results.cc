#include "report/curving_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/numbers.h"
#include "report/json_fields.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Error MissingBogie(const CurvingReportInput& input, const std::string& bogie) {
  return {.where = input.results,
          .what = "has no bogie '" + bogie + "'",
          .mend = "name a bogie of this result"};
}

void ReadTrack(CurvingResults* results) {
  const json track = results->all.value("track", json::object());
  if (!track.is_object()) return;
  results->track_name = track.value("name", "");
  for (const json& section : track.value("sections", json::array())) {
    results->sections.push_back({.kind = section.value("kind", ""),
                                 .begin = NumberOf(section, "begin_s_m"),
                                 .end = NumberOf(section, "end_s_m"),
                                 .radius = std::abs(NumberOf(section, "radius_m"))});
  }
  for (const Section& section : results->sections) {
    if (section.kind != "curve") continue;
    results->steady_begin = section.begin + (section.end - section.begin) * 2 / 3;
    results->steady_end = section.end;
    results->radius = section.radius;
    break;
  }
}

/// The hand of the arc from the recorded curvature, else from the track's centre line.
int FindHand(const CurvingResults& results) {
  if (results.radius == 0) return 0;
  double mean = kNoNumber;
  for (const BogieRun& run : results.runs) {
    mean = run.Mean("curvature_1_m", results.steady_begin, results.steady_end);
    if (std::isfinite(mean)) break;
  }
  if (!std::isfinite(mean)) {
    const json line = results.all.value(json::json_pointer("/track/centre_line"), json::object());
    const json s = line.value("s_m", json::array());
    const json curvature = line.value("curvature_1_m", json::array());
    mean = 0;
    for (std::size_t i = 0; i < s.size() && i < curvature.size(); ++i) {
      const double at = AsNumber(s[i]);
      if (at >= results.steady_begin && at <= results.steady_end) mean += AsNumber(curvature[i]);
    }
  }
  return mean > 0 ? 1 : mean < 0 ? -1 : 0;
}

/// First of the usual places of a bogie's time series that exists; empty if none.
std::string FindSeries(const fs::path& directory, const std::string& bogie, bool single) {
  std::vector<fs::path> places = {directory / (bogie + "_timeseries.h5"),
                                  directory / bogie / "timeseries.h5"};
  if (single) places.push_back(directory / "timeseries.h5");
  for (const fs::path& place : places) {
    if (fs::exists(place)) return place.string();
  }
  return "";
}

}  // namespace

Result<CurvingReportInput> CurvingReportInput::FromDirectory(const std::string& directory) {
  CurvingReportInput input;
  const fs::path folder(directory);
  const bool several = fs::exists(folder / "compare.json");
  input.results = (folder / (several ? "compare.json" : "summary.json")).string();
  if (!fs::exists(input.results)) {
    return Error{.where = directory,
                 .what = "holds no result of a curving run",
                 .allowed = "a directory with compare.json or summary.json",
                 .mend = "name a directory written by phs simulate or phs compare"};
  }
  Result<json> all = ReadJsonObject(input.results, "", "run the simulation again");
  if (!all.ok()) return all.error();
  if (!several) {
    const std::string bogie = all.value().value("bogie", "bogie");
    input.runs.push_back({bogie, FindSeries(folder, bogie, true)});
    return input;
  }
  const json bogies = all.value().value("bogies", json::object());
  for (const auto& [name, summary] : bogies.items()) {
    input.runs.push_back({name, FindSeries(folder, name, bogies.size() == 1)});
  }
  // The steered bogie is the one the others are compared with.
  std::stable_sort(input.runs.begin(), input.runs.end(), [](const Run& a, const Run& b) {
    return (a.bogie == "phs") > (b.bogie == "phs");
  });
  return input;
}

const std::vector<double>* BogieRun::Channel(const std::string& channel) const {
  const int index = series.Find(channel);
  return index < 0 ? nullptr : &series.columns[index];
}

double BogieRun::Mean(const std::string& channel, double begin, double end) const {
  const std::vector<double>* s = Channel("s_m");
  const std::vector<double>* y = Channel(channel);
  if (s == nullptr || y == nullptr) return kNoNumber;
  double sum = 0;
  long count = 0;
  for (std::size_t i = 0; i < s->size(); ++i) {
    if ((*s)[i] < begin || (*s)[i] > end) continue;
    sum += (*y)[i];
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : kNoNumber;
}

double BogieRun::Deviation(const std::string& channel, double begin, double end) const {
  const std::vector<double>* s = Channel("s_m");
  const std::vector<double>* y = Channel(channel);
  const double mean = Mean(channel, begin, end);
  if (!std::isfinite(mean)) return kNoNumber;
  double sum = 0;
  long count = 0;
  for (std::size_t i = 0; i < s->size(); ++i) {
    if ((*s)[i] < begin || (*s)[i] > end) continue;
    sum += ((*y)[i] - mean) * ((*y)[i] - mean);
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

double BogieRun::Number(const std::string& pointer) const {
  const json::json_pointer at(pointer);
  return summary.contains(at) ? AsNumber(summary.at(at)) : kNoNumber;
}

double BogieRun::Steady(const std::string& list, const std::string& item,
                        const std::string& key) const {
  const json::json_pointer at("/steady_curve/" + list);
  if (!summary.contains(at)) return kNoNumber;
  for (const json& entry : summary.at(at)) {
    if (entry.value("name", "") == item) return NumberOf(entry, key);
  }
  return kNoNumber;
}

namespace {

double SumOverWheels(const BogieRun& run, const std::string& prefix, const char* key) {
  const json::json_pointer at("/steady_curve/wheels");
  if (!run.summary.contains(at)) return kNoNumber;
  double sum = 0;
  for (const json& wheel : run.summary.at(at)) {
    if (wheel.value("name", "").starts_with(prefix)) sum += NumberOf(wheel, key);
  }
  return sum;
}

}  // namespace

std::string CurvingResults::Side(bool outer) const {
  return (hand > 0) == outer ? "right" : "left";
}

std::vector<AxleName> CurvingResults::Axles(const std::string& prefix) const {
  bool middle = false;
  for (const BogieRun& run : runs) {
    middle = middle || std::isfinite(run.Steady("wheelsets", prefix + "mid", "lateral_m"));
  }
  if (!middle) return {{"lead", "leading"}, {"trail", "trailing"}};
  return {{"lead", "leading"}, {"mid", "middle"}, {"trail", "trailing"}};
}

double CurvingResults::SteadyWear(const BogieRun& run, const std::string& prefix) {
  return SumOverWheels(run, prefix, "T_gamma_N");
}

double CurvingResults::SteadySpin(const BogieRun& run, const std::string& prefix) {
  return SumOverWheels(run, prefix, "T_gamma_spin_N");
}

std::string BogieLabel(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (name == "phs" || name.starts_with("phs ")) name.replace(0, 3, "PHS");
  return name;
}

std::string BogieWords(const std::string& prefix) {
  return prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1) + " bogie, ";
}

std::string RatioText(double other, double own, double floor) {
  const double ratio = std::abs(other / own);
  if (!std::isfinite(other) || !std::isfinite(own)) return "–";
  if (std::abs(own) < floor) {
    return std::abs(other) < 2 * floor
               ? "–"
               : "at least " + FormatNumber(std::abs(other) / floor, 2) + " ×";
  }
  return FormatNumber(ratio) + " ×";
}

std::string SectionLabel(const Section& section) {
  return section.kind == "curve"        ? fmt::format("R {:.0f} m", section.radius)
         : section.kind == "transition" ? "transition"
                                        : "";
}

Result<CurvingResults> ReadCurvingResults(const CurvingReportInput& input) {
  Result<json> all = ReadJsonObject(input.results, "", "run the simulation again");
  if (!all.ok()) return all.error();
  CurvingResults results;
  results.all = std::move(all.value());
  if (input.runs.empty()) {
    return Error{.where = input.results, .what = "holds no bogie", .mend = "run it again"};
  }
  const bool several = results.all.contains("bogies");
  int colour = 0;
  for (const CurvingReportInput::Run& file : input.runs) {
    BogieRun run{.name = file.bogie,
                 .label = BogieLabel(file.bogie),
                 .colour = colour % 8,
                 .dash = colour % 2};
    ++colour;
    if (several && !results.all["bogies"].contains(file.bogie)) {
      return MissingBogie(input, file.bogie);
    }
    run.summary = several ? results.all["bogies"][file.bogie] : results.all;
    if (!file.series.empty()) {
      Result<Series> series = ReadSeries(file.series);
      if (!series.ok()) return series.error();
      run.series = std::move(series.value());
    }
    results.runs.push_back(std::move(run));
  }
  ReadTrack(&results);
  results.hand = FindHand(results);
  const bool locomotive = results.reference().Channel("front_lead_lateral_m") != nullptr;
  results.prefixes =
      locomotive ? std::vector<std::string>{"front_", "rear_"} : std::vector<std::string>{""};
  return results;
}

}  // namespace phs::report
