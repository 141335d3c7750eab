// generate_rig_data: writes quarter-rig records with something hidden in them.
//   generate_rig_data --effect NAME[+NAME]|none [--grade strong|weak] --seed N --out DIR
//   generate_rig_data --suite tune|score|holdout --out DIR [--only KIND] [--jobs N]
//   generate_rig_data --sets K --seed N --out DIR [--only KIND] [--jobs N]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "set_writer.h"
#include "suite.h"

namespace rigdata {
namespace {

constexpr const char* kUsage =
    "generate_rig_data --effect NAME[+NAME]|none [--grade strong|weak[+strong|weak]]\n"
    "                  [--over-noise X] [--seed N] [--motion FILE.csv] [--then FILE.csv] --out "
    "DIR\n"
    "generate_rig_data --suite tune|score|holdout --out DIR\n"
    "                  [--only clean|single|pair|off_list] [--jobs N]\n"
    "generate_rig_data --sets K --seed N --out DIR [--only …] [--jobs N]   K sets drawn blindly\n"
    "generate_rig_data --list\n"
    "--over-noise: what the best declared model leaves of each effect, in place of its grade.\n"
    "--motion: t_s,actuator_m on a uniform clock, in place of a drawn motion; --then: the effect\n"
    "is scaled on the motion, the record made on this one (the same rig in another test).\n"
    "Writes MANIFEST.yaml and run.csv (200 Hz, about 126 s), and truth.json; a suite writes\n"
    "DIR/set_NNN/ and keeps the truth apart in DIR/truth/ (sets that are there already are "
    "kept).\n";

struct Usage {
  std::string problem;
};

std::map<std::string, std::string> ParseOptions(int argc, char** argv) {
  std::map<std::string, std::string> options;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--help" || key == "--list") {
      options[key] = "";
      continue;
    }
    bool known = false;
    for (const char* name : {"--effect", "--grade", "--seed", "--out", "--suite", "--sets",
                             "--only", "--jobs", "--motion", "--then", "--over-noise"}) {
      known = known || key == name;
    }
    if (!known) throw Usage{"unknown option " + key};
    if (i + 1 >= argc) throw Usage{key + " needs a value"};
    options[key] = argv[++i];
  }
  return options;
}

std::vector<std::string> SplitAtPlus(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == '+') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

uint64_t ParseCount(const std::string& text, const std::string& option) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos ||
      text.size() > 18) {
    throw Usage{option + " must be a whole number, not '" + text + "'"};
  }
  return std::stoull(text);
}

Grade ParseGrade(const std::string& text) {
  if (text == "strong") return Grade::kStrong;
  if (text == "weak") return Grade::kWeak;
  throw Usage{"--grade must be strong or weak, not '" + text + "'"};
}

SampledMotion ReadMotion(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("t_s,actuator_m")) {
    throw Usage{path + " is no motion: the first line must be t_s,actuator_m"};
  }
  SampledMotion motion;
  double first = 0, last = 0;
  while (std::getline(file, line)) {
    double t = 0, x = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf", &t, &x) != 2) throw Usage{path + ": " + line};
    if (motion.position.empty()) first = t;
    last = t;
    motion.position.push_back(x);
  }
  if (motion.position.size() < 1000) throw Usage{path + " has fewer than 1000 samples"};
  motion.step = (last - first) / static_cast<double>(motion.position.size() - 1);
  return motion;
}

SetWish WishFrom(std::map<std::string, std::string>& options) {
  SetWish wish;
  if (options.count("--motion") > 0) wish.motion = ReadMotion(options["--motion"]);
  if (options.count("--then") > 0) wish.then = ReadMotion(options["--then"]);
  if (options.count("--seed") > 0) wish.seed = ParseCount(options["--seed"], "--seed");
  if (options["--effect"] == "none") return wish;
  const std::vector<std::string> names = SplitAtPlus(options["--effect"]);
  const std::vector<std::string> grades =
      SplitAtPlus(options.count("--grade") > 0 ? options["--grade"] : "strong");
  for (size_t i = 0; i < names.size(); ++i) {
    if (!IsKnownEffect(names[i])) {
      throw Usage{"no effect '" + names[i] + "'; --list names them all"};
    }
    wish.effects.push_back({names[i], ParseGrade(grades[std::min(i, grades.size() - 1)])});
    if (options.count("--over-noise") == 0) continue;
    wish.effects.back().over_noise = std::strtod(options["--over-noise"].c_str(), nullptr);
    if (!(wish.effects.back().over_noise > 0)) throw Usage{"--over-noise must be a number > 0"};
  }
  return wish;
}

