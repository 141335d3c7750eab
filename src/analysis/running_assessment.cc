#include "analysis/running_assessment.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/running_statistics.h"
#include "rail/running_safety.h"
#include "rail/wear.h"

namespace phs::analysis {
namespace {

using Signal = std::vector<double>;

constexpr double kShortest_m = 5;     ///< sections shorter are not assessed
constexpr double kHuntingLow_Hz = 1;  ///< band in which hunting is looked for
constexpr double kHuntingHigh_Hz = 12;
constexpr double kLowestHunting_Hz = 2;

const Signal& Column(const vehicle::RunOutcome& run, const std::string& name) {
  return run.columns[static_cast<size_t>(run.Find(name))];
}

/// Interval of the rows [s].
double IntervalOf(const vehicle::RunOutcome& run) {
  const Signal& t = Column(run, "t_s");
  return t.size() < 2 ? 0 : (t.back() - t.front()) / static_cast<double>(t.size() - 1);
}

/// Distance of every wheelset behind the foremost, from where they stand at the start [m].
Signal OffsetsOf(const vehicle::Simulation& simulation, const vehicle::RunOutcome& run) {
  const auto& wheelsets = simulation.binding().wheelsets();
  Signal along;
  const double heading = Column(run, wheelsets[0].name + "_heading_rad")[0];
  for (const auto& w : wheelsets) {
    along.push_back(Column(run, w.name + "_x_m")[0] * std::cos(heading) +
                    Column(run, w.name + "_y_m")[0] * std::sin(heading));
  }
  const double foremost = *std::max_element(along.begin(), along.end());
  for (double& x : along) x = foremost - x;
  return along;
}

/// Rows [first, last) at which `place` lies on the section.
struct RowRange {
  size_t first = 0;
  size_t last = 0;
};
RowRange RowsOn(const Signal& place, double offset, const rail::TrackSection& section) {
  RowRange rows;
  while (rows.first < place.size() && place[rows.first] - offset < section.begin_s) ++rows.first;
  rows.last = rows.first;
  while (rows.last < place.size() && place[rows.last] - offset <= section.end_s) ++rows.last;
  return rows;
}

Signal Part(const Signal& all, const RowRange& rows, double factor = 1) {
  Signal part(all.begin() + static_cast<long>(rows.first),
              all.begin() + static_cast<long>(rows.last));
  for (double& x : part) x *= factor;
  return part;
}

WheelsetForces ForcesOn(const vehicle::RunOutcome& run, const std::string& name,
                        const RowRange& rows) {
  // Recorded Y pushes its own rail outwards; here both count to the left.
  return {Part(Column(run, "s_m"), rows), Part(Column(run, name + "_left_Y_N"), rows),
          Part(Column(run, name + "_right_Y_N"), rows, -1),
          Part(Column(run, name + "_left_Q_N"), rows),
          Part(Column(run, name + "_right_Q_N"), rows)};
}

/// Frequency of the zero crossings in the band of hunting; 0 if there is none above 2 Hz.
double HuntingFrequency(const WheelsetForces& f, double interval_s) {
  Signal sum = f.y_left_N;
  for (size_t i = 0; i < sum.size(); ++i) sum[i] += f.y_right_N[i];
  const auto band = BandPass(sum, interval_s, kHuntingLow_Hz, kHuntingHigh_Hz);
  if (!band.ok() || band.value().size() < 2) return 0;
  int crossings = 0;
  for (size_t i = 1; i < band.value().size(); ++i) {
    crossings += (band.value()[i - 1] < 0) != (band.value()[i] < 0);
  }
  const double time = interval_s * static_cast<double>(band.value().size() - 1);
  const double frequency = 0.5 * crossings / time;
  return frequency > 1.01 * kLowestHunting_Hz ? frequency : 0;
}

bool BelongsTo(const std::string& quantity, const std::string& section) {
  const bool quasi_static = quantity == "Y_qst_N" || quantity == "Q_qst_N";
  return !quasi_static || section == "curve";
}

/// Rate of change; one-sided at the ends.
Signal Derivative(const Signal& x, double interval_s) {
  Signal rate(x.size(), 0.0);
  for (size_t i = 0; i < x.size() && x.size() > 1; ++i) {
    const size_t a = i == 0 ? 0 : i - 1;
    const size_t b = std::min(i + 1, x.size() - 1);
    rate[i] = (x[b] - x[a]) / (interval_s * static_cast<double>(b - a));
  }
  return rate;
}

/// Of the car body along an axis; none where that is not recorded finely enough.
std::optional<AccelerationStatistics> Ride(const vehicle::RunOutcome& run, const char* axis,
                                           const RowRange& rows, double interval_s) {
  const Signal speed = Part(Column(run, std::string("car_body_") + axis + "_speed_m_s"), rows);
  const auto found = AssessAcceleration(Derivative(speed, interval_s), interval_s);
  if (!found.ok()) return {};
  return found.value();
}

void KeepWorst(const WorstQuantity& found, std::vector<WorstQuantity>* worst) {
  const auto kept = std::find_if(worst->begin(), worst->end(), [&](const WorstQuantity& w) {
    return w.quantity.name == found.quantity.name;
  });
  if (kept == worst->end()) {
    worst->push_back(found);
  } else if (kept->Share() < found.Share()) {
    *kept = found;
  }
}

struct Vehicle {
  const vehicle::Simulation& simulation;
  const vehicle::RunOutcome& run;
  double interval_s;
  double wheel_load_N;
  Signal offsets;
};

/// One section; none if the run did not cover it.
Result<std::optional<AssessedSection>> AssessSection(const Vehicle& v,
                                                     const rail::TrackSection& section,
                                                     std::vector<WorstQuantity>* worst) {
  const Signal& place = Column(v.run, "s_m");
  const double radius = section.curvature == 0 ? 0 : std::abs(1 / section.curvature);
  AssessedSection out{section.kind, section.begin_s, section.end_s,
                      section.kind == "curve" ? radius : 0};
  SectionConditions conditions{v.interval_s, v.wheel_load_N, radius, 1, 0};
  const auto& wheelsets = v.simulation.binding().wheelsets();
  for (size_t i = 0; i < wheelsets.size(); ++i) {
    const RowRange rows = RowsOn(place, v.offsets[i], section);
    if (rows.last - rows.first < 2 || place[rows.last - 1] - place[rows.first] < kShortest_m) {
      return std::optional<AssessedSection>();
    }
    const WheelsetForces forces = ForcesOn(v.run, wheelsets[i].name, rows);
    if (section.kind == "tangent") {
      conditions.hunting_Hz = HuntingFrequency(forces, v.interval_s);
    }
    auto found = AssessWheelset(forces, conditions);
    if (!found.ok()) return found.error();
    AssessedWheelset own{wheelsets[i].name, {}, conditions.hunting_Hz};
    for (const AssessedQuantity& q : found.value()) {
      if (!BelongsTo(q.name, section.kind)) continue;
      own.quantities.push_back(q);
      KeepWorst({q, wheelsets[i].name, section.begin_s}, worst);
    }
    out.wheelsets.push_back(std::move(own));
    if (i > 0) continue;
    out.ride_lateral = Ride(v.run, "lateral", rows, v.interval_s);
    out.ride_vertical = Ride(v.run, "vertical", rows, v.interval_s);
  }
  return std::optional(std::move(out));
}

/// T-gamma in the steady curve, worn section over the run.
AssessedWheel WheelWear(const Vehicle& v, const std::string& wheel, const RowRange& steady) {
  const Signal& t_gamma = Column(v.run, wheel + "_T_gamma_N");
  const Signal& place = Column(v.run, "s_m");
  const double diameter = 2 * v.simulation.binding().wheel_rail().params().wheel_radius;
  double area = 0;
  for (size_t i = 1; i < place.size(); ++i) {
    area += (place[i] - place[i - 1]) * 0.5 *
            (rail::CalcWornAreaPerKm(t_gamma[i], diameter) +
             rail::CalcWornAreaPerKm(t_gamma[i - 1], diameter));
  }
  AssessedWheel out{wheel};
  const double way = place.back() - place.front();
  if (way > 0) out.worn_area_mm2_per_km = area / way;
  if (steady.last <= steady.first) return out;
  double mean = 0;
  for (size_t i = steady.first; i < steady.last; ++i) mean += t_gamma[i];
  out.steady_T_gamma_N = mean / static_cast<double>(steady.last - steady.first);
  return out;
}

/// The last third of the first arc, or of a track without one, as in summary.json.
rail::TrackSection SteadySection(const rail::Track& track) {
  rail::TrackSection steady;
  steady.begin_s = 0;
  steady.end_s = track.length();
  for (const rail::TrackSection& section : track.sections()) {
    if (section.kind != "curve") continue;
    steady = section;
    break;
  }
  steady.begin_s = steady.end_s - (steady.end_s - steady.begin_s) / 3;
  return steady;
}

double StaticWheelLoad(const vehicle::Simulation& simulation) {
  const mjModel* m = simulation.model();
  double mass = 0;
  for (int body = 1; body < m->nbody; ++body) mass += m->body_mass[body];
  const double wheels = 2.0 * static_cast<double>(simulation.binding().wheelsets().size());
  return mass * std::abs(m->opt.gravity[2]) / wheels;
}

}  // namespace

Assessment AssessRun(const vehicle::Simulation& simulation, const vehicle::RunOutcome& run) {
  Assessment out;
  if (run.columns.empty() || run.columns[0].size() < 2) {
    out.reason = "the run is too short";
    return out;
  }
  const plugin::Binding& binding = simulation.binding();
  const Vehicle v{simulation, run, IntervalOf(run), StaticWheelLoad(simulation),
                  OffsetsOf(simulation, run)};
  out.gauge_m = binding.track().gauge();
  out.static_wheel_load_N = v.wheel_load_N;
  out.limits_are_orientation =
      std::abs(out.gauge_m - 1.435) > 0.005 || out.static_wheel_load_N > 110.5e3;
  const double flange = binding.wheel_rail().flange_angle();
  if (flange > 0) out.nadal_Y_over_Q = rail::CalcNadalLimit(flange, binding.friction());
  for (const rail::TrackSection& section : binding.track().sections()) {
    auto part = AssessSection(v, section, &out.worst);
    if (!part.ok()) {
      out.reason = part.error().Line();
      return out;
    }
    if (part.value()) out.sections.push_back(*std::move(part).value());
  }
  const RowRange steady = RowsOn(Column(run, "s_m"), 0, SteadySection(binding.track()));
  for (const auto& w : binding.wheelsets()) {
    for (const char* side : {"_left", "_right"}) {
      out.wheels.push_back(WheelWear(v, w.name + side, steady));
    }
  }
  return out;
}

}  // namespace phs::analysis
