// Preloaded (LD_PRELOAD), it makes calls that change a folder fail, as a full, broken or forbidden disk does. Calls are counted
// over all threads and all programs that a run starts. Told by the environment:
//   FAULT_FOLDER   absolute; only what lies in it fails
//   FAULT_COUNTER  a file of eight bytes, which holds the number of calls so far
//   FAULT_AT       which call fails, from 1; 0: none
//   FAULT_ERRNO    with which error
//   FAULT_STAYS    set: all later ones as well
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static const char* folder;
static atomic_long* count;
static long at;
static int error_number;
static int stays;

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

__attribute__((constructor)) static void begin(void) {
  const char* counter = getenv("FAULT_COUNTER");
  folder = getenv("FAULT_FOLDER");
  if (folder == NULL || counter == NULL) return;
  const int file = NEXT(open)(counter, O_RDWR | O_CLOEXEC);
  if (file < 0) abort();
  count = mmap(NULL, sizeof *count, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  NEXT(close)(file);
  if (count == MAP_FAILED) abort();
  at = atol(getenv("FAULT_AT"));
  error_number = atoi(getenv("FAULT_ERRNO"));
  stays = getenv("FAULT_STAYS") != NULL;
}

static int fails_now(void) {
  const long number = atomic_fetch_add(count, 1) + 1;
  if (at == 0 || number < at || (number > at && !stays)) return 0;
  errno = error_number;
  return 1;
}

static int is_within(const char* path) {
  const size_t length = strlen(folder);
  return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

static int path_of(int file, char* path) {
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, PATH_MAX - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return 1;
}

static int file_fails(int file) {
  char path[PATH_MAX];
  const int kept = errno;
  if (count == NULL) return 0;
  const int is_ours = path_of(file, path) && is_within(path);
  errno = kept;
  return is_ours && fails_now();
}

static int path_fails(int beside, const char* path) {
  char whole[2 * PATH_MAX + 2];
  char base[PATH_MAX];
  if (count == NULL || path == NULL) return 0;
  if (path[0] == '/') return is_within(path) && fails_now();
  if (beside == AT_FDCWD ? getcwd(base, sizeof base) == NULL : !path_of(beside, base)) return 0;
  snprintf(whole, sizeof whole, "%s/%s", base, path);
  return is_within(whole) && fails_now();
}

static int writes(int flags) { return (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0; }

static mode_t mode_of(int flags, va_list* more) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(*more, mode_t) : 0;
}

#define OPEN(name)                                                    \
  int name(const char* path, int flags, ...) {                        \
    va_list more;                                                     \
    va_start(more, flags);                                            \
    const mode_t mode = mode_of(flags, &more);                        \
    va_end(more);                                                     \
    if (writes(flags) && path_fails(AT_FDCWD, path)) return -1;       \
    return NEXT(name)(path, flags, mode);                             \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                  \
  int name(int beside, const char* path, int flags, ...) {            \
    va_list more;                                                     \
    va_start(more, flags);                                            \
    const mode_t mode = mode_of(flags, &more);                        \
    va_end(more);                                                     \
    if (writes(flags) && path_fails(beside, path)) return -1;         \
    return NEXT(name)(beside, path, flags, mode);                     \
  }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(name)                                                                 \
  FILE* name(const char* path, const char* mode) {                                  \
    if (strpbrk(mode, "wa+") != NULL && path_fails(AT_FDCWD, path)) return NULL;    \
    return NEXT(name)(path, mode);                                                  \
  }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t write(int file, const void* bytes, size_t size) { return file_fails(file) ? -1 : NEXT(write)(file, bytes, size); }
ssize_t writev(int file, const struct iovec* parts, int number) {
  return file_fails(file) ? -1 : NEXT(writev)(file, parts, number);
}
ssize_t pwrite(int file, const void* bytes, size_t size, off_t place) {
  return file_fails(file) ? -1 : NEXT(pwrite)(file, bytes, size, place);
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t place) {
  return file_fails(file) ? -1 : NEXT(pwrite64)(file, bytes, size, place);
}
size_t fwrite(const void* bytes, size_t size, size_t number, FILE* stream) {
  if (!file_fails(fileno(stream))) return NEXT(fwrite)(bytes, size, number, stream);
  stream->_flags |= 0x20;  // as glibc does, so that ferror tells
  return 0;
}
int fflush(FILE* stream) { return stream != NULL && file_fails(fileno(stream)) ? EOF : NEXT(fflush)(stream); }
int fclose(FILE* stream) {
  const int fails = file_fails(fileno(stream));
  const int result = NEXT(fclose)(stream);
  if (fails) errno = error_number;
  return fails ? EOF : result;
}
int fsync(int file) { return file_fails(file) ? -1 : NEXT(fsync)(file); }
int fdatasync(int file) { return file_fails(file) ? -1 : NEXT(fdatasync)(file); }
int ftruncate(int file, off_t size) { return file_fails(file) ? -1 : NEXT(ftruncate)(file, size); }
int ftruncate64(int file, off64_t size) { return file_fails(file) ? -1 : NEXT(ftruncate64)(file, size); }
int fchmod(int file, mode_t mode) { return file_fails(file) ? -1 : NEXT(fchmod)(file, mode); }
ssize_t sendfile(int to, int from, off_t* place, size_t size) {
  return file_fails(to) ? -1 : NEXT(sendfile)(to, from, place, size);
}
ssize_t sendfile64(int to, int from, off64_t* place, size_t size) {
  return file_fails(to) ? -1 : NEXT(sendfile64)(to, from, place, size);
}
ssize_t copy_file_range(int from, off64_t* from_place, int to, off64_t* to_place, size_t size, unsigned flags) {
  return file_fails(to) ? -1 : NEXT(copy_file_range)(from, from_place, to, to_place, size, flags);
}
#define FCNTL(name)                                                     \
  int name(int file, int command, ...) {                                \
    va_list more;                                                       \
    va_start(more, command);                                            \
    void* argument = va_arg(more, void*);                               \
    va_end(more);                                                       \
    const int locks = command == F_SETLK || command == F_SETLKW || command == F_OFD_SETLK || command == F_OFD_SETLKW; \
    if (locks && file_fails(file)) return -1;                           \
    return NEXT(name)(file, command, argument);                         \
  }
FCNTL(fcntl)
FCNTL(fcntl64)
int flock(int file, int operation) { return file_fails(file) ? -1 : NEXT(flock)(file, operation); }
int rename(const char* from, const char* to) {
  return path_fails(AT_FDCWD, to) ? -1 : NEXT(rename)(from, to);
}
int renameat(int beside, const char* from, int beside_to, const char* to) {
  return path_fails(beside_to, to) ? -1 : NEXT(renameat)(beside, from, beside_to, to);
}
int renameat2(int beside, const char* from, int beside_to, const char* to, unsigned flags) {
  return path_fails(beside_to, to) ? -1 : NEXT(renameat2)(beside, from, beside_to, to, flags);
}
int link(const char* from, const char* to) { return path_fails(AT_FDCWD, to) ? -1 : NEXT(link)(from, to); }
int mkdir(const char* path, mode_t mode) { return path_fails(AT_FDCWD, path) ? -1 : NEXT(mkdir)(path, mode); }
int mkdirat(int beside, const char* path, mode_t mode) {
  return path_fails(beside, path) ? -1 : NEXT(mkdirat)(beside, path, mode);
}
int unlink(const char* path) { return path_fails(AT_FDCWD, path) ? -1 : NEXT(unlink)(path); }
int unlinkat(int beside, const char* path, int flags) {
  return path_fails(beside, path) ? -1 : NEXT(unlinkat)(beside, path, flags);
}
int remove(const char* path) { return path_fails(AT_FDCWD, path) ? -1 : NEXT(remove)(path); }
int rmdir(const char* path) { return path_fails(AT_FDCWD, path) ? -1 : NEXT(rmdir)(path); }
int chmod(const char* path, mode_t mode) { return path_fails(AT_FDCWD, path) ? -1 : NEXT(chmod)(path, mode); }
char* mkdtemp(char* pattern) { return path_fails(AT_FDCWD, pattern) ? NULL : NEXT(mkdtemp)(pattern); }
int mkstemp(char* pattern) { return path_fails(AT_FDCWD, pattern) ? -1 : NEXT(mkstemp)(pattern); }
