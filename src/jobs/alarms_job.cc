#include "jobs/alarms_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/origin.h"
#include "jobs/alarms_found.h"
#include "rail/track.h"
#include "report/alarms_report.h"
#include "sweep/sampling.h"

namespace phs::jobs {
namespace {

using analysis::Extremes;
using analysis::PairSignal;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSoon_s = 1;        ///< an alarm within is soon enough to look at its margin
constexpr double kShareLearn = 0.3;  ///< of the progress
constexpr double kShareBurst = 0.3;
constexpr double kShareOfRun = 0.98;  ///< the vehicle does not reach the very end of its track

class Search {
 public:
  Search(const AlarmsRequest& request, const Watch& watch) : watch_(watch) { found_.ask = request; }

  Result<Alarms> Make() {
    if (Status s = Prepare(); !s.ok()) return s.error();
    for (const auto step : {&Search::Learn, &Search::Tear, &Search::Test}) {
      auto all = (this->*step)();
      if (!all.ok()) return all.error();
      if (!all.value()) return Alarms{};
    }
    return Alarms{true, AlarmsJson(found_), SignalsCsv(found_)};
  }

 private:
  Status Prepare();
  Result<bool> Learn();
  Result<bool> Tear();
  Result<bool> Test();
  void SetThresholds();
  void ChooseSignals();
  Result<std::vector<AlarmTask>> PlainRuns(double km_each, std::uint64_t series);
  Result<AlarmTask> TornRun(size_t service, const std::string& line, int number);
  /// The rows after the run-in.
  AlarmRun Looked(const AlarmRun& run) const;

