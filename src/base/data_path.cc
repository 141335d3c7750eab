#include "base/data_path.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/yaml.h"

namespace phs {
namespace {

namespace fs = std::filesystem;

/// Roots that hold models/ and bogie_xml/, best first.
std::vector<fs::path> Roots() {
  std::vector<fs::path> roots = {fs::path(".")};
  if (const char* own = std::getenv("PHS_DATA")) roots.emplace_back(own);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) roots.push_back(program.parent_path().parent_path() / "share" / "phs");
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

}  // namespace

std::vector<std::string> ListData(const std::string& folder,
                                  const std::vector<std::string>& extensions) {
  std::set<std::string> names;
  for (const fs::path& root : Roots()) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(root / folder, ignored)) {
      const std::string extension = entry.path().extension().string();
      if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
        names.insert(entry.path().stem().string());
      }
    }
  }
  return {names.begin(), names.end()};
}

Result<std::string> FindData(const std::string& kind, const std::string& folder,
                             const std::string& name, const std::vector<std::string>& extensions) {
  if (IsFile(name)) return name;
  for (const fs::path& root : Roots()) {
    for (const std::string& extension : extensions) {
      if (name.empty()) break;
      for (const std::string& file : {name, name + extension}) {
        const fs::path path = root / folder / file;
        if (!fs::path(name).is_absolute() && IsFile(path)) return path.lexically_normal().string();
      }
    }
  }
  const std::vector<std::string> known = ListData(folder, extensions);
  std::string list;
  for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
  const std::string nearest = NearestWord(fs::path(name).stem().string(), known);
  return Error{kind + " '" + name + "'", "was not found",
               "a path, or one of: " + (list.empty() ? "(none installed)" : list),
               nearest.empty() ? "check the name" : "did you mean '" + nearest + "'?"};
}

}  // namespace phs
