/* All of the library's code, in one text so that the compiler sees the whole of it. */
#include "export.h"

#include "doubles.h"
#include "lens.h"
#include "sorting.h"
#include "vectors.h"

#include "points/expand_lzf.c"
#include "points/frame_points.c"
#include "points/pack_points.c"
#include "points/write_decimals.c"

#include "stripe/stripe.c"

#include "detection/directions.c"
#include "detection/bearings.c"
#include "detection/voting.c"
#include "detection/visibility.c"
#include "detection/edge_points.c"
#include "detection/edge_step.c"
#include "detection/edge_fit.c"

#include "adjustment/line_images.c"
#include "adjustment/line_scatter.c"

#include "recording/records.c"
#include "recording/joints.c"
#include "recording/stripes.c"
#include "mesh/closest.c"
#include "mesh/tree.c"

#include "view/surface.c"
#include "view/voxels.c"
