#include "jobs/sweep_job.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "base/origin.h"
#include "base/table.h"
#include "report/sweep_report.h"
#include "sweep/output_check.h"
#include "sweep/outputs.h"
#include "sweep/sensitivity.h"

namespace phs::jobs {
namespace {

using sweep::RunRecord;
using sweep::Study;

/// Sobol indices of one output, where the design gives them.
void AddIndices(const Study& study, const std::vector<RunRecord>& records, std::size_t output,
                report::SweepReportInput* input) {
  if (study.design != sweep::DesignKind::kSobolIndices) return;
  std::vector<double> values;
  values.reserve(records.size());
  for (const RunRecord& r : records) {
    values.push_back(r.status == "ok" ? r.outputs[output] : std::nan(""));
  }
  const auto indices = sweep::SobolIndices(values, static_cast<int>(study.axes.size()));
  if (indices.empty() || input->parameters.size() != study.axes.size()) return;
  report::OutputIndices of{sweep::OutputColumns(study.outputs)[output], {}, {}, {}, {}};
  for (const sweep::SobolIndex& index : indices) {
    of.first.push_back(index.first);
    of.total.push_back(index.total);
    of.first_error.push_back(index.first_error);
    of.total_error.push_back(index.total_error);
  }
  input->indices.push_back(std::move(of));
}

report::SweepReportInput ReportInput(const Study& study, const std::vector<RunRecord>& records,
                                     const std::string& table) {
  report::SweepReportInput input;
  input.table = table;
  input.study = study.path;
  input.sampled =
      study.design != sweep::DesignKind::kGrid && study.design != sweep::DesignKind::kList;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    bool numbers = true, varies = false;
    for (const auto& run : study.runs) {
      numbers &=
          !run[axis].empty() && run[axis].find_first_not_of("+-.eE0123456789") == std::string::npos;
      varies |= run[axis] != study.runs[0][axis];
    }
    if (numbers && varies) input.parameters.push_back(study.axes[axis].column);
  }
  for (std::size_t i = 0; i < study.outputs.size(); ++i) {
    const bool any = std::any_of(records.begin(), records.end(),
                                 [&](const auto& r) { return std::isfinite(r.outputs[i]); });
    if (!any) continue;
    input.outputs.push_back(sweep::OutputColumns(study.outputs)[i]);
    AddIndices(study, records, i, &input);
  }
  return input;
}

}  // namespace

int CountOk(const std::vector<RunRecord>& records) {
  return static_cast<int>(std::count_if(records.begin(), records.end(),
                                        [](const auto& r) { return r.status == "ok"; }));
}

int NumWorkers(int asked) {
  return asked > 0 ? asked : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

Error KeptUnfinished(Error error) {
  error.mend += (error.mend.empty() ? "" : "; ") +
                std::string("what is finished is kept: mend it, then --resume");
  return error;
}

Result<std::vector<RunRecord>> WriteSweep(const Study& study, sweep::WorkDir* work) {
  auto records = sweep::ReadRecords(study, *work);
  auto opened = work->OpenResult();
  if (!opened.ok()) return opened.error();
  ResultDir& dir = opened.value();
  if (Status s = sweep::WriteTables(study, records, *work, dir); !s.ok()) return s.error();
  if (Status s = WriteOrigin(dir.File("")); !s.ok()) return s.error();
  const auto input = ReportInput(study, records, dir.File("sweep.csv"));
  if (CountOk(records) > 0 && !input.outputs.empty() && !input.parameters.empty()) {
    for (const Status& s : {report::KeepSweepReportInput(input),
                            report::WriteSweepReport(input, dir.File("report.html"))}) {
      if (!s.ok()) return s.error();
    }
  }
  if (Status s = work->Finish(&dir); !s.ok()) return s.error();
  return records;
}

Result<Sweep> ReadFinished(const std::string& dir) {
  const auto table = ReadCsv(dir + "/sweep.csv");
  if (!table.ok()) return table.error();
  const int at = table.value().Find("status");
  const auto& states = table.value().text[static_cast<std::size_t>(std::max(at, 0))];
  return Sweep{.all = true,
               .was_finished = true,
               .done = static_cast<int>(states.size()),
               .ok = static_cast<int>(std::count(states.begin(), states.end(), "ok")),
               .records = {}};
}

Result<Sweep> MakeSweep(const Study& study, const SweepRequest& request, const Watch& watch) {
  if (study.optimisation) {
    return Error{study.path, "is a search for the best design", "a study without `optimise:`",
                 "phs sweep searches"};
  }
  if (request.resume && sweep::IsFinished(request.out, study)) return ReadFinished(request.out);
  if (!request.resume) {
    if (Status s = sweep::CheckOutputs(study); !s.ok()) return s.error();
  }
  auto work = sweep::WorkDir::Open(request.out, study, request.resume, request.overwrite);
  if (!work.ok()) return work.error();
  const auto all = sweep::RunLocally(
      study, NumWorkers(request.workers), &work.value(),
      [&](int done, int of) { return watch.GoesOn(static_cast<double>(done) / of); });
  if (!all.ok()) return KeptUnfinished(all.error());
  Sweep made{.all = all.value(),
             .done = study.num_runs() - static_cast<int>(work.value().Missing(study, false).size()),
             .records = {}};
  if (!made.all) return made;
  auto records = WriteSweep(study, &work.value());
  if (!records.ok()) return records.error();
  made.records = std::move(records).value();
  made.ok = CountOk(made.records);
  return made;
}

}  // namespace phs::jobs
