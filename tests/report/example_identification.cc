// A made-up identification: a cylinder force with friction and a clearance, a declared model
// without the clearance, a corrected one with it.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "example_results.h"

namespace phs::report::testing {
namespace {

using Json = nlohmann::ordered_json;

struct Signals {
  std::vector<double> t, x, force, bore, force_before, bore_before, force_after;
};

double Force(double x, double v) { return 4.1e6 * x + 1.7e3 * std::tanh(v / 3e-4); }

Signals MakeSignals() {
  Signals s;
  unsigned state = 7;
  const auto noise = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / (1 << 24) - 0.5;
  };
  const double gap = 1.2e-4;
  double piston = 0;
  for (int i = 0; i < 25600; ++i) {
    const double t = 0.005 * i;
    const double x = 6e-3 * std::sin(0.9 * t) + 2e-3 * std::sin(2.3 * t + 1) * std::sin(0.05 * t);
    const double v =
        5.4e-3 * std::cos(0.9 * t) + 4.6e-3 * std::cos(2.3 * t + 1) * std::sin(0.05 * t);
    piston = std::clamp(piston, x - gap / 2, x + gap / 2);
    const double piston_v = std::abs(piston - x) > 0.49 * gap ? v : 0.0;
    s.t.push_back(t);
    s.x.push_back(x);
    s.force.push_back(Force(piston, piston_v) + 60 * noise());
    s.bore.push_back(1.8e6 - 3e8 * piston + 2e3 * noise());
    s.force_before.push_back(Force(x, v));
    s.bore_before.push_back(1.8e6 - 3e8 * x);
    s.force_after.push_back(Force(piston, piston_v));
  }
  return s;
}

Json Scores(double rmse, double nrmse) {
  return {{"rmse", rmse},
          {"nrmse", nrmse},
          {"bias", -0.1 * rmse},
          {"max", 4 * rmse},
          {"m_re_percent", 900 * nrmse},
          {"share_below_12_percent", 0.97}};
}

}  // namespace

void WriteExampleIdentification(const std::string& directory) {
  const Signals s = MakeSignals();
  const std::vector<std::string> names = {"t_s", "actuator_m", "load_cell_N", "p_bore_Pa"};
  const auto write = [&](const char* file, const std::vector<double>& force,
                         const std::vector<double>& bore) {
    PHS_CHECK(WriteCsv(directory + "/" + file, names, {s.t, s.x, force, bore}).ok());
  };
  write("measured.csv", s.force, s.bore);
  write("baseline.csv", s.force_before, s.bore_before);
  write("predicted.csv", s.force_after, s.bore);
  const Json result = {
      {"rig", "quarter"},
      {"declared", "quarter_setup2"},
      {"estimation", {0.0, 79.0}},
      {"validation", {79.0, 128.0}},
      {"verdict", "undecidable"},
      {"verdict_text", "cannot be told from this record: backlash or another"},
      {"reasons", {"Backlash explains no more than mount_compliance"}},
      {"data_findings",
       {{{"channel", "t_s"}, {"text", "3 gaps of 0.1 s"}},
        {{"channel", "load_cell_N"}, {"text", "one spike left out"}}}},
      {"next_test",
       {"backlash against mount_compliance: small slow reversals about zero force with the piston "
        "locked"}},
      {"noise", {{"load_cell_N", 18.0}, {"p_bore_Pa", 600.0}}},
      {"channels",
       {{"load_cell_N", {{"before", Scores(412, 0.031)}, {"after", Scores(21, 0.0016)}}},
        {"p_bore_Pa", {{"before", Scores(1.6e4, 0.012)}, {"after", Scores(620, 0.0005)}}}}},
      {"effects",
       {{{"name", "backlash"},
         {"parameters", {{"gap_m", {{"value", 1.21e-4}, {"low", 1.17e-4}, {"high", 1.25e-4}}}}},
         {"evidence",
          {{"delta_bic", 4210.0}, {"estimation_gain", 0.93}, {"cross_validation_gain", 0.91}}},
         {"confusable_with", {"mount_compliance"}}}}},
      {"candidates",
       {{{"name", "backlash"}, {"delta_bic", 4210.0}, {"verdict", "accepted"}},
        {{"name", "mount_compliance"}, {"delta_bic", 1480.0}, {"verdict", "weaker than backlash"}},
        {{"effects", {"backlash", "stribeck"}}, {"delta_bic", 4203.0}, {"verdict", "no gain"}}}},
      {"localised", {{"channel", "load_cell_N"}, {"depends_on", {"reversal", "x_m"}}}},
      {"unexplained",
       {{"channel", "load_cell_N"},
        {"residual_over_noise", 1.17},
        {"nrmse", 0.0016},
        {"whiteness_p", 0.21},
        {"depends_on", Json::array()},
        {"formula", nullptr}}},
      {"model", "model.yaml"}};
  PHS_CHECK(WriteFileAtomically(directory + "/result.json", result.dump(1)).ok());
}

}  // namespace phs::report::testing
