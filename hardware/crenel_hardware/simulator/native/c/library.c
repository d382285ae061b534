/* All of the simulator's code, in one text so that the compiler sees the whole of it. */
#include "../../../../../app/crenel/native/c/export.h"

/* How a picture is made, step by step. */
#include "lens.c"
#include "shapes.c"
#include "tracing.c"
#include "shading.c"
#include "casting.c"
#include "striping.c"
#include "noise.c"

/* Where the arm holds the sensor. */
#include "kinematics.c"
