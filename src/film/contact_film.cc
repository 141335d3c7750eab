#include "film/contact_film.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "rail/height_under_load.h"
#include "view/shapes.h"

namespace phs::film {
namespace {

using rail::Side;
constexpr size_t kShown = 3;  ///< patches of a wheel that are shown
constexpr size_t kLead = 0;
constexpr int kMostRolls = 6;
constexpr double kRollTolerance = 1e-11;  ///< [rad]
constexpr double kReach = 0.03;           ///< of a height under load from the rigid one [m]

/// Motion of a wheelset as recorded, for one wheel, in C; height as if it hung.
struct Recorded {
  rail::WheelsetMotion motion;
  rail::RailOffset rail;
  double load = 0;
};

Recorded RecordedAt(const view::Picture& picture, size_t index, Side side, double roll) {
  const plugin::Binding& binding = picture.model->binding();
  const plugin::WheelsetBinding& w = binding.wheelsets()[index];
  const Eigen::Vector3d world = picture.BodyAt(w.body) + picture.origin;
  const rail::Track& track = binding.track();
  const rail::TrackFrame frame = track.FrameAt(track.Project({world.x(), world.y(), world.z()}));
  const auto value = [&](const char* what) { return picture.Value(w.name + what); };
  const double yaw = value("_angle_of_attack_rad");
  const double speed = picture.Value("speed_m_s");
  const double spin = (1 + value("_slip")) * speed / binding.wheel_rail().params().wheel_radius;
  const rail::Vec3 place = rail::MirrorPolar({0, value("_lateral_m"), 0}, side);
  const rail::Vec3 attitude = rail::MirrorAxial({roll, 0, yaw}, side);
  Recorded out;
  out.motion.lateral = place[1];
  out.motion.roll = attitude[0];
  out.motion.yaw = attitude[2];
  out.motion.velocity = rail::MirrorPolar({speed, 0, 0}, side);
  // About its own axle, and with the track about the vertical.
  out.motion.rotation = rail::MirrorAxial(
      {-spin * std::sin(yaw), spin * std::cos(yaw), spin * roll + speed * frame.curvature}, side);
  out.motion.speed = std::abs(speed);
  out.rail = track.Rail(side, frame.s);
  out.load = value(side == Side::kLeft ? "_left_Q_N" : "_right_Q_N");
  return out;
}

std::vector<std::array<double, 2>> PointsOf(const std::vector<Eigen::Vector2d>& outline) {
  std::vector<std::array<double, 2>> points;
  points.reserve(outline.size());
  for (const Eigen::Vector2d& p : outline) points.push_back({p.x(), p.y()});
  return points;
}

void AddNothing(report::ReplayWheel::Patch* patch) {
  for (report::Course* course : {&patch->y, &patch->z, &patch->angle, &patch->a, &patch->b,
                                 &patch->pressure, &patch->load, &patch->share}) {
    course->push_back(kNoNumber);
  }
}

void AddPatch(const rail::ContactPatch& found, report::ReplayWheel::Patch* patch) {
  patch->y.push_back(found.rail_y);
  patch->z.push_back(found.rail_z);
  patch->angle.push_back(found.angle);
  patch->a.push_back(found.a);
  patch->b.push_back(found.b);
  patch->pressure.push_back(found.peak_pressure);
  patch->load.push_back(found.normal / found.weight);  // as axes and pressure, of the whole patch
  patch->share.push_back(found.weight);
}

/// The wheel is drawn so that its most loaded patch lies on the rail's.
void AddPlace(const WheelOnRail& at, const rail::ContactPatch* largest,
              report::ReplayWheel* wheel) {
  if (largest == nullptr) {
    for (report::Course* course : {&wheel->offset_y, &wheel->offset_z, &wheel->roll}) {
      course->push_back(kNoNumber);
    }
    return;
  }
  const double c = std::cos(at.roll);
  const double s = std::sin(at.roll);
  wheel->offset_y.push_back(largest->rail_y - (c * largest->wheel_y - s * largest->wheel_z));
  wheel->offset_z.push_back(largest->rail_z - (s * largest->wheel_y + c * largest->wheel_z));
  wheel->roll.push_back(at.roll);
}

}  // namespace

Result<rail::WheelRail> LawOfRun(const view::ViewModel& model, const vehicle::Scenario& scenario) {
  rail::WheelRailParams params = model.binding().wheel_rail().params();
  const std::string law = scenario.creep.empty() ? rail::CreepLawParams().method : scenario.creep;
  if (Status s = rail::ChooseCreepLaw(law, &params.creep); !s.ok()) return s.error();
  return rail::WheelRail::Create(params);
}

namespace {

/// The height at which one wheel carries its load at this roll; false if none does. From the height
/// that the last roll gave, if it gave one.
bool FindHeight(const view::Picture& picture, const rail::WheelRail& wheel_rail, size_t wheelset,
                Side side, double roll, WheelOnRail* wheel) {
  const rail::Track& track = picture.model->binding().track();
  Recorded at = RecordedAt(picture, wheelset, side, roll);
  double near = wheel->height;
  if (!wheel->found) {
    const auto touch = wheel_rail.Touch(at.motion.lateral, at.motion.roll, at.motion.yaw);
    if (!touch.found) return false;
    near = touch.height;
  }
  wheel->found = false;
  wheel->roll = at.motion.roll;
  if (!(at.load > 0)) return false;
  const rail::WheelUnderLoad sought{.side = side,
                                    .rail = at.rail,
                                    .support = track.support(),
                                    .load = at.load,
                                    .carried = rail::VerticalForce,
                                    .near = near,
                                    .reach = kReach};
  if (!rail::FindHeightUnderLoad(wheel_rail, sought, &at.motion, &wheel->forces)) return false;
  wheel->height = at.motion.vertical;
  wheel->found = true;
  return true;
}

}  // namespace

std::array<WheelOnRail, 2> FindWheelsOnRails(const view::Picture& picture,
                                             const rail::WheelRail& law, size_t wheelset) {
  const plugin::Binding& binding = picture.model->binding();
  const plugin::WheelsetBinding& w = binding.wheelsets()[wheelset];
  const Eigen::Vector3d world = picture.BodyAt(w.body) + picture.origin;
  const rail::TrackFrame frame =
      binding.track().FrameAt(binding.track().Project({world.x(), world.y(), world.z()}));
  double roll = picture.BodyAxes(w.body).col(1).dot(view::ToEigen(frame.up));
  std::array<WheelOnRail, 2> wheels;
  for (int i = 0; i < kMostRolls; ++i) {
    bool both = true;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      both = FindHeight(picture, law, wheelset, side, roll, &wheels[static_cast<size_t>(side)]) &&
             both;
    }
    if (!both) break;
    // With its left wheel raised by the roll the wheelset must lie lower for the left one.
    const double turn = (wheels[0].height - wheels[1].height) / (2 * view::WheelPosition(law));
    if (std::abs(turn) < kRollTolerance) break;
    roll -= turn;
  }
  return wheels;
}

