// The first screen of an identification: the verdict, what was missing, how sure that is, what it
// changed, what to do next, what was found in the data; and two pictures.
#pragma once

#include "report/identify_results.h"
#include "report/report_page.h"

namespace phs::report {

void AddGlance(const IdentifyResults& results, ReportPage* page);

// identify_glance_words.cc

/// The verdict as a sentence, and how it is meant: 0 good, 1 in doubt, 2 bad.
struct VerdictWords {
  std::string sentence;
  int tone = 1;
};
VerdictWords WordsOfVerdict(const IdentifyResults& results);
/// One sentence each.
std::string WhatWasMissing(const IdentifyResults& results);
std::string HowSure(const IdentifyResults& results);
std::string WhatItChanged(const IdentifyResults& results);
std::string WhatNext(const IdentifyResults& results);

// identify_glance_plots.cc

/// Measured, declared and corrected where the declared model errs most; of steps over the step.
void AddWherePicture(const IdentifyResults& results, ReportPage* page);
/// Error of every channel before and after.
void AddChangePicture(const IdentifyResults& results, ReportPage* page);

/// The channel of which the page speaks first: whose likelihood gains most by the strongest effect,
/// or, where nothing was found, which leaves most over its noise; else where the residual of the
/// declared model sits. Empty if no channel has a score.
std::string LeadingChannel(const IdentifyResults& results);

}  // namespace phs::report
