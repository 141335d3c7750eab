// phs view, phs video: a run in three dimensions. The program phs-view draws; it stands beside `phs`
// and is apart from it, so that `phs` itself needs no OpenGL.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/verb_table.h"
#include "view/request.h"

namespace phs::cli {
namespace {

/// Beside this program: installed, or in its own folder of the build.
std::string FindProgram() {
  std::error_code error;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
  for (const std::filesystem::path& place :
       {own.parent_path() / "phs-view", own.parent_path() / "../screen/phs-view"}) {
    if (std::filesystem::exists(place, error)) return place.lexically_normal().string();
  }
  return "";
}

/// The options as they were given, for the program that draws.
std::vector<std::string> ArgumentsOf(const std::string& program, const CLI::App& verb) {
  std::vector<std::string> arguments = {program, verb.get_name()};
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0) continue;
    const bool flag = option->get_items_expected_max() == 0;
    if (!option->get_positional() && flag) {
      arguments.push_back(option->get_name());
      continue;
    }
    for (const std::string& value : option->results()) {
      // Joined to its name, so that no value is taken for an option.
      arguments.push_back(option->get_positional() ? value : option->get_name() + "=" + value);
    }
  }
  return arguments;
}

int Start(const CLI::App& verb) {
  const std::string program = FindProgram();
  if (program.empty()) {
    return BadInput({"phs " + verb.get_name(), "finds no program phs-view beside phs", "",
                     "it is built where OSMesa, GLFW and libpng are installed: run "
                     "scripts/install_packages, then scripts/build"});
  }
  const std::vector<std::string> arguments = ArgumentsOf(program, verb);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  return BadInput({program, std::strerror(errno), "a program that can be started", ""});
}

void AddDrawing(CLI::App* verb, Action* action, void (*add_options)(CLI::App*, view::Request*)) {
  auto request = std::make_shared<view::Request>();
  add_options(verb, request.get());
  verb->callback([=] { *action = [=] { return request ? Start(*verb) : kInternal; }; });
}

}  // namespace

void AddView(CLI::App* verb, Action* action) { AddDrawing(verb, action, &view::AddViewOptions); }

void AddVideo(CLI::App* verb, Action* action) { AddDrawing(verb, action, &view::AddVideoOptions); }

}  // namespace phs::cli
