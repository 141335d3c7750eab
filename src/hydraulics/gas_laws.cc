#include "base/check.h"
#include "hydraulics/bwr_gas.h"
#include "hydraulics/gas_law.h"
#include "hydraulics/perfect_gas.h"

namespace phs::hydraulics {

const std::vector<const GasLaw*>& GasLaws() {
  static const std::vector<const GasLaw*> laws = {
      &kIsothermalGas,
      &kPolytropicGas,
      &kIdealGas,
      &kBwrGas,
  };
  return laws;
}

std::vector<std::string> GasLawNames() {
  std::vector<std::string> names;
  for (const GasLaw* law : GasLaws()) names.emplace_back(law->name);
  return names;
}

const GasLaw* FindGasLaw(const std::string& name) {
  for (const GasLaw* law : GasLaws()) {
    if (law->name == name) return law;
  }
  PHS_CHECK(false);
  return nullptr;
}

}  // namespace phs::hydraulics
