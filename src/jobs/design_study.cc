#include "jobs/design_study.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/data_path.h"
#include "base/disk.h"
#include "base/result_dir.h"
#include "base/words.h"
#include "base/yaml.h"
#include "sweep/subjects.h"

namespace phs::jobs {
namespace {

namespace fs = std::filesystem;

/// Files of the study itself beside its parts.
constexpr const char* kOwnFiles[] = {"study.json", "study.yaml", "report.html", "origin.json"};

std::vector<StudyPlot> ReadPlots(YamlMap* map) {
  std::vector<StudyPlot> plots;
  for (YamlMap& entry : map->Maps("plots")) {
    StudyPlot plot;
    plot.title = entry.Text("title", "");
    plot.x = entry.Text("x");
    plot.y = entry.Text("y");
    plot.by = entry.Texts("by");
    plots.push_back(std::move(plot));
  }
  return plots;
}

std::vector<StudySpread> ReadSpreads(YamlMap* map) {
  std::vector<StudySpread> spreads;
  for (YamlMap& entry : map->Maps("spreads")) {
    StudySpread spread;
    spread.title = entry.Text("title", "");
    spread.of = entry.Texts("of");
    spread.by = entry.Texts("by");
    spread.within_factor = entry.Number("within_factor", {.min = 1, .max = 1e6}, 0.0);
    if (spread.of.empty()) entry.Fail("of", "is missing or empty", "columns of sweep.csv");
    spreads.push_back(std::move(spread));
  }
  return spreads;
}

StudyPart ReadPart(const std::string& file, YamlMap* map) {
  StudyPart part;
  part.name = map->Text("name");
  part.text = map->Text("text", "");
  const bool own =
      std::find(std::begin(kOwnFiles), std::end(kOwnFiles), part.name) != std::end(kOwnFiles);
  if (!part.name.empty() && (!IsFileName(part.name) || own)) {
    map->Fail("name", Quoted(part.name) + " is no name of a folder", kFileNames);
  }
  const std::string sweep = map->Text("sweep", "");
  part.words = map->Texts("run");
  for (std::string& word : part.words) word = BesideFile(file, word);
  part.is_sweep = !sweep.empty();
  if (part.is_sweep == !part.words.empty()) {
    map->Fail("sweep", "a part is a sweep or a verb", "one of sweep: FILE and run: [VERB, …]");
  }
  if (part.is_sweep) part.words = {"sweep", BesideFile(file, sweep)};
  part.may_fail = map->Bool("may_fail", false);
  part.plots = ReadPlots(map);
  part.spreads = ReadSpreads(map);
  if (!part.is_sweep && (!part.plots.empty() || !part.spreads.empty())) {
    map->Fail("run", "has no table to plot", "plots and spreads of a sweep");
  }
  return part;
}

Status ReadParts(YamlMap* map, DesignStudy* study) {
  study->question = map->Text("question");
  std::set<std::string> names;
  for (YamlMap& entry : map->Maps("parts")) {
    study->parts.push_back(ReadPart(study->path, &entry));
    if (!names.insert(study->parts.back().name).second) {
      entry.Fail("name", Quoted(study->parts.back().name) + " is there twice", "each name once");
    }
  }
  if (study->parts.empty()) map->Fail("parts", "is missing or empty", "a list of parts");
  return map->Finish();
}

Result<std::string> FindStudy(const std::string& name) {
  auto own = FindData("study", "models/studies", name, {".yaml"});
  if (own.ok()) return own;
  auto sweep = FindData("sweep", "models/sweeps", name, {".yaml"});
  if (sweep.ok()) return sweep;
  std::vector<std::string> known = ListData("models/studies", {".yaml"});
  for (const std::string& one : ListData("models/sweeps", {".yaml"})) known.push_back(one);
  return Error{name, "is no study", JoinWords(known), DidYouMean(name, known)};
}

/// A sweep alone; `phs sweep` reads what stands in it.
DesignStudy OfSweep(DesignStudy study) {
  StudyPart part;
  part.name = study.name;
  part.words = {"sweep", study.path};
  part.is_sweep = true;
  study.parts.push_back(std::move(part));
  return study;
}

/// What a file has before anything of it is understood.
Result<DesignStudy> Begin(const std::string& path) {
  DesignStudy study;
  study.path = path;
  study.name = fs::path(path).stem().string();
  const auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  study.text = text.value();
  return study;
}

}  // namespace

Result<DesignStudy> ReadDesignStudy(const std::string& path) {
  auto study = Begin(path);
  if (!study.ok()) return study.error();
  auto document = YamlMap::Load(path);
  if (!document.ok()) return document.error();
  if (Status s = ReadParts(&document.value(), &study.value()); !s.ok()) return s.error();
  return study;
}

Result<DesignStudy> LoadDesignStudy(const std::string& name) {
  const auto path = FindStudy(name);
  if (!path.ok()) return path.error();
  auto document = YamlMap::Load(path.value());
  if (!document.ok()) return document.error();
  const bool sweep = std::any_of(sweep::Subjects().begin(), sweep::Subjects().end(),
                                 [&](const auto& of) { return document.value().Has(of.key); });
  if (!sweep) return ReadDesignStudy(path.value());
  auto study = Begin(path.value());
  if (!study.ok()) return study.error();
  return OfSweep(std::move(study).value());
}

}  // namespace phs::jobs
