/* The serial line to the host, 8 data bits, no parity, 1 stop bit. */
#ifndef UART_H
#define UART_H

#include <stdbool.h>
#include <stdint.h>

void uart_init(void);

/* Whether so many bytes can be put without waiting. */
bool uart_has_room(uint8_t count);

/* Appends one byte to what is sent; there must be room for it. */
void uart_put(uint8_t byte);

bool uart_has_input(void);

/* The next byte of the host; there must be one. */
uint8_t uart_get(void);

#endif
