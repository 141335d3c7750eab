#include "base/disk.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace phs {
namespace {

namespace fs = std::filesystem;

constexpr char kNoRoom[] = "no room left on the disk";
constexpr char kFails[] = "the disk fails";

std::string Text(int code) { return std::generic_category().message(code); }

Error Fault(const std::string& path, const char* done, int code, const char* allowed) {
  const std::string begin = std::string("cannot be ") + done;
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return {path, begin + ": " + kNoRoom + " (" + Text(code) + ")", "",
              "free some space, then repeat"};
    case EIO:
      return {path, begin + ": " + kFails + " (" + Text(code) + ")", "",
              "check the disk, then repeat"};
    default:
      return {path, begin + " (" + Text(code) + ")", allowed, ""};
  }
}

/// One open file; closed at the end.
class File {
 public:
  File(const std::string& path, int flags) : number_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~File() { (void)Close(); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  bool ok() const { return number_ >= 0; }

  /// These return 0 or errno.
  int Write(const std::string& text) const {
    for (size_t at = 0; at < text.size();) {
      const ssize_t put = write(number_, text.data() + at, text.size() - at);
      if (put < 0 && errno == EINTR) continue;
      if (put <= 0) return put < 0 ? errno : EIO;
      at += static_cast<size_t>(put);
    }
    return 0;
  }
  int Sync() const {
    while (fsync(number_) != 0) {
      if (errno == EINVAL || errno == ENOTSUP || errno == EROFS) return 0;  // knows no such call
      if (errno != EINTR) return errno;
    }
    return 0;
  }
  int Close() {
    if (number_ < 0) return 0;
    const int code = close(number_) == 0 || errno == EINTR ? 0 : errno;
    number_ = -1;
    return code;
  }

 private:
  int number_;
};

/// 0 or errno.
int SyncPath(const std::string& path) {
  const File file(path, O_RDONLY);
  return file.ok() ? file.Sync() : errno;
}

/// Makes the file `path` anew with that text; 0 or errno.
int WriteAnew(const std::string& path, const std::string& text, bool sync) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW;
  if (unlink(path.c_str()) != 0 && errno != ENOENT) return errno;
  File file(path, kFlags);
  if (!file.ok()) return errno;
  int code = file.Write(text);
  if (code == 0 && sync) code = file.Sync();
  const int closed = file.Close();
  return code != 0 ? code : closed;
}

}  // namespace

Error WriteFault(const std::string& path, int code) {
  return Fault(path, "written", code, "a place with room that can be written");
}

Error ReadFault(const std::string& path, int code) {
  Error error = Fault(path, "read", code, "a readable file");
  if (!IsDiskFault(error)) error.mend = "check the path";
  return error;
}

bool IsDiskFault(const Error& error) {
  return error.what.find(kNoRoom) != std::string::npos ||
         error.what.find(kFails) != std::string::npos;
}

Status SyncFolder(const std::string& path) {
  const int code = SyncPath(path.empty() ? "." : path);
  return code == 0 ? Status() : Status(WriteFault(path, code));
}

Status SyncTree(const std::string& path) {
  std::error_code fault;
  for (fs::recursive_directory_iterator at(path, fault), end; !fault && at != end;
       at.increment(fault)) {
    const auto kind = at->symlink_status(fault).type();
    if (fault) break;
    if (kind != fs::file_type::regular && kind != fs::file_type::directory) continue;
    if (const int code = SyncPath(at->path().string()); code != 0) {
      return WriteFault(at->path().string(), code);
    }
  }
  if (fault) return WriteFault(path, fault.value());
  return SyncFolder(path);
}

Status WriteFileAtomically(const std::string& path, const std::string& text) {
  std::error_code fault;
  // A pipe or a terminal is written to, not replaced.
  if (fs::exists(path, fault) && !fs::is_regular_file(path, fault)) {
    File file(path, O_WRONLY);
    int code = file.ok() ? file.Write(text) : errno;
    if (const int closed = file.Close(); code == 0) code = closed;
    return code == 0 ? Status() : Status(WriteFault(path, code));
  }
  const std::string aside = path + ".tmp." + WriterName();
  int code = WriteAnew(aside, text, true);
  if (code == 0 && rename(aside.c_str(), path.c_str()) != 0) code = errno;
  if (code == 0) return SyncFolder(fs::path(path).parent_path().string());
  unlink(aside.c_str());
  return WriteFault(path, code);
}

Status WritePassingFile(const std::string& path, const std::string& text) {
  const int code = WriteAnew(path, text, false);
  return code == 0 ? Status() : Status(WriteFault(path, code));
}

bool IsFileName(const std::string& name) {
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  return !name.empty() && name.size() <= 100 && name[0] != '.' && name[0] != '-' &&
         name.find_first_not_of(kLetters) == std::string::npos;
}

std::string HostName() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

std::string WriterName() {
  static std::atomic<int> count{0};
  return HostName() + '.' + std::to_string(getpid()) + '.' + std::to_string(count++);
}

}  // namespace phs
