// Numbers as text: the shortest form that reads back to the same bits, and strict reading.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace phs {

/// Where there is none; written as null.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The shortest text that reads back as exactly `value` ("0.1", "1e-07", "nan", "inf").
std::string Shortest(double value);

/// The finite number that `text` is as a whole, with '.' as decimal mark whatever the locale;
/// nothing for anything else: words, "1,5", "0x10", NaN, infinities, numbers beyond double.
std::optional<double> ParseNumber(std::string_view text);

}  // namespace phs
