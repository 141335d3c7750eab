#include "cli/number_within.h"

#include <fmt/format.h>

#include "base/numbers.h"

namespace phs::cli {

CLI::Validator NumberWithin(double low, double high) {
  const std::string allowed = fmt::format("{:g} … {:g}", low, high);
  return CLI::Validator(
      [=](std::string& text) {
        const auto number = ParseNumber(text);
        const bool within = number && *number >= low && *number <= high;
        return within ? std::string() : "is " + text + "; allowed: " + allowed;
      },
      allowed);
}

}  // namespace phs::cli
