// Elements that act along the line between two sites: everything but the law of their force.
//
//   site 0 o---[ F ]---o site 1      l = |p1 - p0|, F > 0 pushes the sites apart
//
// Where the sites meet the line has no direction: no force there.
#pragma once

#include <string>
#include <vector>

#include "plugin/declared_element.h"
#include "plugin/element.h"

namespace phs::plugin {

/// Force of the damper and its slope -dF/dv.
struct DamperForce {
  double force = 0;  ///< [N]
  double slope = 0;  ///< >= 0 [N s/m]
};

class LineElements : public Elements {
 public:
  int Count() const final { return static_cast<int>(lines_.size()); }
  std::string Name(const mjModel* m, int index) const final;
  ElementState StateOf(const mjModel* m, const mjData* d, const double* speed,
                       int index) const noexcept final;
  void AddSprings(const mjModel* m, const mjData* d, double* force) const noexcept final;
  void AddDampers(const mjModel* m, const mjData* d, const double* speed,
                  double* force) const noexcept final;
  void AddSlopes(const mjModel* m, const mjData* d, const double* speed, double scale, double* row,
                 StepMatrix* matrix) const noexcept final;
  double StoredEnergy(const mjModel* m, const mjData* d) const noexcept final;
  double LostPower(const mjModel* m, const mjData* d, const double* speed) const noexcept final;
  void AddForceOnDof(const mjModel* m, const mjData* d, const JointState& at, int dof,
                     double* force) const noexcept final;
  void AddStiffness(const mjModel* m, const mjData* d, const double* along,
                    double* stiffness) const noexcept final;

 protected:
  LineElements(const mjModel* m, const std::vector<DeclaredElement>& declared);
  /// F_s at a length, its stiffness -dF_s/dl and energy; none without override.
  struct SpringForce {
    double force = 0;
    double stiffness = 0;
    double energy = 0;
  };
  virtual SpringForce Spring(int, double) const noexcept { return {}; }
  virtual DamperForce Damper(int index, double length, double speed) const noexcept = 0;

 private:
  struct Line {
    std::string name;
    int site[2];
    std::vector<int> dofs[2];  ///< that move one site and not the other
  };
  /// The line where it stands: length and direction from site 0 to site 1.
  struct Pose {
    double length = 0;
    double direction[3] = {0, 0, 0};
  };
  static Pose PoseOf(const mjData* d, const Line& line);
  /// Calls `visit(dof, dl/dq)`.
  template <typename Visit>
  static void ForEachDof(const mjModel* m, const mjData* d, const Line& line, const Pose& pose,
                         Visit visit);
  static double Rate(const mjModel* m, const mjData* d, const Line& line, const Pose& pose,
                     const double* speed);

  std::vector<Line> lines_;
};

}  // namespace phs::plugin
