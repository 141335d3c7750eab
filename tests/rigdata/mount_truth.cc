#include "mount_truth.h"

#include <cmath>
#include <cstddef>

namespace rigdata {

double MountTruth::Force(const MountState& before, double delta, double h,
                         MountState* after) const {
  const double half = 0.5 * params_.gap;
  const double u = delta > half ? delta - half : (delta < -half ? delta + half : 0.0);
  const double k = params_.stiffness;
  double force = 0;
  switch (params_.form) {
    case SpringForm::kLinear:
      force = k * u;
      break;
    case SpringForm::kHardening:
      force = k * u * (1.0 + params_.shape * u * u);
      break;
    case SpringForm::kUnequal:
      force = k * u * (u > 0 ? 1.0 + params_.shape : 1.0);
      break;
    case SpringForm::kContact:
      // Hertzian power 3/2, stiffness k at 20 µm of approach.
      force = k * u * std::sqrt(std::abs(u) / 20e-6) / 1.5;
      break;
  }
  *after = before;
  for (size_t i = 0; i < params_.branches.size(); ++i) {
    const MaxwellBranch& b = params_.branches[i];
    const double y = (before.creep[i] + h / b.tau * u) / (1.0 + h / b.tau);
    after->creep[i] = y;
    force += b.share * k * (u - y);
  }
  return force;
}

}  // namespace rigdata
