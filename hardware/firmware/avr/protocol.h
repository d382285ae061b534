/* Version 2 of the bridge protocol, as hardware/crenel_hardware/arm/protocol.py describes it. */
#ifndef PROTOCOL_H
#define PROTOCOL_H

#include <stdbool.h>
#include <stdint.h>

#include "config.h"
#include "latch.h"

typedef enum { NO_REQUEST, HELLO_REQUEST, PULSE_REQUEST } RequestKind;

typedef struct {
    RequestKind kind;
    uint8_t number;    /* of a pulse request */
    uint32_t rate_mhz; /* the same */
} Request;

/* Each sends one packet, or nothing if the line is full: the host sees the gap. */
void send_sample(const Latching *latching, uint8_t buttons, const int32_t counts[JOINTS]);
void send_hello(void);
void send_pulse_answer(uint8_t number, bool done, uint32_t rate_mhz);

/* The request that this byte of the host completes. Whatever is no request is passed over. */
Request receive(uint8_t byte);

#endif
