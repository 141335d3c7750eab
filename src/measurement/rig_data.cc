#include "measurement/rig_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/words.h"
#include "measurement/rig_columns.h"
#include "measurement/series.h"
#include "measurement/units.h"

namespace phs::measurement {
namespace {

std::string Text(const char* format, double a) {
  char text[120];
  std::snprintf(text, sizeof text, format, a);
  return text;
}

/// The rows that are kept (time rising) and the clock they suggest.
struct Clock {
  std::vector<int> rows;
  std::vector<double> time;
  double step = 0;
  bool uniform = true;
};

Result<Clock> ReadClock(const Table& table, const Manifest& manifest, RigRun* run) {
  const int column = FindChannel(table, manifest, "t_s");
  if (column < 0) {
    return Error{table.source, "has no time", "a column t_s", "name it under columns: {t_s: …}"};
  }
  double factor = FactorOf("t_s", table.names[static_cast<size_t>(column)]);
  if (const auto own = manifest.factors.find("t_s"); own != manifest.factors.end()) {
    factor *= own->second;
  }
  const std::vector<double>& raw = table.columns[static_cast<size_t>(column)];
  Clock clock;
  int missing = 0, doubled = 0;
  for (int i = 0; i < table.num_rows(); ++i) {
    const double t = factor * raw[static_cast<size_t>(i)];
    if (!std::isfinite(t)) {
      ++missing;
    } else if (!clock.time.empty() && t == clock.time.back()) {
      ++doubled;
      run->row_time.push_back(t);
    } else if (!clock.time.empty() && t < clock.time.back()) {
      const std::string line = static_cast<size_t>(i) < table.line.size()
                                   ? ":" + std::to_string(table.line[static_cast<size_t>(i)])
                                   : "";
      return Error{table.source + line, "time runs backwards", "rising t_s",
                   "cut the record where the clock was reset"};
    } else {
      clock.rows.push_back(i);
      clock.time.push_back(t);
      run->row_time.push_back(t);
    }
  }
  const size_t n = clock.time.size();
  if (n < 50) {
    return Error{table.source,
                 "has " + std::to_string(n) + " samples: too few to tell an effect from noise",
                 "at least 50 samples, better some thousand", "record longer"};
  }
  if (missing > 0) {
    run->findings.push_back({"t_s", std::to_string(missing) + " rows without time left out"});
  }
  if (doubled > 0) {
    run->findings.push_back(
        {"t_s", std::to_string(doubled) + " rows with a repeated time left out"});
  }
  std::vector<double> steps(n - 1);
  for (size_t i = 0; i + 1 < n; ++i) steps[i] = clock.time[i + 1] - clock.time[i];
  clock.step = Quantile(steps, 0.5);
  // The mean of the regular steps is finer than a rounded median.
  double sum = 0;
  int regular = 0, gaps = 0, uneven = 0;
  double longest = 0, gap_at = 0;
  for (size_t i = 0; i + 1 < n; ++i) {
    if (steps[i] > 2.5 * clock.step) {
      ++gaps;
      if (steps[i] > longest) longest = steps[i], gap_at = clock.time[i];
      continue;
    }
    if (std::abs(steps[i] - clock.step) > 0.02 * clock.step) ++uneven;
    sum += steps[i];
    ++regular;
  }
  if (gaps == 0 && regular > 0) clock.step = sum / regular;
  clock.uniform = gaps == 0 && uneven == 0;
  if (uneven > 0) {
    run->findings.push_back(
        {"t_s", "clock is not uniform (" + Text("%.3g", 100.0 * uneven / regular) +
                    " % of the steps off): resampled to " + Text("%.4g Hz", 1 / clock.step)});
  }
  if (gaps > 0) {
    run->findings.push_back({"t_s", std::to_string(gaps) + " gaps, the longest " +
                                        Text("%.3g s", longest) + " at " + Text("%.6g s", gap_at) +
                                        ": bridged, not scored"});
  }
  return clock;
}

/// `y` at the file's rows -> uniform clock, linear; `bad` where a needed row is missing or far.
void Resample(const Clock& clock, const RigRun& run, const std::vector<double>& y,
              Channel* channel) {
  const size_t n = static_cast<size_t>(run.num_samples);
  channel->y.assign(n, 0.0);
  channel->bad.assign(n, 0);
  std::vector<size_t> good;
  for (size_t i = 0; i < y.size(); ++i) {
    if (std::isfinite(y[i])) good.push_back(i);
  }
  if (good.empty()) return;
  size_t k = 0;
  for (size_t i = 0; i < n; ++i) {
    const double t = run.Time(static_cast<int>(i));
    while (k + 2 < good.size() && clock.time[good[k + 1]] <= t + 1e-9 * run.step_s) ++k;
    const size_t a = good[k], b = good[std::min(k + 1, good.size() - 1)];
    const double span = clock.time[b] - clock.time[a];
    const double part = span > 0 ? std::clamp((t - clock.time[a]) / span, 0.0, 1.0) : 0;
    channel->y[i] = part < 1e-6 ? y[a] : part > 1 - 1e-6 ? y[b] : y[a] + part * (y[b] - y[a]);
    const bool inside = part > 0.01 && part < 0.99;
    channel->bad[i] = (inside && span > 2.5 * run.step_s) || t < clock.time[a] - run.step_s ||
                      t > clock.time[b] + run.step_s;
  }
}

Channel ReadChannel(const Table& table, const Manifest& manifest, const Clock& clock,
                    const std::string& name, RigRun* run) {
  Channel channel;
  channel.name = name;
  const int column = FindChannel(table, manifest, name);
  if (column < 0) {
    const std::string other = InUnknownUnit(table, manifest, name);
    if (!other.empty()) {
      run->findings.push_back(
          {name, "column \"" + other + "\" is in no unit that is known: left out"});
    }
    return channel;
  }
  channel.column = table.names[static_cast<size_t>(column)];
  channel.factor = FactorOf(name, channel.column);
  const auto extra = manifest.factors.find(name);
  if (extra != manifest.factors.end()) {
    channel.factor *= extra->second;
  } else if (const std::string unit = UnknownUnit(name, channel.column); !unit.empty()) {
    run->findings.push_back({name, "column " + Quoted(channel.column) + ": unit " + Quoted(unit) +
                                       " is not known, taken in " +
                                       name.substr(name.rfind('_') + 1) + " (factors: scales it)"});
  }
  if (const UnreadableCells cells = FindUnreadable(table, column); cells.count > 0) {
    run->findings.push_back(
        {name, std::to_string(cells.count) + (cells.count > 1 ? " cells hold" : " cell holds") +
                   " no number, the first " + Quoted(cells.cell) + " at " + cells.where});
  }
  std::vector<double> y;
  int missing = 0;
  for (const int row : clock.rows) {
    const double value = table.columns[static_cast<size_t>(column)][static_cast<size_t>(row)];
    y.push_back(channel.factor * value);
    missing += !std::isfinite(value);
  }
  if (missing == static_cast<int>(y.size())) {
    run->findings.push_back({name, "holds no number: left out"});
    channel.column.clear();
    return channel;
  }
  if (missing > 0) {
    run->findings.push_back(
        {name, std::to_string(missing) + " samples are missing (" +
                   Text("%.2g", 100.0 * missing / static_cast<double>(y.size())) +
                   " %): bridged, not scored"});
  }
  Resample(clock, *run, y, &channel);
  return channel;
}

/// Further channels, as measured: they drive laws and are not compared.
Status ReadExtra(const Table& table, const Manifest& manifest, const Clock& clock, RigRun* run) {
  if (manifest.extra.empty()) return {};
  auto series = std::make_shared<hydraulics::ExtraSeries>();
  series->t0_s = run->t0_s, series->step_s = run->step_s;
  for (const std::string& name : manifest.extra) {
    Channel channel = ReadChannel(table, manifest, clock, name, run);
    if (!channel.present()) {
      return Error{manifest.path + ": extra." + name, "holds no number", "a measured column"};
    }
    series->names.push_back(name), series->values.push_back(std::move(channel.y));
  }
  run->extra = std::move(series);
  return {};
}

/// Says which columns stand for nothing: one written wrongly would else be missed in silence.
void NameUnread(const Table& table, const Manifest& manifest, RigRun* run) {
  constexpr size_t kMost = 6;
  std::vector<int> read = {FindChannel(table, manifest, "t_s")};
  for (const std::string& name : manifest.extra) read.push_back(FindChannel(table, manifest, name));
  for (const auto* list : {&run->inputs, &run->outputs}) {
    for (const Channel& c : *list) read.push_back(FindChannel(table, manifest, c.name));
  }
  for (const Channel* c : {&run->speed, &run->pressure, &run->temperature}) {
    read.push_back(FindChannel(table, manifest, c->name));
  }
  std::vector<std::string> unread, missing;
  for (int i = 0; i < table.num_columns(); ++i) {
    const bool used = std::find(read.begin(), read.end(), i) != read.end();
    if (!used) unread.push_back(table.names[static_cast<size_t>(i)]);
  }
  for (const Channel& c : run->outputs) {
    if (!c.present()) missing.push_back(c.name);
  }
  if (unread.empty()) return;
  const size_t more = unread.size() - std::min(unread.size(), kMost);
  unread.resize(unread.size() - more);
  if (more > 0) unread.push_back(std::to_string(more) + " more");
  run->findings.push_back(
      {"columns", JoinWords(unread) + ": not read, as no channel of this rig is called so" +
                      (missing.empty() ? "" : "; not measured: " + JoinWords(missing))});
}

Status ClipWindow(const char* key, RigRun* run, Window* window) {
  if (window->empty()) return {};
  const Window asked = *window;
  const double end = run->Time(run->num_samples - 1) + run->step_s;
  window->begin = std::max(window->begin, run->t0_s);
  window->end = std::min(window->end, end);
  constexpr double kMuch = 0.01;  // of the window
  const double cut = window->begin - asked.begin + asked.end - window->end;
  if (!window->empty() && cut > kMuch * (asked.end - asked.begin)) {
    run->findings.push_back({key, "window [" + Text("%.10g", asked.begin) + ", " +
                                      Text("%.10g", asked.end) + "] goes beyond the record: [" +
                                      Text("%.10g", window->begin) + ", " +
                                      Text("%.10g", window->end) + "] is taken"});
  }
  if (window->empty() || run->Last(*window) - run->First(*window) < 20) {
    return Error{run->source + ": " + key,
                 "window [" + Text("%.10g", asked.begin) + ", " + Text("%.10g", asked.end) +
                     "] holds fewer than 20 samples",
                 "a window inside " + Text("%.10g", run->t0_s) + " to " + Text("%.10g s", end), ""};
  }
  return {};
}

}  // namespace

int RigRun::First(const Window& window) const {
  if (window.empty()) return 0;
  const int i = static_cast<int>(std::ceil((window.begin - t0_s) / step_s - 1e-6));
  return std::clamp(i, 0, num_samples);
}

int RigRun::Last(const Window& window) const {
  if (window.empty()) return 0;
  const int i = static_cast<int>(std::ceil((window.end - t0_s) / step_s - 1e-6));
  return std::clamp(i, 0, num_samples);
}

Result<RigRun> ReadRigRun(const RunSpec& spec, const Manifest& manifest,
                          const std::vector<std::string>& inputs,
                          const std::vector<std::string>& outputs, OutputNeed need) {
  Result<Table> read = ReadTable(spec.data);
  if (!read.ok()) return read.error();
  const Table& table = read.value();
  std::vector<std::string> names = {"t_s", "v_m_s", "p_Pa", "temperature_K"};
  for (const auto* list : {&inputs, &outputs, &manifest.extra}) {
    names.insert(names.end(), list->begin(), list->end());
  }
  for (const std::string& name : names) {
    if (Status s = CheckReadable(table, manifest, name); !s.ok()) return s.error();
  }
  RigRun run;
  run.source = spec.data;
  Result<Clock> clocked = ReadClock(table, manifest, &run);
  if (!clocked.ok()) return clocked.error();
  const Clock& clock = clocked.value();
  run.step_s = clock.step;
  run.t0_s = clock.time.front();
  const double span = clock.time.back() - clock.time.front();
  if (span / clock.step > 5e6) {
    return Error{spec.data, "spans " + Text("%g s", span) + " at " + Text("%g Hz", 1 / clock.step),
                 "at most 5 million samples", "cut the record or its gaps"};
  }
  run.num_samples = static_cast<int>(std::floor(span / clock.step + 0.5)) + 1;
  run.file_time = clock.time;
  std::vector<std::string> known = inputs;
  known.insert(known.end(), outputs.begin(), outputs.end());
  if (Status s = CheckNames(manifest, table, std::move(known)); !s.ok()) return s.error();
  for (const std::string& name : inputs) {
    run.inputs.push_back(ReadChannel(table, manifest, clock, name, &run));
    if (!run.inputs.back().present()) {
      const std::string other = InUnknownUnit(table, manifest, name);
      return Error{spec.data, "the driving motion " + name + " is missing", "a column " + name,
                   other.empty() ? "a model can only be driven by measured motion"
                                 : "column \"" + other +
                                       "\" is in no unit that is known: name it under "
                                       "`columns:` and scale it under `factors:`"};
    }
  }
  int measured = 0;
  for (const std::string& name : outputs) {
    run.outputs.push_back(ReadChannel(table, manifest, clock, name, &run));
    measured += run.outputs.back().present();
  }
  const bool windows = !spec.estimation.empty() || !spec.validation.empty();
  if (measured == 0 && (need == OutputNeed::kSome || windows)) {
    return Error{spec.data, "holds no channel to compare with", JoinWords(outputs),
                 "its columns are " + JoinWords(table.names) + ": name one as `columns: {" +
                     outputs.front() +
                     ": NAME}`; without windows phs rig predicts them from the inputs alone"};
  }
  run.speed = ReadChannel(table, manifest, clock, "v_m_s", &run);
  run.pressure = ReadChannel(table, manifest, clock, "p_Pa", &run);
  run.temperature = ReadChannel(table, manifest, clock, "temperature_K", &run);
  if (Status s = ReadExtra(table, manifest, clock, &run); !s.ok()) return s.error();
  if (!inputs.empty()) NameUnread(table, manifest, &run);  // a bogie names its own
  run.estimation = spec.estimation;
  run.validation = spec.validation;
  if (Status s = ClipWindow("estimation", &run, &run.estimation); !s.ok()) return s.error();
  if (Status s = ClipWindow("validation", &run, &run.validation); !s.ok()) return s.error();
  if (manifest.low_pass_Hz > 0) {
    if (manifest.low_pass_Hz >= 0.5 / run.step_s) {
      return Error{manifest.path + ": low_pass_Hz",
                   "would change nothing at " + Text("%g Hz", 1 / run.step_s), "below half of that",
                   ""};
    }
    auto smooth = [&](Channel* c) {
      if (c->present()) c->y = LowPass(c->y, run.step_s, manifest.low_pass_Hz);
    };
    for (Channel& c : run.inputs) smooth(&c);
    for (Channel& c : run.outputs) smooth(&c);
    smooth(&run.speed);
    smooth(&run.pressure);
    smooth(&run.temperature);
  }
  return run;
}

}  // namespace phs::measurement
