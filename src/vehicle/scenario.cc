#include "vehicle/scenario.h"

#include <filesystem>

namespace phs::vehicle {

void UseBogie(const std::string& asked, Scenario* scenario) {
  const size_t at = asked.find('@');
  scenario->bogie = asked.substr(0, at);
  if (at != std::string::npos) scenario->phs = asked.substr(at + 1);
}

std::string BogieLabel(const std::string& asked) {
  Scenario own;
  UseBogie(asked, &own);
  const std::filesystem::path bogie(own.bogie), phs(own.phs);
  const std::string name = bogie.extension() == ".xml" ? bogie.stem().string() : own.bogie;
  return own.phs.empty() ? name : name + "@" + phs.stem().string();
}

}  // namespace phs::vehicle
