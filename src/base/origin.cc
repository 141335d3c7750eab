#include "base/origin.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "base/disk.h"
#include "base/local_folder.h"
#include "base/numbers.h"
#include "base/sha256.h"

namespace phs {

struct OriginNotes::Notes {
  std::string program, command, date, given_folder;
  std::map<std::string, std::string> inputs;  ///< path → digest
};

namespace {

using Json = nlohmann::ordered_json;

std::mutex mutex;
// Of the process: readers stand in every folder and thread.
std::vector<std::shared_ptr<OriginNotes::Notes>> living;
thread_local std::shared_ptr<OriginNotes::Notes> own;

std::string Now() {
  const char* given = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = given == nullptr ? std::nullopt : ParseNumber(given);
  return UtcText(seconds && *seconds >= 0 && *seconds < 1e11 ? static_cast<long long>(*seconds)
                                                             : std::time(nullptr));
}

/// A file of a result that is just being written (result_dir.h, a sweep's work), or of a folder for
/// a moment: no input.
bool IsOwnWork(const std::string& path) {
  return path.find(".partial.") != std::string::npos ||
         path.find(".unfinished/") != std::string::npos || IsInLocalFolder(path);
}

std::optional<std::string> BytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad()) return std::nullopt;
  return text.str();
}

std::string TextOf(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

OriginNotes::OriginNotes(std::string program, std::string command, std::string given_folder) {
  before_ = own;
  own = notes_ = std::make_shared<Notes>(
      Notes{std::move(program), std::move(command), Now(), std::move(given_folder), {}});
  const std::lock_guard<std::mutex> lock(mutex);
  living.push_back(notes_);
}

OriginNotes::~OriginNotes() {
  if (own == notes_) own = before_;
  const std::lock_guard<std::mutex> lock(mutex);
  std::erase(living, notes_);
}

OriginShare::OriginShare() : notes_(own) {}
OriginShare::Part::Part(const OriginShare& share) : before_(own) { own = share.notes_; }
OriginShare::Part::~Part() { own = before_; }

namespace {

/// Whose work this thread does; all there are for a thread that belongs to none. With the lock.
std::vector<std::shared_ptr<OriginNotes::Notes>> NotesOfThisThread() {
  if (!own) return living;
  return {own};
}

/// False while nobody takes notes of a new file. With the lock.
bool IsNew(const std::string& path) {
  for (const auto& notes : NotesOfThisThread()) {
    if (notes->inputs.count(path) == 0) return true;
  }
  return false;
}

/// How an input is named: files made from what was handed over have no path of their own.
std::string NameOf(const std::string& path, const std::string& given_folder) {
  if (given_folder.empty() || !path.starts_with(given_folder + "/")) return path;
  return "given: " + path.substr(given_folder.size() + 1);
}

}  // namespace

void NoteInput(const std::string& path, std::string_view bytes) {
  const std::lock_guard<std::mutex> lock(mutex);
  if (IsOwnWork(path) || !IsNew(path)) return;
  const std::string digest = Sha256(bytes);
  for (const auto& notes : NotesOfThisThread()) notes->inputs.emplace(path, digest);
}

void NoteInput(const std::string& path) {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (IsOwnWork(path) || !IsNew(path)) return;
  }
  if (const auto bytes = BytesOf(path)) NoteInput(path, *bytes);
}

std::optional<Origin> NotedOrigin() {
  const std::lock_guard<std::mutex> lock(mutex);
  const auto all = NotesOfThisThread();
  if (all.size() != 1) return std::nullopt;
  const OriginNotes::Notes& notes = *all[0];
  Origin origin{notes.program, notes.command, notes.date, {}};
  for (const auto& [path, digest] : notes.inputs) {
    std::error_code fault;  // a track laid out for a moment is gone: the command says what made it
    if (!std::filesystem::exists(path, fault)) continue;
    origin.inputs.push_back({NameOf(path, notes.given_folder), digest});
  }
  return origin;
}

Status WriteOrigin(const std::string& folder) {
  const auto origin = NotedOrigin();
  if (!origin) return {};
  Json inputs = Json::array();
  for (const InputFile& file : origin->inputs) {
    inputs.push_back({{"path", file.path}, {"sha256", file.sha256}});
  }
  const Json json = {{"program", origin->program},
                     {"command", origin->command},
                     {"date", origin->date},
                     {"inputs", inputs}};
  return WriteFileAtomically((std::filesystem::path(folder) / kOriginFile).string(),
                             json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<Origin> ReadOrigin(const std::string& folder) {
  const auto text = BytesOf((std::filesystem::path(folder) / kOriginFile).string());
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  Origin origin{TextOf(json, "program"), TextOf(json, "command"), TextOf(json, "date"), {}};
  const auto inputs = json.find("inputs");
  if (inputs == json.end() || !inputs->is_array()) return origin;
  for (const Json& file : *inputs) {
    if (file.is_object()) origin.inputs.push_back({TextOf(file, "path"), TextOf(file, "sha256")});
  }
  return origin;
}

std::string ShellLine(const std::vector<std::string>& arguments) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  std::string line;
  for (const std::string& argument : arguments) {
    if (!line.empty()) line += ' ';
    if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) {
      line += argument;
      continue;
    }
    line += '\'';
    for (const char c : argument) {
      if (c == '\'') {
        line += "'\\''";
      } else {
        line += c;
      }
    }
    line += '\'';
  }
  return line;
}

std::string UtcText(long long seconds) {
  const auto at = static_cast<std::time_t>(seconds);
  std::tm parts{};
  gmtime_r(&at, &parts);
  std::array<char, 40> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

}  // namespace phs
