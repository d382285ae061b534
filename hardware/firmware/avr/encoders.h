/* Absolute encoders AS5048A in one chain: SPI, common chip select. */
#ifndef ENCODERS_H
#define ENCODERS_H

#include <stdbool.h>
#include <stdint.h>

#include "config.h"

void encoders_init(void);

/* Shifts out what was latched, and makes the encoders ready for the next latching.
   Returns false if a reading is not valid; counts then stay as they were. */
bool encoders_read(int32_t counts[JOINTS]);

#endif
