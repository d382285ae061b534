/* The stripe's extraction, in the order in which a frame is worked on. */
#include "lanes.h"
#include "workspace.h"

#define BITS 8
#include "greys.h"
#include "search.c"
#include "read_noise.c"
#include "peaks.c"
#undef BITS
#define BITS 16
#include "greys.h"
#include "search.c"
#include "read_noise.c"
#include "peaks.c"
#undef BITS

#include "choice.c"

#define BITS 8
#include "profiles.c"
#undef BITS
#define BITS 16
#include "profiles.c"
#undef BITS

#include "start.c"
#include "normal.c"
#include "fit.c"
#include "noise.c"
#include "sift.c"
#include "runs.c"
#include "speckle.c"

#define BITS 8
#include "pipeline.c"
#undef BITS
#define BITS 16
#include "pipeline.c"
#undef BITS
#include "tracking.c"
