// Texts and numbers as a page shows them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "report/report_page.h"

namespace phs::report {
namespace {

/// "2.0e-04" as "2.0·10⁻⁴".
std::string PowerOfTen(const std::string& text) {
  static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t at = text.find('e');
  const int power = std::stoi(text.substr(at + 1));
  std::string raised = power < 0 ? "⁻" : "";
  for (char digit : std::to_string(std::abs(power))) raised += kRaised[digit - '0'];
  return text.substr(0, at) + "·10" + raised;
}

}  // namespace

std::string EscapeHtml(const std::string& text) {
  std::string safe;
  safe.reserve(text.size());
  for (char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string FormatNumber(double value, int significant) {
  if (!std::isfinite(value)) return "–";
  if (value == 0) return "0";
  const double size = std::abs(value);
  char buffer[40];
  if (size < 1e-3 || size >= 1e6) {
    std::snprintf(buffer, sizeof buffer, "%.*e", significant - 1, size);
    return (value < 0 ? "−" : "") + PowerOfTen(buffer);
  } else {
    // The decimals that leave `significant` digits after rounding (9.996 → 10.0 with three).
    const double rounded_up = size * (1 + 0.5 * std::pow(10.0, -significant));
    const int decimals = significant - 1 - static_cast<int>(std::floor(std::log10(rounded_up)));
    std::snprintf(buffer, sizeof buffer, "%.*f", std::max(0, decimals), size);
  }
  return (value < 0 ? "−" : "") + std::string(buffer);
}

}  // namespace phs::report
