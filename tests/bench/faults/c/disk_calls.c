/* Preloaded into a station: logs its calls that reach the disk or the network, in their order,
 * and has those under one folder fail as on a full disk, on request.
 *
 * CRENEL_CALLS_UNDER  the folder, an absolute path; calls elsewhere are left alone
 * CRENEL_CALLS_LOG    a file that each call is added to: name, file descriptor, path or first bytes
 * CRENEL_CALLS_DISK   a file of three int64: calls until the disk is full, calls it stays full
 *                     (negative: for ever), calls so far; shared memory with the bench
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#define SEEN __attribute__((visibility("default")))
#define REAL(name) ((__typeof__(&name))real(#name, &name##_found))
#define FILES 65536
#define HEAD 160
#define LINE (HEAD + 512)

enum { LEFT, FULL_FOR, SO_FAR, NUMBERS };

static char *paths[FILES];
static const char *under;
static int log_file = -1;
static int64_t *disk;

static void *real(const char *name, void **found) {
    if (!*found) *found = dlsym(RTLD_NEXT, name);
    return *found;
}

__attribute__((constructor)) static void begin(void) {
    under = getenv("CRENEL_CALLS_UNDER");
    const char *log = getenv("CRENEL_CALLS_LOG"), *shared = getenv("CRENEL_CALLS_DISK");
    if (log) log_file = (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (shared) {
        int file = (int)syscall(SYS_openat, AT_FDCWD, shared, O_RDWR | O_CLOEXEC);
        void *memory = mmap(0, NUMBERS * sizeof *disk, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (file >= 0 && memory != MAP_FAILED) disk = memory;
    }
}

static int is_ours(const char *path) {
    return under && path && !strncmp(path, under, strlen(under));
}

static const char *path_of(int file) {
    return file >= 0 && file < FILES ? paths[file] : 0;
}

/* Whether the disk is full now; each call that takes from it counts. */
static int is_full(const char *path) {
    if (!disk || !is_ours(path)) return 0;
    __atomic_add_fetch(&disk[SO_FAR], 1, __ATOMIC_SEQ_CST);
    if (__atomic_load_n(&disk[LEFT], __ATOMIC_SEQ_CST) < 0) return 0; /* it is never full */
    if (__atomic_fetch_sub(&disk[LEFT], 1, __ATOMIC_SEQ_CST) > 0) return 0;
    __atomic_store_n(&disk[LEFT], 0, __ATOMIC_SEQ_CST);
    int64_t left = __atomic_load_n(&disk[FULL_FOR], __ATOMIC_SEQ_CST);
    if (left >= 0 && __atomic_sub_fetch(&disk[FULL_FOR], 1, __ATOMIC_SEQ_CST) < 0) {
        __atomic_store_n(&disk[LEFT], -1, __ATOMIC_SEQ_CST); /* it has emptied */
        return 0;
    }
    errno = ENOSPC;
    return 1;
}

static int put_line(char *line, const char *call, int file, const char *text, size_t length) {
    int at = snprintf(line, 64, "%s\t%d\t", call, file);
    for (size_t k = 0; k < length && at < LINE - 1; k++)
        line[at++] = (unsigned char)text[k] < ' ' ? ' ' : text[k];
    line[at++] = '\n';
    return at;
}

static void append(const char *lines, int length) {
    int kept = errno;
    if (syscall(SYS_write, log_file, lines, length) < 0) log_file = -1;
    errno = kept;
}

static void note(const char *call, int file, const char *text, size_t length) {
    if (log_file < 0 || !text) return;
    char line[LINE];
    append(line, put_line(line, call, file, text, length));
}

/* Both names at once, so that no line of another thread comes between them. */
static void note_renaming(const char *from, const char *to) {
    if (log_file < 0) return;
    char lines[2 * LINE];
    int at = put_line(lines, "from", -1, from, strlen(from));
    append(lines, at + put_line(lines + at, "rename", -1, to, strlen(to)));
}

static void note_path(const char *call, int file, const char *path) {
    if (is_ours(path)) note(call, file, path, strlen(path));
}

/* -- files ------------------------------------------------------------------------------- */

static int opened(int file, const char *path) {
    if (file >= 0 && file < FILES) {
        free(paths[file]);
        paths[file] = is_ours(path) ? strdup(path) : 0;
    }
    return file;
}

