// Tracks: alignment, gauge, irregularities.
#include "one_input.h"
#include "rail/track.h"
#include "rail/track_layout.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string file = phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".yaml");
  const auto layout = phs::rail::ReadTrackLayout(file, false, 0);
  phs::fuzz::ExpectValueOrLine(layout);
  // Long irregularities are allowed, but not worth the time here.
  constexpr double kQuick = 3e6;
  if (layout.ok() && layout.value().irregularity && !layout.value().irregularity->samples &&
      phs::rail::IrregularityWork(layout.value().irregularity->psd) > kQuick) {
    return 0;
  }
  phs::fuzz::ExpectValueOrLine(phs::rail::Track::Load(file));
  return 0;
}
