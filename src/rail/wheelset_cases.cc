#include "rail/wheelset_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "base/numbers.h"
#include "rail/frames.h"

namespace phs::rail {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A cell of the table, checked.
class Cells {
 public:
  explicit Cells(const Table& table) : table_(table) {}
  bool Has(const char* name) const { return table_.Find(name) >= 0; }
  /// Value in SI from a column in `unit`; `otherwise` where the column is absent.
  double Get(const char* name, int row, double unit, double limit, double otherwise) {
    const int column = table_.Find(name);
    if (column < 0) return otherwise;
    const double v = table_.columns[static_cast<size_t>(column)][static_cast<size_t>(row)];
    if (std::isfinite(v) && std::abs(v) <= limit) return v * unit;
    Fail(name, row, "a number from -" + Shortest(limit) + " to " + Shortest(limit));
    return otherwise;
  }
  std::string Text(const char* name, int row) const {
    const auto column = static_cast<size_t>(table_.Find(name));
    return column < table_.text.size() ? table_.text[column][static_cast<size_t>(row)] : "";
  }
  void Fail(const char* name, int row, const std::string& allowed) {
    const auto r = static_cast<size_t>(row);
    const int line = r < table_.line.size() ? table_.line[r] : row + 1;
    if (error_.ok()) {
      error_ =
          Error{table_.source + ":" + std::to_string(line),
                std::string(name) + " is '" + Text(name, row) + "'", allowed, "correct this cell"};
    }
  }
  const Status& error() const { return error_; }

 private:
  const Table& table_;
  Status error_;
};

/// One position in C.
struct Position {
  Side side = Side::kLeft;
  WheelsetMotion motion;
  double load = kNone;  ///< vertical force on the rail, NaN: the height is given [N]
};

Status ReadPosition(Cells* cells, int row, Side side, double radius, Position* out) {
  if (cells->Has("side")) {
    const std::string word = cells->Text("side", row);
    if (word != "left" && word != "right") cells->Fail("side", row, "left, right");
    side = word == "left" ? Side::kLeft : Side::kRight;
  }
  // A right wheel's C are the track axes of the table; a left wheel's are mirrored in y.
  const double hand = side == Side::kRight ? 1 : -1;
  out->side = side;
  WheelsetMotion& m = out->motion;
  m.lateral = hand * cells->Get("y_mm", row, 1e-3, 200, 0);
  m.roll = hand * cells->Get("roll_rad", row, 1, 0.3, 0);
  m.yaw = hand * cells->Get("yaw_rad", row, 1, 0.3, 0);
  m.vertical = cells->Get("z_mm", row, 1e-3, 200, 0) - radius;
  if (cells->Has("Fz_N")) out->load = cells->Get("Fz_N", row, 1, 1e7, 0);
  m.velocity = {cells->Get("vs_mm_s", row, 1e-3, 2e5, 0),
                hand * cells->Get("vy_mm_s", row, 1e-3, 1e5, 0),
                cells->Get("vz_mm_s", row, 1e-3, 1e5, 0)};
  m.speed = std::abs(m.velocity[0]);
  const double pitch = cells->Get("vpitch_rad_s", row, 1, 1e4, 0);
  const Vec3 axle = {-std::sin(m.yaw) * std::cos(m.roll), std::cos(m.yaw) * std::cos(m.roll),
                     std::sin(m.roll)};
  m.rotation = {hand * cells->Get("vroll_rad_s", row, 1, 100, 0) + pitch * axle[0], pitch * axle[1],
                hand * cells->Get("vyaw_rad_s", row, 1, 100, 0) + pitch * axle[2]};
  if (out->load < 0) cells->Fail("Fz_N", row, "zero or more");
  return cells->error();
}

/// Lowers the wheelset until the rail carries the load. Bisection: the load grows with depth.
bool SolveHeight(const WheelRail& pair, Position* position, WheelRailForces* forces) {
  const auto load_at = [&](double z) {
    position->motion.vertical = z;
    pair.Calc(position->motion, position->side, {}, {}, forces);
    return -forces->force[2];
  };
  double high = -pair.params().wheel_radius - 0.05;
  double low = high;
  while (load_at(low) <= position->load) {
    high = low;
    low += 0.5e-3;
    if (low > -pair.params().wheel_radius + 0.05) return false;
  }
  for (int i = 0; i < 60 && low - high > 1e-14; ++i) {
    const double middle = 0.5 * (low + high);
    (load_at(middle) > position->load ? low : high) = middle;
  }
  load_at(low);
  return true;
}

/// The columns of the result: name and value of one patch (track axes of the table).
struct Shown {
  const char* name;
  std::function<double(const Position&, const WheelRailForces&, const ContactPatch&)> value;
};

double HandOf(const Position& p) { return p.side == Side::kRight ? 1 : -1; }

std::vector<Shown> WheelColumns() {
  using P = const Position&;
  using W = const WheelRailForces&;
  using C = const ContactPatch&;
  return {
      {"patches", [](P, W w, C) { return static_cast<double>(w.count); }},
      {"FX_N", [](P, W w, C) { return -w.force[0]; }},
      {"FY_N", [](P p, W w, C) { return -HandOf(p) * w.force[1]; }},
      {"FZ_N", [](P, W w, C) { return -w.force[2]; }},
  };
}

std::vector<Shown> PatchColumns() {
  using P = const Position&;
  using W = const WheelRailForces&;
  using C = const ContactPatch&;
  return {
      {"weight", [](P, W, C c) { return c.weight; }},
      {"ycp_rail_mm", [](P p, W, C c) { return HandOf(p) * 1e3 * c.rail_y; }},
      {"zcp_rail_mm", [](P, W, C c) { return 1e3 * c.rail_z; }},
      {"ycp_wheel_mm", [](P p, W, C c) { return HandOf(p) * 1e3 * c.wheel_y; }},
      {"zcp_wheel_mm", [](P, W, C c) { return 1e3 * c.wheel_z; }},
      {"contact_angle_rad", [](P p, W, C c) { return -HandOf(p) * c.angle; }},
      {"xi", [](P, W, C c) { return c.xi; }},
      {"eta", [](P p, W, C c) { return HandOf(p) * c.eta; }},
      {"phi_rad_per_mm", [](P p, W, C c) { return HandOf(p) * 1e-3 * c.phi; }},
      {"FN_N", [](P, W, C c) { return c.normal; }},
      {"Fx_N", [](P, W, C c) { return c.creep.x; }},
      {"Fs_N", [](P p, W, C c) { return HandOf(p) * c.creep.y; }},
      {"Mn_Nmm", [](P p, W, C c) { return HandOf(p) * 1e3 * c.creep.moment; }},
      {"a_mm", [](P, W, C c) { return 1e3 * c.a; }},
      {"b_mm", [](P, W, C c) { return 1e3 * c.b; }},
      {"approach_mm", [](P, W, C c) { return 1e3 * c.approach; }},
      {"pmax_MPa", [](P, W, C c) { return 1e-6 * c.peak_pressure; }},
      {"rolling_radius_mm", [](P, W, C c) { return 1e3 * c.rolling_radius; }},
      {"friction", [](P, W, C c) { return c.friction; }},
  };
}

/// The table of results, row by row.
class ResultRows {
 public:
  explicit ResultRows(const Table& input) : input_(input) {
    out_.source = input.source;
    out_.names = input.names;
    for (const char* name : {"case", "patch", "z_solved_mm"}) out_.names.push_back(name);
    for (const Shown& s : wheel_) out_.names.push_back(s.name);
    for (const Shown& s : patch_) out_.names.push_back(s.name);
    out_.columns.resize(out_.names.size());
    out_.text.resize(out_.names.size());
  }
  void Add(int row, const Position& position, const WheelRailForces& forces, int patch,
           double radius) {
    const auto r = static_cast<size_t>(row);
    size_t column = 0;
    const auto put = [&](double value) {
      out_.columns[column].push_back(value);
      out_.text[column++].push_back(std::isfinite(value) ? Shortest(value) : "");
    };
    for (size_t i = 0; i < input_.columns.size(); ++i) {
      put(input_.columns[i][r]);
      if (i < input_.text.size()) out_.text[i].back() = input_.text[i][r];
    }
    put(row + 1);
    put(patch + 1);
    put(1e3 * (position.motion.vertical + radius));
    const ContactPatch none;
    const bool touching = patch >= 0;
    const ContactPatch& at = touching ? forces.patch[static_cast<size_t>(patch)] : none;
    for (const Shown& s : wheel_) put(s.value(position, forces, at));
    for (const Shown& s : patch_) put(touching ? s.value(position, forces, at) : kNone);
    out_.line.push_back(r < input_.line.size() ? input_.line[r] : row + 1);
  }
  Table Take() { return std::move(out_); }

