// HDF5 time series.
#include "base/hdf5_series.h"
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  phs::fuzz::ExpectValueOrLine(
      phs::ReadSeries(phs::fuzz::InputFile(phs::fuzz::Text(data, size), ".h5")));
  return 0;
}
