#include "analysis/hunting_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "analysis/balance_branch.h"
#include "analysis/drives_off.h"
#include "vehicle/tangent_state.h"

namespace phs::analysis {
namespace {

using Eigen::VectorXd;

constexpr size_t kMostPoints = 400;  ///< of a map
constexpr double kLeastSpeed = 1;    ///< of a map [m/s]
constexpr double kSpeedStep = 1e-3;  ///< of differences [m/s]

/// A vehicle on straight track at a prescribed forward speed as a system of rates. Its positions
/// are those of the tangent vector without the way and the spin angles, which nothing depends on;
/// its states are the spin speeds, then the activations.
class GuidedVehicle {
 public:
  explicit GuidedVehicle(vehicle::Simulation* simulation)
      : simulation_(*simulation),
        m_(simulation->mutable_model()),
        binding_(simulation->binding()),
        radius_(binding_.wheel_rail().params().wheel_radius),
        instant_(m_),
        drives_off_(m_, binding_),
        base_(mj_makeData(m_)),
        data_(mj_makeData(m_)) {
    forward_ = m_->body_dofadr[m_->body_rootid[binding_.wheelsets()[0].body]];
    for (const plugin::WheelsetBinding& w : binding_.wheelsets()) spins_.push_back(w.spin_dof);
    for (int i = 0; i < m_->nv; ++i) {
      if (i != forward_ && std::ranges::find(spins_, i) == spins_.end()) dofs_.push_back(i);
    }
  }

  int positions() const { return static_cast<int>(dofs_.size()); }
  int states() const { return static_cast<int>(spins_.size()) + m_->na; }

  VectorXd Rates(double speed, const VectorXd& x) {
    if (speed != speed_) {
      if (!StartAtSpeed(simulation_, speed, base_.get()).ok()) return Failed();
      speed_ = speed;
    }
    vehicle::SetState(m_, base_.get(), Whole(x), data_.get());
    mj_forward(m_, data_.get());
    const double lacking = data_->qacc[forward_];
    VectorXd rates(positions() + states());
    for (int i = 0; i < positions(); ++i) rates[i] = data_->qacc[dofs_[Index(i)]];
    int k = positions();
    for (const int spin : spins_) rates[k++] = data_->qacc[spin] - lacking / radius_;
    for (int i = 0; i < m_->na; ++i) rates[k++] = data_->act_dot[i];
    return rates;
  }

  VectorXd Steps() const {
    const DifferenceSteps steps;
    const VectorXd scale = vehicle::ActivationScale(m_, binding_);
    VectorXd out(2 * positions() + states());
    out.head(positions()).setConstant(steps.position);
    out.segment(positions(), positions() + static_cast<int>(spins_.size()))
        .setConstant(steps.speed);
    out.tail(m_->na) = steps.activation * scale;
    return out;
  }

  /// Lateral motion of the leading wheelset per position.
  VectorXd Lateral() {
    (void)StartAtSpeed(simulation_, simulation_.binding().target_speed(), data_.get());
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> place(3, m_->nv);
    mj_jacBody(m_, data_.get(), place.data(), nullptr, binding_.wheelsets()[0].body);
    VectorXd out(positions());
    for (int i = 0; i < positions(); ++i) out[i] = place(1, dofs_[Index(i)]);
    return out;
  }

  /// A linear mode as a motion of one harmonic, its watched amplitude one, phase zero.
  PeriodicMotion Of(const VibrationMode& mode, const VectorXd& watched) const {
    Eigen::VectorXcd own(positions() + states());
    for (int i = 0; i < positions(); ++i) own[i] = mode.state[dofs_[Index(i)]];
    int k = positions();
    for (const int spin : spins_) own[k++] = mode.state[m_->nv + spin];
    own.tail(m_->na) = mode.state.tail(m_->na);
    std::complex<double> size = 0;
    for (int i = 0; i < positions(); ++i) size += watched[i] * own[i];
    own /= size;
    PeriodicMotion motion;
    motion.omega = std::abs(mode.eigenvalue.imag());
    motion.parameter = mode.speed;
    if (mode.eigenvalue.imag() < 0) own = own.conjugate().eval();
    motion.coefficients = Eigen::MatrixXd::Zero(own.size(), 3);
    motion.coefficients.col(1) = own.real();
    motion.coefficients.col(2) = -own.imag();
    return motion;
  }

  /// Lost in the PHS, mean over a period [W].
  double MeanPhsPower(const PeriodicMotion& motion) {
    constexpr int kInstants = 256;
    double sum = 0;
    for (int i = 0; i < kInstants; ++i) {
      const double phase = 2 * std::numbers::pi * i / kInstants;
      (void)Rates(motion.parameter, motion.At(phase, positions()));
      sum += data_->userdata[plugin::UserData::kPhsPower];
    }
    return sum / kInstants;
  }

  VibratingSystem System() {
    return {positions(), states(),
            Steps(),     kSpeedStep,
            Lateral(),   [this](double speed, const VectorXd& x) { return Rates(speed, x); }};
  }

