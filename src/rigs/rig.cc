#include "rigs/rig.h"

#include "base/words.h"

namespace phs::rigs {

Result<RigKind> ParseRigKind(const std::string& word) {
  static const std::vector<std::string> kKinds = {"cylinder", "quarter", "full", "element"};
  for (size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i] == word) return static_cast<RigKind>(i);
  }
  const std::string nearest = NearestWord(word, kKinds);
  return Error{"rig", "unknown rig \"" + word + "\"", "cylinder, quarter, full, element",
               nearest.empty() ? "" : "did you mean " + nearest + "?"};
}

std::vector<double> DifferentiateMotion(const std::vector<double>& position, double step_s) {
  const size_t n = position.size();
  std::vector<double> speed(n, 0.0);
  if (n < 2) return speed;
  for (size_t i = 1; i + 1 < n; ++i) speed[i] = (position[i + 1] - position[i - 1]) / (2 * step_s);
  speed[0] = (position[1] - position[0]) / step_s;
  speed[n - 1] = (position[n - 1] - position[n - 2]) / step_s;
  return speed;
}

std::vector<double> AccelerationOf(const RigMotion& motion, const std::vector<double>& speed) {
  if (!motion.acceleration_m_s2.empty()) return motion.acceleration_m_s2.front();
  return DifferentiateMotion(speed, motion.step_s);
}

}  // namespace phs::rigs
