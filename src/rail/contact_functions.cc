#include "rail/contact_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/rising_root.h"
#include "rail/height_under_load.h"

namespace phs::rail {
namespace {

constexpr double kMostWheelsetRoll = 0.06;  ///< [rad]
constexpr double kRollStep = 0.1e-3;        ///< the first step from the roll beside [rad]
constexpr double kAmplitudeStep = 0.5e-3;
constexpr double kLeastAmplitude = 1e-3;
constexpr double kTurnStep = 0.05e-3;  ///< the first step to the turning point of an amplitude [m]
constexpr int kPhases = 2000;
constexpr double kDeepest = 4e-3;  ///< of an elastic contact [m]

/// A wheel sunk into its rail until it carries `load`; means over the patches.
TouchPoint Pressed(const WheelRail& pair, double lateral, double roll, double load) {
  TouchPoint point = pair.Touch(lateral, roll, 0);
  if (!point.found) return point;
  WheelsetMotion motion;
  motion.lateral = lateral;
  motion.roll = roll;
  motion.speed = 1;
  motion.velocity = {1, 0, 0};
  WheelRailForces f;
  const WheelUnderLoad under{
      .load = load, .carried = ElasticVerticalForce, .near = point.height, .reach = kDeepest};
  if (!FindHeightUnderLoad(pair, under, &motion, &f)) return {};
  point = {true, motion.vertical, 0, 0, 0, 0};
  double sum = 0;
  for (int k = 0; k < f.count; ++k) sum += f.patch[static_cast<size_t>(k)].normal;
  for (int k = 0; k < f.count; ++k) {
    const ContactPatch& patch = f.patch[static_cast<size_t>(k)];
    const double share = patch.normal / sum;
    point.rail_y += share * patch.rail_y;
    point.wheel_y += share * patch.wheel_y;
    point.angle += share * patch.angle;
    point.radius += share * patch.rolling_radius;
  }
  return point;
}

TouchPoint Placed(const WheelRail& pair, double lateral, double roll, double load) {
  return load > 0 ? Pressed(pair, lateral, roll, load) : pair.Touch(lateral, roll, 0);
}

/// C of a right wheel has the axes used here; a left wheel's is its mirror image. Near a flange up to
/// three rolls let both wheels touch; wanted is the one nearest to `near`.
std::optional<ContactFunctionRow> RowAt(const WheelRail& left, const WheelRail& right, double y,
                                        double load, double near) {
  ContactFunctionRow row;
  row.y = y;
  const auto place = [&](double roll) {
    row.roll = roll;
    row.right = Placed(right, y, roll, load);
    row.left = Placed(left, -y, -roll, load);
    return row.right.found && row.left.found;
  };
  // The right wheel sinks with the roll, so it touches at a lesser height.
  const auto difference = [&](double roll) {
    return place(roll) ? row.left.height - row.right.height : std::nan("");
  };
  const auto roll = RisingRoot(difference, {near, kRollStep, kMostWheelsetRoll, 1e-12});
  if (!roll || !place(*roll)) return std::nullopt;
  row.height = 0.5 * (row.right.height + row.left.height);
  return row;
}

/// Dr between the rows, and its integral from the first row.
class RadiusCurve {
 public:
  explicit RadiusCurve(const std::vector<ContactFunctionRow>& rows) : rows_(rows) {
    sum_.push_back(0);
    for (size_t i = 1; i < rows.size(); ++i) {
      sum_.push_back(sum_.back() + 0.5 * (rows[i].y - rows[i - 1].y) * (At(i) + At(i - 1)));
    }
  }
  double Integral(double y) const {
    const size_t i = Before(y);
    const double t = y - rows_[i].y;
    const double step = rows_[i + 1].y - rows_[i].y;
    return sum_[i] + t * (At(i) + 0.5 * t * (At(i + 1) - At(i)) / step);
  }
  double begin() const { return rows_.front().y; }
  double end() const { return rows_.back().y; }

