// Bounds of a PHS that tell which steps in time it stands.
#include <algorithm>
#include <cmath>

#include "hydraulics/phs_system_impl.h"

namespace phs::hydraulics {

double PhsSystem::max_stiffness() const {
  double most = 0;
  for (const CompiledCylinder& c : impl_->cylinders) {
    double k = c.friction.stiffness() + c.stop.stiffness_N_per_m;
    auto chamber = [&](int node, double area) {
      if (node == kOpen) return 0.0;
      const Node& at = impl_->nodes[node];
      // Gas on its stop: the oil alone carries, at the stiffest pressure it may see.
      return area * area * at.oil.At(5e7) / at.oil_volume;
    };
    k += chamber(c.bore, c.bore_area) + chamber(c.rod, c.rod_area);
    most = std::max(most, k);
  }
  return most;
}

double PhsSystem::max_line_frequency() const {
  double most = 0;
  for (const Path& path : impl_->paths) {
    if (path.flow < 0) continue;
    double stiffness = 0;  // [Pa/m3]
    for (int end : {path.from, path.to}) {
      if (end == kOpen) continue;
      const Node& node = impl_->nodes[end];
      stiffness += node.oil.modulus / node.oil_volume;
    }
    const double inertance = path.law->Inertance();
    double resistance;
    path.law->Drop({}, 0, &resistance);
    const double decay = 0.5 * resistance / inertance;
    most = std::max(most, std::sqrt(std::max(0.0, stiffness / inertance - decay * decay)));
  }
  return most;
}

double PhsSystem::max_damping() const {
  double most = 0;
  for (const CompiledCylinder& c : impl_->cylinders) {
    most = std::max(most, c.friction.MaxDamping() + c.stop.damping_Ns_per_m);
  }
  return most;
}

}  // namespace phs::hydraulics
