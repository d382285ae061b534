/* Three buttons to ground at PD2, PD3 and PD4. */
#ifndef BUTTONS_H
#define BUTTONS_H

#include <stdint.h>

void buttons_init(void);

/* Settled state, a bit each, 1 = pressed; call it once per sample. */
uint8_t buttons_sample(void);

#endif
