// A disk that fails, or a machine that stops, at the n-th call. Loaded before a program
// (LD_PRELOAD), it counts the calls that change files below one folder (opening for writing, write,
// truncate, fsync, rename, unlink, mkdir …), over all processes of a group, and at the n-th does
// what it is told:
//
//   FAULT_UNDER    the folder; calls elsewhere are not counted
//   FAULT_COUNTER  a file of 8 bytes that the processes share: the number of calls so far
//   FAULT_AT       n, from 1; 0 or nothing: count only
//   FAULT_MODE     enospc       the n-th call fails, and all that need room after it
//                  eio          the n-th call fails, those after it do not
//                  kill_before  the process group is killed instead of the n-th call
//                  kill_after   it is killed behind the n-th call
//
// Calls inside the C library (fopen's own open) cannot be seen; the program's writers are told by
// the walk's number of calls.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static _Atomic long* counter;
static long at;
static int fails_with, kills_before, kills_after, stays;
static char under[PATH_MAX];

__attribute__((constructor)) static void Begin(void) {
  const char* folder = getenv("FAULT_UNDER");
  const char* file = getenv("FAULT_COUNTER");
  const char* number = getenv("FAULT_AT");
  const char* mode = getenv("FAULT_MODE");
  if (folder == NULL || file == NULL || strlen(folder) >= sizeof under) return;
  memcpy(under, folder, strlen(folder) + 1);
  const int fd = open(file, O_RDWR | O_CLOEXEC);
  if (fd < 0) return;
  void* page = mmap(NULL, sizeof(long), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  close(fd);
  if (page == MAP_FAILED) return;
  at = number == NULL ? 0 : atol(number);
  if (mode != NULL && strcmp(mode, "enospc") == 0) fails_with = ENOSPC, stays = 1;
  if (mode != NULL && strcmp(mode, "eio") == 0) fails_with = EIO;
  if (mode != NULL && strcmp(mode, "kill_before") == 0) kills_before = 1;
  if (mode != NULL && strcmp(mode, "kill_after") == 0) kills_after = 1;
  counter = page;
}

static void Stop(void) {
  kill(0, SIGKILL);
  for (;;) pause();
}

static int IsUnder(const char* path) {
  const size_t length = strlen(under);
  return strncmp(path, under, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

/// Whether a path, relative to the folder `dir`, lies below the folder watched.
static int Watched(int dir, const char* path) {
  if (counter == NULL || path == NULL) return 0;
  if (path[0] == '/') return IsUnder(path);
  char base[PATH_MAX];
  if (dir == AT_FDCWD) {
    if (getcwd(base, sizeof base) == NULL) return 0;
  } else {
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", dir);
    const ssize_t n = readlink(link, base, sizeof base - 1);
    if (n < 0) return 0;
    base[n] = '\0';
  }
  return IsUnder(base);
}

static int WatchedFile(int fd) {
  if (counter == NULL) return 0;
  struct stat about;
  if (fstat(fd, &about) != 0 || !(S_ISREG(about.st_mode) || S_ISDIR(about.st_mode))) return 0;
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  const ssize_t n = readlink(link, path, sizeof path - 1);
  if (n < 0) return 0;
  path[n] = '\0';
  return IsUnder(path);
}

/// Counts a call. True: it must fail, errno is set. `last` comes back true where to die behind it.
static int Fails(int watched, int needs_room, int* last) {
  *last = 0;
  if (!watched) return 0;
  const long now = atomic_fetch_add(counter, 1) + 1;
  if (at == 0 || now < at) return 0;
  if (now == at && kills_before) Stop();
  *last = now == at && kills_after;
  if (fails_with != 0 && (now == at || (stays && needs_room))) {
    errno = fails_with;
    return 1;
  }
  return 0;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/// `RETURN name PARAMETERS` that calls the true one with ARGUMENTS unless the call fails.
#define WATCH(RETURN, name, PARAMETERS, ARGUMENTS, WATCHED, NEEDS_ROOM, FAILED) \
  RETURN name PARAMETERS {                                                      \
    int last;                                                                   \
    if (Fails(WATCHED, NEEDS_ROOM, &last)) return FAILED;                       \
    RETURN done = REAL(name) ARGUMENTS;                                         \
    if (last) Stop();                                                           \
    return done;                                                                \
  }

WATCH(ssize_t, write, (int fd, const void* data, size_t size), (fd, data, size), WatchedFile(fd), 1,
      -1)
WATCH(ssize_t, writev, (int fd, const struct iovec* parts, int n), (fd, parts, n), WatchedFile(fd),
      1, -1)
WATCH(ssize_t, pwrite, (int fd, const void* data, size_t size, off_t to), (fd, data, size, to),
      WatchedFile(fd), 1, -1)
WATCH(ssize_t, pwrite64, (int fd, const void* data, size_t size, off64_t to), (fd, data, size, to),
      WatchedFile(fd), 1, -1)
WATCH(int, fsync, (int fd), (fd), WatchedFile(fd), 1, -1)
WATCH(int, fdatasync, (int fd), (fd), WatchedFile(fd), 1, -1)
WATCH(int, ftruncate, (int fd, off_t size), (fd, size), WatchedFile(fd), 1, -1)
WATCH(int, ftruncate64, (int fd, off64_t size), (fd, size), WatchedFile(fd), 1, -1)
WATCH(int, rename, (const char* from, const char* to), (from, to), Watched(AT_FDCWD, to), 1, -1)
WATCH(int, renameat, (int a, const char* from, int b, const char* to), (a, from, b, to),
      Watched(b, to), 1, -1)
WATCH(int, renameat2, (int a, const char* from, int b, const char* to, unsigned flags),
      (a, from, b, to, flags), Watched(b, to), 1, -1)
WATCH(int, unlink, (const char* path), (path), Watched(AT_FDCWD, path), 0, -1)
WATCH(int, unlinkat, (int dir, const char* path, int flags), (dir, path, flags), Watched(dir, path),
      0, -1)
WATCH(int, remove, (const char* path), (path), Watched(AT_FDCWD, path), 0, -1)
WATCH(int, rmdir, (const char* path), (path), Watched(AT_FDCWD, path), 0, -1)
WATCH(int, mkdir, (const char* path, mode_t mode), (path, mode), Watched(AT_FDCWD, path), 1, -1)
WATCH(char*, mkdtemp, (char* path), (path), Watched(AT_FDCWD, path), 1, NULL)

static int Writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) != 0; }

#define WATCH_OPEN(name, PARAMETERS, DIR, CALL)                          \
  int name PARAMETERS {                                                  \
    mode_t mode = 0;                                                     \
    if ((flags & O_CREAT) != 0) {                                        \
      va_list rest;                                                      \
      va_start(rest, flags);                                             \
      mode = va_arg(rest, mode_t);                                       \
      va_end(rest);                                                      \
    }                                                                    \
    int last;                                                            \
    if (Fails(Writes(flags) && Watched(DIR, path), 1, &last)) return -1; \
    const int done = CALL;                                               \
    if (last) Stop();                                                    \
    return done;                                                         \
  }

WATCH_OPEN(open, (const char* path, int flags, ...), AT_FDCWD, REAL(open)(path, flags, mode))
WATCH_OPEN(open64, (const char* path, int flags, ...), AT_FDCWD, REAL(open64)(path, flags, mode))
WATCH_OPEN(openat, (int dir, const char* path, int flags, ...), dir,
           REAL(openat)(dir, path, flags, mode))
WATCH_OPEN(openat64, (int dir, const char* path, int flags, ...), dir,
           REAL(openat64)(dir, path, flags, mode))

#define WATCH_FOPEN(name)                                                                      \
  FILE* name(const char* path, const char* mode) {                                             \
    int last;                                                                                  \
    if (Fails(strpbrk(mode, "wa+") != NULL && Watched(AT_FDCWD, path), 1, &last)) return NULL; \
    FILE* const done = REAL(name)(path, mode);                                                 \
    if (last) Stop();                                                                          \
    return done;                                                                               \
  }
WATCH_FOPEN(fopen)
WATCH_FOPEN(fopen64)
