/* Firmware of an encoder arm with an ATmega328P: see docs/build_an_arm.md. */
#include <avr/interrupt.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "buttons.h"
#include "config.h"
#include "encoders.h"
#include "latch.h"
#include "protocol.h"
#include "uart.h"

/* After a reset by the watchdog it still runs, with the shortest time. */
void stop_watchdog(void) __attribute__((naked, used, section(".init3")));
void stop_watchdog(void) {
    MCUSR = 0;
    wdt_disable();
}

static void answer_pulse_request(const Request *request) {
    static bool answered;
    static uint8_t number;
    static uint32_t rate_mhz, true_mhz;
    bool repeated = answered && request->number == number && request->rate_mhz == rate_mhz;
    bool possible = request->rate_mhz == 0 || (request->rate_mhz >= LOWEST_PULSE_MHZ &&
                                               request->rate_mhz <= HIGHEST_PULSE_MHZ);
    if (possible && !repeated) {
        true_mhz = latch_set_pulses(request->rate_mhz);
        number = request->number;
        rate_mhz = request->rate_mhz;
        answered = true;
    }
    send_pulse_answer(request->number, possible, true_mhz);
}

static void answer(uint8_t byte) {
    Request request = receive(byte);
    if (request.kind == HELLO_REQUEST)
        send_hello();
    else if (request.kind == PULSE_REQUEST)
        answer_pulse_request(&request);
}

static void take_sample(void) {
    static int32_t counts[JOINTS];
    Latching latching = latch_take();
    bool valid = encoders_read(counts);
    uint8_t buttons = buttons_sample();
    if (valid)
        send_sample(&latching, buttons, counts);
}

int main(void) {
    uart_init();
    buttons_init();
    latch_init();
    encoders_init();
    set_sleep_mode(SLEEP_MODE_IDLE);
    wdt_enable(WDTO_250MS);
    sei();
    for (;;) {
        if (latch_is_ready()) {
            take_sample();
            wdt_reset(); /* only while encoders are latched and read */
        }
        while (uart_has_input())
            answer(uart_get());
        cli();
        if (!latch_is_ready() && !uart_has_input()) {
            sleep_enable();
            sei(); /* takes effect after the next instruction */
            sleep_cpu();
            sleep_disable();
        }
        sei();
    }
}
