#include "rail/wheelset_cases.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "rail/frames.h"
#include "rail/height_under_load.h"

namespace phs::rail {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A name that a column may carry, and its unit in SI.
struct ColumnName {
  const char* name;
  double unit;
};
struct PositionColumn {
  std::vector<ColumnName> names;  ///< ours first
  double limit;                   ///< largest size, SI
  const char* limit_text;
};

const PositionColumn kY = {
    {{"y_mm", 1e-3}, {"y_m", 1}, {"Y", 1e-3}, {"Y_WS", 1e-3}}, 0.2, "a number from -200 to 200 mm"};
const PositionColumn kZ = {
    {{"z_mm", 1e-3}, {"z_m", 1}, {"Z", 1e-3}, {"Z_WS", 1e-3}}, 0.2, "a number from -200 to 200 mm"};
const PositionColumn kLoad = {{{"Fz_N", 1}, {"FZ", 1}}, 1e7, "0 … 1e7 N"};
const PositionColumn kRoll = {
    {{"roll_rad", 1}, {"ROLL", 1}, {"ROLL_WS", 1}}, 0.3, "a number from -0.3 to 0.3 rad"};
const PositionColumn kYaw = {
    {{"yaw_rad", 1}, {"YAW", 1}, {"YAW_WS", 1}}, 0.3, "a number from -0.3 to 0.3 rad"};
const PositionColumn kForward = {{{"vs_mm_s", 1e-3}, {"vs_m_s", 1}, {"VS", 1e-3}, {"VX_WS", 1e-3}},
                                 200,
                                 "a number from -200 to 200 m/s"};
const PositionColumn kSideways = {{{"vy_mm_s", 1e-3}, {"vy_m_s", 1}, {"VY", 1e-3}, {"VY_WS", 1e-3}},
                                  100,
                                  "a number from -100 to 100 m/s"};
const PositionColumn kDown = {{{"vz_mm_s", 1e-3}, {"vz_m_s", 1}, {"VZ", 1e-3}, {"VZ_WS", 1e-3}},
                              100,
                              "a number from -100 to 100 m/s"};
const PositionColumn kRollSpeed = {
    {{"vroll_rad_s", 1}, {"VROLL", 1}, {"VROLL_WS", 1}}, 100, "a number from -100 to 100 rad/s"};
const PositionColumn kYawSpeed = {
    {{"vyaw_rad_s", 1}, {"VYAW", 1}, {"VYAW_WS", 1}}, 100, "a number from -100 to 100 rad/s"};
const PositionColumn kPitchSpeed = {{{"vpitch_rad_s", 1}, {"VPITCH", 1}, {"VPITCH_WS", 1}},
                                    1e4,
                                    "a number from -10000 to 10000 rad/s"};

std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The cells of a table, checked as they are read; the first wrong one is kept.
class Cells {
 public:
  explicit Cells(const Table& table) : table_(table) {}
  bool Has(const PositionColumn& column) const { return Find(column).first >= 0; }
  /// Value in SI; 0 where the column is absent.
  double Get(const PositionColumn& column, int row) {
    const auto [index, unit] = Find(column);
    if (index < 0) return 0;
    const double v = unit * table_.columns[static_cast<size_t>(index)][static_cast<size_t>(row)];
    if (std::isfinite(v) && std::abs(v) <= column.limit) return v;
    Fail(index, row, column.limit_text);
    return 0;
  }
  Side SideOf(int row, Side otherwise) {
    const int index = table_.Find("side");
    if (index < 0) return otherwise;
    const std::string word = Lower(Text(index, row));
    const bool left = word.find("left") != std::string::npos;
    const bool right = word.find("right") != std::string::npos;
    if (left == right) Fail(index, row, "left, right");
    return right ? Side::kRight : Side::kLeft;
  }
  void Fail(const PositionColumn& column, int row, const std::string& allowed) {
    Fail(Find(column).first, row, allowed);
  }
  const Status& error() const { return error_; }

