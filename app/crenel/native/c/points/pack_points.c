/* Points of a cloud as records behind one another, as files and the display are handed them. */
#include "../export.h"

/* As POINT in app/crenel/formats/clouds/points.py. */
typedef struct __attribute__((packed)) {
    double x, y, z;
    float intensity, uncertainty_um;
    int32_t frame;
} PointRecord;

_Static_assert(sizeof(PointRecord) == 36, "a record has no gaps");

/* points_mm (n, 3), intensity, uncertainty_um and frame (n) to records (n, 36); points that are
 * not finite are left out. Returns how many records there are. */
EXPORT(int64_t, pack_points)(int64_t n, const double *points_mm, const double *intensity,
                             const double *uncertainty_um, const int64_t *frame, uint8_t *records)
{
    PointRecord *next = (PointRecord *)records;
    for (int64_t i = 0; i < n; i++) {
        double x = points_mm[3 * i], y = points_mm[3 * i + 1], z = points_mm[3 * i + 2];
        if (isfinite(x) && isfinite(y) && isfinite(z))
            *next++ = (PointRecord){
                x, y, z, (float)intensity[i], (float)uncertainty_um[i], (int32_t)frame[i]};
    }
    return next - (PointRecord *)records;
}
