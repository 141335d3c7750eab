#include "hydraulics/mount.h"

#include <utility>

namespace phs::hydraulics {
namespace {

constexpr double kContactStiffness = 2e9;  // [N/m] of a mounting that only has play

}  // namespace

Mount::Mount(MountLaws laws) : laws_(std::move(laws)) {
  for (const auto& law : laws_) {
    const Play play = law->FreePlay();
    play_.total += play.total, play_.tension += play.tension;
    if (const double k = law->Stiffness(); k > 0) {
      stiffness_ = stiffness_ > 0 ? 1 / (1 / stiffness_ + 1 / k) : k;
    }
    for (MaxwellBranch& branch : law->Branches()) branches_.push_back(std::move(branch));
  }
  if (stiffness_ <= 0) stiffness_ = kContactStiffness;
}

Stiffening Mount::Stiffen(double e) const {
  Stiffening all;
  bool bent = false;
  for (const auto& law : laws_) {
    const Stiffening one = law->Stiffen(e);
    all.side *= one.side;
    if (one.factor == 1 && one.slope == 1) continue;
    if (bent && one.factor <= all.factor) continue;
    all.factor = one.factor, all.slope = one.slope, bent = true;
  }
  return all;
}

double Mount::SpringForce(double e, double* slope) const {
  const Stiffening at = Stiffen(e);
  const double k = stiffness_ * at.side;
  *slope = k * at.slope;
  return k * e * at.factor;
}

double Mount::Force(double u, const double* q, double h, double* slope) const {
  const double e = PlayFree(u);
  double force = SpringForce(e, slope);
  for (size_t b = 0; b < branches_.size(); ++b) {
    const MaxwellBranch& branch = branches_[b];
    const double k = branch.stiffness / (1 + h * branch.stiffness / branch.damping);
    force += k * (e - q[b]);
    *slope += k;
  }
  if (e == 0) *slope = 0;
  return force;
}

double Mount::Energy(double u, const double* q) const {
  // Gauss-Legendre over the way from 0 to e: exact for factors up to e^6.
  constexpr double kPoint[] = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                               0.930568155797026288};
  constexpr double kWeight[] = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                                0.173927422568726929};
  const double e = PlayFree(u);
  double energy = 0, slope;
  for (int i = 0; i < 4; ++i) energy += kWeight[i] * e * SpringForce(kPoint[i] * e, &slope);
  for (size_t b = 0; b < branches_.size(); ++b) {
    energy += 0.5 * branches_[b].stiffness * (e - q[b]) * (e - q[b]);
  }
  return energy;
}

double Mount::Loss(double u, const double* q) const {
  const double e = PlayFree(u);
  double lost = 0;
  for (size_t b = 0; b < branches_.size(); ++b) {
    const double force = branches_[b].stiffness * (e - q[b]);
    lost += force * force / branches_[b].damping;
  }
  return lost;
}

void Mount::CalcRates(double u, const double* q, double h, double* rate) const {
  const double e = PlayFree(u);
  for (size_t b = 0; b < branches_.size(); ++b) {
    const double speed = branches_[b].stiffness / branches_[b].damping;
    rate[b] = speed * (e - q[b]) / (1 + h * speed);
  }
}

}  // namespace phs::hydraulics
