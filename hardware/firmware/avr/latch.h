/* Time, the latch line of the encoders and the trigger output of the camera.

   Timer 1 counts half microseconds. Its compare unit B raises the latch line (OC1B), its compare
   unit A the trigger (OC1A), both in hardware: at a trigger pulse they rise with the same tick,
   whatever the program is doing. */
#ifndef LATCH_H
#define LATCH_H

#include <stdbool.h>
#include <stdint.h>

/* One latching of all encoders. */
typedef struct {
    uint32_t sequence;
    uint64_t time_us;
    uint32_t pulse; /* number of the trigger pulse; 0 between pulses */
} Latching;

void latch_init(void);

/* Whether the encoders were latched since the last latch_take. */
bool latch_is_ready(void);

Latching latch_take(void);

/* Pulls the latch line low, to shift the readings out. */
void latch_lower(void);

/* The encoders are ready for the next latching. */
void latch_arm(void);

/* Stops the pulses; starts them 0.35 s later unless the rate is 0.
   Returns the rate as exactly as it is known, in mHz. */
uint32_t latch_set_pulses(uint32_t rate_mhz);

#endif
