#include "rail/contact_modulus.h"

#include <algorithm>
#include <cmath>

#include "rail/arc_mean.h"

namespace phs::rail {
namespace {

constexpr double kTableStep = 0.125e-3;   ///< of the table [m]
constexpr double kMostShift = 25e-3;      ///< of the wheel across the rail, either way [m]
constexpr double kShiftStep = 0.1e-3;     ///< [m]
constexpr double kSearchStep = 0.5e-3;    ///< on the wheel [m]
constexpr double kJump = 1e-3;            ///< touches farther apart leave the rail between them [m]
constexpr double kWindow = 0.5e-3;        ///< of curvature, half, arc length [m]
constexpr double kEvenedOver = 1.5e-3;    ///< over which kappa is evened out, half, arc length [m]
constexpr double kLeftOut = 1e-3;         ///< curvature is not asked for nearer to an end [m]
constexpr double kFlattestRegion = 0.05;  ///< conformal regions carry a wide but finite patch [1/m]

/// Mean curvature: the turn of the surface over its length.
double MeanCurvature(const Profile& p, double y) {
  const double slope = p.At(y).slope;
  const double dy = kWindow / std::sqrt(1 + slope * slope);
  const Profile::Sample from = p.At(y - dy);
  const Profile::Sample to = p.At(y + dy);
  return (std::atan(to.slope) - std::atan(from.slope)) / std::hypot(2 * dy, to.z - from.z);
}

/// Where the upright wheel touches first, its origin `shift` outside of the rail's; wheel profile.
double TouchOf(const Profile& wheel, const Profile& rail, double shift) {
  const double from = std::max(wheel.min_y(), rail.min_y() - shift) + kLeftOut;
  const double to = std::min(wheel.max_y(), rail.max_y() - shift) - kLeftOut;
  const auto depth = [&](double y) { return wheel.At(y).z - rail.At(y + shift).z; };
  double deepest = from;
  double most = depth(from);
  for (double y = from; y < to; y += kSearchStep) {
    const double there = depth(y);
    if (there > most) {
      most = there;
      deepest = y;
    }
  }
  double low = std::max(from, deepest - kSearchStep);
  double high = std::min(to, deepest + kSearchStep);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (wheel.At(middle).slope > rail.At(middle + shift).slope ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// kappa over a rail's surface in the making; 0 = not yet known.
class ModulusTable {
 public:
  ModulusTable(const Profile& wheel, const Profile& rail, double radius, const Hertz& hertz)
      : wheel_(wheel), rail_(rail), radius_(radius), hertz_(hertz) {
    const int pieces = static_cast<int>(std::ceil((rail.max_y() - rail.min_y()) / kTableStep));
    per_step_ = pieces / (rail.max_y() - rail.min_y());
    modulus_.assign(static_cast<size_t>(pieces) + 1, 0);
    shift_.assign(modulus_.size(), 0);
  }

  double per_step() const { return per_step_; }

  /// What touches at the least shift counts.
  void FillTouched() {
    Touch last[2];
    for (double size = 0; size < kMostShift; size += kShiftStep) {
      for (const int way : {0, 1}) {
        const double shift = way == 0 ? size : -size;
        const double y = TouchOf(wheel_, rail_, shift);
        const Touch now{y + shift, ModulusOf(y + shift, y), shift};
        const bool near = std::abs(now.rail_y - last[way].rail_y) < kJump;
        Fill(near ? last[way] : now, now);
        last[way] = now;
      }
    }
  }

  /// Between touches the wheel lies opposite as it does when it touches on both sides.
  void FillRest() {
    const size_t none = modulus_.size();
    size_t before = none;
    for (size_t i = 0; i <= none; ++i) {
      if (i < none && !(modulus_[i] > 0)) continue;
      const size_t after = i < none ? i : before;
      for (size_t j = before == none ? 0 : before + 1; j < i; ++j) {
        const bool nearer = before == none || (i < none && 2 * j > before + i);
        const double y = rail_.min_y() + static_cast<double>(j) / per_step_;
        modulus_[j] = ModulusOf(y, y - shift_[nearer ? after : before]);
      }
      before = i;
    }
  }

  std::vector<double> EvenedOut() const {
    std::vector<double> arc{0};
    for (size_t i = 0; i + 1 < modulus_.size(); ++i) {
      const double y = rail_.min_y() + (static_cast<double>(i) + 0.5) / per_step_;
      const double slope = rail_.At(y).slope;
      arc.push_back(arc.back() + std::sqrt(1 + slope * slope) / per_step_);
    }
    const std::vector<double> same(modulus_.size(), 1);
    return MeanOverArc(modulus_, arc, same, kEvenedOver, [](double away) { return 1 - away; });
  }

 private:
  struct Touch {
    double rail_y = 1e9, modulus = 0, shift = 0;
  };

  double ModulusOf(double rail_y, double wheel_y) const {
    const Profile::Sample s = wheel_.At(wheel_y);
    const double across = 0.5 * (MeanCurvature(rail_, rail_y) - MeanCurvature(wheel_, wheel_y));
    const double along = 0.5 / ((radius_ + s.z) * std::sqrt(1 + s.slope * s.slope));
    const double b = std::max(across, kFlattestRegion);
    const double energy = 0.4 * hertz_.Stiffness(along, b);  // over depth^2.5
    return std::pow(energy, 1.8) * std::sqrt(b) / kParabolaFourth;
  }

  /// The rail between two touches.
  void Fill(const Touch& a, const Touch& b) {
    const double length = b.rail_y - a.rail_y;
    const auto index = [&](double y) { return std::lround((y - rail_.min_y()) * per_step_); };
    const auto end = static_cast<long>(modulus_.size()) - 1;
    const long from = std::max(0L, index(std::min(a.rail_y, b.rail_y)));
    const long to = std::min(end, index(std::max(a.rail_y, b.rail_y)));
    for (long k = from; k <= to; ++k) {
      double& modulus = modulus_[static_cast<size_t>(k)];
      if (modulus > 0) continue;
      const double y = rail_.min_y() + static_cast<double>(k) / per_step_;
      const double share = length == 0 ? 1 : std::clamp((y - a.rail_y) / length, 0.0, 1.0);
      modulus = a.modulus + share * (b.modulus - a.modulus);
      shift_[static_cast<size_t>(k)] = b.shift;
    }
  }

  const Profile& wheel_;
  const Profile& rail_;
  double radius_;
  const Hertz& hertz_;
  double per_step_;
  std::vector<double> modulus_, shift_;
};

}  // namespace

ContactModulus::ContactModulus(const Profile& wheel, const Profile& rail, double radius,
                               const Hertz& hertz)
    : begin_(rail.min_y()) {
  ModulusTable table(wheel, rail, radius, hertz);
  table.FillTouched();
  table.FillRest();
  modulus_ = table.EvenedOut();
  per_step_ = table.per_step();
  last_ = static_cast<double>(modulus_.size() - 1) - 1e-9;
}

}  // namespace phs::rail
