// What the numbers say, in words made from the numbers.
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <limits>

#include "base/axle_words.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// "2.4 kN m" of moment.
std::string Moment(double moment) { return FormatNumber(1e-3 * std::abs(moment)) + " kN m"; }

std::string Capital(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

/// "a, b and c".
std::string JoinWords(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

struct Part {
  const char* name;
  double moment;
};

std::vector<Part> PartsOf(const MomentBudget& budget) {
  return {{"the creep forces between wheel and rail", budget.creep},
          {"the oil pressure in the cylinders", budget.phs_pressure},
          {"the seal friction of the cylinders", budget.phs_friction},
          {"the primary suspension with its links", budget.primary},
          {"the rest (inertia)", budget.rest}};
}

/// "a (1 kN m), b (2 kN m) and c (3 kN m)" of the parts that steer (sign 1) or hold back (-1).
std::string ListParts(const MomentBudget& budget, int sign) {
  double total = 0;
  for (const Part& part : PartsOf(budget)) total += std::abs(part.moment);
  std::vector<std::string> words;
  for (const Part& part : PartsOf(budget)) {
    if (part.moment * sign <= 0 || std::abs(part.moment) < 0.01 * total) continue;
    words.push_back(fmt::format("{} ({})", part.name, Moment(part.moment)));
  }
  return words.empty() ? "nothing of weight" : JoinWords(words);
}

std::string DescribeAxle(const BogieRun& run, const CurvingResults& results,
                         const std::string& prefix) {
  const std::string lead = prefix + "lead";
  const double attack = run.Steady("wheelsets", lead, "angle_of_attack_rad");
  std::string text;
  if (std::isfinite(attack)) {
    text = fmt::format(
        "The {}leading axle points {} mrad to the {}{}. ",
        BogieWords(prefix).empty() ? "" : prefix.substr(0, prefix.size() - 1) + " bogie's ",
        FormatNumber(1e3 * std::abs(attack)), RailPointedTo(attack, results.hand),
        results.hand == 0 ? "" : " rail");
  }
  const MomentBudget budget = CalcBudget(run, results, lead);
  if (!budget.known) return text;
  return text +
         fmt::format("Towards the radial direction it is turned by {}; it is held back by {}.",
                     ListParts(budget, 1), ListParts(budget, -1));
}

/// "2.1 times the angle of attack (4.6 instead of 2.2 mrad)".
std::string Compare(const std::string& what, const std::string& unit, double other, double own,
                    double floor) {
  if (!std::isfinite(other) || !std::isfinite(own)) return "";
  const std::string numbers = fmt::format("{} instead of {} {}", FormatNumber(std::abs(other)),
                                          FormatNumber(std::abs(own)), unit);
  const double ratio = std::abs(other / own);
  if (std::abs(own) < floor && std::abs(other) < 2 * floor) {
    return fmt::format("practically no {} either ({})", what, numbers);
  }
  if (std::abs(own) < floor) return fmt::format("{} {}", numbers, what);
  if (ratio > 0.97 && ratio < 1.03) return fmt::format("the same {} within 3 %", what);
  return fmt::format("{} times the {} ({})", FormatNumber(ratio, 2), what, numbers);
}

std::string CompareRuns(const CurvingResults& results, const std::string& prefix,
                        const BogieRun& other) {
  const BogieRun& own = results.reference();
  const auto wear = [&prefix](const BogieRun& run) {
    return CurvingResults::SteadyWear(run, prefix);
  };
  std::vector<std::string> parts;
  for (std::string part :
       {Compare("angle of attack of the leading axle", "mrad",
                1e3 * other.Steady("wheelsets", prefix + "lead", "angle_of_attack_rad"),
                1e3 * own.Steady("wheelsets", prefix + "lead", "angle_of_attack_rad"), 0.1),
        Compare("guiding force on the leading outer wheel", "kN",
                1e-3 * other.Steady("wheels", prefix + "lead_outer", "Y_N"),
                1e-3 * own.Steady("wheels", prefix + "lead_outer", "Y_N"), 0.5),
        Compare("wear number Tγ of its wheels", "N", wear(other), wear(own), 1)}) {
    if (!part.empty()) parts.push_back(std::move(part));
  }
  return JoinWords(parts);
}

/// "−68 %".
std::string SignedPercent(double share) {
  return fmt::format("{}{:.0f} %", share < 0 ? "−" : "+", std::abs(100 * share));
}

/// "creep forces +100 %, oil pressure −51 %, …": parts below 1 % are left out.
std::string SharesText(const MomentBudget& budget) {
  std::string text;
  for (const auto& [name, moment] : {std::pair{"creep forces", budget.creep},
                                     {"oil pressure", budget.phs_pressure},
                                     {"seal friction", budget.phs_friction},
                                     {"primary suspension with its links", budget.primary},
                                     {"rest", budget.rest}}) {
    if (std::abs(moment) < 0.005 * std::abs(budget.creep)) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name,
                        SignedPercent(moment / budget.creep));
  }
  return text;
}

/// Advice that follows from the steering budget of the reference bogie; of a locomotive, from the
/// bogie whose leading axle is offered the larger moment.
void AdviseOnSteering(const CurvingResults& results, std::vector<std::string>* advice) {
  const BogieRun& run = results.reference();
  MomentBudget lead;
  for (const std::string& prefix : results.prefixes) {
    const MomentBudget own = CalcBudget(run, results, prefix + "lead");
    if (own.known && (!lead.known || own.creep > lead.creep)) lead = own;
  }
  if (!lead.known || lead.creep <= 0) return;
  advice->push_back(fmt::format(
      "Who takes the steering moment of the {} bogie's leading axle, as a share of that of the "
      "creep forces (+ steers, − holds back; all add up to 0): {}.",
      run.label, SharesText(lead)));
  const auto share = [&](double moment) { return SignedPercent(moment / lead.creep); };
  if (lead.phs_friction < -0.15 * lead.creep) {
    advice->push_back(fmt::format(
        "Seal friction holds back ({}). Run the same scenario with a PHS model of lower seal "
        "friction to see what better seals would give.",
        share(lead.phs_friction)));
  }
  if (lead.phs_pressure < -0.15 * lead.creep) {
    advice->push_back(fmt::format(
        "Oil pressure holds back ({}): the axles do not bend against each other "
        "alone, so the stiff shear mode of the network is loaded. Look at shear and at the lateral "
        "forces in the transitions.",
        share(lead.phs_pressure)));
  }
  if (lead.primary < -0.3 * lead.creep) {
    advice->push_back(
        fmt::format("The primary suspension with its links holds back ({}): its longitudinal "
                    "stiffness is the first thing to vary.",
                    share(lead.primary)));
  }
}

void AdviseOnLimits(const CurvingResults& results, std::vector<std::string>* advice) {
  for (const BogieRun& run : results.runs) {
    if (!run.ok()) {
      advice->push_back(
          fmt::format("Find out why the {} run ended as '{}'; a lower speed or a "
                      "larger radius tells on which side of the limit it is.",
                      run.label, run.summary.value("status", "?")));
    }
    const double ratio = run.Number("/run/max_Y_over_Q");
    if (ratio > 0.8) {
      advice->push_back(
          fmt::format("Y/Q of the {} bogie reaches {} in the run, above the usual limit of 0.8 (2 "
                      "m mean): look "
                      "at the place in the plot and at the flange contact there.",
                      run.label, FormatNumber(ratio)));
    }
    const double energy = std::abs(run.Number("/run/energy_error_relative"));
    if (energy > 1e-3) {
      advice->push_back(
          fmt::format("The energy balance of the {} run misses {}: repeat it with half "
                      "the time step.",
                      run.label, FormatNumber(energy, 2)));
    }
  }
}

}  // namespace