ContactFilm::ContactFilm(const view::ViewModel& model, const rail::WheelRail& law) : law_(law) {
  const rail::WheelRail& wheel_rail = model.binding().wheel_rail();
  has_profiles_ = wheel_rail.wheel_profile() != nullptr && wheel_rail.rail_profile() != nullptr;
  if (!has_profiles_) return;
  wheel_outline_ = PointsOf(view::WheelOutline(wheel_rail));
  rail_outline_ = PointsOf(model.rail_section().point);
  for (auto& p : rail_outline_) p[1] = -p[1];  // z down, as the wheel's
  for (const char* name : {"left wheel", "right wheel"}) {
    report::ReplayWheel wheel;
    wheel.name = name;
    wheel.patches.resize(kShown);
    wheels_.push_back(wheel);
  }
}

void ContactFilm::Add(const view::Picture& picture) {
  if (!has_profiles_) return;
  const std::array<WheelOnRail, 2> both = FindWheelsOnRails(picture, law_, kLead);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const WheelOnRail& at = both[static_cast<size_t>(side)];
    std::vector<const rail::ContactPatch*> patches;
    for (int k = 0; at.found && k < at.forces.count; ++k) {
      patches.push_back(&at.forces.patch[static_cast<size_t>(k)]);
    }
    std::sort(patches.begin(), patches.end(),
              [](const auto* p, const auto* q) { return p->normal > q->normal; });
    report::ReplayWheel* wheel = &wheels_[static_cast<size_t>(side)];
    AddPlace(at, patches.empty() ? nullptr : patches[0], wheel);
    for (size_t k = 0; k < kShown; ++k) {
      if (k < patches.size()) {
        AddPatch(*patches[k], &wheel->patches[k]);
      } else {
        AddNothing(&wheel->patches[k]);
      }
    }
  }
}

void ContactFilm::Finish(report::ReplayBogie* bogie) const {
  bogie->wheels = wheels_;
  bogie->wheel_outline = wheel_outline_;
  bogie->rail_outline = rail_outline_;
}

}  // namespace phs::film
