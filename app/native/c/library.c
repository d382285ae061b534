/* All of the library's code, in one text so that the compiler sees the whole of it. */
#include "export.h"

#include "points/frame_points.c"
#include "points/pack_points.c"
#include "points/write_decimals.c"

#include "stripe/stripe.c"

#include "recording/records.c"
#include "recording/joints.c"
#include "recording/stripes.c"
#include "view/voxels.c"
