#include "hydraulics/warm_filling.h"

#include <cstdio>

#include "hydraulics/node_gases.h"
#include "hydraulics/solve_node.h"

namespace phs::hydraulics {
namespace {

std::string Words(const char* format, double a, double b) {
  char text[120];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

Status Warm(double filled_at, double T, double expansion, LineParams* line) {
  const Node node = [&] {
    Node made = MakeNode(*line, filled_at);
    made.Prepare();
    return made;
  }();
  const double growth = expansion * (T - filled_at);
  const double p = SolveNode(node, node.oil_volume * growth, T, nullptr, nullptr).p;
  double gas = 0;
  for (const NodeGas& g : node.gases) {
    if (g.blow_off) {
      line->accumulator_precharge_Pa *= CalcGasPressure(g.gas, g.gas.reference_volume, T) /
                                        CalcGasPressure(g.gas, g.gas.reference_volume, filled_at);
      continue;
    }
    const double volume = CalcGas(g.gas, p, T).volume;
    if (volume >= g.gas.max_volume) {
      return Error{
          line->name,
          Words("its reservoir is empty of oil at %.5g K (%.3g MPa absolute)", T, p * 1e-6),
          "gas smaller than its shell", "less gas, more oil or a larger reservoir"};
    }
    gas += volume;
  }
  if (!(p >= 1e4 && p <= 1e8)) {
    return Error{line->name,
                 Words("filled at %.5g K it would be at %.3g MPa", filled_at, p * 1e-6) +
                     Words(" absolute at %.5g K", T, 0),
                 "0.01 … 100 MPa absolute",
                 "more gas in its reservoir, or a filling nearer to the temperature"};
  }
  line->static_pressure_Pa = p;
  line->gas_volume_m3 = gas;
  line->oil_volume_m3 *= 1 + growth;
  line->free_air_m3 *= T / filled_at;
  return {};
}

}  // namespace

Result<PhsParams> AtItsTemperature(const PhsParams& stated) {
  if (stated.filled_at_K == 0) return stated;
  PhsParams out = stated;
  for (LineParams& line : out.lines) {
    const double T = line.temperature_K > 0 ? line.temperature_K : stated.temperature_K;
    line.temperature_K = 0;
    if (T == stated.filled_at_K) continue;
    Status s = Warm(stated.filled_at_K, T, stated.oil_expansion_1_per_K, &line);
    if (!s.ok()) return s.error();
  }
  out.filled_at_K = 0;
  return out;
}

}  // namespace phs::hydraulics