 private:
  const Table& input_;
  Table out_;
  std::vector<Shown> wheel_ = WheelColumns();
  std::vector<Shown> patch_ = PatchColumns();
};

}  // namespace

Result<Table> CalcWheelsetCases(const Table& table, const WheelRail& pair, Side side) {
  for (const char* name : {"y_mm", "vs_mm_s", "vpitch_rad_s"}) {
    if (auto column = table.Column(name); !column.ok()) return column.error();
  }
  if (table.Find("Fz_N") < 0 && table.Find("z_mm") < 0) {
    return Error{table.source, "has neither Fz_N nor z_mm", "one of both columns",
                 "give the load or the height"};
  }
  Cells cells(table);
  ResultRows rows(table);
  const double radius = pair.params().wheel_radius;
  for (int row = 0; row < table.num_rows(); ++row) {
    Position position;
    WheelRailForces forces;
    if (Status s = ReadPosition(&cells, row, side, radius, &position); !s.ok()) return s.error();
    if (std::isfinite(position.load)) {
      if (!SolveHeight(pair, &position, &forces)) {
        cells.Fail("Fz_N", row, "a load that the rail can carry at this lateral position");
        return cells.error().error();
      }
    } else {
      pair.Calc(position.motion, position.side, {}, {}, &forces);
    }
    if (forces.count == 0) rows.Add(row, position, forces, -1, radius);
    for (int k = 0; k < forces.count; ++k) rows.Add(row, position, forces, k, radius);
  }
  return rows.Take();
}

Result<Table> CalcWheelsetCases(const WheelsetCases& cases) {
  auto pair = WheelRail::Create(cases.wheel_rail);
  if (!pair.ok()) return pair.error();
  return CalcWheelsetCases(cases.table, pair.value(), cases.side);
}

}  // namespace phs::rail
