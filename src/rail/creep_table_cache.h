// The creep table of a run: from this process, from disk, or built (about half a second).
//
// On disk it lies in $XDG_CACHE_HOME/phs, else $HOME/.cache/phs, one file per grid and bound. The
// file starts with a format version, the grid and a checksum; after reading, some entries
// are calculated anew and compared. A file that is missing, stale, damaged or unreadable is built
// anew without a word; a folder that cannot be written is left alone. Files are written aside and
// renamed, so several processes may start at once.
#pragma once

#include <memory>
#include <string>

#include "rail/creep_table.h"

namespace phs::rail {

/// Folder of cached tables; empty when neither variable is set.
std::string CreepCacheFolder();

/// Reads the table of `params` from a folder; empty when there is none that can be trusted.
CreepTable ReadCreepTable(const std::string& folder, const FastsimParams& params);
/// Writes it; false when that fails.
bool WriteCreepTable(const std::string& folder, const FastsimParams& params,
                     const CreepTable& table);

/// The table of `params`, shared by all laws of this process.
std::shared_ptr<const CreepTable> SharedCreepTable(const FastsimParams& params,
                                                   bool use_disk_cache);

}  // namespace phs::rail
