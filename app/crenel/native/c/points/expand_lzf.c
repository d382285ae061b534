/* Compressed data of PCD files: LZF, as PCL writes it.
 *
 * A byte below 32 begins that many literal bytes and one more. Any other begins a copy of bytes
 * written before: its upper three bits and two are the length (7: the next byte adds to it), its
 * lower five bits and the next byte how far back they lie. */
#include "../export.h"

enum { LITERALS = 32, LONG_COPY = 7 };

/* Expands size bytes into exactly wanted ones; 1, or 0 where they are not such data. */
EXPORT(int64_t, expand_lzf)(int64_t size, int64_t wanted, const uint8_t *packed, uint8_t *expanded)
{
    int64_t at = 0, done = 0;
    while (at < size) {
        int64_t control = packed[at++];
        if (control < LITERALS) {
            int64_t count = control + 1;
            if (count > size - at || count > wanted - done)
                return 0;
            memcpy(expanded + done, packed + at, (size_t)count);
            at += count;
            done += count;
            continue;
        }
        int64_t count = control >> 5;
        if (count == LONG_COPY) {
            if (at >= size)
                return 0;
            count += packed[at++];
        }
        count += 2;
        if (at >= size)
            return 0;
        int64_t back = ((control & 31) << 8) + packed[at++] + 1;
        if (back > done || count > wanted - done)
            return 0;
        for (int64_t i = 0; i < count; i++, done++)
            expanded[done] = expanded[done - back];
    }
    return done == wanted;
}
