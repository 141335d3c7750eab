#include "base/data_path.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/words.h"

namespace phs {
namespace {

namespace fs = std::filesystem;

/// `share/phs` beside the folder that holds a program or library: PREFIX/bin/phs, PREFIX/lib/x.so,
/// PREFIX/lib/TRIPLET/x.so, PREFIX/lib/python3/dist-packages/phs/x.so.
void AddShareOf(const fs::path& binary, std::vector<fs::path>* roots) {
  fs::path folder = binary.parent_path();
  for (int level = 0; level < 4 && folder.has_relative_path(); ++level) {
    folder = folder.parent_path();
    roots->push_back(folder / "share" / "phs");
  }
}

/// Roots that hold models/ and bogie_xml/, best first.
std::vector<fs::path> Roots() {
  std::vector<fs::path> roots = {fs::path(".")};
  if (const char* own = std::getenv("PHS_DATA"); own != nullptr && *own != '\0') {
    roots.emplace_back(own);
  }
  std::error_code fault;
  const fs::path program = fs::read_symlink("/proc/self/exe", fault);
  if (!fault) AddShareOf(program, &roots);
  // The plugin is loaded by programs that live elsewhere: look beside the library, too.
  if (Dl_info here; dladdr(reinterpret_cast<const void*>(&AddShareOf), &here) != 0) {
    const fs::path library = fs::canonical(here.dli_fname, fault);
    if (!fault && library != program) AddShareOf(library, &roots);
  }
#ifdef PHS_SOURCE_FOLDER
  roots.emplace_back(PHS_SOURCE_FOLDER);
#endif
#ifdef PHS_INSTALLED_DATA
  roots.emplace_back(PHS_INSTALLED_DATA);
#endif
  return roots;
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Files of folder/family by name: "quarter_sine", "lowe/fig_6_10".
void AddNames(const fs::path& folder, const std::string& family,
              const std::vector<std::string>& extensions, std::set<std::string>* names) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / family, ignored)) {
    const std::string extension = entry.path().extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) continue;
    names->insert((fs::path(family) / entry.path().stem()).string());
  }
}

/// "did you mean …?": by the whole name or, for one given without its folder, by its last part.
std::string Nearest(const std::string& name, const std::vector<std::string>& known) {
  const std::string stem = fs::path(name).stem().string();
  std::string whole = DidYouMean((fs::path(name).parent_path() / stem).string(), known);
  if (!whole.empty()) return whole;
  std::vector<std::string> stems;
  stems.reserve(known.size());
  for (const std::string& one : known) stems.push_back(fs::path(one).stem().string());
  const std::string nearest = NearestWord(stem, stems);
  const auto at = std::find(stems.begin(), stems.end(), nearest);
  if (nearest.empty() || at == stems.end()) return "check the name";
  return "did you mean '" + known[static_cast<size_t>(at - stems.begin())] + "'?";
}

}  // namespace

std::vector<std::string> ListData(const std::string& folder,
                                  const std::vector<std::string>& extensions,
                                  const std::vector<std::string>& families) {
  std::set<std::string> names;
  for (const fs::path& root : Roots()) {
    AddNames(root / folder, "", extensions, &names);
    for (const std::string& family : families) {
      AddNames(root / folder, family, extensions, &names);
    }
  }
  return {names.begin(), names.end()};
}

std::string BesideFile(const std::string& naming, const std::string& name) {
  const fs::path given(name);
  const bool bare = !given.has_parent_path() && !given.has_extension();
  if (bare || given.is_absolute()) return name;
  const fs::path beside = fs::path(naming).parent_path() / given;
  return IsFile(beside) ? beside.lexically_normal().string() : name;
}

std::string Anywhere(const std::string& name) {
  const bool bare = !fs::path(name).has_parent_path() && !fs::path(name).has_extension();
  if (bare || !IsFile(name)) return name;
  std::error_code none;
  return fs::absolute(name, none).lexically_normal().string();
}

Result<std::string> FindData(const std::string& kind, const std::string& folder,
                             const std::string& name, const std::vector<std::string>& extensions,
                             const std::vector<std::string>& families) {
  // A bare word is a name first: a program called phs beside one must not hide the bogie phs.
  const bool bare = !fs::path(name).has_parent_path() && !fs::path(name).has_extension();
  if (!bare && IsFile(name)) return name;
  for (const fs::path& root : Roots()) {
    for (const std::string& extension : extensions) {
      if (name.empty()) break;
      for (const std::string& file : {name, name + extension}) {
        const fs::path path = root / folder / file;
        if (!fs::path(name).is_absolute() && IsFile(path)) return path.lexically_normal().string();
      }
    }
  }
  if (bare && IsFile(name)) return name;
  const std::vector<std::string> known = ListData(folder, extensions, families);
  return Error{kind + " " + Quoted(name), "was not found",
               "a path, or one of: " + (known.empty() ? "(none installed)" : JoinWords(known)),
               Nearest(name, known)};
}

}  // namespace phs
