// phs report: the HTML of a result directory made anew, without simulating; or a page of all results
// below a folder.
#include <fmt/format.h>

#include <memory>

#include "cli/verb_table.h"
#include "film/film.h"
#include "report/index_report.h"
#include "report/page_links.h"
#include "report/result_summary.h"

namespace phs::cli {
namespace {

struct ReportOptions {
  std::string dir;
  bool index = false;
};

int Remake(const std::string& dir) {
  if (const Status s = report::RemakeReport(dir, &film::FilmOrReason); !s.ok())
    return BadInput(s.error());
  fmt::print("Report: {}/{}\n", dir, report::kReportName);
  return kDone;
}

int MakeIndex(const std::string& dir) {
  const auto written = report::WriteIndex(dir);
  if (!written.ok()) return BadInput(written.error());
  const report::IndexWritten& index = written.value();
  fmt::print("Index: {} ({} results, {} with a report)\n", index.page, index.results,
             index.reports);
  if (index.older > 0) {
    fmt::print("{} reports of older versions keep no links: phs report DIR draws them again\n",
               index.older);
  }
  return kDone;
}

}  // namespace

void AddReport(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ReportOptions>();
  verb->add_option("dir", options->dir, "Result directory; with --index a folder of results")
      ->required();
  verb->add_flag("--index", options->index,
                 "Write index.html into the folder: all results below it, with links");
  verb->callback([=] {
    *action = [=]() -> int {
      return options->index ? MakeIndex(options->dir) : Remake(options->dir);
    };
  });
}

}  // namespace phs::cli
