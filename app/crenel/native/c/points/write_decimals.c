/* Points of a cloud as text: numbers with a fixed number of decimals, one point a line. */
#include "../export.h"

enum { LONGEST_NUMBER = 22, MOST_DECIMALS = 18 }; /* a sign, 19 digits, a point, what follows */

/* Writes scaled / 10^decimals; returns its length. */
static int64_t write_decimal(int64_t scaled, int64_t decimals, uint8_t *text)
{
    uint8_t digits[LONGEST_NUMBER];
    uint64_t left = scaled < 0 ? 0 - (uint64_t)scaled : (uint64_t)scaled;
    int64_t count = 0, length = 0;
    for (int64_t place = 0; left > 0 || place <= decimals; place++, left /= 10) {
        if (place == decimals && place > 0)
            digits[count++] = '.';
        digits[count++] = (uint8_t)('0' + left % 10);
    }
    if (scaled < 0)
        text[length++] = '-';
    while (count > 0)
        text[length++] = digits[--count];
    return length;
}

/* scaled (n, columns) whole numbers, each 10^decimals (columns) times the number that is written to
 * text, whose size is enough. Returns how many bytes they take; -1 where decimals are too many. */
EXPORT(int64_t, write_decimals)(int64_t n, int64_t columns, const int64_t *scaled,
                                const int64_t *decimals, uint8_t *text)
{
    for (int64_t column = 0; column < columns; column++)
        if (decimals[column] < 0 || decimals[column] > MOST_DECIMALS)
            return -1;
    int64_t at = 0;
    for (int64_t i = 0; i < n * columns; i++) {
        int64_t column = i % columns;
        at += write_decimal(scaled[i], decimals[column], text + at);
        text[at++] = column == columns - 1 ? '\n' : ' ';
    }
    return at;
}
