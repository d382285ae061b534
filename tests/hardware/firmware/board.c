/* The arm's circuit board around the real machine code: microcontroller of simavr, a chain of
   AS5048A encoders on its SPI, three buttons, the trigger output, and its UART at a pseudo-terminal.

   board FIRMWARE.elf JOINTS LINK
   makes LINK a symbolic link to the terminal. Commands come as lines on standard input:
     angle JOINT VALUE    error JOINT    noise JOINT (wrong parity, once)
     glide MS (the encoders turn to new angles, all together, in so many milliseconds)
     button BIT DOWN      reset          hang (no timer interrupt any more)
     bounce BIT COUNT MS (so many changes of the contact, each for so long; an odd count presses)
     mark (says "mark", after all that was said before)
     drop COUNT (samples that the line swallows)
     step VALUE (the first encoder turns by this after each trigger pulse)
   On standard output, a line "running" says that the arm sends, "host" that bytes arrived from the
   host, and "pulse" with three numbers the clock cycles of a trigger pulse: when it rose, when the
   encoders were last latched before it fell, and when it fell. */
#include <fcntl.h>
#include <pty.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_spi.h>
#include <simavr/avr_timer.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { CLOCK_HZ = 16000000, MOST_JOINTS = 7, TIMSK1_ADDRESS = 0x6F, SLICE = 16000 };
enum { TCCR1A_ADDRESS = 0x80, COM1A0_BIT = 6 };
enum { READ_ANGLE = 0xFFFF, READ_ERROR = 0x4001, ERROR_FLAG = 0x4000 };

static avr_t *avr;
static int joints, terminal;

/* ---- encoders ---- */

static int angle[MOST_JOINTS], has_error[MOST_JOINTS], is_noisy[MOST_JOINTS];
static int target[MOST_JOINTS], glide_ms = 1, left_ms;
static int step_at_pulse;
static unsigned answer[MOST_JOINTS];
static unsigned char chain[2 * MOST_JOINTS];
static int selected;
static avr_cycle_count_t latched_at;
static avr_irq_t *miso;

static unsigned with_parity(unsigned word) {
    return (word & 0x7FFF) | (unsigned)__builtin_parity(word & 0x7FFF) << 15;
}

static void end_frame(void) {
    for (int i = 0; i < joints; i++) {
        unsigned command = chain[2 * i] << 8 | chain[2 * i + 1], flag;
        if (with_parity(command) != command || (command != READ_ANGLE && command != READ_ERROR))
            has_error[i] = 1;
        flag = has_error[i] ? ERROR_FLAG : 0;
        if (command == READ_ERROR) {
            answer[i] = with_parity(flag | 4);
            has_error[i] = 0;
        } else {
            answer[i] = with_parity(flag | (angle[i] & 0x3FFF));
        }
        if (is_noisy[i]) {
            answer[i] ^= 0x8000;
            is_noisy[i] = 0;
        }
    }
    latched_at = avr->cycle;
}

static void turn_on(void) {
    if (!left_ms)
        return;
    for (int i = 0; i < joints; i++)
        angle[i] += (((target[i] - angle[i] + 0x2000) & 0x3FFF) - 0x2000) / left_ms;
    left_ms--;
}

static void on_select(avr_irq_t *irq, uint32_t value, void *param) {
    (void)irq, (void)param;
    if (!value && !selected) {
        selected = 1;
        for (int i = 0; i < joints; i++) {
            chain[2 * i] = answer[i] >> 8;
            chain[2 * i + 1] = answer[i] & 0xFF;
        }
    } else if (value && selected) {
        selected = 0;
        end_frame();
    }
}

static void on_spi_byte(avr_irq_t *irq, uint32_t value, void *param) {
    unsigned char out = chain[0];
    (void)irq, (void)param;
    if (!selected)
        return;
    memmove(chain, chain + 1, 2 * joints - 1);
    chain[2 * joints - 1] = (unsigned char)value;
    avr_raise_irq(miso, out);
}

/* ---- trigger ---- */

