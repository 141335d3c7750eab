#include "identify/fit/form_starts.h"

#include <cmath>

namespace phs::identify::search {

using hydraulics::FormNumber;
using hydraulics::Walk;

std::vector<double> Between(double from, double to, int count) {
  std::vector<double> out = {from};
  for (int k = 1; k < count; ++k) {
    const double part = static_cast<double>(k) / (count - 1);
    out.push_back(from > 0 && to > 0 ? from * std::pow(to / from, part)
                                     : from + part * (to - from));
  }
  return out;
}

namespace {

std::vector<double> ValuesOf(const FormNumber& number, const NumberScale& scale) {
  std::vector<double> out;
  for (const double x : Between(number.from, number.to, number.count)) {
    if (number.walk != Walk::kEitherWay) {
      out.push_back(x * scale.unit);
      continue;
    }
    const double way = scale.of_nothing ? x * scale.nothing : x * scale.unit;
    out.push_back(scale.nothing - way), out.push_back(scale.nothing + way);
  }
  return out;
}

}  // namespace

std::vector<std::vector<double>> GridOf(const std::vector<FormNumber>& numbers,
                                        const std::vector<NumberScale>& scale) {
  struct Start {
    std::vector<double> values;
    size_t step = 0;  ///< of the last number that others go in step with
  };
  std::vector<Start> starts = {{}};
  for (size_t k = 0; k < numbers.size(); ++k) {
    const FormNumber& number = numbers[k];
    const std::vector<double> values = ValuesOf(number, scale[k]);
    std::vector<Start> longer;
    for (const Start& start : starts) {
      const bool in_step = number.walk == Walk::kInStep;
      for (size_t i = 0; i < values.size(); ++i) {
        if (in_step && i != start.step) continue;
        Start next = start;
        next.values.push_back(values[i]);
        if (!in_step) next.step = number.walk == Walk::kEitherWay ? i / 2 : i;
        longer.push_back(std::move(next));
      }
    }
    starts = std::move(longer);
  }
  std::vector<std::vector<double>> out;
  out.reserve(starts.size());
  for (Start& start : starts) out.push_back(std::move(start.values));
  return out;
}

}  // namespace phs::identify::search
