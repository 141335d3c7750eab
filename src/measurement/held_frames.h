// A channel that holds its last value now and then, as a radio link or a bus does that loses frames,
// and then jumps to where it would have been. With noise added behind the link no two samples are
// alike (MarkStuck then sees nothing), and a flat stretch alone may be true: a play, a vapour
// pressure. The jump is not: what a model says of the stretch comes at once, in one sample.
#pragma once

#include <vector>

#include "measurement/fit_data.h"

namespace phs::measurement {

/// Samples [begin, end) in which a channel holds its value.
struct HeldStretch {
  size_t begin = 0, end = 0;
};

/// Stretches of four samples or more within eight noise levels, with no more than 1.6 of them as
/// deviation, over which `predicted` moves by more than ten, ended by a jump of more than ten that is
/// half to twice what `predicted` moved, and three times what it moves within three samples of it.
std::vector<HeldStretch> FindHeld(const MeasuredChannel& channel,
                                  const std::vector<double>& predicted);

/// Leaves out of every output what it held, where that came three times or more, and says so.
/// `predicted`: by the declared model.
void LeaveOutHeld(const std::vector<std::vector<double>>& predicted, FitData* data);

}  // namespace phs::measurement