void WriteIndex(const std::vector<SuiteEntry>& suite, const std::string& out) {
  nlohmann::ordered_json index = nlohmann::ordered_json::array();
  for (const SuiteEntry& e : suite) {
    index.push_back({{"set", e.name}, {"kind", KindName(e.kind)}, {"truth", e.name + ".json"}});
  }
  std::filesystem::create_directories(out + "/truth");
  std::ofstream file(out + "/truth/index.json");
  file << index.dump(1) << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + out + "/truth/index.json");
}

void WriteSuite(const std::vector<SuiteEntry>& suite, const std::string& out, uint64_t jobs) {
  WriteIndex(suite, out);
  std::atomic<size_t> next = 0;
  std::mutex printing;
  std::exception_ptr failure;
  const auto work = [&] {
    for (size_t i = next++; i < suite.size(); i = next++) {
      try {
        const SuiteEntry& e = suite[i];
        // A set's truth is written last: where it stands, the set is whole.
        if (std::filesystem::exists(out + "/truth/" + e.name + ".json")) continue;
        WriteSet(MakeRigSet(e.wish), out + "/" + e.name, out + "/truth/" + e.name + ".json");
        const std::lock_guard<std::mutex> lock(printing);
        std::printf("%zu of %zu: %s\n", i + 1, suite.size(), e.name.c_str());
        std::fflush(stdout);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(printing);
        failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> pool;
  for (uint64_t j = 1; j < jobs; ++j) pool.emplace_back(work);
  work();
  for (std::thread& t : pool) t.join();
  if (failure) std::rethrow_exception(failure);
}

std::vector<SuiteEntry> SuiteFrom(std::map<std::string, std::string>& options) {
  std::vector<SuiteEntry> suite;
  if (options.count("--sets") > 0) {
    const uint64_t count = ParseCount(options["--sets"], "--sets");
    if (count < 1 || count > 999) throw Usage{"--sets must be 1 to 999"};
    if (options.count("--seed") == 0) throw Usage{"--sets needs --seed"};
    suite = DrawSuite(ParseCount(options["--seed"], "--seed"), static_cast<int>(count));
  } else {
    auto named = ComposeSuite(options["--suite"]);
    if (!named) throw Usage{"no suite '" + options["--suite"] + "'; tune, score or holdout"};
    suite = std::move(*named);
  }
  if (options.count("--only") > 0) {
    std::erase_if(suite,
                  [&](const SuiteEntry& e) { return KindName(e.kind) != options["--only"]; });
    if (suite.empty()) throw Usage{"no sets of kind '" + options["--only"] + "'"};
  }
  return suite;
}

int Run(int argc, char** argv) {
  std::map<std::string, std::string> options = ParseOptions(argc, argv);
  if (options.count("--help") > 0) {
    std::printf("%s", kUsage);
    return 0;
  }
  if (options.count("--list") > 0) {
    for (const std::string& name : ListedNames()) std::printf("%s\n", name.c_str());
    for (const std::string& name : OffListNames()) std::printf("%s (off list)\n", name.c_str());
    return 0;
  }
  if (options.count("--out") == 0) throw Usage{"--out is missing"};
  const std::string out = options["--out"];
  if (options.count("--effect") + options.count("--suite") + options.count("--sets") != 1) {
    throw Usage{"give one of --effect, --suite and --sets"};
  }
  if (options.count("--effect") > 0) {
    WriteSet(MakeRigSet(WishFrom(options)), out, out + "/truth.json");
    return 0;
  }
  std::vector<SuiteEntry> suite = SuiteFrom(options);
  const uint64_t jobs = options.count("--jobs") > 0 ? ParseCount(options["--jobs"], "--jobs") : 1;
  WriteSuite(suite, out, std::min<uint64_t>(jobs, 64));
  return 0;
}

}  // namespace
}  // namespace rigdata

int main(int argc, char** argv) {
  try {
    return rigdata::Run(argc, argv);
  } catch (const rigdata::Usage& usage) {
    std::fprintf(stderr, "generate_rig_data: %s\n%s", usage.problem.c_str(), rigdata::kUsage);
    return 2;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "generate_rig_data: %s\n", failure.what());
    return 1;
  }
}
