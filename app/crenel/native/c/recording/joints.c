/* Messages of the arm: foxglove.JointStates, as they are mostly written.
 *
 * JointStates: 1 timestamp, 2 joints. JointState: 1 name, 2 position (a double); others skipped. */
#include "spans.h"

enum { MOST_JOINTS = 16, JOINT_COLUMNS = MOST_JOINTS + 1 };
enum { NAME_TAG = 1 << 3 | 2, POSITION_TAG = 2 << 3 | 1 };

/* Fowler, Noll and Vo's hash, of a byte more. */
static inline uint64_t hashed(uint64_t hash, uint64_t byte) { return (hash ^ byte) * 1099511628211u; }

/* Where a joint's position stands (-1: it is written in another way); its name goes into names. */
static int64_t find_joint(Span in, uint64_t *names)
{
    int64_t position = -1;
    bool named = false;
    while (left_in(&in) > 0) {
        uint8_t tag = in.data[in.at++];
        if (tag == NAME_TAG) {
            Span name;
            if (named || !take_part(&in, &name))
                return -1;
            named = true;
            for (int64_t i = name.at; i < name.end; i++)
                *names = hashed(*names, name.data[i]);
        } else if (tag == POSITION_TAG) {
            position = in.at;
            if (!skip_bytes(&in, 8))
                return -1;
        } else if (tag >= 128 || !skip_field(&in, tag)) {
            return -1;
        }
    }
    *names = hashed(*names, 257);
    return position;
}

/* Fills a row: the stamp, and where each position stands. How many joints, or -1. */
static int64_t find_joint_states(Span in, int64_t *row, uint64_t *names)
{
    enum { STAMP_TAG = 1 << 3 | 2, JOINT_TAG = 2 << 3 | 2 };
    int64_t count = 0;
    row[0] = -1;
    *names = 14695981039346656037u;
    while (left_in(&in) > 0) {
        uint8_t tag = in.data[in.at++];
        Span part;
        if ((tag != STAMP_TAG && tag != JOINT_TAG) || !take_part(&in, &part))
            return -1;
        if (tag == STAMP_TAG) {
            if (row[0] >= 0 || !take_stamp(&part, &row[0]))
                return -1;
        } else {
            int64_t found = find_joint(part, names);
            if (found < 0 || count >= MOST_JOINTS)
                return -1;
            row[++count] = found;
        }
    }
    return row[0] >= 0 ? count : -1;
}

/* Of each message, by its row of find_records' table: stamp and the positions' places (rows), how
 * many joints there are or -1 where it is to be decoded in another way (counts), and a number that
 * distinguishes the joints' names from others (names). */
EXPORT(void, find_joints)(int64_t n, int64_t m, const uint8_t *data, const int64_t *messages,
                          int64_t *rows, int64_t *counts, int64_t *names)
{
    for (int64_t i = 0; i < m; i++) {
        int64_t at = messages[5 * i + 3], length = messages[5 * i + 4];
        uint64_t hash = 0;
        counts[i] = -1;
        if (is_within(at, length, n))
            counts[i] = find_joint_states((Span){data, at, at + length}, rows + JOINT_COLUMNS * i,
                                          &hash);
        names[i] = (int64_t)hash;
    }
}

/* The positions at rows' places as numbers, out (m, count). Returns false where a place is beyond
 * the bytes. */
EXPORT(int64_t, gather_joints)(int64_t n, int64_t m, int64_t count, const uint8_t *data,
                               const int64_t *rows, double *out)
{
    if (count > MOST_JOINTS)
        return false;
    for (int64_t i = 0; i < m; i++)
        for (int64_t j = 0; j < count; j++) {
            int64_t at = rows[JOINT_COLUMNS * i + 1 + j];
            if (!is_within(at, 8, n))
                return false;
            memcpy(out + count * i + j, data + at, 8);
        }
    return true;
}
