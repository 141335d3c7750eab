#include "identify/run/input_unit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "measurement/data_checks.h"
#include "measurement/units.h"

namespace phs::identify::search {

using measurement::FitData;

void MendInputUnit(
    const std::function<Result<std::vector<std::vector<double>>>(const FitData&)>& predict,
    FitData* data, std::vector<std::vector<double>>* predicted) {
  const double kOff = std::log(5.0), kFits = std::log(2.5);
  double least = measurement::SwingsOff(*data, *predicted);
  if (least < kOff) return;
  const FitData as_read = *data;
  for (const measurement::Unit& unit : measurement::KnownUnits()) {
    if (unit.si != std::string("_m")) continue;
    FitData other = as_read;
    measurement::ScaleInputs(unit.factor / as_read.input_unit_m, &other);
    auto then = predict(other);
    if (!then.ok()) continue;  // a motion that no model can follow
    const double off = measurement::SwingsOff(other, then.value());
    if (off > kFits || off >= least) continue;
    least = off;
    for (const auto& input : other.inputs) {
      std::erase_if(other.findings, [&](const auto& f) {
        return f.channel == input.name && f.text.find("taken in units of") != std::string::npos;
      });
      other.findings.push_back(
          {input.name, "every output swings otherwise than the model: taken in " + unit.name()});
    }
    *data = std::move(other), *predicted = std::move(then.value());
  }
}

}  // namespace phs::identify::search
