// Play, elasticity and viscoelastic bushes between actuator and piston.
#include <algorithm>
#include <cmath>

#include "hidden_effect.h"

namespace rigdata {
namespace {

// With several effects in one mount the gap is kept and the softest spring rules.
void MakeElastic(MountParams* mount, double stiffness) {
  mount->stiffness = mount->rigid ? stiffness : std::min(mount->stiffness, stiffness);
  mount->rigid = false;
}

HiddenEffect Backlash(RandomSource& random) {
  const bool hertz = random.Coin();
  const double stiffness = random.LogUniform(5e10, 1.5e11);
  HiddenEffect effect;
  effect.form = hertz ? "gap_hertz_contact" : "gap_stiff_contact";
  effect.smallest = 0.05;
  effect.largest = 12;
  effect.strong_low = 8;
  effect.strong_high = 80;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    MountParams& mount = r->rig.mount;
    if (mount.rigid && hertz) mount.form = SpringForm::kContact;
    MakeElastic(&mount, stiffness);
    mount.gap = 50e-6 * size;
    return {{"gap_m", mount.gap}, {"contact_stiffness_N_m", stiffness}};
  };
  return effect;
}

HiddenEffect MountCompliance(RandomSource& random) {
  constexpr SpringForm kForms[] = {SpringForm::kLinear, SpringForm::kHardening,
                                   SpringForm::kUnequal};
  constexpr const char* kNames[] = {"linear", "hardening", "unequal_push_pull"};
  const int form = random.Integer(3);
  const double unequal = random.Uniform(-0.4, 0.8), hardening = random.Uniform(0.2, 1.0);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.smallest = 0.02;
  effect.largest = 20;
  effect.strong_low = 8;
  effect.strong_high = 150;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    MountParams& mount = r->rig.mount;
    MakeElastic(&mount, 4e8 / size);
    mount.form = kForms[form];
    // Hardening by the drawn share at 40 kN.
    const double travel = 4e4 / mount.stiffness;
    mount.shape = form == 1 ? hardening / (travel * travel) : (form == 2 ? unequal : 0);
    return {{"stiffness_N_m", mount.stiffness}, {"shape", mount.shape}};
  };
  return effect;
}

std::vector<MaxwellBranch> DrawBranches(RandomSource& random, int form) {
  std::vector<MaxwellBranch> branches;
  if (form == 2) {
    // Power-law relaxation ~ t^(−order) by branches one third of a decade apart.
    const double order = random.Uniform(0.25, 0.5), share = random.Uniform(0.3, 0.7);
    for (int i = 0; i < kMaxBranches; ++i) {
      const double tau = 0.03 * std::pow(10.0, 0.5 * i);
      branches.push_back({share * std::pow(tau / 0.3, -order), tau});
    }
    return branches;
  }
  const int count = form == 1 ? 3 : 1;
  for (int i = 0; i < count; ++i) {
    const double low = count == 1 ? 0.15 : 0.05 * std::pow(8.0, i);
    branches.push_back({random.Uniform(0.4, 1.4) / std::sqrt(count),
                        random.LogUniform(low, low * (count == 1 ? 15 : 3))});
  }
  return branches;
}

HiddenEffect ViscoelasticBush(RandomSource& random) {
  constexpr const char* kNames[] = {"one_branch", "three_branches", "power_law",
                                    "hardening_one_branch"};
  const int form = random.Integer(4);
  const std::vector<MaxwellBranch> branches = DrawBranches(random, form);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.smallest = 0.02;
  effect.largest = 20;
  effect.strong_low = 8;
  effect.strong_high = 150;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    MountParams& mount = r->rig.mount;
    MakeElastic(&mount, 3e8 / size);
    mount.branches = branches;
    mount.form = SpringForm::kLinear;
    if (form == 3) {
      mount.form = SpringForm::kHardening;
      const double travel = 4e4 / mount.stiffness;
      mount.shape = 0.6 / (travel * travel);
    }
    NumberList numbers = {{"stiffness_N_m", mount.stiffness}};
    for (size_t i = 0; i < branches.size(); ++i) {
      numbers.push_back({"share_" + std::to_string(i + 1), branches[i].share});
      numbers.push_back({"tau_" + std::to_string(i + 1) + "_s", branches[i].tau});
    }
    return numbers;
  };
  return effect;
}

}  // namespace

HiddenEffect DrawMounting(const std::string& name, RandomSource& random) {
  if (name == "backlash") return Backlash(random);
  if (name == "mount_compliance") return MountCompliance(random);
  if (name == "bush_viscoelastic") return ViscoelasticBush(random);
  return {};
}

}  // namespace rigdata
