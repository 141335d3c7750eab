// Readers of profile files, and generated profiles.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/origin.h"
#include "base/result_dir.h"
#include "rail/profile.h"
#include "rail/profile_smoothing.h"

namespace phs::rail {
namespace {

constexpr size_t kMaxPoints = 200000;

/// What a file says of its points.
struct RawProfile {
  std::vector<double> y, z;  ///< in the file's unit and order
  double per_metre = 1000;   ///< file units per metre
  double smoothing = 0;      ///< wavelength [m]; 0 = none
  int mirror_y = 0;
  int mirror_z = 0;
  int inversion = 0;
};

std::vector<std::string> Words(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line) {
    if (c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r') {
      if (!word.empty()) words.push_back(std::move(word));
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

bool ToNumber(std::string text, double* value) {
  if (!text.empty() && text[0] == '+') text.erase(0, 1);
  std::replace(text.begin(), text.end(), 'd', 'e');
  std::replace(text.begin(), text.end(), 'D', 'e');
  const char* end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, *value);
  return fault == std::errc() && rest == end && std::isfinite(*value);
}

/// `key = value ! comment` of SIMPACK's form.
void ReadSetting(const std::string& line, RawProfile* raw) {
  const size_t equals = line.find('=');
  if (equals == std::string::npos) return;
  const std::vector<std::string> key = Words(line.substr(0, equals));
  const std::vector<std::string> value = Words(line.substr(equals + 1));
  double number = 0;
  if (key.empty() || value.empty() || !ToNumber(value[0], &number)) return;
  if (key[0] == "units.len.f" && number > 0) raw->per_metre = number;
  if (key[0] == "mirror.y") raw->mirror_y = static_cast<int>(number);
  if (key[0] == "mirror.z") raw->mirror_z = static_cast<int>(number);
  if (key[0] == "inversion") raw->inversion = static_cast<int>(number);
}

Result<RawProfile> ReadRaw(const std::string& text, const std::string& name) {
  RawProfile raw;
  const bool simpack = text.find("point.begin") != std::string::npos;
  bool in_points = !simpack;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string where = name + ":" + std::to_string(number);
    if (line.find("unit: m") != std::string::npos && line.find("unit: mm") == std::string::npos) {
      raw.per_metre = 1;
    }
    if (const size_t at = line.find("smoothing_mm:"); at != std::string::npos) {
      const std::vector<std::string> words = Words(line.substr(at + 13));
      double value = 0;
      if (words.empty() || !ToNumber(words[0], &value) || value < 0 || value > 50) {
        return Error{where, "smoothing_mm is wrong", "0 … 50", ""};
      }
      raw.smoothing = 1e-3 * value;
    }
    const size_t comment = line.find_first_of("!#%");
    const std::vector<std::string> words = Words(line.substr(0, comment));
    if (words.empty()) continue;
    if (words[0] == "point.begin") {
      in_points = true;
    } else if (words[0] == "point.end") {
      in_points = false;
    } else if (!in_points) {
      ReadSetting(line.substr(0, comment), &raw);
    } else {
      double y = 0;
      double z = 0;
      if (words.size() < 2 || !ToNumber(words[0], &y) || !ToNumber(words[1], &z)) {
        return Error{where, "is no point", "two numbers: y z", ""};
      }
      if (raw.y.size() >= kMaxPoints) return Error{where, "too many points", "200000", ""};
      raw.y.push_back(y);
      raw.z.push_back(z);
    }
  }
  if (raw.y.size() < 5) return Error{name, "has too few points", "at least 5", ""};
  return raw;
}

/// Generated profiles: kind before the colon, parameter behind it.
Result<Profile> Generate(const std::string& text, ProfileKind kind) {
  const size_t colon = text.find(':');
  const std::string shape = text.substr(0, colon);
  double value = 0;
  const bool wheel = kind == ProfileKind::kWheel;
  if (!ToNumber(text.substr(colon + 1), &value) || !(value > 0) ||
      (wheel ? shape != "cone" || value > 1 : shape != "arc" || value < 0.02 || value > 10)) {
    return Error{"profile '" + text + "'", "cannot be generated",
                 wheel ? "cone:LAMBDA with 0 < LAMBDA <= 1" : "arc:RADIUS_M with 0.02 … 10 m", ""};
  }
  std::vector<double> y;
  std::vector<double> z;
  const double half = wheel ? 0.065 : std::min(0.035, 0.9 * value);
  for (double at = -half; at <= half + 1e-9; at += 0.4e-3) {
    y.push_back(at);
    z.push_back(wheel ? -value * at : value - std::sqrt(value * value - at * at));
  }
  return Profile::FromPoints(text, y, z);
}

/// A lone point far off both its neighbours, which are near each other.
Status CheckSpikes(const std::string& name, const std::vector<double>& y,
                   const std::vector<double>& z) {
  constexpr double kNear = 5e-3, kFar = 10e-3;  // [m]
  const auto between = [&](size_t a, size_t b) { return std::hypot(y[a] - y[b], z[a] - z[b]); };
  for (size_t i = 1; i + 1 < y.size(); ++i) {
    if (between(i - 1, i + 1) > kNear) continue;
    if (between(i, i - 1) < kFar || between(i, i + 1) < kFar) continue;
    return Error{name,
                 "point " + std::to_string(i + 1) + " lies " +
                     std::to_string(std::lround(1e3 * between(i, i - 1))) +
                     " mm off its neighbours",
                 "an outline without spikes", "remove it"};
  }
  return {};
}

/// A wheel has its flange inside (y < 0) and below the tread (z > 0), a rail its top above its
/// sides.
Status CheckSides(const std::string& name, ProfileKind kind, const std::vector<double>& y,
                  const std::vector<double>& z) {
  constexpr double kFlange = 15e-3, kSide = 5e-3, kTallest = 0.25;  // [m]
  size_t middle = 0;
  for (size_t i = 0; i < y.size(); ++i) {
    if (std::abs(y[i]) < std::abs(y[middle])) middle = i;
  }
  const auto [high, low] = std::minmax_element(z.begin(), z.end());  // z is down
  const std::string mend = "turn the sign of y or z (mirror.y, mirror.z)";
  if (*low - *high > kTallest) {
    return Error{name, "is " + std::to_string(std::lround(1e3 * (*low - *high))) + " mm tall",
                 "at most 250 mm", "check the unit of length and single points"};
  }
  if (kind == ProfileKind::kRail) {
    if (z[middle] - std::min(z.front(), z.back()) > kSide) {
      return Error{name, "is upside down: its sides stand above its top", "z downwards", mend};
    }
    return {};
  }
  if (z[middle] - *high > kFlange) {
    return Error{name, "is upside down: its flange stands above its tread", "z downwards", mend};
  }
  if (*low - z[middle] > kFlange && y[static_cast<size_t>(low - z.begin())] > 0) {
    return Error{name, "is mirrored: its flange is on the outer side",
                 "y outwards, flange at y < 0", mend};
  }
  return {};
}

}  // namespace

Result<Profile> ParseProfile(const std::string& text, const std::string& name, ProfileKind kind) {
  auto read = ReadRaw(text, name);
  if (!read.ok()) return read.error();
  RawProfile& raw = read.value();
  std::vector<double> y;
  std::vector<double> z;
  for (size_t i = 0; i < raw.y.size(); ++i) {
    y.push_back((raw.mirror_y == 1 ? -raw.y[i] : raw.y[i]) / raw.per_metre);
    z.push_back((raw.mirror_z == 1 ? -raw.z[i] : raw.z[i]) / raw.per_metre);
  }
  if (y.back() < y.front()) {
    std::reverse(y.begin(), y.end());
    std::reverse(z.begin(), z.end());
  }
  const double widest =
      *std::max_element(y.begin(), y.end()) - *std::min_element(y.begin(), y.end());
  if (!(widest > 0.02 && widest < 0.4)) {
    return Error{name, "is " + std::to_string(widest * 1e3) + " mm wide", "20 … 400 mm",
                 "check the unit of length"};
  }
  if (Status s = CheckSpikes(name, y, z); !s.ok()) return s.error();
  if (Status s = CheckSides(name, kind, y, z); !s.ok()) return s.error();
  if (raw.smoothing > 0) SmoothOutline(raw.smoothing, &y, &z);
  return Profile::FromPoints(name, std::move(y), std::move(z));
}

Result<Profile> LoadProfile(const std::string& path, ProfileKind kind) {
  if (path.rfind("cone:", 0) == 0 || path.rfind("arc:", 0) == 0) return Generate(path, kind);
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  NoteInput(path, text.value());
  return ParseProfile(text.value(), path, kind);
}

}  // namespace phs::rail
