// phs new: a commented start of one's own, a copy of models/new/KIND that runs as it is.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "base/data_path.h"
#include "base/result_dir.h"
#include "cli/verb_table.h"

namespace phs::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kFolder[] = "models/new/";

struct NewKind {
  const char* name;
  const char* first;        ///< the file to begin with
  const char* run;          ///< what to type then
  const char* beside = "";  ///< a folder of the product that is copied too
};

constexpr NewKind kNewKinds[] = {
    {"bogie", "my_bogie.xml", "phs compare scenario.yaml --bogies my_bogie.xml,phs --out result",
     "bogie_xml/shared"},
    {"track", "my_track.yaml", "phs simulate scenario.yaml --out result"},
    {"scenario", "scenario.yaml", "phs compare scenario.yaml --bogies phs,rigid_link --out result"},
    {"study", "study.yaml", "phs sweep study.yaml --out result"},
    {"rig", "rig.yaml", "phs rig rig.yaml --out result"},
};

/// Schemas are named by where they are installed.
std::string WithSchemas(std::string text, const std::string& schemas) {
  const std::string mark = "$schema=../../schemas";
  for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
    text.replace(at, mark.size(), "$schema=" + schemas);
  }
  return text;
}

Status CopyFiles(const fs::path& from, const std::string& below, const std::string& schemas,
                 ResultDir* dir) {
  std::error_code fault;
  if (!below.empty()) fs::create_directories(dir->File(below), fault);
  for (const auto& entry : fs::directory_iterator(from, fault)) {
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string name = (fs::path(below) / entry.path().filename()).string();
    if (Status s = WriteFileAtomically(dir->File(name), WithSchemas(text, schemas)); !s.ok()) {
      return s;
    }
  }
  if (!fault) return {};
  return Error{from.string(), "cannot be read: " + fault.message(), "", "install phs again"};
}

/// A path as a shell takes it in one piece.
std::string ForShell(const std::string& path) {
  constexpr char kPlain[] =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+:=@%,";
  if (path.find_first_not_of(kPlain) == std::string::npos) return path;
  std::string out = "'";
  for (const char c : path) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

int MakeNew(const std::string& name, const std::string& out) {
  for (const NewKind& kind : kNewKinds) {
    if (name != kind.name) continue;
    const auto first = FindData("start of a " + name, kFolder + name, kind.first, {""});
    if (!first.ok()) return BadInput(first.error());
    const auto schema = FindData("schema", "models/schemas", "scenario", {".json"});
    if (!schema.ok()) return BadInput(schema.error());
    if (fs::exists(out)) {
      return BadInput({out, "exists already", "a new directory", "choose another"});
    }
    auto dir = ResultDir::Create(out, false);
    if (!dir.ok()) return BadInput(dir.error());
    const fs::path schemas = fs::absolute(schema.value()).parent_path().lexically_normal();
    const fs::path start = fs::path(first.value()).parent_path();
    if (Status s = CopyFiles(start, "", schemas.string(), &dir.value()); !s.ok()) {
      return BadInput(s.error());
    }
    if (*kind.beside != '\0') {
      const fs::path beside = start / "../../.." / kind.beside;
      const Status copied =
          CopyFiles(beside, beside.filename().string(), schemas.string(), &dir.value());
      if (!copied.ok()) return BadInput(copied.error());
    }
    if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
    fmt::print("{}/{} is yours to change. It runs as it is:\n  cd {} && {}\n", out, kind.first,
               ForShell(out), kind.run);
  }
  return kDone;
}

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const NewKind& kind : kNewKinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace

void AddNew(CLI::App* verb, Action* action) {
  struct Options {
    std::string kind, dir;
  };
  auto options = std::make_shared<Options>();
  verb->add_option("kind", options->kind, "What")->required()->check(CLI::IsMember(Names()));
  verb->add_option("dir", options->dir, "New folder")->required()->check(NotEmpty);
  verb->callback([=] { *action = [=] { return MakeNew(options->kind, options->dir); }; });
}

}  // namespace phs::cli
