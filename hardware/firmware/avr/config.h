/* What differs from arm to arm. Every value may be given to make: make JOINTS=7 SERIAL_NUMBER=A-2 */
#ifndef CONFIG_H
#define CONFIG_H

#ifndef JOINTS
#define JOINTS 6
#endif

#ifndef SAMPLE_HZ
#define SAMPLE_HZ 200
#endif

/* A baud rate that F_CPU yields exactly: 250000, 500000 or 1000000 at 16 MHz. */
#ifndef BAUD_RATE
#define BAUD_RATE 500000
#endif

#ifndef NAME
#define NAME "Encoder arm"
#endif

#ifndef SERIAL_NUMBER
#define SERIAL_NUMBER "unnumbered"
#endif

#define FIRMWARE_VERSION "1.0.0"

/* Of an AS5048A. */
#define COUNTS_PER_REVOLUTION 16384

/* Trigger pulses: limits of the rate, and length of a pulse. */
#define LOWEST_PULSE_MHZ 1000UL
#define HIGHEST_PULSE_MHZ 200000UL
#define PULSE_US 300

/* Which buttons are there: bit 0 primary, bit 1 undo, bit 2 back. */
#define BUTTONS 7

#if JOINTS < 5 || JOINTS > 7
#error "an arm has 5, 6 or 7 joints"
#endif
#if SAMPLE_HZ < 50 || SAMPLE_HZ > 400
#error "the sample rate is 50 to 400 Hz"
#endif
/* A sample is 23 + 4 n bytes of 10 bits each, one at a pulse 28 + 4 n; leave a fifth free. */
#if (23 + 4 * JOINTS) * SAMPLE_HZ + (28 + 4 * JOINTS) * (HIGHEST_PULSE_MHZ / 1000) > BAUD_RATE / 10 * 4 / 5
#error "the line is too slow for this sample rate"
#endif

#endif