 private:
  std::pair<int, double> Find(const PositionColumn& column) const {
    for (const ColumnName& known : column.names) {
      for (int i = 0; i < table_.num_columns(); ++i) {
        if (Lower(table_.names[static_cast<size_t>(i)]) == Lower(known.name)) {
          return {i, known.unit};
        }
      }
    }
    return {-1, 0};
  }
  std::string Text(int column, int row) const {
    const auto c = static_cast<size_t>(column);
    return c < table_.text.size() ? table_.text[c][static_cast<size_t>(row)] : "";
  }
  void Fail(int column, int row, const std::string& allowed) {
    if (!error_.ok()) return;
    const auto r = static_cast<size_t>(row);
    const int line = r < table_.line.size() ? table_.line[r] : row + 1;
    const std::string& name = table_.names[static_cast<size_t>(column)];
    error_ = Error{table_.source + ":" + std::to_string(line),
                   name + " is '" + Text(column, row) + "'", allowed, "correct this cell"};
  }

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
  out->side = cells->SideOf(row, side);
  // A right wheel's C are the track axes of the table; a left wheel's are mirrored in y.
  const double hand = out->side == Side::kRight ? 1 : -1;
  WheelsetMotion& m = out->motion;
  m.lateral = hand * cells->Get(kY, row);
  m.roll = hand * cells->Get(kRoll, row);
  m.yaw = hand * cells->Get(kYaw, row);
  if (cells->Has(kLoad)) {
    out->load = cells->Get(kLoad, row);
    if (out->load < 0) cells->Fail(kLoad, row, kLoad.limit_text);
  } else {
    m.vertical = cells->Get(kZ, row) - radius;
  }
  m.velocity = {cells->Get(kForward, row), hand * cells->Get(kSideways, row),
                cells->Get(kDown, row)};
  m.speed = std::abs(m.velocity[0]);
  const double pitch = cells->Get(kPitchSpeed, row);
  const Vec3 axle = {-std::sin(m.yaw) * std::cos(m.roll), std::cos(m.yaw) * std::cos(m.roll),
                     std::sin(m.roll)};
  m.rotation = {hand * cells->Get(kRollSpeed, row) + pitch * axle[0], pitch * axle[1],
                hand * cells->Get(kYawSpeed, row) + pitch * axle[2]};
  return cells->error();
}

Status CheckColumns(const Table& table, const Cells& cells) {
  for (const PositionColumn* needed : {&kY, &kForward, &kPitchSpeed}) {
    // The message of the table names the nearest column.
    if (!cells.Has(*needed)) return table.Column(needed->names[0].name).status();
  }
  if (cells.Has(kLoad) || cells.Has(kZ)) return {};
  return Error{table.source, "has neither Fz_N nor z_mm", "one of both columns",
               "give the load or the height"};
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
    std::vector<std::string> added = {"case", "patch", "z_solved_mm"};
    for (const Shown& s : wheel_) added.emplace_back(s.name);
    for (const Shown& s : patch_) added.emplace_back(s.name);
    out_.source = input.source;
    // A result that the input holds already is replaced.
    for (int i = 0; i < input.num_columns(); ++i) {
      const std::string& name = input.names[static_cast<size_t>(i)];
      if (std::find(added.begin(), added.end(), name) != added.end()) continue;
      kept_.push_back(static_cast<size_t>(i));
      out_.names.push_back(name);
    }
    out_.names.insert(out_.names.end(), added.begin(), added.end());
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
    for (const size_t i : kept_) {
      put(input_.columns[i][r]);
      if (i < input_.text.size()) out_.text[column - 1].back() = input_.text[i][r];
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
  std::vector<size_t> kept_;  ///< columns of the input that are passed through
  std::vector<Shown> wheel_ = WheelColumns();
  std::vector<Shown> patch_ = PatchColumns();
};

}  // namespace

Result<Table> CalcWheelsetCases(const Table& table, const WheelRail& pair, Side side) {
  Cells cells(table);
  if (Status s = CheckColumns(table, cells); !s.ok()) return s.error();
  ResultRows rows(table);
  const double radius = pair.params().wheel_radius;
  for (int row = 0; row < table.num_rows(); ++row) {
    Position position;
    WheelRailForces forces;
    if (Status s = ReadPosition(&cells, row, side, radius, &position); !s.ok()) return s.error();
    if (std::isfinite(position.load)) {
      const WheelUnderLoad wheel{.side = position.side,
                                 .load = position.load,
                                 .carried = VerticalForce,
                                 .near = -radius,
                                 .reach = 0.05};
      if (!FindHeightUnderLoad(pair, wheel, &position.motion, &forces)) {
        cells.Fail(kLoad, row, "a load that the rail can carry at this lateral position");
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
