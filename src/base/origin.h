// Where a result comes from: program, command, date, and the input files with their digests.
//
// While an OriginNotes lives, every reader of an input file notes what it has read (NoteInput); at
// the end WriteOrigin puts that into the result as origin.json. Results are told apart by it, and
// it is the only file of a result, with the page that shows it, that holds a date.
// Several may live at once, each for a work of its own: a thread takes notes for its own (that it
// made, or took part in by an OriginShare), any other thread for all of them.
// Noted are YAML, CSV, MAT, MJCF with its includes, URDF, profiles and contact inputs; not meshes.
#pragma once

#include <memory>
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

/// From its making on, the inputs read are noted, until it goes; of several of one thread the last counts. The date
/// is now, or that of SOURCE_DATE_EPOCH in the environment (seconds since 1970, as build tools take
/// it), so that a result can be made again to the last byte. Files in `given_folder` were made for
/// this work from what the caller handed over: they are named "given: FILE".
class OriginNotes {
 public:
  OriginNotes(std::string program, std::string command, std::string given_folder = "");
  ~OriginNotes();
  OriginNotes(const OriginNotes&) = delete;
  OriginNotes& operator=(const OriginNotes&) = delete;
  struct Notes;

 private:
  std::shared_ptr<Notes> notes_, before_;
};

/// The notes of one thread, so that another that works for it takes part:
///   const OriginShare share;  // here
///   std::thread([&] { const OriginShare::Part part(share); … })
class OriginShare {
 public:
  OriginShare();
  class Part {
   public:
    explicit Part(const OriginShare& share);
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    std::shared_ptr<OriginNotes::Notes> before_;
  };

 private:
  std::shared_ptr<OriginNotes::Notes> notes_;
};

/// Notes a file that was read, and its bytes; nothing while nobody takes notes.
void NoteInput(const std::string& path, std::string_view bytes);
/// The same for a file that a library reads.
void NoteInput(const std::string& path);

/// What is noted so far for this thread's work (of a thread without one: for the only work there
/// is), files of results being written left out, sorted by path; empty while nobody takes notes.
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
