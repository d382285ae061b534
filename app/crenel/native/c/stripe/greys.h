/* Sixty-four grey levels side by side, of either depth. Included with BITS defined. */
#include "pixel.h"

enum { OF(GREYS) = 64 };

typedef PIXEL OF(greys) __attribute__((vector_size(64 * sizeof(PIXEL))));
typedef OF(greys) OF(unaligned_greys) __attribute__((aligned(sizeof(PIXEL)), may_alias));

static inline OF(greys) OF(load_greys)(const PIXEL *from)
{
    return *(const OF(unaligned_greys) *)from;
}

static inline void OF(store_greys)(PIXEL *to, OF(greys) value)
{
    *(OF(unaligned_greys) *)to = value;
}

/* The levels at the end of a row: the first `count`, then zeros. */
static inline OF(greys) OF(load_some)(const PIXEL *from, int64_t count)
{
    OF(greys) value = {0};
    memcpy(&value, from, (size_t)count * sizeof(PIXEL));
    return value;
}

/* Asks for pixels that will be read soon. */
static inline void OF(fetch)(const PIXEL *first, int64_t columns)
{
    const int64_t line = 64 / (int64_t)sizeof(PIXEL); /* of the caches */
    for (int64_t i = 0; i < columns; i += line)
        __builtin_prefetch(first + i);
}

static inline OF(greys) OF(all_greys)(PIXEL level)
{
    return level - (OF(greys)){0};
}

static inline OF(greys) OF(pick)(OF(greys) mask, OF(greys) one, OF(greys) other)
{
    return (mask & one) | (~mask & other);
}

/* All bits set where the first is above the second. */
static inline OF(greys) OF(over)(OF(greys) a, OF(greys) b) { return (OF(greys))(a > b); }

static inline OF(greys) OF(lower)(OF(greys) a, OF(greys) b)
{
    return OF(pick)(OF(over)(b, a), a, b);
}

static inline OF(greys) OF(higher)(OF(greys) a, OF(greys) b)
{
    return OF(pick)(OF(over)(a, b), a, b);
}

/* By how much the first is above the second, or 0. */
static inline OF(greys) OF(excess)(OF(greys) a, OF(greys) b) { return OF(higher)(a, b) - b; }

/* The mean, rounded up. */
static inline OF(greys) OF(mean)(OF(greys) a, OF(greys) b)
{
#if BITS == 8
    typedef uint16_t wide __attribute__((vector_size(128)));
#else
    typedef uint32_t wide __attribute__((vector_size(256)));
#endif
    wide sum = __builtin_convertvector(a, wide) + __builtin_convertvector(b, wide) + 1;
    return __builtin_convertvector(sum >> 1, OF(greys));
}

/* The highest of the sixty-four. */
static inline PIXEL OF(highest_of)(OF(greys) value)
{
    PIXEL part[64], top = 0;
    memcpy(part, &value, sizeof part);
    for (int i = 0; i < 64; i++)
        top = part[i] > top ? part[i] : top;
    return top;
}

/* A mask's lanes as a number's bits, the first the lowest. */
static inline uint64_t OF(bits_of)(OF(greys) mask)
{
#ifdef __clang__
    typedef bool answers __attribute__((ext_vector_type(64)));
    answers held = __builtin_convertvector(mask, answers);
    uint64_t bits;
    memcpy(&bits, &held, sizeof bits);
    return bits;
#else
    uint64_t bits = 0;
    for (int i = 0; i < 64; i++)
        bits |= (uint64_t)(mask[i] != 0) << i;
    return bits;
#endif
}
