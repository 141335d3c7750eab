#include "vehicle/result_files.h"

#include "base/table.h"

namespace phs::vehicle {

Status WriteTimeSeries(const RunOutcome& run, const std::string& path_stem, bool csv) {
  auto writer = SeriesWriter::Create(path_stem + ".h5", run.channels);
  if (!writer.ok()) return writer.error();
  if (Status s = writer.value().Note("status", run.status); !s.ok()) return s;
  std::vector<double> row(run.channels.size());
  const size_t num_rows = run.columns.empty() ? 0 : run.columns[0].size();
  for (size_t i = 0; i < num_rows; ++i) {
    for (size_t k = 0; k < row.size(); ++k) row[k] = run.columns[k][i];
    if (Status s = writer.value().Append(row.data()); !s.ok()) return s;
  }
  if (Status s = writer.value().Close(); !s.ok()) return s;
  if (!csv) return {};
  std::vector<std::string> names;
  for (const Channel& channel : run.channels) names.push_back(channel.name);
  return WriteCsv(path_stem + ".csv", names, run.columns);
}

}  // namespace phs::vehicle
