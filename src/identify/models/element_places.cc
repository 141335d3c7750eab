#include "identify/models/element_places.h"

#include "identify/models/element_candidates.h"
#include "rigs/element_bench.h"
#include "rigs/rig_model.h"

namespace phs::identify::element {

Result<FormulaPlaces> PlacesOf(const ElementData& data, const hydraulics::PhsParams& params) {
  FormulaPlaces out;
  for (const ElementRecord& r : data.records) {
    Result<rigs::RigModel> rig = BenchOf(params, r);
    if (!rig.ok()) return rig.error();
    const hydraulics::PhsSystem& system = rig.value().system();
    const auto& m = r.motion;
    const size_t n = m.position_m[0].size();
    std::vector<double> force(n);
    rigs::ElementPlaces places;
    rigs::RunElementBench(system, m, m.speed_m_s[0], &force, &places);
    std::vector<hydraulics::ForcePlace>& run = out.emplace_back(n);
    for (size_t i = 0; i < n; ++i) {
      run[i].time = r.Time(static_cast<int>(i));
      run[i].piston = m.position_m[0][i];
      run[i].speed = m.speed_m_s[0][i];
      run[i].direction = places.direction[i];
      if (data.has_pressure) run[i].bore_rise = m.pressure_Pa[i];
      if (data.has_temperature) run[i].temperature = m.temperature_K[i] - params.temperature_K;
    }
  }
  return out;
}

}  // namespace phs::identify::element
