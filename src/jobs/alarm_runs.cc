#include "jobs/alarm_runs.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <thread>

#include "analysis/running_statistics.h"
#include "base/data_path.h"
#include "base/disk.h"
#include "base/first_thrown.h"
#include "vehicle/simulation.h"

namespace phs::jobs {
namespace {

using Signal = std::vector<double>;

constexpr double kSafetyBand_Hz = 20;  ///< EN 14363
constexpr double kSafetyWindow_m = 2;

const Signal& Column(const vehicle::RunOutcome& run, const std::string& name) {
  return run.columns[static_cast<size_t>(run.Find(name))];
}

/// Mean over the window that ends at each row; at the beginning over what there is.
Signal TrailingMean(const Signal& place, const Signal& signal) {
  Signal out(signal.size());
  double sum = 0;
  for (size_t i = 0, first = 0; i < signal.size(); ++i) {
    sum += signal[i];
    while (place[i] - place[first] > kSafetyWindow_m) sum -= signal[first++];
    out[i] = sum / static_cast<double>(i - first + 1);
  }
  return out;
}

/// The largest magnitude of what is there already and `more`, row by row.
void Raise(const Signal& more, Signal* to) {
  to->resize(more.size(), 0);
  for (size_t i = 0; i < more.size(); ++i) (*to)[i] = std::max((*to)[i], std::abs(more[i]));
}

Status AddSafety(const vehicle::Simulation& simulation, const vehicle::RunOutcome& outcome,
                 AlarmRun* run) {
  const auto filtered = [&](const std::string& name) {
    return analysis::LowPass(Column(outcome, name), run->interval_s, kSafetyBand_Hz);
  };
  for (const plugin::WheelsetBinding& w : simulation.binding().wheelsets()) {
    const auto sum_Y = filtered(w.name + "_sum_Y_N");
    if (!sum_Y.ok()) return sum_Y.error();
    Raise(TrailingMean(run->place_m, sum_Y.value()), &run->sum_Y_N);
    for (const char* side : {"_left", "_right"}) {
      const auto Y = filtered(w.name + side + "_Y_N"), Q = filtered(w.name + side + "_Q_N");
      if (!Y.ok()) return Y.error();
      if (!Q.ok()) return Q.error();
      double mean = 0;
      for (const double q : Q.value()) mean += q / static_cast<double>(Q.value().size());
      Signal ratio = Y.value(), lost = Q.value();
      for (size_t i = 0; i < ratio.size(); ++i) {
        ratio[i] /= std::max(Q.value()[i], 1.0);
        lost[i] = std::max(0.0, 1 - Q.value()[i] / mean);
      }
      Raise(TrailingMean(run->place_m, ratio), &run->Y_over_Q);
      Raise(lost, &run->unloading);
    }
  }
  return {};
}

}  // namespace

Result<std::string> DrawnTracks::Draw(const std::string& track, std::uint64_t seed) {
  if (Status s = folder_.status(); !s.ok()) return s.error();
  const auto path = FindData("track", "models/tracks", track, {".yaml"});
  if (!path.ok()) return path.error();
  try {
    YAML::Node node = YAML::LoadFile(path.value());
    YAML::Node irregularity = node["irregularity"];
    if (!irregularity || !irregularity["psd"]) {
      return Error{path.value(), "has no spectrum of irregularities to draw from",
                   "a track with irregularity: {psd: …}", "see models/tracks/line_rough.yaml"};
    }
    irregularity["seed"] = fmt::format("{}", seed);
    const std::string drawn = fmt::format("{}/track_{}.yaml", folder_.path(), ++drawn_);
    if (Status s = WritePassingFile(drawn, YAML::Dump(node) + "\n"); !s.ok()) return s.error();
    return drawn;
  } catch (const YAML::Exception& fault) {
    return Error{fmt::format("{}:{}", path.value(), fault.mark.line + 1), fault.msg, "YAML", ""};
  }
}

Result<AlarmRun> MakeAlarmRun(const vehicle::Scenario& scenario, bool safety, const Watch& watch) {
  auto made = vehicle::Simulation::Create(scenario);
  if (!made.ok()) return made.error();
  vehicle::Simulation& simulation = made.value();
  if (simulation.binding().phs().size() != 1) {
    return Error{scenario.name, "has not exactly one PHS", "vehicle: bogie with a PHS", ""};
  }
  const auto outcome = simulation.Run([&](double) { return !watch.IsStopped(); });
  if (!outcome.ok()) return outcome.error();
  AlarmRun run;
  run.status = outcome.value().status;
  run.lines = simulation.binding().phs()[0].system->line_names();
  run.time_s = Column(outcome.value(), "t_s");
  run.place_m = Column(outcome.value(), "s_m");
  if (run.time_s.size() < 2) return Error{scenario.name, "ended at once", "", ""};
  run.interval_s = run.time_s[1] - run.time_s[0];
  for (size_t i = 1; i < run.place_m.size(); ++i) {
    run.place_m[i] = std::max(run.place_m[i], run.place_m[i - 1]);
  }
  for (const std::string& line : run.lines) {
    run.pressure_Pa.push_back(Column(outcome.value(), "line_" + line + "_pressure_Pa"));
  }
  if (safety) {
    if (Status s = AddSafety(simulation, outcome.value(), &run); !s.ok()) return s.error();
  }
  return run;
}

Result<bool> DoAll(int count, int workers, double from, double to, const Watch& watch,
                   const std::function<Status(int)>& task) {
  std::atomic<int> next = 0, done = 0;
  std::atomic<bool> end = false;
  std::mutex mutex;
  std::optional<Error> first;
  FirstThrown thrown;
  const auto work = [&] {
    for (int i = next++; i < count && !end; i = next++) {
      Status s;
      if (!thrown.Run([&] { s = task(i); })) end = true;
      ++done;
      if (s.ok()) continue;
      const std::lock_guard lock(mutex);
      if (!first) first = s.error();
      end = true;
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(static_cast<size_t>(std::min(workers, count)));
  for (int i = 0; i < std::min(workers, count); ++i) threads.emplace_back(work);
  bool goes_on = true;
  while (done < count && !end) {
    goes_on = watch.GoesOn(from + (to - from) * done / count);
    if (!goes_on) end = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  for (std::thread& thread : threads) thread.join();
  thrown.Rethrow();
  if (first && goes_on) return *first;
  return goes_on;
}

}  // namespace phs::jobs