static int makes(const char *path, int flags) {
    return (flags & O_CREAT) && is_ours(path) && syscall(SYS_faccessat, AT_FDCWD, path, F_OK) != 0;
}

#define OPENING(name)                                                                            \
    static void *name##_found;                                                                   \
    SEEN int name(const char *path, int flags, ...) {                                            \
        va_list more;                                                                            \
        va_start(more, flags);                                                                   \
        mode_t mode = va_arg(more, mode_t);                                                      \
        va_end(more);                                                                            \
        int new = makes(path, flags);                                                            \
        if (new && is_full(path)) return -1;                                                     \
        int file = opened(REAL(name)(path, flags, mode), path);                                  \
        if (new && file >= 0) note_path("make", file, path);                                     \
        return file;                                                                             \
    }
OPENING(open)
OPENING(open64)

#define OPENING_AT(name)                                                                         \
    static void *name##_found;                                                                   \
    SEEN int name(int at, const char *path, int flags, ...) {                                    \
        va_list more;                                                                            \
        va_start(more, flags);                                                                   \
        mode_t mode = va_arg(more, mode_t);                                                      \
        va_end(more);                                                                            \
        int new = makes(path, flags);                                                            \
        if (new && is_full(path)) return -1;                                                     \
        int file = opened(REAL(name)(at, path, flags, mode), path);                              \
        if (new && file >= 0) note_path("make", file, path);                                     \
        return file;                                                                             \
    }
OPENING_AT(openat)
OPENING_AT(openat64)

static void *close_found;
SEEN int close(int file) {
    if (file >= 0 && file < FILES && paths[file]) {
        free(paths[file]);
        paths[file] = 0;
    }
    return REAL(close)(file);
}

#define WRITING(name, kind, declared, given)                                                     \
    static void *name##_found;                                                                   \
    SEEN kind name declared {                                                                    \
        if (is_full(path_of(file))) return -1;                                                   \
        kind done = REAL(name) given;                                                            \
        note_path("write", file, path_of(file));                                                 \
        return done;                                                                             \
    }
WRITING(write, ssize_t, (int file, const void *data, size_t size), (file, data, size))
WRITING(writev, ssize_t, (int file, const struct iovec *data, int count), (file, data, count))
WRITING(pwrite, ssize_t, (int file, const void *data, size_t size, off_t at), (file, data, size, at))
WRITING(pwrite64, ssize_t, (int file, const void *data, size_t size, off64_t at), (file, data, size, at))
WRITING(ftruncate, int, (int file, off_t size), (file, size))
WRITING(ftruncate64, int, (int file, off64_t size), (file, size))

#define SYNCING(name)                                                                            \
    static void *name##_found;                                                                   \
    SEEN int name(int file) {                                                                    \
        if (is_full(path_of(file))) return -1;                                                   \
        int done = REAL(name)(file);                                                             \
        if (!done) note_path("sync", file, path_of(file));                                       \
        return done;                                                                             \
    }
SYNCING(fsync)
SYNCING(fdatasync)

static void *mkdir_found, *rename_found;
SEEN int mkdir(const char *path, mode_t mode) {
    struct stat found;
    if (is_ours(path) && stat(path, &found) && is_full(path)) return -1;
    int done = REAL(mkdir)(path, mode);
    if (!done) note_path("make", -1, path);
    return done;
}

SEEN int rename(const char *from, const char *to) {
    if (is_full(to)) return -1;
    int done = REAL(rename)(from, to);
    if (!done && is_ours(from) && is_ours(to)) note_renaming(from, to);
    return done;
}

/* -- the network: a line before anything is answered, and what was asked ------------------- */

static void *send_found, *sendmsg_found, *recv_found;
SEEN ssize_t send(int file, const void *data, size_t size, int flags) {
    note("send", file, data, size < HEAD ? size : HEAD);
    return REAL(send)(file, data, size, flags);
}

SEEN ssize_t sendmsg(int file, const struct msghdr *message, int flags) {
    if (message->msg_iovlen) {
        const struct iovec *first = message->msg_iov;
        note("send", file, first->iov_base, first->iov_len < HEAD ? first->iov_len : HEAD);
    }
    return REAL(sendmsg)(file, message, flags);
}

SEEN ssize_t recv(int file, void *data, size_t size, int flags) {
    ssize_t got = REAL(recv)(file, data, size, flags);
    if (got > 0) note("recv", file, data, got < HEAD ? (size_t)got : HEAD);
    return got;
}
