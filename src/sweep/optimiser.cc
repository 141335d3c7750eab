#include "sweep/optimiser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <nlopt.hpp>
#include <numeric>
#include <optional>

#include "base/numbers.h"
#include "base/result_dir.h"

namespace phs::sweep {
namespace {

constexpr double kKept = 1e-6;  ///< violation that rounding of the values may leave

std::string SixDigits(double value) { return fmt::format("{:.6g}", value); }

/// The lines that earlier walks of the search left: candidates in their order.
std::vector<std::string> ReadLines(const std::string& path) {
  std::vector<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

class Search {
 public:
  Search(Study* study, int workers, WorkDir* work, const Progress& progress)
      : study_(*study),
        plan_(*study->optimisation),
        workers_(workers),
        work_(work),
        progress_(progress),
        walked_(ReadLines(work->File("candidates.txt"))),
        most_runs_(plan_.NumCombinations() * (plan_.parameters.empty() ? 1 : plan_.evaluations) *
                   NumCases()) {}

  Result<SearchResult> Execute() {
    study_.runs.clear();
    study_.case_of_run.clear();
    for (int i = 0; i < plan_.NumCombinations() && !stopped_ && !fault_; ++i) SearchCombination(i);
    if (fault_) return *fault_;
    result_.all = !stopped_;
    for (int i = 0; i < plan_.NumCombinations(); ++i) result_.best_of.push_back(BestOf(i));
    for (int best : result_.best_of) {
      if (best >= 0 && (result_.best < 0 || Better(best, result_.best))) result_.best = best;
    }
    return result_;
  }

 private:
  int NumCases() const { return static_cast<int>(study_.cases.size()); }

  void SearchCombination(int number) {
    combination_ = number;
    if (plan_.parameters.empty()) {
      try {
        (void)Evaluate({});
      } catch (const nlopt::forced_stop&) {  // stopped_ or fault_ says why
      }
      return;
    }
    const auto size = static_cast<unsigned>(plan_.parameters.size());
    nlopt::opt search(Algorithm(), size);
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    search.set_initial_step(0.25);
    search.set_xtol_abs(plan_.tolerance);
    search.set_maxeval(plan_.evaluations);
    search.set_min_objective(&Search::Objective, this);
    std::vector<ConstraintCall> calls;
    calls.reserve(plan_.constraints.size());
    for (std::size_t i = 0; i < plan_.constraints.size(); ++i) {
      calls.push_back({this, i});
      search.add_inequality_constraint(&Search::Constraint, &calls.back(), 0);
    }
    // Each combination has the same random numbers: it does not depend on those before it.
    nlopt::srand(static_cast<unsigned long>(study_.seed));
    std::vector<double> u(size);
    for (std::size_t i = 0; i < size; ++i) {
      u[i] = plan_.parameters[i].ShareOf(plan_.parameters[i].start);
    }
    double least = 0;
    try {
      search.optimize(u, least);
    } catch (const nlopt::roundoff_limited&) {  // as near as the rounded values allow
    } catch (const nlopt::forced_stop&) {       // stopped_ or fault_ says why
    } catch (const std::exception& e) {
      fault_ = Error{"NLopt", e.what(), "", "another method"};
    }
  }

  nlopt::algorithm Algorithm() const {
    switch (plan_.method) {
      case Optimisation::Method::kDirect:
        return nlopt::GN_ORIG_DIRECT_L;
      case Optimisation::Method::kIsres:
        return nlopt::GN_ISRES;
      case Optimisation::Method::kCobyla:
        break;
    }
    return nlopt::LN_COBYLA;
  }

  struct ConstraintCall {
    Search* search;
    std::size_t number;
  };

  static double Objective(const std::vector<double>& u, std::vector<double>&, void* self) {
    auto* search = static_cast<Search*>(self);
    const Candidate& c = search->Evaluate(u);
    return c.broken ? 10 * search->largest_objective_ : c.objective;
  }

  static double Constraint(const std::vector<double>& u, std::vector<double>&, void* self) {
    auto* call = static_cast<ConstraintCall*>(self);
    const Candidate& c = call->search->Evaluate(u);
    return call->search->plan_.constraints[call->number].Violation(c.constrained[call->number]);
  }

  std::vector<std::string> ValuesAt(const std::vector<double>& u) const {
    std::vector<std::string> values = plan_.Combination(combination_);
    for (std::size_t i = 0; i < u.size(); ++i) {
      values.push_back(SixDigits(plan_.parameters[i].AtShare(std::clamp(u[i], 0.0, 1.0))));
    }
    return values;
  }

  /// The candidate at `u`, made if it is new. Throws forced_stop when the search has to end.
  const Candidate& Evaluate(const std::vector<double>& u) {
    const std::vector<std::string> values = ValuesAt(u);
    const std::string line = fmt::format("{}", fmt::join(values, ","));
    if (const auto known = known_.find(line); known != known_.end()) {
      return result_.candidates[known->second];
    }
    const std::size_t number = result_.candidates.size();
    if (Status s = Note(number, line); !s.ok()) End(s.error());
    const int first = study_.num_runs();
    for (int k = 0; k < NumCases(); ++k) {
      study_.runs.push_back(values);
      study_.runs.back().push_back(study_.cases[static_cast<std::size_t>(k)].name);
      study_.case_of_run.push_back(k);
    }
    MakeMissing(first);
    known_[line] = number;
    result_.candidates.push_back(Judge(first, values));
    return result_.candidates.back();
  }

  /// Keeps the candidate's values, or holds them against those of the walk before.
  Status Note(std::size_t number, const std::string& line) {
    if (number < walked_.size()) {
      if (walked_[number] == line) return {};
      return Error{work_->path(), "the search takes another way than before it was stopped",
                   "the program and libraries it was begun with", "--force starts anew"};
    }
    walked_.push_back(line);
    return WriteFileAtomically(work_->File("candidates.txt"),
                               fmt::format("{}\n", fmt::join(walked_, "\n")));
  }

  void MakeMissing(int first) {
    std::vector<int> missing;
    for (int run = first; run < study_.num_runs(); ++run) {
      const auto record = ReadRecord(study_, work_->path(), run);
      if (!record || record->status == "killed") missing.push_back(run);
    }
    const int before = study_.num_runs() - static_cast<int>(missing.size());
    const auto all =
        MakeRuns(study_, missing, workers_, work_->File("scratch"), work_,
                 [&](int done, int) { return progress_(std::max(done, before), most_runs_); });
    if (!all.ok()) End(all.error());
    if (!all.value() || !progress_(study_.num_runs(), most_runs_)) {
      stopped_ = true;
      throw nlopt::forced_stop();
    }
  }

  [[noreturn]] void End(const Error& error) {
    fault_ = error;
    throw nlopt::forced_stop();
  }

  double NumberOf(const CaseNumber& number, const std::vector<RunRecord>& records) const {
    const auto& outputs = study_.outputs;
    const auto at = std::find(outputs.begin(), outputs.end(), number.result) - outputs.begin();
    const double value =
        records[static_cast<std::size_t>(number.of_case)].outputs[static_cast<std::size_t>(at)];
    return number.magnitude ? std::abs(value) : value;
  }

  Candidate Judge(int first, const std::vector<std::string>& values) {
    Candidate c;
    c.values = values;
    c.combination = combination_;
    std::vector<RunRecord> records;
    for (int run = first; run < study_.num_runs(); ++run) {
      records.push_back(*ReadRecord(study_, work_->path(), run));
      c.broken |= records.back().status != "ok";
    }
    for (const ObjectiveTerm& term : plan_.objective) {
      c.objective += term.weight * NumberOf(term.number, records);
    }
    c.broken |= !std::isfinite(c.objective);
    if (c.broken) c.objective = kNoNumber;
    if (!c.broken) largest_objective_ = std::max(largest_objective_, std::abs(c.objective));
    c.violation = -std::numeric_limits<double>::infinity();
    for (const DesignConstraint& constraint : plan_.constraints) {
      c.constrained.push_back(c.broken ? kNoNumber : NumberOf(constraint.number, records));
      c.violation = std::max(c.violation, constraint.Violation(c.constrained.back()));
    }
    return c;
  }

  /// @pre neither is broken
  bool Better(int a, int b) const {
    const Candidate& x = result_.candidates[static_cast<std::size_t>(a)];
    const Candidate& y = result_.candidates[static_cast<std::size_t>(b)];
    if (x.Kept() != y.Kept()) return x.Kept();
    return x.Kept() ? x.objective < y.objective : x.violation < y.violation;
  }

  int BestOf(int combination) const {
    int best = -1;
    for (std::size_t i = 0; i < result_.candidates.size(); ++i) {
      const Candidate& c = result_.candidates[i];
      if (c.combination != combination || c.broken) continue;
      if (best < 0 || Better(static_cast<int>(i), best)) best = static_cast<int>(i);
    }
    return best;
  }

  Study& study_;
  const Optimisation& plan_;
  int workers_;
  WorkDir* work_;
  const Progress& progress_;
  std::vector<std::string> walked_;
  int most_runs_;
  int combination_ = 0;
  bool stopped_ = false;
  std::optional<Error> fault_;
  double largest_objective_ = 1;
  std::map<std::string, std::size_t> known_;
  SearchResult result_;
};

}  // namespace

bool Candidate::Kept() const { return !broken && violation <= kKept; }

Result<SearchResult> SearchOptimum(Study* study, int workers, WorkDir* work,
                                   const Progress& progress) {
  return Search(study, workers, work, progress).Execute();
}

}  // namespace phs::sweep
