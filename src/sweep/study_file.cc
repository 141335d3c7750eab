#include "sweep/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "base/words.h"
#include "sweep/axis_key.h"
#include "sweep/case_files.h"
#include "sweep/outputs.h"
#include "sweep/subjects.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;

bool IsSampled(DesignKind design) {
  return design != DesignKind::kGrid && design != DesignKind::kList;
}

DesignKind ReadDesign(YamlMap* map) {
  const std::string word =
      map->Word("design", {"grid", "list", "latin_hypercube", "sobol", "sobol_indices"}, "grid");
  if (word == "list") return DesignKind::kList;
  if (word == "latin_hypercube") return DesignKind::kLatinHypercube;
  if (word == "sobol") return DesignKind::kSobol;
  return word == "sobol_indices" ? DesignKind::kSobolIndices : DesignKind::kGrid;
}

void ReadGridValues(YamlMap* map, Axis* axis) {
  if (map->Has("values")) {
    axis->values = map->Texts("values");
    if (axis->values.empty()) map->Fail("values", "is empty", "at least one value");
    return;
  }
  const double from = map->Number("from", {}), to = map->Number("to", {});
  const int count = map->Integer("count", 2, kMostRuns);
  for (int i = 0; i < count; ++i) {
    // Both ends exactly, and the same numbers from either side.
    axis->values.push_back(Shortest(i == count - 1 ? to : from + (to - from) * i / (count - 1)));
  }
}

void ReadAxes(YamlMap* map, Study* study) {
  std::set<std::string> keys;
  for (YamlMap& entry : map->Maps("axes")) {
    Axis axis;
    axis.key = entry.Text("key");
    if (Status s = CheckAxisKey(*study->cases.front().subject, axis.key); !s.ok()) {
      entry.Fail("key", s.error().what, s.error().allowed, s.error().mend);
    }
    if (!keys.insert(axis.key).second) {
      entry.Fail("key", fmt::format("'{}' is varied twice", axis.key), "each key once",
                 "remove one of the two axes");
    }
    if (IsSampled(study->design)) {
      axis.distribution = ReadDistribution(&entry);
    } else {
      ReadGridValues(&entry, &axis);
    }
    study->axes.push_back(std::move(axis));
  }
  if (study->axes.empty()) map->Fail("axes", "is missing or empty", "a list of axes");
}

/// Last part of the key; the whole key with underscores where two axes would share it.
void NameColumns(std::vector<Axis>* axes) {
  for (Axis& axis : *axes) axis.column = axis.key.substr(axis.key.rfind('.') + 1);
  for (std::size_t i = 0; i < axes->size(); ++i) {
    bool shared = false;
    for (std::size_t j = 0; j < axes->size(); ++j) {
      if (i == j) continue;
      const std::string& other = (*axes)[j].key;
      shared |= other.substr(other.rfind('.') + 1) ==
                (*axes)[i].key.substr((*axes)[i].key.rfind('.') + 1);
    }
    if (!shared) continue;
    std::string name = (*axes)[i].key;
    for (char& c : name) {
      if (c == '.') c = '_';
      if (c == '*') c = 'a';
    }
    (*axes)[i].column = name;
  }
}

Axis AxisOf(const std::string& key) { return {key, {}, {}, {}}; }

Status LayOutGrid(Study* study) {
  double count = 1;
  for (const Axis& axis : study->axes) count *= static_cast<double>(axis.values.size());
  if (count > kMostRuns) {
    return Error{study->path, fmt::format("lays out {:.0f} runs", count),
                 fmt::format("at most {}", kMostRuns), "fewer values, or a sampled design"};
  }
  study->runs = {{}};
  for (const Axis& axis : study->axes) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& run : study->runs) {
      for (const std::string& value : axis.values) {
        longer.push_back(run);
        longer.back().push_back(value);
      }
    }
    study->runs = std::move(longer);
  }
  return {};
}

Status LayOutList(YamlMap* map, Study* study) {
  const fs::path file = fs::path(study->path).parent_path() / map->Text("cases");
  if (map->Has("axes")) map->Fail("axes", "has no place beside a list", "columns of `cases`");
  if (Status s = map->Finish(); !s.ok()) return s;
  const auto table = ReadCsv(file.string());
  if (!table.ok()) return table.error();
  for (const std::string& name : table.value().names) {
    if (Status s = CheckAxisKey(*study->cases.front().subject, name); !s.ok()) {
      return Error{file.string() + ":1: " + name, s.error().what, s.error().allowed,
                   s.error().mend};
    }
    study->axes.push_back(AxisOf(name));
  }
  if (table.value().num_rows() == 0) return Error{file.string(), "lists no run", "rows", ""};
  for (int row = 0; row < table.value().num_rows(); ++row) {
    std::vector<std::string> run;
    for (const auto& column : table.value().text)
      run.push_back(column[static_cast<std::size_t>(row)]);
    study->runs.push_back(std::move(run));
  }
  return {};
}

std::vector<std::string> Values(const std::vector<Axis>& axes, const std::vector<double>& u,
                                std::size_t offset) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    values.push_back(Shortest(axes[i].distribution.Quantile(u[offset + i])));
  }
  return values;
}

/// Rows of Saltelli's scheme for each base point: A, B, then A with one axis from B, axis by axis.
void AddIndexRows(const std::vector<double>& u, Study* study) {
  const std::size_t d = study->axes.size();
  study->runs.push_back(Values(study->axes, u, 0));
  study->runs.push_back(Values(study->axes, u, d));
  for (std::size_t axis = 0; axis < d; ++axis) {
    std::vector<double> mixed(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(d));
    mixed[axis] = u[d + axis];
    study->runs.push_back(Values(study->axes, mixed, 0));
  }
}

