// phs report: the HTML of a result directory made anew, without simulating.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/verb_table.h"
#include "report/curving_report.h"
#include "report/radius_report.h"

namespace phs::cli {

void AddReport(CLI::App* verb, Action* action) {
  auto dir = std::make_shared<std::string>();
  verb->add_option("dir", *dir, "Result directory")->required();
  verb->callback([=] {
    *action = [=]() -> int {
      const std::string file = *dir + "/report.html";
      const std::string bogies = *dir + "/bogies.json";
      const Status s = std::filesystem::exists(bogies) ? report::WriteRadiusReport(bogies, file)
                                                       : report::WriteCurvingReport(*dir, file);
      if (!s.ok()) return BadInput(s.error());
      fmt::print("Report: {}\n", file);
      return kDone;
    };
  });
}

}  // namespace phs::cli
