// Where a result comes from: program, command, date, and the input files with their digests.
//
// While an OriginNotes lives, every reader of an input file notes what it has read (NoteInput); at
// the end WriteOrigin puts that into the result as origin.json. Results are told apart by it, and
// it is the only file of a result, with the page that shows it, that holds a date.
// Noted are YAML, CSV, MAT, MJCF with its includes, URDF, profiles and contact inputs; not meshes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace phs {

inline constexpr char kOriginFile[] = "origin.json";

struct InputFile {
  std::string path;    ///< as it was asked for
  std::string sha256;  ///< of the bytes that were read
};

struct Origin {
  std::string program;  ///< "phs 1.2.3"
  std::string command;  ///< as a shell takes it
  std::string date;     ///< "2026-11-23T17:00:00Z": when the program began
  std::vector<InputFile> inputs;
};

/// From its making on, the inputs read by any thread are noted; only one lives at a time. The date
/// is now, or that of SOURCE_DATE_EPOCH in the environment (seconds since 1970, as build tools take
/// it), so that a result can be made again to the last byte.
class OriginNotes {
 public:
  OriginNotes(std::string program, std::string command);
  ~OriginNotes();
  OriginNotes(const OriginNotes&) = delete;
  OriginNotes& operator=(const OriginNotes&) = delete;
};

/// Notes a file that was read, and its bytes; nothing while nobody takes notes.
void NoteInput(const std::string& path, std::string_view bytes);
/// The same for a file that a library reads.
void NoteInput(const std::string& path);

/// What is noted so far, files of results being written left out, sorted by path; empty while
/// nobody takes notes.
std::optional<Origin> NotedOrigin();

/// Writes what is noted as origin.json into a folder; nothing while nobody takes notes.
Status WriteOrigin(const std::string& folder);
/// Reads it again; empty where there is none or it has another form.
std::optional<Origin> ReadOrigin(const std::string& folder);

/// Arguments as one line that a shell would take apart again the same way.
std::string ShellLine(const std::vector<std::string>& arguments);
/// "2026-11-23T17:00:00Z" of seconds since 1970.
std::string UtcText(long long seconds);

}  // namespace phs
