#include "plugin/line_elements.h"

#include <algorithm>
#include <iterator>

#include "plugin/dof_chain.h"

namespace phs::plugin {

LineElements::LineElements(const mjModel* m, const std::vector<DeclaredElement>& declared) {
  for (const DeclaredElement& element : declared) {
    Line line{element.kind + "_" + element.name, {element.sites[0], element.sites[1]}, {}};
    const std::vector<int> chain[2] = {DofChain(m, m->site_bodyid[line.site[0]]),
                                       DofChain(m, m->site_bodyid[line.site[1]])};
    // What moves both ends moves them together and leaves the length alone.
    for (int k = 0; k < 2; ++k) {
      std::set_difference(chain[k].begin(), chain[k].end(), chain[1 - k].begin(),
                          chain[1 - k].end(), std::back_inserter(line.dofs[k]));
    }
    lines_.push_back(std::move(line));
  }
}

LineElements::Pose LineElements::PoseOf(const mjData* d, const Line& line) {
  Pose pose;
  mju_sub3(pose.direction, d->site_xpos + 3 * line.site[1], d->site_xpos + 3 * line.site[0]);
  pose.length = mju_norm3(pose.direction);
  for (double& x : pose.direction) x = pose.length > 0 ? x / pose.length : 0;
  return pose;
}

template <typename Visit>
void LineElements::ForEachDof(const mjModel* m, const mjData* d, const Line& line, const Pose& pose,
                              Visit visit) {
  for (int k = 0; k < 2; ++k) {
    const double sign = k == 1 ? 1 : -1;
    const mjtNum* place = d->site_xpos + 3 * line.site[k];
    const int body = m->site_bodyid[line.site[k]];
    mjtNum arm[3], turn[3];
    mju_sub3(arm, place, d->subtree_com + 3 * m->body_rootid[body]);
    mju_cross(turn, arm, pose.direction);
    for (const int dof : line.dofs[k]) {
      const mjtNum* c = d->cdof + 6 * dof;
      visit(dof, sign * (mju_dot3(c, turn) + mju_dot3(c + 3, pose.direction)));
    }
  }
}

double LineElements::Rate(const mjModel* m, const mjData* d, const Line& line, const Pose& pose,
                          const double* speed) {
  double rate = 0;
  ForEachDof(m, d, line, pose, [&](int dof, double moment) { rate += moment * speed[dof]; });
  return rate;
}

std::string LineElements::Name(const mjModel*, int index) const {
  return lines_[static_cast<size_t>(index)].name;
}

ElementState LineElements::StateOf(const mjModel* m, const mjData* d, const double* speed,
                                   int index) const noexcept {
  const Line& line = lines_[static_cast<size_t>(index)];
  const Pose pose = PoseOf(d, line);
  const double rate = Rate(m, d, line, pose, speed);
  return {pose.length, rate,
          Spring(index, pose.length).force + Damper(index, pose.length, rate).force};
}

void LineElements::AddSprings(const mjModel* m, const mjData* d, double* force) const noexcept {
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double along = Spring(i, pose.length).force;
    if (along == 0) continue;
    ForEachDof(m, d, line, pose, [&](int dof, double moment) { force[dof] += moment * along; });
  }
}

void LineElements::AddDampers(const mjModel* m, const mjData* d, const double* speed,
                              double* force) const noexcept {
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double along = Damper(i, pose.length, Rate(m, d, line, pose, speed)).force;
    ForEachDof(m, d, line, pose, [&](int dof, double moment) { force[dof] += moment * along; });
  }
}

void LineElements::AddSlopes(const mjModel* m, const mjData* d, const double* speed, double scale,
                             double* row, StepMatrix* matrix) const noexcept {
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double slope = Damper(i, pose.length, Rate(m, d, line, pose, speed)).slope;
    if (!(slope > 0)) continue;
    std::fill(row, row + m->nv, 0.0);
    ForEachDof(m, d, line, pose, [&](int dof, double moment) { row[dof] = moment; });
    matrix->AddOuter(scale * slope, row);
  }
}

double LineElements::StoredEnergy(const mjModel*, const mjData* d) const noexcept {
  double energy = 0;
  for (int i = 0; i < Count(); ++i) {
    energy += Spring(i, PoseOf(d, lines_[static_cast<size_t>(i)]).length).energy;
  }
  return energy;
}

double LineElements::LostPower(const mjModel* m, const mjData* d,
                               const double* speed) const noexcept {
  double power = 0;
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double rate = Rate(m, d, line, pose, speed);
    power -= Damper(i, pose.length, rate).force * rate;
  }
  return power;
}

void LineElements::AddForceOnDof(const mjModel* m, const mjData* d, const JointState& at, int dof,
                                 double* force) const noexcept {
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double along = StateOf(m, d, at.speed, i).force;
    ForEachDof(m, d, line, pose, [&](int moved, double moment) {
      if (moved == dof) *force += moment * along;
    });
  }
}

void LineElements::AddStiffness(const mjModel* m, const mjData* d, const double* along,
                                double* stiffness) const noexcept {
  for (int i = 0; i < Count(); ++i) {
    const Line& line = lines_[static_cast<size_t>(i)];
    const Pose pose = PoseOf(d, line);
    const double moved = Rate(m, d, line, pose, along);
    *stiffness += Spring(i, pose.length).stiffness * moved * moved;
  }
}

}  // namespace phs::plugin
