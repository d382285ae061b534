/* Which cubes of space already show a point (app/crenel/station/view3d/voxel_lod.py).
 *
 * Cubes of one size are remembered as bits, 4 x 4 x 4 to a brick. Bricks stand in a table of a
 * power of two of slots, at most half of them taken; a brick's key is never 0. */
#include "../export.h"

enum { SIZES = 16, CUBE_BITS = 21, BRICK_BITS = CUBE_BITS - 2 };

typedef struct {
    uint64_t key, cubes; /* a bit for each of its cubes that shows a point */
} Brick;

/* Where a brick is in the table, or where it would be entered. */
static int64_t slot_of(uint64_t key, int64_t slots, const Brick *table)
{
    uint64_t mask = (uint64_t)slots - 1;
    uint64_t mixed = (key ^ key >> 31) * 0x2545F4914F6CDD1Du;
    uint64_t slot = (mixed ^ mixed >> 29) & mask;
    while (table[slot].key != 0 && table[slot].key != key)
        slot = (slot + 1) & mask;
    return (int64_t)slot;
}

/* Enters points_mm (n, 3) until there is no workspace for more bricks; returns how many it did.
 *
 * table (slots, 2); before (old_slots, 2) the smaller table that it replaces, whose bricks count
 * although they are not all in it yet; bricks (SIZES) how many there are of each size, counted up;
 * left how many more the table takes. tiers (n) is filled: 2 size, or 2 size + 1, of the largest
 * cube that a point is the first of; -1 where it is not shown. */
EXPORT(int64_t, take_points)(int64_t n, int64_t slots, int64_t old_slots, const double *points_mm,
                             double per_mm, int64_t finest, int64_t *table_, const int64_t *before_,
                             int64_t *bricks, int64_t left, int8_t *tiers)
{
    const double half = 1 << (CUBE_BITS - 1);
    Brick *table = (Brick *)table_;
    const Brick *before = (const Brick *)before_;
    for (int64_t i = 0; i < n; i++) {
        if (left < SIZES)
            return i;
        tiers[i] = -1;
        const double *point = points_mm + 3 * i;
        double fx = point[0] * per_mm, fy = point[1] * per_mm, fz = point[2] * per_mm;
        if (!(fabs(fx) < half && fabs(fy) < half && fabs(fz) < half))
            continue;
        int64_t size = finest >> 1, tier = -1;
        uint64_t x = (uint64_t)(floor(fx) + half) >> size;
        uint64_t y = (uint64_t)(floor(fy) + half) >> size;
        uint64_t z = (uint64_t)(floor(fz) + half) >> size;
        for (; size < SIZES; size++, x >>= 1, y >>= 1, z >>= 1) {
            uint64_t key = (uint64_t)(size + 1) << 3 * BRICK_BITS | x >> 2 << 2 * BRICK_BITS |
                           y >> 2 << BRICK_BITS | z >> 2;
            uint64_t cube = (uint64_t)1 << ((x & 3) | (y & 3) << 2 | (z & 3) << 4);
            Brick *brick = table + slot_of(key, slots, table);
            if (brick->key == 0) {
                const Brick *old = before + slot_of(key, old_slots, before);
                *brick = (Brick){key, old->cubes};
                if (old->key == 0) {
                    bricks[size]++;
                    left--;
                }
            }
            if (brick->cubes & cube)
                break; /* then so are all larger cubes around it */
            brick->cubes |= cube;
            tier = 2 * size + 1 - (int64_t)((x + y + z) & 1);
        }
        if (tier >= finest)
            tiers[i] = (int8_t)tier;
    }
    return n;
}

/* Enters bricks of this size and larger ones, of before (old_slots, 2), into table (slots, 2)
 * unless they are there. */
EXPORT(void, copy_bricks)(int64_t old_slots, int64_t slots, const int64_t *before_,
                          int64_t smallest, int64_t *table_)
{
    Brick *table = (Brick *)table_;
    const Brick *before = (const Brick *)before_;
    for (int64_t i = 0; i < old_slots; i++) {
        if (before[i].key >> 3 * BRICK_BITS <= (uint64_t)smallest)
            continue;
        Brick *brick = table + slot_of(before[i].key, slots, table);
        if (brick->key == 0)
            *brick = before[i];
    }
}
