/* What a library says of itself, compiled once: its sources, and the variant for this processor. */
#include <stdint.h>

#ifdef _WIN32
#define VISIBLE __declspec(dllexport)
#else
#define VISIBLE __attribute__((visibility("default")))
#endif

/* Identifies the text that the library was compiled from. */
VISIBLE const char *crenel_sources(void) { return SOURCES; }

#if defined(__x86_64__) || defined(_M_X64)

static void cpuid(uint32_t leaf, uint32_t part, uint32_t out[4])
{
    __asm__ volatile("cpuid"
                     : "=a"(out[0]), "=b"(out[1]), "=c"(out[2]), "=d"(out[3])
                     : "a"(leaf), "c"(part));
}

/* Which registers the operating system keeps for a process. */
static uint64_t xgetbv(void)
{
    uint32_t low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return (uint64_t)high << 32 | low;
}

static int has(uint32_t word, uint32_t bits) { return (word & bits) == bits; }

/* The highest variant this processor runs: 1, 3 or 4, as in x86-64-v3 of the psABI. */
VISIBLE int crenel_best_variant(void)
{
    enum { SSE3_TO_F16C = 1u << 0 | 1u << 9 | 1u << 12 | 1u << 13 | 1u << 19 | 1u << 20 | 1u << 22 |
                          1u << 23 | 1u << 26 | 1u << 27 | 1u << 28 | 1u << 29 };
    const uint32_t avx2 = 1u << 3 | 1u << 5 | 1u << 8; /* BMI1, AVX2, BMI2 */
    const uint32_t avx512 = 1u << 16 | 1u << 17 | 1u << 28 | 1u << 30 | 1u << 31; /* F DQ CD BW VL */
    const uint32_t lzcnt = 1u << 5;
    uint32_t leaf[4];
    cpuid(0, 0, leaf);
    if (leaf[0] < 7)
        return 1;
    cpuid(1, 0, leaf);
    if (!has(leaf[2], SSE3_TO_F16C) || (xgetbv() & 0x06) != 0x06)
        return 1;
    cpuid(0x80000001u, 0, leaf);
    if (!has(leaf[2], lzcnt))
        return 1;
    cpuid(7, 0, leaf);
    if (!has(leaf[1], avx2))
        return 1;
    return has(leaf[1], avx512) && (xgetbv() & 0xe6) == 0xe6 ? 4 : 3;
}

#else

VISIBLE int crenel_best_variant(void) { return 1; }

#endif