void AddSteeringWords(const CurvingResults& results, ReportPage* page) {
  for (const BogieRun& run : results.runs) {
    for (const std::string& prefix : results.prefixes) {
      const std::string text = DescribeAxle(run, results, prefix);
      if (!text.empty()) page->Paragraph(text, Capital(run.label) + " bogie.");
    }
  }
  for (std::size_t i = 1; i < results.runs.size(); ++i) {
    std::string text;
    for (const std::string& prefix : results.prefixes) {
      const std::string own = CompareRuns(results, prefix, results.runs[i]);
      if (own.empty()) continue;
      const std::string where =
          prefix.empty() ? "" : " at the " + prefix.substr(0, prefix.size() - 1) + " bogie";
      text += fmt::format("{}{} {}", text.empty() ? "it has" : ";", where, own);
    }
    if (text.empty()) continue;
    text += ".";
    page->Paragraph(text, fmt::format("{} bogie against {} bogie:", Capital(results.runs[i].label),
                                      results.reference().label));
  }
}

void AddNextSteps(const CurvingResults& results, ReportPage* page) {
  std::vector<std::string> advice;
  AdviseOnLimits(results, &advice);
  AdviseOnSteering(results, &advice);
  if (results.radius > 0) {
    advice.push_back(fmt::format(
        "One curve says little about a line: repeat the comparison over radius, speed and friction "
        "(phs sweep), from R = 150 m to straight track; at R = {:.0f} m the answer holds for this "
        "speed and this rail only.",
        results.radius));
  }
  advice.push_back(
      "A bogie that steers well must also run straight: check its critical speed with "
      "phs stability and the axle modes with phs modes.");
  advice.push_back(
      "Where rig data of the hydraulics exist, put the identified model in place of the "
      "declared one (phs identify writes it) and run this comparison again.");
  page->List(advice);
}

}  // namespace phs::report
