// phs oil: the hydraulic oil over temperature.
#include <fmt/format.h>

#include <memory>

#include "cli/verb_table.h"
#include "hydraulics/oil.h"

namespace phs::cli {

void AddOil(CLI::App* verb, Action* action) {
  auto celsius = std::make_shared<std::vector<double>>(std::vector<double>{-20, 0, 20, 40, 60});
  verb->add_option("--temperature", *celsius, "In °C")
      ->delimiter(',')
      ->check(CLI::Range(-20, 100))
      ->capture_default_str();
  verb->callback([=] {
    *action = [=]() -> int {
      fmt::print("temperature_C,viscosity_mm2_s,density_kg_m3\n");
      for (const double t : *celsius) {
        fmt::print("{:g},{:.2f},{:.2f}\n", t, 1e6 * hydraulics::CalcKinematicViscosity(t + 273.15),
                   hydraulics::CalcDensity(t + 273.15));
      }
      return kDone;
    };
  });
}

}  // namespace phs::cli
