// Reader of CONTACT's input files for wheel-rail cases (contact program github.com/eve70a/CONTACT).
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "rail/wheelset_cases.h"

namespace phs::rail {
namespace {

/// A line of the file: its numbers and text in quotes, then its labels.
struct InputLine {
  std::string where;
  std::vector<double> numbers;
  std::string quoted;
  std::string first_token;          ///< the control digits keep their leading zeros
  std::vector<std::string> labels;  ///< upper case letters and digits
};

InputLine Split(const std::string& text, const std::string& where) {
  InputLine line;
  line.where = where;
  std::string rest = text.substr(0, text.find('%'));
  const size_t open = rest.find('\'');
  const size_t close = open == std::string::npos ? open : rest.find('\'', open + 1);
  if (close != std::string::npos) {
    line.quoted = rest.substr(open + 1, close - open - 1);
    rest.erase(open, close - open + 1);
  }
  std::replace(rest.begin(), rest.end(), ',', ' ');
  std::istringstream words(rest);
  std::string word;
  bool in_numbers = true;
  while (words >> word) {
    if (line.first_token.empty()) line.first_token = word;
    const auto number = ParseNumber(word);
    // Angles may carry a `d` for degrees; none of the lines used here does.
    if (in_numbers && number) {
      line.numbers.push_back(*number);
    } else {
      in_numbers = false;
      line.labels.push_back(word);
    }
  }
  return line;
}

/// What the file has said so far; a case takes what it does not repeat from the one before.
struct State {
  WheelsetCases cases;
  bool prescribed_load = true;
  double position[6] = {};  ///< s, y, Fz or z, roll, yaw, pitch
  double speed[6] = {};
};

Status Need(const InputLine& line, size_t count) {
  if (line.numbers.size() >= count) return {};
  return Error{line.where, "holds too few numbers", std::to_string(count) + " numbers", ""};
}

void AddRow(const State& s, int line, Table* table) {
  const double values[] = {s.position[1], s.position[2], s.position[3], s.position[4], s.speed[0],
                           s.speed[1],    s.speed[2],    s.speed[3],    s.speed[4],    s.speed[5]};
  for (size_t i = 0; i < table->columns.size(); ++i) {
    table->columns[i].push_back(values[i]);
    table->text[i].push_back(Shortest(values[i]));
  }
  table->line.push_back(line);
}

/// Settings that stand once for all cases.
Status ReadSetting(const InputLine& line, const std::filesystem::path& folder, State* s) {
  const std::string& label = line.labels[0];
  const std::vector<double>& n = line.numbers;
  WheelRailParams& p = s->cases.wheel_rail;
  const auto beside = [&](const std::string& name) { return (folder / name).string(); };
  if (label == "FSTAT") {
    if (Status e = Need(line, 1); !e.ok()) return e;
    p.tread = FrictionLaw{n[0]};
    p.flange = p.tread;
  } else if (label == "POISS") {
    if (Status e = Need(line, 4); !e.ok()) return e;
    if (n[0] != n[1] || n[2] != n[3]) {
      return Error{line.where, "wheel and rail differ in material", "equal materials", ""};
    }
    p.creep.material = {n[2] * 1e6, n[0]};
  } else if (label == "GAUGHT") {
    if (Status e = Need(line, 4); !e.ok()) return e;
    p.gauge_height = n[0] * 1e-3;
    p.gauge = n[2] * 1e-3;
    p.rail_cant = n[3];
  } else if (label == "FBDIST") {
    if (Status e = Need(line, 3); !e.ok()) return e;
    p.flange_back_distance = n[0] * 1e-3;
    p.flange_back_position = n[1] * 1e-3;
    p.wheel_radius = n[2] * 1e-3;
  } else if (label == "RFNAME") {
    p.rail_profile = beside(line.quoted);
  } else if (label == "WFNAME") {
    p.wheel_profile = beside(line.quoted);
  }
  return {};
}

/// Control digits: first line C-P-B-T-N-F-S, C1 = right side (1, 5), N1 = 1 prescribes the load.
Status ReadControl(const InputLine& line, State* s) {
  const std::string& digits = line.first_token;
  if (digits.size() != 7) return Error{line.where, "are no control digits", "seven digits", ""};
  s->cases.side = digits[0] == '1' || digits[0] == '5' ? Side::kRight : Side::kLeft;
  s->prescribed_load = digits[4] == '1';
  return {};
}

}  // namespace

Result<WheelsetCases> ReadContactInput(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  NoteInput(path, text.value());
  State s;
  Table& table = s.cases.table;
  table.source = path;
  table.columns.resize(10);
  table.text.resize(10);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::istringstream lines(text.value());
  std::string raw;
  bool mixed = false;
  for (int number = 1; std::getline(lines, raw); ++number) {
    const InputLine line = Split(raw, path + ":" + std::to_string(number));
    if (line.labels.empty()) continue;
    Status fault;
    if (line.labels[0] == "C-P-B-T-N-F-S") {
      const bool before = s.prescribed_load;
      fault = ReadControl(line, &s);
      mixed = mixed || (table.num_rows() > 0 && before != s.prescribed_load);
    } else if (line.labels[0] == "S" || line.labels[0] == "VS") {
      fault = Need(line, 6);
      double* to = line.labels[0] == "S" ? s.position : s.speed;
      if (fault.ok()) std::copy_n(line.numbers.begin(), 6, to);
      if (fault.ok() && line.labels[0] == "VS") AddRow(s, number, &table);
    } else {
      fault = ReadSetting(line, folder, &s);
    }
    if (!fault.ok()) return fault.error();
  }
  if (table.num_rows() == 0 || s.cases.wheel_rail.wheel_profile.empty() ||
      s.cases.wheel_rail.rail_profile.empty()) {
    return Error{path, "holds no wheel-rail cases", "input of CONTACT's module 1", ""};
  }
  if (mixed) return Error{path, "mixes prescribed load and height", "one of both", "split it"};
  table.names = {"y_mm",       s.prescribed_load ? "Fz_N" : "z_mm",
                 "roll_rad",   "yaw_rad",
                 "vs_mm_s",    "vy_mm_s",
                 "vz_mm_s",    "vroll_rad_s",
                 "vyaw_rad_s", "vpitch_rad_s"};
  return std::move(s.cases);
}

}  // namespace phs::rail
