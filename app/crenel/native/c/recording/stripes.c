/* Messages of the sensor: crenel.StripeProfile (app/crenel/formats/recording/stripe_message.py).
 *
 * 1 timestamp, 2 width_px, 3 height_px, 4 u, 5 v, 6 intensity, 7 sigma_px, 8 axis. Lists are
 * packed. */
#include "spans.h"

enum { STRIPE_STAMP, STRIPE_WIDTH, STRIPE_U = 3, STRIPE_SIGMA = 6, STRIPE_AXIS, STRIPE_POINTS,
       STRIPE_COLUMNS };

static inline int64_t number_size(int64_t column) { return column < 5 ? 8 : 4; }

/* Notes one of the parts that have a length; false where it is not as it is mostly written. */
static bool note_part(Span part, int column, int64_t *row, int64_t counts[4])
{
    int64_t size = left_in(&part);
    if (column == STRIPE_STAMP)
        return row[STRIPE_STAMP] < 0 && take_stamp(&part, &row[STRIPE_STAMP]);
    if (column == STRIPE_AXIS) {
        row[STRIPE_AXIS] = size == 1 ? part.data[part.at] : 0;
        return row[STRIPE_AXIS] == 'u' || row[STRIPE_AXIS] == 'v';
    }
    if (row[column] || size % number_size(column))
        return false;
    row[column] = part.at;
    counts[column - STRIPE_U] = size / number_size(column);
    return true;
}

/* Fills a row: stamp, width, height, where the four lists stand, the axis' letter, the points. */
static bool find_stripe(Span in, int64_t *row)
{
    int64_t counts[4] = {0};
    memset(row, 0, STRIPE_COLUMNS * sizeof *row);
    row[STRIPE_STAMP] = -1;
    while (left_in(&in) > 0) {
        uint8_t tag = in.data[in.at++];
        int column = (tag >> 3) - 1, kind = tag & 7;
        Span part;
        if (kind == 0 && (column == STRIPE_WIDTH || column == STRIPE_WIDTH + 1)) {
            if (!take_varint(&in, &row[column]) || row[column] > UINT32_MAX)
                return false;
        } else if (kind == 2 && (column == STRIPE_STAMP ||
                                 (column >= STRIPE_U && column <= STRIPE_AXIS))) {
            if (!take_part(&in, &part) || !note_part(part, column, row, counts))
                return false;
        } else {
            return false;
        }
    }
    row[STRIPE_POINTS] = counts[0];
    return row[STRIPE_STAMP] >= 0 && counts[1] == counts[0] && counts[2] == counts[0] &&
           counts[3] == counts[0];
}

/* Of each message, by its row of find_records' table, what find_stripe finds; points are -1 where
 * it is to be decoded in another way. */
EXPORT(void, find_stripes)(int64_t n, int64_t m, const uint8_t *data, const int64_t *messages,
                           int64_t *rows)
{
    for (int64_t i = 0; i < m; i++) {
        int64_t at = messages[5 * i + 3], length = messages[5 * i + 4];
        int64_t *row = rows + STRIPE_COLUMNS * i;
        if (!is_within(at, length, n) || !find_stripe((Span){data, at, at + length}, row))
            row[STRIPE_POINTS] = -1;
    }
}

/* One list of all stripes, behind one another, out (size); returns how many bytes were filled, or
 * -1 where a list reaches beyond the bytes or beyond out. */
EXPORT(int64_t, gather_list)(int64_t n, int64_t m, int64_t size, const uint8_t *data,
                             const int64_t *rows, int64_t column, uint8_t *out)
{
    if (column < STRIPE_U || column > STRIPE_SIGMA)
        return -1;
    int64_t filled = 0;
    for (int64_t i = 0; i < m; i++) {
        const int64_t *row = rows + STRIPE_COLUMNS * i;
        int64_t at = row[column], points = row[STRIPE_POINTS];
        if (points < 0 || points > (size - filled) / number_size(column))
            return -1;
        int64_t length = points * number_size(column);
        if (!is_within(at, length, n))
            return -1;
        memcpy(out + filled, data + at, (size_t)length);
        filled += length;
    }
    return filled;
}