  AlarmsFound found_;
  const Watch& watch_;
  DrawnTracks tracks_;
  std::vector<double> track_m_;  ///< [service] length
};

Status Search::Prepare() {
  if (found_.ask.services.empty()) return Error{"phs alarms", "has no scenario", "one or more", ""};
  double whole_m = kNever;
  for (const vehicle::Scenario& service : found_.ask.services) {
    const auto path = tracks_.Draw(service.track, found_.ask.seed);
    if (!path.ok()) return path.error();
    const auto track = rail::Track::Load(path.value(), false, {}, service.speed_m_s);
    if (!track.ok()) return track.error();
    track_m_.push_back(track.value().length());
    const double seconds = track_m_.back() / service.speed_m_s;
    const double looked_m =
        kShareOfRun * (track_m_.back() - found_.ask.run_in_s * service.speed_m_s);
    whole_m = std::min(whole_m, looked_m);
    if (seconds < found_.ask.run_in_s + found_.ask.after_s + 5) {
      return Error{service.name + ": track " + service.track, "is too short to look at a run",
                   fmt::format("{:.0f} m or more at this speed",
                               service.speed_m_s * (found_.ask.run_in_s + found_.ask.after_s + 5)),
                   ""};
    }
  }
  found_.block_m = found_.ask.block_m > 0 ? found_.ask.block_m : whole_m;
  return {};
}

/// Runs without failure over `km_each` in each service; `series` tells their tracks from others.
Result<std::vector<AlarmTask>> Search::PlainRuns(double km_each, std::uint64_t series) {
  std::vector<AlarmTask> tasks;
  for (size_t k = 0; k < found_.ask.services.size(); ++k) {
    const vehicle::Scenario& service = found_.ask.services[k];
    const double each_m = track_m_[k] - found_.ask.run_in_s * service.speed_m_s;
    const int runs = std::max(1, static_cast<int>(std::ceil(1e3 * km_each / each_m)));
    for (int i = 0; i < runs; ++i) {
      const std::uint64_t own = series * 1'000'000 + k * 100'000 + static_cast<std::uint64_t>(i);
      const auto track = tracks_.Draw(service.track, sweep::RunSeed(found_.ask.seed, own));
      if (!track.ok()) return track.error();
      tasks.push_back({k, service});
      tasks.back().scenario.track = track.value();
    }
  }
  return tasks;
}

AlarmRun Search::Looked(const AlarmRun& run) const {
  AlarmRun out = run;
  const auto first = std::lower_bound(run.time_s.begin(), run.time_s.end(), found_.ask.run_in_s);
  const auto skip = first - run.time_s.begin();
  const auto cut = [skip](std::vector<double>* column) {
    column->erase(column->begin(), column->begin() + skip);
  };
  cut(&out.time_s), cut(&out.place_m);
  for (auto& p : out.pressure_Pa) cut(&p);
  return out;
}

Status CheckPlain(const AlarmTask& task, const AlarmRun& run) {
  if (run.status == "ok") return {};
  return Error{task.scenario.name, "ended " + run.status + " without any failure", "ok",
               "a slower or smoother service"};
}

Result<bool> Search::Learn() {
  const auto tasks = PlainRuns(found_.ask.learn_km, 1);
  if (!tasks.ok()) return tasks.error();
  std::vector<std::vector<std::vector<double>>> of_task(tasks.value().size());
  std::vector<std::vector<std::string>> lines(tasks.value().size());
  auto all = DoAll(
      static_cast<int>(tasks.value().size()), found_.ask.workers, 0, kShareLearn, watch_,
      [&](int i) {
        const AlarmTask& task = tasks.value()[static_cast<size_t>(i)];
        const auto made = MakeAlarmRun(task.scenario, false, watch_);
        if (!made.ok()) return Status(made.error());
        if (Status s = CheckPlain(task, made.value()); !s.ok()) return s;
        const AlarmRun run = Looked(made.value());
        lines[static_cast<size_t>(i)] = run.lines;
        for (const PairSignal& s : analysis::PairSignals(static_cast<int>(run.lines.size()))) {
          of_task[static_cast<size_t>(i)].push_back(analysis::BlockMaxima(
              run.place_m,
              analysis::CalcSignal(s, run.pressure_Pa, run.interval_s, found_.ask.times),
              found_.block_m));
        }
        return Status();
      });
  if (!all.ok() || !all.value()) return all;
  found_.lines = lines[0];
  for (const auto& other : lines) {
    if (other != found_.lines)
      return Error{"phs alarms", "the services have different lines", "", ""};
  }
  found_.signals = analysis::PairSignals(static_cast<int>(found_.lines.size()));
  found_.maxima.assign(found_.ask.services.size(),
                       std::vector<std::vector<double>>(found_.signals.size()));
  for (size_t i = 0; i < of_task.size(); ++i) {
    for (size_t s = 0; s < found_.signals.size(); ++s) {
      auto& into = found_.maxima[tasks.value()[i].service][s];
      into.insert(into.end(), of_task[i][s].begin(), of_task[i][s].end());
    }
  }
  if (found_.maxima[0][0].size() < 3) {
    return Error{"--learn-km", "gives fewer than three blocks to learn from",
                 fmt::format("blocks of {:.0f} m, three or more in all", found_.block_m), ""};
  }
  SetThresholds();
  return true;
}

void Search::SetThresholds() {
  const double blocks = 1e6 / found_.block_m;  // in 1000 km
  found_.block_share =
      found_.ask.wanted_per_1000_km / static_cast<double>(found_.lines.size()) / blocks;
  found_.thresholds.assign(found_.signals.size(), -kNever);
  for (const auto& service : found_.maxima) {
    found_.laws.emplace_back();
    for (size_t s = 0; s < found_.signals.size(); ++s) {
      const Extremes law = analysis::FitExtremes(service[s]);
      found_.laws.back().push_back(law);
      const double level = law.UpperLevel(found_.block_share);
      found_.thresholds[s] = std::max(found_.thresholds[s], level);
    }
  }
}

/// A run up to `after_s` behind the burst, which lies in the middle of its share of the track.
Result<AlarmTask> Search::TornRun(size_t service, const std::string& line, int number) {
  AlarmTask task{service, found_.ask.services[service], line, 0};
  const double usable =
      track_m_[service] / task.scenario.speed_m_s - found_.ask.run_in_s - found_.ask.after_s - 1;
  task.at_s = found_.ask.run_in_s + usable * (number + 0.5) / found_.ask.bursts;
  const std::uint64_t own = 2'000'000 + service * 100'000 + static_cast<std::uint64_t>(number);
  const auto track = tracks_.Draw(task.scenario.track, sweep::RunSeed(found_.ask.seed, own));
  if (!track.ok()) return track.error();
  task.scenario.track = track.value();
  task.scenario.duration_s = task.at_s + found_.ask.after_s;
  phs_model::Failure burst;
  burst.kind = "line_burst";
  burst.line = line;
  burst.at_s = task.at_s;
  task.scenario.phs_changes.failures.push_back(burst);
  return task;
}

Result<bool> Search::Tear() {
  for (size_t k = 0; k < found_.ask.services.size(); ++k) {
    for (const std::string& line : found_.lines) {
      for (int n = 0; n < found_.ask.bursts; ++n) {
        auto task = TornRun(k, line, n);
        if (!task.ok()) return task.error();
        found_.bursts.push_back({std::move(task).value(), {}, {}, {}});
      }
    }
  }
  auto all = DoAll(
      static_cast<int>(found_.bursts.size()), found_.ask.workers, kShareLearn,
      kShareLearn + kShareBurst, watch_, [&](int i) {
        Burst& burst = found_.bursts[static_cast<size_t>(i)];
        auto made = MakeAlarmRun(burst.task.scenario, true, watch_);
        if (!made.ok()) return Status(made.error());
        burst.run = std::move(made).value();
        const std::vector<double>& t = burst.run.time_s;
        const size_t from =
            static_cast<size_t>(std::lower_bound(t.begin(), t.end(), burst.task.at_s) - t.begin());
        for (size_t s = 0; s < found_.signals.size(); ++s) {
          const auto x = analysis::CalcSignal(found_.signals[s], burst.run.pressure_Pa,
                                              burst.run.interval_s, found_.ask.times);
          size_t row = from;
          while (row < x.size() && !(x[row] > found_.thresholds[s])) ++row;
          burst.seconds.push_back(row < x.size() ? t[row] - burst.task.at_s : kNever);
          const auto since = std::lower_bound(t.begin(), t.end(), burst.task.at_s + kSoon_s);
          const auto settled = std::min_element(x.begin() + (since - t.begin()), x.end());
          burst.settled.push_back(settled == x.end() ? -kNever : *settled);
        }
        return Status();
      });
  if (all.ok() && all.value()) ChooseSignals();
  return all;
}

void Search::ChooseSignals() {
  for (const std::string& line : found_.lines) {
    size_t best = 0;
    double least = kNever, widest = -kNever;
    for (size_t s = 0; s < found_.signals.size(); ++s) {
      double mean = 0;
      const double slowest = std::max(kSoon_s, found_.Slowest(line, s, &mean));
      const double margin = found_.Margin(line, s);
      if (slowest > least || (slowest == least && margin <= widest)) continue;
      best = s, least = slowest, widest = margin;
    }
    found_.chosen.push_back(best);
  }
}

Result<bool> Search::Test() {
  const auto tasks =
      PlainRuns(found_.ask.test_km / static_cast<double>(found_.ask.services.size()), 3);
  if (!tasks.ok()) return tasks.error();
  std::vector<double> km(tasks.value().size());
  std::vector<std::vector<int>> counts(tasks.value().size());
  auto all = DoAll(static_cast<int>(tasks.value().size()), found_.ask.workers,
                   kShareLearn + kShareBurst, 1, watch_, [&](int i) {
                     const AlarmTask& task = tasks.value()[static_cast<size_t>(i)];
                     const auto made = MakeAlarmRun(task.scenario, false, watch_);
                     if (!made.ok()) return Status(made.error());
                     if (Status s = CheckPlain(task, made.value()); !s.ok()) return s;
                     const AlarmRun run = Looked(made.value());
                     km[static_cast<size_t>(i)] = 1e-3 * (run.place_m.back() - run.place_m.front());
                     for (const size_t s : found_.chosen) {
                       counts[static_cast<size_t>(i)].push_back(analysis::CountAlarms(
                           analysis::CalcSignal(found_.signals[s], run.pressure_Pa, run.interval_s,
                                                found_.ask.times),
                           found_.thresholds[s], run.interval_s, found_.ask.hold_s));
                     }
                     return Status();
                   });
  if (!all.ok() || !all.value()) return all;
  found_.tested_km.assign(found_.ask.services.size(), 0);
  found_.false_count.assign(found_.ask.services.size(), std::vector<int>(found_.lines.size(), 0));
  for (size_t i = 0; i < km.size(); ++i) {
    const size_t k = tasks.value()[i].service;
    found_.tested_km[k] += km[i];
    for (size_t hose = 0; hose < found_.lines.size(); ++hose)
      found_.false_count[k][hose] += counts[i][hose];
  }
  return true;
}

}  // namespace

Result<Alarms> FindAlarms(const AlarmsRequest& request, const Watch& watch) {
  return Search(request, watch).Make();
}

Status WriteAlarms(const Alarms& alarms, ResultDir* dir) {
  const std::string main = dir->File("alarms.json");
  if (Status s = WriteFileAtomically(main, alarms.json.dump(2) + "\n"); !s.ok()) return s;
  if (Status s = WriteFileAtomically(dir->File("signals.csv"), alarms.signals_csv); !s.ok()) {
    return s;
  }
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  return report::WriteAlarmsReport(main, dir->File("report.html"));
}

}  // namespace phs::jobs
