#include "encoders.h"

#include <avr/io.h>
#include <util/parity.h>

#include "latch.h"

/* Words for the encoders: a read has bit 14, and bit 15 makes the number of ones even. */
#define READ_ANGLE 0xFFFF
#define READ_AND_CLEAR_ERROR 0x4001
#define ERROR_FLAG 0x4000
#define VALUE_MASK 0x3FFF

static uint16_t latched = READ_ANGLE; /* what the edge of the latch line before asked for */
static uint16_t next = READ_ANGLE;

static uint16_t exchange(uint16_t word) {
    uint16_t answer;
    SPDR = word >> 8;
    loop_until_bit_is_set(SPSR, SPIF);
    answer = (uint16_t)SPDR << 8;
    SPDR = word & 0xFF;
    loop_until_bit_is_set(SPSR, SPIF);
    return answer | SPDR;
}

/* Shifts a command into every encoder, and their answers to the command before out.
   The rising edge of the latch line ends the exchange; the angles are those at that edge. */
static void exchange_all(uint16_t command, uint16_t answers[JOINTS]) {
    latch_lower();
    for (uint8_t i = 0; i < JOINTS; i++)
        answers[i] = exchange(command);
    latch_arm();
}

static bool is_valid(uint16_t answer) {
    return !(answer & ERROR_FLAG) && !(parity_even_bit((uint8_t)(answer >> 8) ^ (uint8_t)answer));
}

void encoders_init(void) {
    uint16_t ignored[JOINTS];
    DDRB |= _BV(DDB3) | _BV(DDB5);
    SPCR = _BV(SPE) | _BV(MSTR) | _BV(CPHA) | _BV(SPR0); /* mode 1 */
    SPSR = _BV(SPI2X);                                   /* F_CPU / 8 */
    exchange_all(READ_ANGLE, ignored);
}

bool encoders_read(int32_t counts[JOINTS]) {
    static uint16_t last[JOINTS];
    static bool counting;
    uint16_t answers[JOINTS], answered = latched;
    bool valid = true;
    latched = next;
    next = READ_ANGLE;
    exchange_all(latched, answers);
    if (answered != READ_ANGLE)
        return false;
    for (uint8_t i = 0; i < JOINTS; i++)
        valid = valid && is_valid(answers[i]);
    if (!valid) {
        /* an encoder repeats its error until its register is read */
        if (latched == READ_ANGLE)
            next = READ_AND_CLEAR_ERROR;
        return false;
    }
    for (uint8_t i = 0; i < JOINTS; i++) {
        uint16_t value = answers[i] & VALUE_MASK;
        /* the shorter way round from the reading before: full turns leave no jump */
        int16_t moved = (int16_t)((value - last[i]) << 2) >> 2;
        counts[i] = counting ? counts[i] + moved : value;
        last[i] = value;
    }
    counting = true;
    return true;
}
