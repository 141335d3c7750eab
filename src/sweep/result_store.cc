#include "sweep/result_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "base/result_dir.h"
#include "sweep/outputs.h"

namespace phs::sweep {
namespace {

std::string CsvCell(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos) return text;
  std::string cell = "\"";
  for (char c : text) {
    if (c == '"') cell += '"';
    cell += c == '\n' || c == '\r' ? ' ' : c;
  }
  return cell + "\"";
}

/// The cells of one run as text, in the order of ColumnNames; no number = empty.
std::vector<std::string> Cells(const Study& study, const RunRecord& record) {
  std::vector<std::string> cells = {fmt::format("{}", record.run)};
  for (const std::string& value : study.runs[static_cast<std::size_t>(record.run)]) {
    cells.push_back(value);
  }
  if (study.vary_irregularity) {
    cells.push_back(fmt::format("{}", RunSeed(study.seed, static_cast<std::uint64_t>(record.run))));
  }
  cells.push_back(record.status);
  for (double value : record.outputs) cells.push_back(std::isfinite(value) ? Shortest(value) : "");
  cells.push_back(record.reason);
  return cells;
}

/// The unit a column's name ends with, after the last words that are units; "" for none.
std::string UnitOf(const std::string& column) {
  for (const char* unit :
       {"km_h", "m_s", "N_per_m", "Ns_per_m", "Nm_per_rad", "m3", "Pa", "rad", "kg", "Hz"}) {
    const std::string end = std::string("_") + unit;
    if (column.size() > end.size() &&
        column.compare(column.size() - end.size(), end.size(), end) == 0) {
      return unit;
    }
  }
  const std::string last = column.substr(column.rfind('_') + 1);
  return last == "N" || last == "J" || last == "m" || last == "s" || last == "K" ? last : "";
}

/// What the disk says when a file is written beside `path`: SQLite often has lost the reason.
int AskDisk(const std::string& path) {
  const std::string aside = path + ".probe";
  const int file = open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  const std::vector<char> block(1 << 16);
  const ssize_t written = write(file, block.data(), block.size());
  int code = written < 0 ? errno : written < static_cast<ssize_t>(block.size()) ? ENOSPC : 0;
  close(file);
  unlink(aside.c_str());
  return code;
}

/// Why SQLite failed, as the fault of the disk that it mostly is.
Error FaultOf(sqlite3* db, const std::string& path) {
  const int code = sqlite3_errcode(db) & 0xff;
  const int system = sqlite3_system_errno(db);
  if (code == SQLITE_FULL) return WriteFault(path, ENOSPC);
  if (code == SQLITE_IOERR || code == SQLITE_CANTOPEN || code == SQLITE_READONLY) {
    if (system == ENOSPC || system == EDQUOT || system == EFBIG || system == EACCES) {
      return WriteFault(path, system);
    }
    const int told = AskDisk(path);
    return WriteFault(path, told != 0 ? told : EIO);
  }
  return {path, sqlite3_errmsg(db), "", ""};
}

class Database {
 public:
  static Result<Database> Create(const std::string& path) {
    sqlite3* raw = nullptr;
    if (sqlite3_open(path.c_str(), &raw) != SQLITE_OK) {
      const Error error = FaultOf(raw, path);
      sqlite3_close(raw);
      return error;
    }
    return Database(raw, path);
  }
  Status Execute(const std::string& sql) {
    if (sqlite3_exec(db_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return {};
    return Fault();
  }
  /// INSERT of one row of texts; numbers find their column's type.
  Status Insert(const std::string& table, const std::vector<std::string>& cells) {
    std::string marks;
    for (std::size_t i = 0; i < cells.size(); ++i) marks += i == 0 ? "?" : ",?";
    sqlite3_stmt* raw = nullptr;
    const std::string sql = fmt::format("INSERT INTO {} VALUES ({})", table, marks);
    if (sqlite3_prepare_v2(db_.get(), sql.c_str(), -1, &raw, nullptr) != SQLITE_OK) return Fault();
    const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> row(raw, &sqlite3_finalize);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int place = static_cast<int>(i) + 1;
      if (cells[i].empty()) {
        sqlite3_bind_null(raw, place);
      } else {
        sqlite3_bind_text(raw, place, cells[i].c_str(), -1, SQLITE_TRANSIENT);
      }
    }
    return sqlite3_step(raw) == SQLITE_DONE ? Status() : Fault();
  }

  Status Close() {
    return sqlite3_close(db_.release()) == SQLITE_OK ? Status() : Status(WriteFault(path_, EIO));
  }

 private:
  Database(sqlite3* raw, std::string path) : db_(raw, &sqlite3_close), path_(std::move(path)) {}
  Status Fault() const { return FaultOf(db_.get(), path_); }
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> db_;
  std::string path_;
};

std::string Quote(const std::string& name) { return "\"" + name + "\""; }

Status FillIndex(const Study& study, const std::vector<RunRecord>& records, Database* db) {
  const auto names = ColumnNames(study);
  const std::size_t status = 1 + study.axes.size() + (study.vary_irregularity ? 1 : 0);
  std::string columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* type = i == 0                                 ? " INTEGER PRIMARY KEY"
                       : i == status || i + 1 == names.size() ? " TEXT"
                       : i > status                           ? " REAL"
                                                              : " NUMERIC";
    columns += (i == 0 ? "" : ", ") + Quote(names[i]) + type;
  }
  const std::string begin = fmt::format(
      "BEGIN; CREATE TABLE runs ({}); CREATE TABLE columns (name TEXT, unit TEXT, kind TEXT);"
      "CREATE TABLE study (name TEXT, text TEXT);",
      columns);
  if (Status s = db->Execute(begin); !s.ok()) return s;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const char* kind = i == 0 || i + 1 == names.size() || i == status ? "run"
                       : i < status                                   ? "axis"
                                                                      : "output";
    if (Status s = db->Insert("columns", {names[i], UnitOf(names[i]), kind}); !s.ok()) return s;
  }
  if (Status s = db->Insert("study", {study.name, study.text}); !s.ok()) return s;
  for (const RunRecord& record : records) {
    if (Status s = db->Insert("runs", Cells(study, record)); !s.ok()) return s;
  }
  return db->Execute("CREATE INDEX runs_by_status ON runs (status); COMMIT;");
}

}  // namespace

std::vector<std::string> ColumnNames(const Study& study) {
  std::vector<std::string> names = {"run"};
  for (const Axis& axis : study.axes) names.push_back(axis.column);
  if (study.vary_irregularity) names.emplace_back("seed");
  names.emplace_back("status");
  for (std::string& column : OutputColumns(study.outputs)) names.push_back(std::move(column));
  names.emplace_back("reason");
  return names;
}

Status WriteSweepCsv(const Study& study, const std::vector<RunRecord>& records,
                     const std::string& path) {
  std::string text = fmt::format("{}\n", fmt::join(ColumnNames(study), ","));
  for (const RunRecord& record : records) {
    const auto cells = Cells(study, record);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += (i == 0 ? "" : ",") + CsvCell(cells[i]);
    }
    text += '\n';
  }
  return WriteFileAtomically(path, text);
}

Status WriteIndex(const Study& study, const std::vector<RunRecord>& records,
                  const std::string& path) {
  auto db = Database::Create(path);
  if (!db.ok()) return db.error();
  if (Status s = FillIndex(study, records, &db.value()); !s.ok()) return s;
  return db.value().Close();
}

}  // namespace phs::sweep
