#include "cli/sweep_search.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/origin.h"
#include "jobs/sweep_job.h"
#include "report/optimisation_report.h"
#include "sweep/optimiser.h"

namespace phs::cli {
namespace {

using sweep::Candidate;
using sweep::SearchResult;
using sweep::Study;

void PrintDesign(const Study& study, const SearchResult& result, int number) {
  const auto& constraints = study.optimisation->constraints;
  if (number < 0) {
    fmt::print("  no candidate was calculated to the end\n");
    return;
  }
  const Candidate& c = result.candidates[static_cast<std::size_t>(number)];
  fmt::print("  objective {:.6g}{}\n", c.objective, c.Kept() ? "" : ", constraints missed");
  for (std::size_t i = study.optimisation->choices.size(); i < c.values.size(); ++i) {
    fmt::print("  {} = {}\n", study.axes[i].key, c.values[i]);
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const bool kept = constraints[i].Violation(c.constrained[i]) <= 1e-6;
    fmt::print("  {}: {:.5g}{}\n", constraints[i].name, c.constrained[i],
               kept ? "" : "   <- missed");
  }
}

void Print(const Study& study, const SearchResult& result, const std::string& path) {
  const auto& o = *study.optimisation;
  fmt::print("{}: {} candidates, {} runs\n", study.name, result.candidates.size(),
             study.num_runs());
  for (std::size_t i = 0; i < result.best_of.size(); ++i) {
    const bool best = result.best_of[i] == result.best && result.best >= 0;
    fmt::print("\n{}{}\n", fmt::join(o.Combination(static_cast<int>(i)), ", "),
               best ? " (best)" : "");
    PrintDesign(study, result, result.best_of[i]);
  }
  fmt::print("\nTables: {0}/candidates.csv, {0}/sweep.csv, report: {0}/report.html\n", path);
  if (result.best >= 0) {
    fmt::print("The best design as files: {}/best/{}/\n", path, study.cases[0].name);
  }
}

}  // namespace

int FindBestDesign(Study study, int workers, const std::string& out, bool resume,
                   const CommonOptions& common) {
  auto work = sweep::WorkDir::Open(out, study, resume, common.force);
  if (!work.ok()) return BadInput(work.error());
  const auto found = [&] {
    ProgressLine progress(study.name, common.quiet);
    return sweep::SearchOptimum(
        &study, jobs::NumWorkers(workers), &work.value(),
        [&](int done, int of) { return progress(static_cast<double>(done) / of); });
  }();
  if (!found.ok()) return BadInput(found.error());
  if (!found.value().all) {
    return Stopped(
        fmt::format("{} candidates are done; --resume continues", found.value().candidates.size()));
  }
  const auto records = sweep::ReadRecords(study, work.value());
  auto opened = work.value().OpenResult();
  if (!opened.ok()) return BadInput(opened.error());
  ResultDir& dir = opened.value();
  for (const Status& s :
       {sweep::WriteTables(study, records, work.value(), dir),
        sweep::WriteOptimum(study, found.value(), dir), WriteOrigin(dir.File(""))}) {
    if (!s.ok()) return BadInput(s.error());
  }
  if (Status s = report::WriteOptimisationReport(dir.File(""), dir.File("report.html")); !s.ok()) {
    return BadInput(s.error());
  }
  if (Status s = work.value().Finish(&dir); !s.ok()) return BadInput(s.error());
  const SearchResult& result = found.value();
  if (common.format == "json") {
    const nlohmann::ordered_json json = {{"candidates", result.candidates.size()},
                                         {"best", result.best},
                                         {"optimum", work.value().final_path() + "/optimum.json"}};
    fmt::print("{}\n", json.dump());
  } else {
    Print(study, result, work.value().final_path());
  }
  const bool kept =
      result.best >= 0 && result.candidates[static_cast<std::size_t>(result.best)].Kept();
  return kept ? kDone : kFailed;
}

}  // namespace phs::cli
