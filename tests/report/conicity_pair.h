// `conicity` of results as the reports read it, with one curve from 1 mm in steps of 0.5 mm.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace phs::report::testing {

inline nlohmann::ordered_json Pair(double gauge_m, const std::vector<double>& values,
                                   double load_N = 0) {
  nlohmann::ordered_json curve = {{"wheel_load_N", load_N},
                                  {"amplitude_m", nlohmann::ordered_json::array()},
                                  {"equivalent", values}};
  for (size_t i = 0; i < values.size(); ++i) curve["amplitude_m"].push_back(1e-3 + 0.5e-3 * i);
  return {{"wheel", "S1002.prw"},           {"worn_depth_m", 0.0},    {"rail", "UIC60.prr"},
          {"rail_inclination_rad", 0.025},  {"gauge_m", gauge_m},     {"gauge_depth_m", 0.014},
          {"flange_back_distance_m", 1.36}, {"wheel_radius_m", 0.46}, {"curves", {curve}}};
}

}  // namespace phs::report::testing