/* simavr also changes the output where the timer overflows, and where a compare register is written:
   to the opposite of what a match does, as in PWM, whatever the timer's mode. The hardware changes
   it at a match alone. */
static int is_match(uint32_t value) {
    return value == (avr->data[TCCR1A_ADDRESS] >> COM1A0_BIT & 1);
}

static void on_trigger(avr_irq_t *irq, uint32_t value, void *param) {
    static int high;
    static unsigned long long rose;
    (void)irq, (void)param;
    if (!is_match(value))
        return;
    if (value && !high)
        rose = avr->cycle;
    if (!value && high) {
        printf("pulse %llu %llu %llu\n", rose, (unsigned long long)latched_at,
               (unsigned long long)avr->cycle);
        fflush(stdout);
        target[0] = angle[0] += step_at_pulse;
    }
    high = value != 0;
}

/* ---- serial line ---- */

static unsigned char to_host[65536], to_arm[4096], packet[264];
static int to_host_count, to_arm_count, packet_count, drop, running, may_receive = 1;
static avr_irq_t *receiver;

/* Whole packets, so that the line can swallow one. */
static void on_uart_byte(avr_irq_t *irq, uint32_t value, void *param) {
    static const unsigned char sync[] = {0xA7, 0x5C};
    (void)irq, (void)param;
    packet[packet_count++] = (unsigned char)value;
    if (packet_count <= 2 && packet[packet_count - 1] == sync[packet_count - 1])
        return;
    if (packet_count > 2 && (packet_count < 5 || packet_count < packet[4] + 9))
        return;
    if (packet_count > 2 && packet[3] == 1 && drop)
        drop--;
    else if (to_host_count + packet_count <= (int)sizeof to_host) {
        memcpy(to_host + to_host_count, packet, packet_count);
        to_host_count += packet_count;
    }
    packet_count = 0;
}

static void on_uart_ready(avr_irq_t *irq, uint32_t value, void *param) {
    (void)irq, (void)value, (void)param;
    may_receive = 1;
}

static void on_uart_full(avr_irq_t *irq, uint32_t value, void *param) {
    (void)irq, (void)value, (void)param;
    may_receive = 0;
}

/* One byte in the time of two, as from a host in no hurry. */
static void feed(void) {
    static avr_cycle_count_t due;
    if (!to_arm_count || !may_receive || avr->cycle < due)
        return;
    unsigned char byte = to_arm[0];
    due = avr->cycle + 640;
    memmove(to_arm, to_arm + 1, --to_arm_count);
    avr_raise_irq(receiver, byte);
}

static void exchange_with_host(void) {
    ssize_t count = read(terminal, to_arm + to_arm_count, sizeof to_arm - to_arm_count);
    if (count > 0) {
        to_arm_count += count;
        printf("host\n");
        fflush(stdout);
    }
    if (to_host_count) {
        if (!running) { /* before, it would not hear a request */
            running = 1;
            printf("running\n");
            fflush(stdout);
        }
        /* what the host has not read waits; a packet that finds no room is lost */
        ssize_t written = write(terminal, to_host, to_host_count);
        if (written > 0) {
            to_host_count -= written;
            memmove(to_host, to_host + written, to_host_count);
        }
    }
}

static void open_terminal(const char *link) {
    int other;
    char name[128];
    struct termios raw;
    if (openpty(&terminal, &other, name, NULL, NULL))
        exit(3);
    tcgetattr(other, &raw);
    cfmakeraw(&raw);
    tcsetattr(other, TCSANOW, &raw);
    fcntl(terminal, F_SETFL, O_NONBLOCK);
    fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
    unlink(link);
    if (symlink(name, link))
        exit(3);
}

/* ---- commands ---- */

static void press(int bit, int down) {
    avr_raise_irq(
        avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), IOPORT_IRQ_PIN2 + bit), !down);
}

static int bouncing_bit, bounces_left, bounce_ms, bounce_due;

