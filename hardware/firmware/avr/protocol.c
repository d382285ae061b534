#include "protocol.h"

#include <avr/pgmspace.h>
#include <string.h>

#include "uart.h"

#define FRAME_BYTES 9
#define SAMPLE_BYTES (14 + 4 * JOINTS)
#define HELLO_BYTES (83 + 4 * JOINTS)
#define REQUEST_BYTES 14
#define HELLO_REQUEST_BYTES 9

enum { SAMPLE = 0x01, HELLO = 0x02, PULSE = 0x04, PULSE_ANSWER = 0x05 };

/* CRC-32 of the 16 values of half a byte, polynomial EDB88320. */
static const uint32_t half_byte_crc[16] PROGMEM = {
    0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
    0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C,
};

static const uint8_t hello_request[HELLO_REQUEST_BYTES] PROGMEM = {
    0xA7, 0x5C, 0x01, 0x81, 0x00, 0x2F, 0x1A, 0x1B, 0xDC,
};
static const uint8_t pulse_request[5] PROGMEM = {0xA7, 0x5C, 0x02, 0x82, 0x05};

static uint32_t crc;

static uint32_t crc_of(uint32_t before, uint8_t byte) {
    before ^= byte;
    before = (before >> 4) ^ pgm_read_dword(&half_byte_crc[before & 15]);
    return (before >> 4) ^ pgm_read_dword(&half_byte_crc[before & 15]);
}

static void put(uint8_t byte) {
    crc = crc_of(crc, byte);
    uart_put(byte);
}

/* Numbers are little-endian here as in the packet. */
static void put_all(const void *data, uint8_t size) {
    for (const uint8_t *byte = data; size--; byte++)
        put(*byte);
}

static void put_text(const char *text, uint8_t size) {
    while (size--)
        put(*text ? *text++ : 0);
}

/* False if the whole packet does not fit. */
static bool begin(uint8_t type, uint8_t size) {
    if (!uart_has_room(size + FRAME_BYTES))
        return false;
    uart_put(0xA7);
    uart_put(0x5C);
    crc = 0xFFFFFFFF;
    put(2);
    put(type);
    put(size);
    return true;
}

static void finish(void) {
    uint32_t sum = ~crc;
    for (uint8_t i = 0; i < 4; i++, sum >>= 8)
        uart_put((uint8_t)sum);
}

void send_sample(const Latching *latching, uint8_t buttons, const int32_t counts[JOINTS]) {
    if (latching->pulse) {
        if (!begin(PULSE, 5 + SAMPLE_BYTES))
            return;
        put_all(&latching->pulse, 4);
        put(SAMPLE);
    } else if (!begin(SAMPLE, SAMPLE_BYTES)) {
        return;
    }
    put_all(&latching->sequence, 4);
    put_all(&latching->time_us, 8);
    put(buttons);
    put(JOINTS);
    put_all(counts, 4 * JOINTS);
    finish();
}

void send_hello(void) {
    static const struct {
        uint8_t joints;
        uint32_t rate_mhz;
        uint8_t properties, buttons;
        uint32_t setting, lowest_pulse_mhz, highest_pulse_mhz;
    } __attribute__((packed)) head = {
        JOINTS, 1000UL * SAMPLE_HZ, 0, BUTTONS, 0, LOWEST_PULSE_MHZ, HIGHEST_PULSE_MHZ,
    };
    uint32_t counts = COUNTS_PER_REVOLUTION;
    if (!begin(HELLO, HELLO_BYTES))
        return;
    put_all(&head, sizeof head);
    for (uint8_t i = 0; i < JOINTS; i++)
        put_all(&counts, 4);
    put_text(NAME, 32);
    put_text(SERIAL_NUMBER, 16);
    put_text(FIRMWARE_VERSION, 16);
    finish();
}

void send_pulse_answer(uint8_t number, bool done, uint32_t rate_mhz) {
    if (!begin(PULSE_ANSWER, 6))
        return;
    put(number);
    put(!done);
    put_all(&rate_mhz, 4);
    finish();
}

Request receive(uint8_t byte) {
    static uint8_t heard[REQUEST_BYTES];
    Request request = {NO_REQUEST, 0, 0};
    uint32_t sum = 0xFFFFFFFF, stated;
    memmove(heard, heard + 1, REQUEST_BYTES - 1);
    heard[REQUEST_BYTES - 1] = byte;
    if (!memcmp_P(heard + REQUEST_BYTES - HELLO_REQUEST_BYTES, hello_request, sizeof hello_request)) {
        request.kind = HELLO_REQUEST;
    } else if (!memcmp_P(heard, pulse_request, sizeof pulse_request)) {
        for (uint8_t i = 2; i < 10; i++)
            sum = crc_of(sum, heard[i]);
        memcpy(&stated, heard + 10, 4);
        if (stated == ~sum) {
            request.kind = PULSE_REQUEST;
            request.number = heard[5];
            memcpy(&request.rate_mhz, heard + 6, 4);
        }
    }
    return request;
}
