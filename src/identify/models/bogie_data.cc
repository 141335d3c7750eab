#include "identify/models/bogie_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/data_path.h"
#include "base/words.h"
#include "measurement/channel_noise.h"
#include "measurement/data_checks.h"
#include "measurement/fit_run.h"
#include "measurement/series.h"
#include "measurement/stuck_bit.h"
#include "rail/track.h"

namespace phs::identify::search {

using measurement::Channel;
using measurement::CheckWindows;
using measurement::DataFinding;
using measurement::EstimateNoise;
using measurement::FitData;
using measurement::Manifest;
using measurement::MarkSpikes;
using measurement::Quantum;
using measurement::ReadBackStuckBit;
using measurement::ReadRigRun;
using measurement::RigRun;
using measurement::SmoothMotion;
using measurement::SmoothPosition;
using measurement::StandardDeviation;
using measurement::StartData;
using measurement::TakeOutput;
using measurement::WhiteNoise;
namespace {

constexpr double kUnevenSpeed = 0.03;    // relative spread worth a word
constexpr double kStraight = 1.0 / 3e4;  // [1/m] change of curvature that is none
constexpr double kBeyond = 2.0;          // [m] a record may begin before the run does

/// Channels that say where and how fast the vehicle is: they drive, they are not explained.
bool Drives(const std::string& channel) {
  static const std::vector<std::string> names = {"t_s",      "s_m", "speed_m_s", "curvature_1_m",
                                                 "cant_rad", "x_m", "y_m",       "heading_rad"};
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return channel == name || ((name == "x_m" || name == "y_m" || name == "heading_rad") &&
                               channel.ends_with("_" + name));
  });
}

/// Every name under which something may be measured: channels of a run, and a rig's names.
std::vector<std::string> KnownColumns(const BogieModel& model) {
  std::vector<std::string> names = {"s_m", "speed_m_s"};
  for (const auto& c : model.phs.cylinders) {
    names.push_back("piston" + c.name + "_m"), names.push_back("load" + c.name + "_N");
  }
  for (const auto& l : model.phs.lines) names.push_back("p" + l.name + "_Pa");
  for (const std::string& channel : model.observed) {
    if (!Drives(channel)) names.push_back(channel);
  }
  return names;
}

Channel* Find(std::vector<Channel>* channels, const std::string& name) {
  for (Channel& c : *channels) {
    if (c.name == name && c.present()) return &c;
  }
  return nullptr;
}

/// Columns of the file that stand for nothing: named, with the nearest known.
Status NameUnknown(const Manifest& manifest, const std::vector<std::string>& known, RigRun* run) {
  Result<Table> table = ReadTable(run->source);
  if (!table.ok()) return table.status();
  for (const std::string& column : table.value().names) {
    if (column == "t_s" || Drives(column)) continue;
    const bool used = std::any_of(run->outputs.begin(), run->outputs.end(),
                                  [&](const Channel& c) { return c.column == column; }) ||
                      std::any_of(manifest.columns.begin(), manifest.columns.end(),
                                  [&](const auto& named) { return named.second == column; });
    if (used) continue;
    const std::string nearest = NearestWord(column, known);
    run->findings.push_back(
        {column, "is no channel of this bogie: left out" +
                     (nearest.empty() ? "" : " (did you mean " + nearest + "?)")});
  }
  return {};
}

/// Place of the leading wheelset at every sample.
Result<SmoothMotion> ReadPlace(const BogieModel& model, RigRun* run) {
  Channel* s = Find(&run->outputs, "s_m");
  Channel* v = Find(&run->outputs, "speed_m_s");
  if (s == nullptr && v == nullptr) {
    return Error{run->source, "does not say where the vehicle is", "a column s_m or speed_m_s",
                 "s_m: arc length of the leading wheelset along the track"};
  }
  Channel place = s != nullptr ? *s : *v;
  if (s == nullptr) {
    place.name = "s_m";
    place.y.front() = model.start_m;
    for (size_t i = 1; i < place.y.size(); ++i) {
      place.y[i] = place.y[i - 1] + 0.5 * run->step_s * (v->y[i - 1] + v->y[i]);
    }
    run->findings.push_back(
        {"s_m", fmt::format("was not measured: speed_m_s integrated from {:.4g} m, where the "
                            "scenario starts",
                            model.start_m)});
  }
  MarkSpikes(&place, &run->findings);
  const double noise = std::max({WhiteNoise(place.y, place.bad), Quantum(place.y) / 3.46, 1e-6});
  SmoothMotion motion = SmoothPosition(place.y, place.bad, run->step_s, noise);
  const std::vector<double>& at = motion.position;
  if (!(at.back() - at.front() > 10)) {
    return Error{run->source, fmt::format("the vehicle moves {:.3g} m", at.back() - at.front()),
                 "10 m or more", "check s_m, speed_m_s and the clock"};
  }
  const double least = *std::min_element(at.begin(), at.end());
  if (least < model.start_m - kBeyond || at.back() > model.track_length_m + kBeyond) {
    return Error{run->source,
                 fmt::format("runs from {:.1f} to {:.1f} m, the scenario's leading wheelset from "
                             "{:.1f} to {:.1f} m",
                             least, at.back(), model.start_m, model.track_length_m),
                 "a record inside the track", "cut the record, or set start_s_m of the scenario"};
  }
  return motion;
}

