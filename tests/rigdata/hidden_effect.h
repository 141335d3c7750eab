// What may be hidden in a record: every effect is drawn in one of several physical forms with its
// own secondary numbers, and scaled by one `size`, which the calibration chooses. Size 1 is a
// middling value; `smallest` and `largest` keep it physically plausible.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "random_source.h"
#include "rig_truth.h"
#include "sensor_truth.h"

namespace rigdata {

using NumberList = std::vector<std::pair<std::string, double>>;

// Everything that makes up one true rig with its instruments.
struct TrueRig {
  RigParams rig;
  SensorSet sensors{};
};

struct HiddenEffect {
  std::string name;
  std::string form;
  bool listed = true;       // one of the effects that an identification can name
  bool wants_deep = false;  // needs low pressure on the bore line
  double smallest = 0.02, largest = 20;
  // Size over noise that "strong" aims at. Where the natural size of an effect is far above the
  // noise, the range is high; `largest` then decides.
  double strong_low = 4, strong_high = 20;
  double calibration_step = 1e-3;  // s
  // Puts the effect into the rig and returns its numbers.
  std::function<NumberList(double size, TrueRig* rig)> apply;
};

// All names, the listed ones first.
const std::vector<std::string>& ListedNames();
const std::vector<std::string>& OffListNames();
bool IsKnownEffect(const std::string& name);

// Draws the form and the secondary numbers of the named effect. The name must be known.
HiddenEffect DrawEffect(const std::string& name, RandomSource random);

// One function per family; an effect without `apply` means that the name is of another family.
HiddenEffect DrawHydraulic(const std::string& name, RandomSource& random);
HiddenEffect DrawFriction(const std::string& name, RandomSource& random);
HiddenEffect DrawMounting(const std::string& name, RandomSource& random);
HiddenEffect DrawInstrument(const std::string& name, RandomSource& random);
HiddenEffect DrawOffList(const std::string& name, RandomSource& random);

}  // namespace rigdata
