/* All of the simulator's code, in one text so that the compiler sees the whole of it. */
#include "../../../../app/native/c/export.h"
