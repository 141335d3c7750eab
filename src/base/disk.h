// What happens between a program and its disk: errors that are the disk's and not the input's, and
// the calls that make sure that something is on it.
#pragma once

#include <string>

#include "base/result.h"

namespace phs {

/// A file or folder that could not be written, for the reason `code` of errno. A disk that is full
/// or that fails says so (IsDiskFault); anything else is a place that cannot be written.
Error WriteFault(const std::string& path, int code);
/// The same for reading.
Error ReadFault(const std::string& path, int code);
/// True where the disk is full or fails: the input may be right, and a repetition may work.
bool IsDiskFault(const Error& error);

/// Waits until a folder's entries are on the disk, after something was made, renamed or removed in
/// it. "" is the current one. File systems that know no such call are taken as they are.
Status SyncFolder(const std::string& path);
/// The same for all files and folders in `path` and for itself.
Status SyncTree(const std::string& path);

/// Writes a text file aside, waits until it is on the disk and renames it (a pipe or device is
/// written directly).
Status WriteFileAtomically(const std::string& path, const std::string& text);
/// Writes a text file in its place, for files that nobody needs after a crash.
Status WritePassingFile(const std::string& path, const std::string& text);

/// True for a name that may become a file or folder of a result: it cannot lead out of it.
bool IsFileName(const std::string& name);
inline constexpr char kFileNames[] = "letters, digits, '_', '-', '.' (not first), at most 100";

/// "HOST.PID.COUNT": no two writers of one file share it, on one machine or on a shared disk.
std::string WriterName();
/// The first part of it.
std::string HostName();

}  // namespace phs