void SetSpeed(const SmoothMotion& motion, const RigRun& run, BogieModel* model,
              std::vector<DataFinding>* findings) {
  const double seconds = run.step_s * static_cast<double>(motion.position.size() - 1);
  const double mean = (motion.position.back() - motion.position.front()) / seconds;
  const double spread = StandardDeviation(motion.speed);
  if (spread > kUnevenSpeed * mean) {
    findings->push_back({"speed_m_s", fmt::format("varies by {:.1f} %: the model runs at the mean "
                                                  "of {:.2f} m/s",
                                                  100 * spread / mean, mean)});
  }
  if (std::abs(mean - model->scenario.speed_m_s) > 0.01 * model->scenario.speed_m_s) {
    findings->push_back(
        {"speed_m_s", fmt::format("is {:.2f} m/s in the data, {:.2f} m/s in the scenario: the "
                                  "measured one is used",
                                  mean, model->scenario.speed_m_s)});
  }
  model->scenario.speed_m_s = mean;
}

Status CheckCurve(const BogieModel& model, const FitData& data) {
  auto path = FindData("track", "models/tracks", model.scenario.track, {".yaml"});
  if (!path.ok()) return path.status();
  auto track = rail::Track::Load(path.value());
  if (!track.ok()) return track.status();
  double least = 1e9, most = -1e9;
  for (size_t i = 0; i < data.time_s.size(); ++i) {
    if (!data.InEstimation(i)) continue;
    const double k = track.value().FrameAt(data.motion.front().position[i]).curvature;
    least = std::min(least, k), most = std::max(most, k);
  }
  if (most - least > kStraight) return {};
  return Error{data.source, "the curvature does not change in the estimation window",
               "a window with a curve and its transition",
               "nothing can be identified of a bogie that does not steer; choose another window"};
}

}  // namespace

Result<FitData> ReadBogieData(const Manifest& manifest, BogieModel* model, bool several) {
  const std::vector<std::string> known = KnownColumns(*model);
  Result<RigRun> read = ReadRigRun(manifest.runs.front(), manifest, {}, known);
  if (!read.ok()) return read.error();
  RigRun& run = read.value();
  const bool fits = !run.estimation.empty();
  if (!fits && run.validation.empty()) run.validation = {run.t0_s, run.Time(run.num_samples)};
  if (fits || several) {
    if (Status s = CheckWindows(run, several); !s.ok()) return s.error();
  }
  if (Status s = NameUnknown(manifest, known, &run); !s.ok()) return s.error();
  Result<SmoothMotion> motion = ReadPlace(*model, &run);
  if (!motion.ok()) return motion.error();
  FitData data = StartData(run);
  SetSpeed(motion.value(), run, model, &data.findings);
  data.inputs.push_back({"s_m", motion.value().position, 0});
  data.motion.push_back(std::move(motion).value());
  if (fits) {
    if (Status s = CheckCurve(*model, data); !s.ok()) return s.error();
  } else if (!several) {
    data.estimation = data.validation;
  }
  const std::vector<char> none(data.time_s.size(), 0);
  for (Channel& output : run.outputs) {
    if (!output.present() || Drives(output.name)) continue;
    ReadBackStuckBit(run, &output, &data.findings);
    output.noise = EstimateNoise(output, none, run.step_s);
    TakeOutput(&output, run, none, &data);
  }
  if (data.outputs.empty()) {
    return Error{data.source, "no output channel can be used",
                 "a measured channel that changes: piston1_m, load1_N, pL1_Pa, lead_lateral_m, …",
                 "docs/identify_bogie.md lists them"};
  }
  return data;
}

}  // namespace phs::identify::search