Status LayOutSamples(YamlMap* map, Study* study) {
  const int dimensions = static_cast<int>(study->axes.size());
  const bool indices = study->design == DesignKind::kSobolIndices;
  const int needed = indices ? 2 * dimensions : dimensions;
  if (study->design != DesignKind::kLatinHypercube && needed > kMostSobolDimensions) {
    return Error{map->Where("axes"), fmt::format("are {} for Sobol's sequence", dimensions),
                 fmt::format("at most {}", kMostSobolDimensions / (indices ? 2 : 1)),
                 "design: latin_hypercube"};
  }
  const auto points = study->design == DesignKind::kLatinHypercube
                          ? LatinHypercube(study->samples, needed, study->seed)
                          : SobolPoints(study->samples, needed, study->seed);
  for (const auto& u : points) {
    if (indices) {
      AddIndexRows(u, study);
    } else {
      study->runs.push_back(Values(study->axes, u, 0));
    }
  }
  return {};
}

Status LayOut(YamlMap* map, Study* study) {
  if (study->design == DesignKind::kList) return LayOutList(map, study);
  if (Status s = map->Finish(); !s.ok()) return s;
  return study->design == DesignKind::kGrid ? LayOutGrid(study) : LayOutSamples(map, study);
}

/// The base of a case: a path beside the study file, or a name.
Result<std::string> FindBase(const Study& study, const StudyCase& of) {
  const fs::path beside = fs::path(study.path).parent_path() / of.base;
  std::error_code ignored;
  if (fs::is_regular_file(beside, ignored)) return beside.string();
  return of.subject->find(of.base);
}

/// The axes of a search, and its first candidate as runs, to be checked.
void LayOutSearch(Study* study) {
  const Optimisation& o = *study->optimisation;
  std::vector<std::string> values = o.Combination(0);
  for (const DesignChoice& choice : o.choices) study->axes.push_back(AxisOf(choice.key));
  for (const DesignParameter& p : o.parameters) {
    study->axes.push_back(AxisOf(p.key));
    values.push_back(Shortest(p.start));
  }
  study->axes.push_back(AxisOf("case"));
  for (std::size_t k = 0; k < study->cases.size(); ++k) {
    study->runs.push_back(values);
    study->runs.back().push_back(study->cases[k].name);
    study->case_of_run.push_back(static_cast<int>(k));
    for (const std::string& output : study->cases[k].outputs) {
      if (std::find(study->outputs.begin(), study->outputs.end(), output) == study->outputs.end()) {
        study->outputs.push_back(output);
      }
    }
  }
}

Status FindBases(YamlMap* map, Study* study) {
  for (StudyCase& c : study->cases) {
    const auto base = FindBase(*study, c);
    if (!base.ok()) {
      const std::string where =
          c.name.empty() ? map->Where(c.subject->key) : map->Where("optimise") + ".cases." + c.name;
      return Error{where, Quoted(c.base) + " " + base.error().what, base.error().allowed,
                   base.error().mend};
    }
    c.base = base.value();
  }
  return {};
}

Status ReadSearch(YamlMap* map, Study* study) {
  for (const char* key : {"axes", "design", "samples", "outputs", "analysis", "rig"}) {
    if (map->Has(key)) map->Fail(key, "has no place beside `optimise`", "", "remove it");
  }
  const Subject& searched = Subjects().front();
  OptimisationBlock block =
      ReadOptimisation(searched, map->Map("optimise"), map->Text(searched.key, ""));
  study->optimisation = std::move(block.optimisation);
  study->cases = std::move(block.cases);
  if (Status s = map->Finish(); !s.ok()) return s;
  LayOutSearch(study);
  return {};
}

Status ReadPlain(YamlMap* map, Study* study) {
  StudyCase only;
  only.subject = ReadSubject(map);
  only.base = map->Text(only.subject->key);
  only.analysis = ReadAnalysis(map, only.subject->key);
  study->cases = {only};
  study->design = ReadDesign(map);
  if (IsSampled(study->design)) study->samples = map->Integer("samples", 1, kMostRuns);
  study->outputs = map->Texts("outputs");
  if (study->outputs.empty()) study->outputs = only.analysis->outputs;
  if (study->design != DesignKind::kList) ReadAxes(map, study);
  return LayOut(map, study);
}

}  // namespace

Result<Study> LoadStudy(const std::string& name) {
  const auto path = FindData("sweep", "models/sweeps", name, {".yaml"});
  if (!path.ok()) return path.error();
  Study study;
  study.path = path.value();
  study.name = fs::path(study.path).stem().string();
  const auto text = ReadFile(study.path);
  if (!text.ok()) return text.error();
  study.text = text.value();
  auto document = YamlMap::Parse(study.text, study.path);
  if (!document.ok()) return document.error();
  YamlMap& map = document.value();
  study.seed = static_cast<std::uint64_t>(map.Integer("seed", 0, 2147483647, 1));
  study.vary_irregularity = map.Bool("vary_irregularity", false);
  study.time_limit_s =
      map.Number("time_limit_s", {.min = 0, .max = 1e6, .open_min = true}, study.time_limit_s);
  if (map.Has("slurm")) study.slurm = ReadSlurmOptions(map.Map("slurm"));
  const Status read = map.Has("optimise") ? ReadSearch(&map, &study) : ReadPlain(&map, &study);
  if (!read.ok()) return read.error();
  NameColumns(&study.axes);
  if (Status s = FindBases(&map, &study); !s.ok()) return s.error();
  if (Status s = CheckCases(study); !s.ok()) return s.error();
  return study;
}

}  // namespace phs::sweep
