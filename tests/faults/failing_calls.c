/* For LD_PRELOAD: disturbs a program at its FAULT_AT-th call of a kind.
 *
 *     FAULT_CALL=write    this write to a regular file and all later ones fail with "No space left on device"
 *     FAULT_CALL=change   the process is killed before this change of a name, of rights, or wait for the disk
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;

static int is_disturbed(const char* kind) {
  const char *wanted = getenv("FAULT_CALL"), *number = getenv("FAULT_AT");
  return wanted && number && strcmp(wanted, kind) == 0 && ++calls >= atol(number);
}

static int is_full(int file) {
  struct stat status;
  if (file <= STDERR_FILENO || fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || !is_disturbed("write"))
    return 0;
  errno = ENOSPC;
  return 1;
}

static void end_here(void) {
  if (is_disturbed("change")) kill(getpid(), SIGKILL);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* bytes, size_t count) {
  return is_full(file) ? -1 : NEXT(write)(file, bytes, count);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
  return is_full(file) ? -1 : NEXT(writev)(file, parts, count);
}
ssize_t pwrite(int file, const void* bytes, size_t count, off_t at) {
  return is_full(file) ? -1 : NEXT(pwrite)(file, bytes, count, at);
}
ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t at) {
  return is_full(file) ? -1 : NEXT(pwrite64)(file, bytes, count, at);
}

int unlink(const char* path) { return end_here(), NEXT(unlink)(path); }
int remove(const char* path) { return end_here(), NEXT(remove)(path); }
int rename(const char* from, const char* to) { return end_here(), NEXT(rename)(from, to); }
int renameat2(int old, const char* from, int new, const char* to, unsigned how) {
  return end_here(), NEXT(renameat2)(old, from, new, to, how);
}
int link(const char* from, const char* to) { return end_here(), NEXT(link)(from, to); }
int fchmodat(int folder, const char* path, mode_t mode, int how) {
  return end_here(), NEXT(fchmodat)(folder, path, mode, how);
}
int syncfs(int file) { return end_here(), NEXT(syncfs)(file); }
int mkdir(const char* path, mode_t mode) { return end_here(), NEXT(mkdir)(path, mode); }
int rmdir(const char* path) { return end_here(), NEXT(rmdir)(path); }
