/* The records of an MCAP chunk: an opcode, the content's length in 8 bytes, the content.
 *
 * A message's content begins with its channel (2 bytes), sequence (4), log and publish time
 * (8 each). */
#include "spans.h"

enum { RECORD_HEAD = 9, MESSAGE = 5, MESSAGE_HEAD = 22, MESSAGE_LOG_TIME = 6 };

/* The next record's content; false where it reaches beyond the chunk's end. */
static bool take_record(Span *in, Span *content)
{
    if (left_in(in) < RECORD_HEAD)
        return false;
    uint8_t opcode = in->data[in->at];
    int64_t length = i64_at(in->data + in->at + 1);
    in->at += RECORD_HEAD;
    if (!is_within(in->at, length, in->end) || (opcode == MESSAGE && length < MESSAGE_HEAD))
        return false;
    *content = (Span){in->data, in->at, in->at + length};
    in->at += length;
    return true;
}

/* How many records a chunk of n bytes holds; -1 where one reaches beyond its end. */
EXPORT(int64_t, count_records)(int64_t n, const uint8_t *data)
{
    Span in = {data, 0, n}, content;
    int64_t count = 0;
    for (; left_in(&in) > 0; count++)
        if (!take_record(&in, &content))
            return -1;
    return count;
}

/* Of each record: its opcode, channel (of a message, else -1), log time (else 0), first byte of
 * what it holds, and length of that. Fills table (m, 5); returns how many rows it filled. */
EXPORT(int64_t, find_records)(int64_t n, int64_t m, const uint8_t *data, int64_t *table)
{
    Span in = {data, 0, n}, content;
    int64_t found = 0;
    for (; found < m; found++) {
        int64_t start = in.at, *row = table + 5 * found;
        if (!take_record(&in, &content))
            break;
        row[0] = data[start];
        row[1] = -1;
        row[2] = 0;
        if (row[0] == MESSAGE) {
            row[1] = u16_at(data + content.at);
            row[2] = i64_at(data + content.at + MESSAGE_LOG_TIME);
            content.at += MESSAGE_HEAD;
        }
        row[3] = content.at;
        row[4] = left_in(&content);
    }
    return found;
}
