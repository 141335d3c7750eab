// Where displacement sensors count from. A rig's model begins in the static state with its pistons at
// zero; a sensor may have its zero elsewhere (an LVDT at the middle of its stroke). The pressures and
// forces tell: where they begin as at zero, and not as where the sensor says that the piston stands,
// the sensor counts from elsewhere.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"
#include "measurement/rig_data.h"

namespace phs::measurement {

/// Outputs of the model as it stands [channel][sample], with the driving positions less `zeros` [m].
using PredictFrom =
    std::function<Result<std::vector<std::vector<double>>>(const std::vector<double>& zeros)>;

/// A channel at the beginning of a record.
struct BeginningChannel {
  std::string name;
  double at = 0;     ///< first value that is there
  double swing = 0;  ///< standard deviation over the record
};
BeginningChannel BeginningOf(const std::string& name, const std::vector<double>& values);

/// What the driving positions and the measured pistons are to be counted from, in the order of
/// `inputs` and `outputs`; all 0: as they are. `least_m`: of each input, less is no zero elsewhere.
/// A piston's sensor that stands more than a millimetre, and a twentieth of its swing, off what the
/// model says is counted from there.
struct ZeroPositions {
  std::vector<double> inputs, outputs;
  bool any() const;
};
ZeroPositions FindZeroPositions(const std::vector<BeginningChannel>& inputs,
                                const std::vector<double>& least_m,
                                const std::vector<BeginningChannel>& outputs,
                                const PredictFrom& predict);

/// Said of each that is counted from elsewhere.
void NameZeros(const std::vector<BeginningChannel>& channels, const std::vector<double>& zeros,
               std::vector<DataFinding>* findings);

}  // namespace phs::measurement
