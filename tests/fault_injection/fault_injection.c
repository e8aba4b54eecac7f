// SPDX-License-Identifier: Apache-2.0
// Preloaded into the program: lets one call of the system fail, or all from one on, or ends the program at it.
//
// IONSKIN_FAULT_CALL    write, rename, fsync, open or malloc
// IONSKIN_FAULT_NUMBER  the call that fails, from 1
// IONSKIN_FAULT_STAYS   1: those after it fail too, as on a full disk
// IONSKIN_FAULT_SIGNAL  the call does not fail: the program gets this signal before it
// IONSKIN_FAULT_ONCE    a file that must not be there yet: the program that makes it is the only one to get the signal
// IONSKIN_FAULT_TEXT    the signal comes before this text is first printed by fputs, as progress is
// IONSKIN_FAULT_FOLDER  only files whose path begins so count
// IONSKIN_FAULT_COUNT   a file to leave the number of calls in
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_long calls;
static long number;
static int stays, counts, signal_number;
static char call[16], folder[4096], once[4096], text[256];
static atomic_flag said = ATOMIC_FLAG_INIT;
enum { least_allocation = 65536 };

__attribute__((constructor)) static void begin(void) {
  const char *name = getenv("IONSKIN_FAULT_CALL"), *which = getenv("IONSKIN_FAULT_NUMBER");
  const char *place = getenv("IONSKIN_FAULT_FOLDER"), *all = getenv("IONSKIN_FAULT_STAYS");
  const char *ends = getenv("IONSKIN_FAULT_SIGNAL"), *words = getenv("IONSKIN_FAULT_TEXT");
  const char *mark = getenv("IONSKIN_FAULT_ONCE");
  snprintf(call, sizeof call, "%s", name ? name : "");
  snprintf(text, sizeof text, "%s", words ? words : "");
  snprintf(folder, sizeof folder, "%s", place ? place : "/");
  snprintf(once, sizeof once, "%s", mark ? mark : "");
  number = which ? atol(which) : 0;
  signal_number = ends ? atoi(ends) : 0;
  stays = all && *all == '1';
  counts = *call != '\0';
}

__attribute__((destructor)) static void end(void) {
  const char *path = getenv("IONSKIN_FAULT_COUNT");
  FILE *file = counts && path ? fopen(path, "w") : NULL;
  counts = 0;
  if (file) {
    fprintf(file, "%ld\n", atomic_load(&calls));
    fclose(file);
  }
}

/* By the system's own call, which does not count. */
static void get_signal(void) {
  if (!*once || syscall(SYS_openat, AT_FDCWD, once, O_CREAT | O_EXCL | O_WRONLY, 0600) >= 0) {
    kill(getpid(), signal_number);
  }
}

static int fails(const char *name) {
  if (!counts || strcmp(name, call) != 0) {
    return 0;
  }
  const long now = atomic_fetch_add(&calls, 1) + 1;
  if (signal_number && now == number) {
    get_signal();
  }
  return !signal_number && number > 0 && (now == number || (stays && now > number));
}

static int counted_path(const char *path) {
  char whole[8192];
  if (path && *path != '/') {
    char here[4096];
    snprintf(whole, sizeof whole, "%s/%s", getcwd(here, sizeof here) ? here : "", path);
    path = whole;
  }
  return path && strncmp(path, folder, strlen(folder)) == 0;
}

static int counted_file(int file) {
  char name[64], path[4096];
  snprintf(name, sizeof name, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(name, path, sizeof path - 1);
  if (length < 0) {
    return 0;
  }
  path[length] = '\0';
  return counted_path(path);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define FAIL_FULL_DISK(name)                                                                       \
  if (counts && fails(name)) {                                                                     \
    errno = ENOSPC;                                                                                \
    return -1;                                                                                     \
  }

ssize_t write(int file, const void *bytes, size_t count) {
  if (counts && counted_file(file)) {
    FAIL_FULL_DISK("write")
  }
  return NEXT(write)(file, bytes, count);
}

ssize_t pwrite(int file, const void *bytes, size_t count, off_t place) {
  if (counts && counted_file(file)) {
    FAIL_FULL_DISK("write")
  }
  return NEXT(pwrite)(file, bytes, count, place);
}

ssize_t pwrite64(int file, const void *bytes, size_t count, off64_t place) {
  if (counts && counted_file(file)) {
    FAIL_FULL_DISK("write")
  }
  return NEXT(pwrite64)(file, bytes, count, place);
}

ssize_t copy_file_range(int from, off64_t *at, int to, off64_t *there, size_t count,
                        unsigned flags) {
  if (counts && counted_file(to)) {
    FAIL_FULL_DISK("write")
  }
  return NEXT(copy_file_range)(from, at, to, there, count, flags);
}

ssize_t sendfile(int to, int from, off_t *place, size_t count);
ssize_t sendfile(int to, int from, off_t *place, size_t count) {
  if (counts && counted_file(to)) {
    FAIL_FULL_DISK("write")
  }
  return NEXT(sendfile)(to, from, place, count);
}

int rename(const char *from, const char *to) {
  if (counts && counted_path(to)) {
    FAIL_FULL_DISK("rename")
  }
  return NEXT(rename)(from, to);
}

int fsync(int file) {
  if (counts && counted_file(file) && fails("fsync")) {
    errno = EIO;
    return -1;
  }
  return NEXT(fsync)(file);
}

int fputs(const char *line, FILE *file) {
  if (*text && strstr(line, text) && !atomic_flag_test_and_set(&said)) {
    get_signal();
  }
  return NEXT(fputs)(line, file);
}

#define OPEN(name)                                                                                 \
  int name(const char *path, int flags, ...) {                                                     \
    va_list rest;                                                                                  \
    va_start(rest, flags);                                                                         \
    const mode_t mode = (flags & O_CREAT) ? va_arg(rest, mode_t) : 0;                              \
    va_end(rest);                                                                                  \
    if (counts && (flags & (O_WRONLY | O_RDWR)) && counted_path(path)) {                           \
      FAIL_FULL_DISK("open")                                                                       \
    }                                                                                              \
    return NEXT(name)(path, flags, mode);                                                          \
  }
OPEN(open)
OPEN(open64)

/* Small ones are the libraries' own, and the system does not refuse them. */
extern void *__libc_malloc(size_t);
void *malloc(size_t size) {
  if (counts && size >= least_allocation && fails("malloc")) {
    errno = ENOMEM;
    return NULL;
  }
  return __libc_malloc(size);
}
