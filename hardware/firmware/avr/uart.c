#include "uart.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "config.h"

#define INPUT_MASK 63

/* Rings: an index is changed on one side only. 8-bit indices wrap at the size of the output ring. */
static volatile uint8_t output[256], input[INPUT_MASK + 1];
static volatile uint8_t output_head, output_tail, input_head, input_tail;

void uart_init(void) {
    UBRR0 = F_CPU / 8 / BAUD_RATE - 1;
    UCSR0A = _BV(U2X0);
    UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);
    UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
}

bool uart_has_room(uint8_t count) {
    return (uint8_t)(output_tail - output_head - 1) >= count;
}

void uart_put(uint8_t byte) {
    output[output_head] = byte;
    output_head++;
    UCSR0B |= _BV(UDRIE0);
}

bool uart_has_input(void) {
    return input_head != input_tail;
}

uint8_t uart_get(void) {
    uint8_t byte = input[input_tail];
    input_tail = (input_tail + 1) & INPUT_MASK;
    return byte;
}

ISR(USART_UDRE_vect) {
    if (output_head == output_tail) {
        UCSR0B &= ~_BV(UDRIE0);
        return;
    }
    UDR0 = output[output_tail];
    output_tail++;
}

ISR(USART_RX_vect) {
    uint8_t byte = UDR0, next = (input_head + 1) & INPUT_MASK;
    if (next != input_tail) { /* else the request is lost, and the host repeats it */
        input[input_head] = byte;
        input_head = next;
    }
}
