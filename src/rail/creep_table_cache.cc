#include "rail/creep_table_cache.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>
#include <tuple>
#include <vector>

#include "rail/creep_table_grid.h"

namespace phs::rail {
namespace {

constexpr std::uint64_t kVersion = 1;
/// "phscreep" in this machine's byte order, so a foreign order is a foreign file.
constexpr std::uint64_t kMagic = 0x7068736372656570;

struct Header {
  std::uint64_t magic = kMagic;
  std::uint64_t version = kVersion;
  std::uint64_t strips = 0;
  std::uint64_t slices = 0;
  std::uint64_t elliptic = 0;
  std::uint64_t count = 0;
  std::uint64_t checksum = 0;
};

/// FNV-1a over 64-bit words.
std::uint64_t Checksum(std::span<const double> data) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (double value : data) {
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    hash = (hash ^ word) * 1099511628211ULL;
  }
  return hash;
}

Header HeaderOf(const FastsimParams& params, std::span<const double> data) {
  Header h;
  h.strips = static_cast<std::uint64_t>(params.strips);
  h.slices = static_cast<std::uint64_t>(params.slices);
  h.elliptic = params.elliptic_bound ? 1 : 0;
  h.count = data.size();
  h.checksum = Checksum(data);
  return h;
}

std::filesystem::path FileOf(const std::string& folder, const FastsimParams& params) {
  return std::filesystem::path(folder) /
         ("creep_table_" + std::to_string(params.strips) + "x" + std::to_string(params.slices) +
          (params.elliptic_bound ? "_elliptic.bin" : "_parabolic.bin"));
}

/// A table of an older algorithm has a right checksum and wrong numbers. At its nodes the table is
/// FASTSIM itself but for rounding (processors round differently), so a few nodes of all faces,
/// shapes and sizes are calculated anew.
bool AgreesWithFastsim(const CreepTable& table, const FastsimParams& params) {
  using creep_table::Direction, creep_table::kFaces, creep_table::kGrids, creep_table::kShapes,
      creep_table::kSizes, creep_table::kSizeUnit;
  constexpr int kNodes = 48;
  constexpr double kRounding = 1e-9;  ///< of forces of size 1
  const Fastsim fastsim(params);
  for (int i = 0; i < kNodes; ++i) {
    const int face = i % kFaces;
    NormalisedCreepage c =
        Direction(face, (3 * i) % kGrids[face].nodes[2], (5 * i + 1) % kGrids[face].nodes[3]);
    const double t = (1 + 7 * i % (kSizes - 2)) / static_cast<double>(kSizes - 1);
    const double p = kSizeUnit * t / (1 - t);
    c = {p * c.u, p * c.v, p * c.w, (i % kShapes) / static_cast<double>(kShapes - 1)};
    const NormalisedForce a = fastsim.Calc(c);
    const NormalisedForce b = table.At(c);
    if (!(std::abs(a.x - b.x) < kRounding && std::abs(a.y - b.y) < kRounding &&
          std::abs(a.moment - b.moment) < kRounding)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string CreepCacheFolder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) {
    return std::string(cache) + "/phs";
  }
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::string(home) + "/.cache/phs";
  }
  return "";
}

CreepTable ReadCreepTable(const std::string& folder, const FastsimParams& params) {
  std::ifstream file(FileOf(folder, params), std::ios::binary);
  Header found;
  if (!file.read(reinterpret_cast<char*>(&found), sizeof found)) return {};
  if (found.magic != kMagic || found.count != CreepTable::DataSize()) return {};
  std::vector<double> data(CreepTable::DataSize());
  if (!file.read(reinterpret_cast<char*>(data.data()),
                 static_cast<std::streamsize>(data.size() * sizeof(double)))) {
    return {};
  }
  const Header expected = HeaderOf(params, data);
  if (std::memcmp(&found, &expected, sizeof found) != 0) return {};
  CreepTable table = CreepTable::FromData(std::move(data));
  if (!AgreesWithFastsim(table, params)) return {};
  return table;
}

bool WriteCreepTable(const std::string& folder, const FastsimParams& params,
                     const CreepTable& table) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return false;
  const fs::path path = FileOf(folder, params);
  const fs::path aside = path.string() + "." + std::to_string(::getpid()) + ".part";
  {
    std::ofstream file(aside, std::ios::binary | std::ios::trunc);
    const Header header = HeaderOf(params, table.data());
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    file.write(reinterpret_cast<const char*>(table.data().data()),
               static_cast<std::streamsize>(table.data().size_bytes()));
    file.close();
    if (!file) {
      fs::remove(aside, error);
      return false;
    }
  }
  fs::rename(aside, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    return false;
  }
  return true;
}

std::shared_ptr<const CreepTable> SharedCreepTable(const FastsimParams& params,
                                                   bool use_disk_cache) {
  static std::mutex mutex;
  static std::map<std::tuple<int, int, bool>, std::weak_ptr<const CreepTable>> known;
  const std::lock_guard<std::mutex> lock(mutex);
  auto& slot = known[{params.strips, params.slices, params.elliptic_bound}];
  if (auto table = slot.lock()) return table;
  const std::string folder = use_disk_cache ? CreepCacheFolder() : "";
  CreepTable table;
  if (!folder.empty()) table = ReadCreepTable(folder, params);
  if (table.empty()) {
    const unsigned cores = std::thread::hardware_concurrency();
    table = CreepTable::Build(params, static_cast<int>(std::clamp(cores, 1u, 8u)));
    if (!folder.empty()) WriteCreepTable(folder, params, table);
  }
  auto shared = std::make_shared<const CreepTable>(std::move(table));
  slot = shared;
  return shared;
}

}  // namespace phs::rail