/* Each millisecond of the arm's clock, so that a host that is held up makes no contact longer. */
static void bounce(void) {
    if (!bounces_left || --bounce_due > 0)
        return;
    bounce_due = bounce_ms;
    press(bouncing_bit, bounces_left-- & 1);
}

static void obey(const char *line) {
    int joint, value;
    if (sscanf(line, "bounce %d %d %d", &bouncing_bit, &bounces_left, &bounce_ms) == 3) {
        bounce_due = 0;
        return;
    }
    if (sscanf(line, "angle %d %d", &joint, &value) == 2)
        target[joint] = value, left_ms = glide_ms;
    else if (sscanf(line, "glide %d", &value) == 1)
        glide_ms = value;
    else if (sscanf(line, "error %d", &joint) == 1)
        has_error[joint] = 1;
    else if (sscanf(line, "noise %d", &joint) == 1)
        is_noisy[joint] = 1;
    else if (sscanf(line, "button %d %d", &joint, &value) == 2)
        press(joint, value);
    else if (sscanf(line, "drop %d", &value) == 1)
        drop = value;
    else if (sscanf(line, "step %d", &value) == 1)
        step_at_pulse = value;
    else if (!strcmp(line, "reset"))
        avr_reset(avr);
    else if (!strcmp(line, "mark")) {
        printf("mark\n");
        fflush(stdout);
    } else if (!strcmp(line, "hang"))
        avr->data[TIMSK1_ADDRESS] = 0;
}

static void obey_input(void) {
    static char line[256];
    static int length;
    char byte;
    ssize_t count;
    while ((count = read(STDIN_FILENO, &byte, 1)) == 1) {
        if (byte == '\n') {
            line[length] = 0;
            length = 0;
            obey(line);
        } else if (length < (int)sizeof line - 1) {
            line[length++] = byte;
        }
    }
    if (count == 0) /* the test has ended */
        exit(0);
}

/* ---- time ---- */

static void do_not_wait(avr_t *of, avr_cycle_count_t cycles) {
    (void)of, (void)cycles;
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

int main(int argc, char **argv) {
    static elf_firmware_t firmware;
    avr_cycle_count_t due = 0;
    double host_s = seconds(), arm_s = 0, last_s = 0;
    uint32_t flags = 0;
    if (argc != 4 || elf_read_firmware(argv[1], &firmware))
        return 2;
    joints = atoi(argv[2]);
    avr = avr_make_mcu_by_name("atmega328p");
    avr_init(avr);
    firmware.frequency = CLOCK_HZ;
    avr_load_firmware(avr, &firmware);
    avr->sleep = do_not_wait;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    open_terminal(argv[3]);
    miso = avr_io_getirq(avr, AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_INPUT);
    receiver = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
#define LISTEN(control, pin, call) \
    avr_irq_register_notify(avr_io_getirq(avr, control, pin), call, NULL)
    LISTEN(AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_OUTPUT, on_spi_byte);
    LISTEN(AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT, on_uart_byte);
    LISTEN(AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON, on_uart_ready);
    LISTEN(AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF, on_uart_full);
    /* the output of the compare unit: writing the port does not change a pin that it drives */
    LISTEN(AVR_IOCTL_TIMER_GETIRQ('1'), TIMER_IRQ_OUT_COMP, on_trigger);
    LISTEN(AVR_IOCTL_IOPORT_GETIRQ('B'), IOPORT_IRQ_PIN2, on_select);
    for (int bit = 0; bit < 3; bit++)
        press(bit, 0);
    for (;;) {
        int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed)
            return 4;
        feed();
        if (avr->cycle < due)
            continue;
        due = avr->cycle + SLICE;
        obey_input();
        turn_on();
        bounce();
        exchange_with_host();
        /* the arm's clock keeps step with the host's, or is slower if this machine is too slow; it
           never makes up for that, since a real one does not run fast */
        arm_s += (double)SLICE / CLOCK_HZ;
        last_s = seconds() - host_s;
        if (arm_s > last_s + 0.001)
            usleep(1e6 * (arm_s - last_s));
        else if (arm_s < last_s)
            arm_s = last_s;
    }
}
