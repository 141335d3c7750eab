// What an option's number may be.
#pragma once

#include <CLI/CLI.hpp>

namespace phs::cli {

/// A finite number within [low, high]. (CLI::Range lets "nan" pass.)
CLI::Validator NumberWithin(double low, double high);

}  // namespace phs::cli
