#include "measurement/joined_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::measurement {
namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// Takes a sample of one run over into `data`, which has room for it.
void Take(const FitData& run, size_t from, const std::vector<int>& outputs, FitData* data) {
  for (size_t a = 0; a < run.inputs.size(); ++a) {
    data->inputs[a].values.push_back(run.inputs[a].values[from]);
    const SmoothMotion& m = run.motion[a];
    SmoothMotion& out = data->motion[a];
    out.position.push_back(m.position[from]), out.speed.push_back(m.speed[from]);
    if (!m.acceleration.empty()) out.acceleration.push_back(m.acceleration[from]);
    if (!m.position_deviation.empty()) {
      out.position_deviation.push_back(m.position_deviation[from]);
      out.speed_deviation.push_back(m.speed_deviation[from]);
    }
  }
  if (!run.pressure_Pa.empty()) data->pressure_Pa.push_back(run.pressure_Pa[from]);
  for (MeasuredChannel& channel : data->outputs) channel.values.push_back(kAbsent);
  for (size_t c = 0; c < outputs.size(); ++c) {
    data->outputs[static_cast<size_t>(outputs[c])].values.back() = run.outputs[c].values[from];
  }
}

/// Outputs by name; the noise of one is the root mean square of its runs'.
std::vector<std::vector<int>> JoinOutputs(const std::vector<FitData>& runs, FitData* data) {
  std::vector<std::vector<int>> index;
  std::vector<double> count;
  for (const FitData& run : runs) {
    std::vector<int>& own = index.emplace_back();
    for (const MeasuredChannel& channel : run.outputs) {
      const auto known = std::find_if(data->outputs.begin(), data->outputs.end(),
                                      [&](const auto& c) { return c.name == channel.name; });
      const auto k = static_cast<size_t>(known - data->outputs.begin());
      if (known == data->outputs.end()) {
        data->outputs.push_back({channel.name, {}, 0}), count.push_back(0);
      }
      data->outputs[k].noise += channel.noise * channel.noise, ++count[k];
      own.push_back(static_cast<int>(k));
    }
  }
  for (size_t k = 0; k < count.size(); ++k) {
    data->outputs[k].noise = std::sqrt(data->outputs[k].noise / count[k]);
  }
  return index;
}

FitData Begin(const std::vector<FitData>& runs) {
  FitData data;
  const FitData& first = runs.front();
  data.kind = first.kind, data.options = first.options;
  data.candidates = first.candidates, data.own = first.own, data.free = first.free;
  data.step_s = first.step_s;
  data.motion.resize(first.motion.size());
  for (const MeasuredChannel& input : first.inputs) {
    data.inputs.push_back({input.name, {}, input.noise});
  }
  for (size_t r = 0; r < runs.size(); ++r) {
    data.source += (r > 0 ? ", " : "") + runs[r].source;
    for (const std::string& fault : runs[r].faults) {
      data.faults.push_back(runs[r].source + ": " + fault);
    }
    for (const DataFinding& f : runs[r].findings) {
      data.findings.push_back({f.channel, runs[r].source + ": " + f.text});
    }
  }
  return data;
}

Status CheckClocks(const std::vector<FitData>& runs) {
  for (const FitData& run : runs) {
    if (std::abs(run.step_s / runs.front().step_s - 1) < 1e-3) continue;
    return Error{run.source,
                 fmt::format("is sampled at {:.4g} Hz, {} at {:.4g} Hz", 1 / run.step_s,
                             runs.front().source, 1 / runs.front().step_s),
                 "runs of one rate", "resample the faster one"};
  }
  return {};
}

}  // namespace

Result<JoinedData> JoinData(const std::vector<FitData>& runs) {
  if (Status s = CheckClocks(runs); !s.ok()) return s.error();
  JoinedData out;
  out.data = Begin(runs);
  FitData& data = out.data;
  out.outputs = JoinOutputs(runs, &data);
  out.places.resize(runs.size());
  for (const bool estimation : {true, false}) {
    auto& window = estimation ? data.estimation : data.validation;
    window[0] = static_cast<double>(data.time_s.size()) * data.step_s;
    for (size_t r = 0; r < runs.size(); ++r) {
      const FitData& run = runs[r];
      const auto& own = estimation ? run.estimation : run.validation;
      for (size_t i = 0; i < run.time_s.size(); ++i) {
        if (run.time_s[i] < own[0] || run.time_s[i] >= own[1]) continue;
        const auto at = static_cast<int>(data.time_s.size());
        out.places[r].push_back({static_cast<int>(i), at});
        data.time_s.push_back(static_cast<double>(at) * data.step_s);
        data.run.push_back(static_cast<double>(r + 1));
        data.run_time_s.push_back(run.time_s[i]);
        Take(run, i, out.outputs[r], &data);
      }
    }
    window[1] = static_cast<double>(data.time_s.size()) * data.step_s;
    if (window[1] > window[0]) continue;
    return Error{data.source, estimation ? "no estimation window" : "no validation window",
                 "one of each, in this run or that", "estimation: [begin, end]"};
  }
  return out;
}

}  // namespace phs::measurement
