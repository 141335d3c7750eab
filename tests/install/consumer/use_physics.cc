// The PHS of a bogie and a creep law, from the installed libraries, headers and data.
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/data_path.h"
#include "hydraulics/phs_system.h"
#include "phs_model/phs_model.h"
#include "rail/creep_law.h"

int main() {
  const auto path = phs::FindData("PHS model", "models/phs", "bo_bo", {".yaml"});
  if (!path.ok()) {
    std::printf("%s\n", path.error().Line().c_str());
    return 1;
  }
  const auto loaded = phs::phs_model::LoadPhsSystem(path.value());
  if (!loaded.ok()) {
    std::printf("%s\n", loaded.error().Line().c_str());
    return 1;
  }
  const phs::hydraulics::PhsSystem& system = loaded.value();
  const size_t cylinders = static_cast<size_t>(system.num_cylinders());
  const std::vector<double> x(cylinders, 1e-4), v(cylinders, 0.0);
  const std::vector<double> state(static_cast<size_t>(system.num_states()), 0.0);
  std::vector<double> force(cylinders);
  phs::hydraulics::PhsOutputs out;
  out.force = force.data();
  system.Calc(0, x.data(), v.data(), state.data(), &out);
  std::printf("data %s\n", path.value().c_str());
  std::printf("cylinders %zu, force of the first %.17g N\n", cylinders, force[0]);
  const auto law = phs::rail::CreateCreepLaw({.method = "polach"});
  return law.ok() && std::isfinite(force[0]) ? 0 : 1;
}
