#include "latch.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/atomic.h>

#include "config.h"

#define TICKS_PER_S 2000000UL
#define SAMPLE_TICKS (TICKS_PER_S / SAMPLE_HZ)
#define PAUSE_TICKS (TICKS_PER_S / 100 * 35)
#define PULSE_TICKS (2 * PULSE_US)
/* Latchings are at least 2 ms apart, time to read and to send; a sample closer to a pulse is left
   out. simavr needs most of it, since it takes 0.1 ms for a byte of SPI. */
#define LEAST_TICKS (TICKS_PER_S / 500)

/* Effect of a match on the pin; without one, the port drives the pin low. */
#define TRIGGER_CLEARS _BV(COM1A1)
#define TRIGGER_SETS (_BV(COM1A1) | _BV(COM1A0))
#define LATCH_CLEARS _BV(COM1B1)
#define LATCH_SETS (_BV(COM1B1) | _BV(COM1B0))

static uint64_t now_ticks;    /* of the latching that OCR1B waits for */
static uint32_t next_sample, next_pulse, pulse_ticks, pulses;
static uint32_t sequence;
static bool at_pulse;         /* the latching that OCR1B waits for is a pulse */
static bool trigger_is_high;
static volatile bool ready, armed;
static Latching latching;

/* Timer 1 raises the trigger together with the latch line. */
static void prepare_trigger(void) {
    OCR1A = OCR1B;
    TCCR1A |= TRIGGER_SETS;
}

/* The next latching: a pulse, or a sample if no pulse is near it. */
static void schedule(void) {
    uint32_t at = (uint32_t)now_ticks;
    at_pulse = pulse_ticks && (int32_t)(next_pulse - next_sample) < (int32_t)LEAST_TICKS;
    if (at_pulse) {
        at = next_pulse;
        next_pulse += pulse_ticks;
        if ((int32_t)(next_sample - at) < (int32_t)LEAST_TICKS)
            next_sample += SAMPLE_TICKS;
    } else {
        at = next_sample;
        next_sample += SAMPLE_TICKS;
    }
    now_ticks += at - (uint32_t)now_ticks;
    OCR1B = (uint16_t)at;
    if (at_pulse && !trigger_is_high)
        prepare_trigger();
}

void latch_init(void) {
    DDRB |= _BV(DDB1) | _BV(DDB2);
    TCCR1A = TRIGGER_CLEARS | LATCH_CLEARS;
    TCCR1C = _BV(FOC1A) | _BV(FOC1B);
    TCCR1A = 0;
    next_sample = SAMPLE_TICKS;
    schedule();
    TIFR1 = _BV(OCF1A) | _BV(OCF1B);
    TIMSK1 = _BV(OCIE1A) | _BV(OCIE1B);
    TCNT1 = 0;
    TCCR1B = _BV(CS11); /* F_CPU / 8 */
}

ISR(TIMER1_COMPB_vect) {
    sequence++;
    if (at_pulse) {
        pulses++;
        trigger_is_high = true;
        TCCR1A &= ~TRIGGER_SETS | TRIGGER_CLEARS; /* at the next match of unit A */
        OCR1A = OCR1B + PULSE_TICKS;
    }
    if (armed) { /* else the readings before were not shifted out yet: this one is lost */
        latching.sequence = sequence;
        latching.time_us = now_ticks / 2;
        latching.pulse = at_pulse ? pulses : 0;
        armed = false;
        ready = true;
    }
    schedule();
}

ISR(TIMER1_COMPA_vect) {
    if ((TCCR1A & TRIGGER_SETS) != TRIGGER_CLEARS)
        return;
    trigger_is_high = false;
    TCCR1A &= ~TRIGGER_SETS;
    if (at_pulse)
        prepare_trigger();
}

bool latch_is_ready(void) {
    return ready;
}

Latching latch_take(void) {
    ready = false;
    return latching;
}

void latch_lower(void) {
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        armed = false;
        /* through the compare unit, so that its output is low when it is connected again */
        TCCR1A = (TCCR1A & ~LATCH_SETS) | LATCH_CLEARS;
        TCCR1C = _BV(FOC1B);
        TCCR1A &= ~LATCH_SETS;
        PORTB &= ~_BV(PORTB2); /* simavr knows no forced match */
    }
}

void latch_arm(void) {
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        TCCR1A |= LATCH_SETS;
        armed = true;
    }
}

uint32_t latch_set_pulses(uint32_t rate_mhz) {
    uint32_t ticks = 0;
    if (rate_mhz)
        ticks = (TICKS_PER_S * 1000UL + rate_mhz / 2) / rate_mhz;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        if (at_pulse) { /* what was prepared becomes a sample */
            at_pulse = false;
            if (!trigger_is_high)
                TCCR1A &= ~TRIGGER_SETS;
        }
        pulses = 0;
        pulse_ticks = ticks;
        next_pulse = (uint32_t)now_ticks + PAUSE_TICKS;
    }
    return ticks ? (TICKS_PER_S * 1000UL + ticks / 2) / ticks : 0;
}