 private:
  double At(size_t i) const { return rows_[i].RadiusDifference(); }
  size_t Before(double y) const {
    const auto after = std::upper_bound(rows_.begin(), rows_.end(), y,
                                        [](double at, const auto& row) { return at < row.y; });
    return std::clamp<size_t>(static_cast<size_t>(after - rows_.begin()), 1, rows_.size() - 1) - 1;
  }
  const std::vector<ContactFunctionRow>& rows_;
  std::vector<double> sum_;
};

/// The crossing of Dr = 0 nearest to the middle.
std::optional<double> CentreOf(const std::vector<ContactFunctionRow>& rows) {
  std::optional<double> nearest;
  for (size_t i = 1; i < rows.size(); ++i) {
    const double a = rows[i - 1].RadiusDifference();
    const double b = rows[i].RadiusDifference();
    if (!(a < 0 && b >= 0)) continue;
    const double y = rows[i - 1].y - a * (rows[i].y - rows[i - 1].y) / (b - a);
    if (!nearest || std::abs(y) < std::abs(*nearest)) nearest = y;
  }
  return nearest;
}

/// Turning point on the left that belongs to the one on the right: the same integral.
std::optional<double> TurningPoint(const RadiusCurve& curve, double centre, double right) {
  const double level = curve.Integral(right);
  double low = curve.begin();
  double high = centre;
  if (curve.Integral(low) < level) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (curve.Integral(middle) > level ? low : high) = middle;
  }
  return high;
}

/// Conicity of the wave between two turning points: y'^2/2 = (V(turn) - V(y))/(e r0), V = int Dr.
double ConicityBetween(const RadiusCurve& curve, double left, double right) {
  const double level = curve.Integral(right);
  const double middle = 0.5 * (left + right);
  const double half = 0.5 * (right - left);
  // y = middle + half sin t takes the root out of the ends.
  double sum = 0;
  for (int i = 0; i < kPhases; ++i) {
    const double t = ((i + 0.5) / kPhases - 0.5) * std::numbers::pi;
    const double rest = level - curve.Integral(middle + half * std::sin(t));
    sum += half * std::cos(t) / std::sqrt(2 * std::max(rest, 1e-18));
  }
  // Half a wave is sqrt(e r0) times the integral, so e r0 leaves the conicity.
  const double half_wave = sum * std::numbers::pi / kPhases;
  return 0.5 * std::pow(std::numbers::pi / half_wave, 2);
}

}  // namespace

Result<ContactFunctions> CalcContactFunctions(const WheelRail& left, const WheelRail& right,
                                              double reach, double step, double load) {
  ContactFunctions out;
  const int count = static_cast<int>(std::floor(reach / step + 1e-9));
  const auto middle = RowAt(left, right, 0, load, 0);
  if (middle) out.rows.push_back(*middle);
  // Outwards on either hand, each roll from the one beside.
  for (const int hand : {-1, 1}) {
    for (int i = 1; middle && i <= count; ++i) {
      const ContactFunctionRow& beside = hand < 0 ? out.rows.front() : out.rows.back();
      const auto row = RowAt(left, right, hand * i * step, load, beside.roll);
      if (row) out.rows.insert(hand < 0 ? out.rows.begin() : out.rows.end(), *row);
    }
  }
  const std::string pair = right.params().wheel_profile + " on " + right.params().rail_profile;
  if (!middle || out.rows.size() < 3) {
    return Error{pair, "do not touch near the centre of the track",
                 "profiles that meet at this gauge and flange-back distance", ""};
  }
  for (ContactFunctionRow& row : out.rows) row.height -= middle->height;
  const auto centre = CentreOf(out.rows);
  if (!centre) {
    return Error{pair, "roll straight nowhere: no lateral position has equal radii", "",
                 "check the profiles and their sides"};
  }
  out.centre = *centre;
  const auto base = [](const WheelRail& wheel, const TouchPoint& p) {
    const WheelRailParams& w = wheel.params();
    return w.flange_back_distance / 2 - w.flange_back_position + p.wheel_y;
  };
  out.half_base = 0.5 * (base(left, middle->left) + base(right, middle->right));
  const RadiusCurve curve(out.rows);
  double turn = *centre + kLeastAmplitude;
  for (double amplitude = kLeastAmplitude;; amplitude += kAmplitudeStep) {
    const auto wider = [&](double right) {
      if (!(right > *centre && right < curve.end())) return std::nan("");
      const auto other = TurningPoint(curve, *centre, right);
      return other ? 0.5 * (right - *other) - amplitude : std::nan("");
    };
    const auto found = RisingRoot(wider, {turn, kTurnStep, curve.end() - 1e-9 - turn, 1e-9});
    if (!found) break;
    turn = *found;
    out.conicity.push_back(
        {amplitude, ConicityBetween(curve, *TurningPoint(curve, *centre, turn), turn)});
  }
  return out;
}

}  // namespace phs::rail
