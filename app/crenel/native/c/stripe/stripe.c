/* The stripe's extraction, in the order in which a frame is worked on. */
#include "lanes.h"
#include "workspace.h"
#include "median.c"

#define BITS 8
#include "greys.h"
#include "reduce.c"
#include "search.c"
#include "read_noise.c"
#include "peaks.c"
#undef BITS
#define BITS 16
#include "greys.h"
#include "reduce.c"
#include "search.c"
#include "read_noise.c"
#include "peaks.c"
#undef BITS

#include "choice.c"

#define BITS 8
#include "plateau.c"
#include "profiles.c"
#undef BITS
#define BITS 16
#include "plateau.c"
#include "profiles.c"
#undef BITS

#include "start.c"
#include "normal.c"
#include "fit.c"
#include "noise.c"
#include "runs.c"
#include "sift.c"
#include "speckle.c"

/* a line whose core is clipped */
#include "clipped.h"
#define BITS 8
#include "clipped_runs.c"
#undef BITS
#define BITS 16
#include "clipped_runs.c"
#undef BITS
#include "cores.c"
#define BITS 8
#include "flanks.c"
#undef BITS
#define BITS 16
#include "flanks.c"
#undef BITS
#include "flank_step.c"
#include "flank_noise.c"
#include "halo.c"
#include "flank_fit.c"
#include "smooth.c"
#include "join.c"

#include "line.c"
#define BITS 8
#include "evidence.c"
#undef BITS
#define BITS 16
#include "evidence.c"
#undef BITS

#define BITS 8
#include "pipeline.c"
#undef BITS
#define BITS 16
#include "pipeline.c"
#undef BITS
#include "tracking.c"
