#include "buttons.h"

#include <avr/io.h>

#include "config.h"

#define FIRST_PIN PORTD2
/* A button changes when its contact was the other way for so many samples in a row. Every state
   therefore lasts at least as long. */
#define SETTLED 5

void buttons_init(void) {
    PORTD |= BUTTONS << FIRST_PIN; /* pull-up resistors */
}

uint8_t buttons_sample(void) {
    static uint8_t state, changed[3];
    uint8_t down = (uint8_t)(~PIND >> FIRST_PIN) & BUTTONS;
    for (uint8_t i = 0; i < 3; i++) {
        uint8_t bit = 1 << i;
        if ((down ^ state) & bit) {
            if (++changed[i] >= SETTLED) {
                state ^= bit;
                changed[i] = 0;
            }
        } else {
            changed[i] = 0;
        }
    }
    return state;
}