 private:
  static size_t Index(int i) { return static_cast<size_t>(i); }
  VectorXd Failed() const {
    return VectorXd::Constant(positions() + states(), std::numeric_limits<double>::quiet_NaN());
  }
  VectorXd Whole(const VectorXd& x) const {
    VectorXd out = VectorXd::Zero(vehicle::TangentSize(m_));
    for (int i = 0; i < positions(); ++i) {
      out[dofs_[Index(i)]] = x[i];
      out[m_->nv + dofs_[Index(i)]] = x[positions() + i];
    }
    int k = 2 * positions();
    for (const int spin : spins_) out[m_->nv + spin] = x[k++];
    out.tail(m_->na) = x.tail(m_->na);
    return out;
  }

  const vehicle::Simulation& simulation_;
  mjModel* m_;
  const plugin::Binding& binding_;
  double radius_;
  plugin::InstantForces instant_;
  DrivesOff drives_off_;
  vehicle::DataPtr base_, data_;
  int forward_ = 0;
  double speed_ = -1;
  std::vector<int> spins_, dofs_;
};

HuntingPoint PointOf(const PeriodicMotion& motion, const VectorXd& watched,
                     GuidedVehicle* vehicle) {
  HuntingPoint p;
  p.amplitude = motion.Amplitude(watched, 1);
  p.speed = motion.parameter;
  p.frequency = motion.omega / (2 * std::numbers::pi);
  p.phs_power = vehicle->MeanPhsPower(motion);
  for (int k = 2; k <= motion.harmonics(); ++k) p.harmonics.push_back(motion.Amplitude(watched, k));
  return p;
}

}  // namespace

Result<std::vector<HuntingPoint>> FindHuntingMap(vehicle::Simulation* simulation,
                                                 const VibrationMode& mode,
                                                 const HuntingMapOptions& options,
                                                 const vehicle::Progress& progress) {
  if (options.samples < 4 * options.harmonics + 1) {
    return Error{"samples of the map of hunting", "are too few: " + std::to_string(options.samples),
                 "at least four for each harmonic, and one", ""};
  }
  GuidedVehicle vehicle(simulation);
  const VibratingSystem system = vehicle.System();
  PeriodicMotion start = vehicle.Of(mode, system.watched).WithHarmonics(options.harmonics);
  start.coefficients *= options.least_m;
  const BalanceOptions solver{.samples = options.samples};
  auto first = SolveBalance(system, start, options.least_m, solver);
  if (!first.ok()) return first.error();
  std::vector<HuntingPoint> map = {PointOf(first.value(), system.watched, &vehicle)};
  PeriodicMotion larger = first.value();
  larger.coefficients *= options.ratio;
  auto second = SolveBalance(system, larger, options.ratio * options.least_m, solver);
  if (!second.ok()) return map;
  map.push_back(PointOf(second.value(), system.watched, &vehicle));
  BalanceBranch branch(system,
                       {.ratio = options.ratio,
                        .step = options.step_m,
                        .largest = options.largest_m,
                        .solver = solver},
                       std::move(first.value()), std::move(second.value()));
  double done = 0;
  while (map.size() < kMostPoints && map.back().amplitude >= options.least_m &&
         map.back().speed > kLeastSpeed && branch.Next()) {
    map.push_back(PointOf(branch.last(), system.watched, &vehicle));
    done = std::max(done, std::log(map.back().amplitude / options.least_m) /
                              std::log(options.largest_m / options.least_m));
    if (progress && !progress(done)) return Error{"map of hunting", "was interrupted", "", ""};
  }
  return map;
}

HuntingAt HuntingAtSpeed(const std::vector<HuntingPoint>& map, double speed) {
  HuntingAt at{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  for (size_t i = 1; i < map.size(); ++i) {
    const HuntingPoint &a = map[i - 1], &b = map[i];
    if ((a.speed > speed) == (b.speed > speed)) continue;
    const double amplitude =
        a.amplitude + (b.amplitude - a.amplitude) * (speed - a.speed) / (b.speed - a.speed);
    (b.speed > speed ? at.cycle : at.brink) = amplitude;
  }
  return at;
}

const HuntingPoint* LeastSpeed(const std::vector<HuntingPoint>& map) {
  const auto least = std::ranges::min_element(map, {}, &HuntingPoint::speed);
  return least == map.end() || least == map.begin() || least + 1 == map.end() ? nullptr : &*least;
}

nlohmann::ordered_json HuntingMapJson(const std::vector<HuntingPoint>& map,
                                      const HuntingMapOptions& options) {
  using Json = nlohmann::ordered_json;
  const auto of = [](const HuntingPoint& p) {
    return Json{{"amplitude_m", p.amplitude},
                {"speed_m_s", p.speed},
                {"frequency_Hz", p.frequency},
                {"phs_power_W", p.phs_power},
                {"higher_harmonics_m", p.harmonics}};
  };
  const HuntingPoint* least = LeastSpeed(map);
  Json json = {{"harmonics", options.harmonics}, {"least", least ? of(*least) : Json(nullptr)}};
  json["points"] = Json::array();
  for (const HuntingPoint& p : map) json["points"].push_back(of(p));
  return json;
}

}  // namespace phs::analysis
