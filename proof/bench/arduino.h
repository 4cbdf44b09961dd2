/* digitalRead and digitalWrite in the manner of the Arduino core, for the pins of the standard wiring: what a pin is
 * stands in tables in flash, a pin with a timer has its PWM switched off first, and a write cannot be interrupted.
 * Written anew for this comparison; the core's own work in the same steps. */

#ifndef ARDUINO_H
#define ARDUINO_H

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <stdint.h>

#define LOW 0
#define HIGH 1
#define INPUT_PULLUP 2
#define OUTPUT 1

enum { NO_TIMER, TIMER0A, TIMER0B, TIMER1A, TIMER1B, TIMER2A, TIMER2B };
enum { PORT_B, PORT_C, PORT_D };

/* Pins 0 to 19: D0 to D13, A0 to A5. */
#define PINS 20

static const uint8_t PROGMEM pin_port[PINS] = {
    PORT_D, PORT_D, PORT_D, PORT_D, PORT_D, PORT_D, PORT_D, PORT_D, PORT_B, PORT_B,
    PORT_B, PORT_B, PORT_B, PORT_B, PORT_C, PORT_C, PORT_C, PORT_C, PORT_C, PORT_C,
};
static const uint8_t PROGMEM pin_mask[PINS] = {
    1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 4, 1 << 5, 1 << 6, 1 << 7, 1 << 0, 1 << 1,
    1 << 2, 1 << 3, 1 << 4, 1 << 5, 1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 4, 1 << 5,
};
static const uint8_t PROGMEM pin_timer[PINS] = {
    NO_TIMER, NO_TIMER, NO_TIMER, TIMER2B,  NO_TIMER, TIMER0B,  TIMER0A,  NO_TIMER, NO_TIMER, TIMER1A,
    TIMER1B,  TIMER2A,  NO_TIMER, NO_TIMER, NO_TIMER, NO_TIMER, NO_TIMER, NO_TIMER, NO_TIMER, NO_TIMER,
};
static const uint16_t PROGMEM port_in[] = {(uint16_t)&PINB, (uint16_t)&PINC, (uint16_t)&PIND};
static const uint16_t PROGMEM port_out[] = {(uint16_t)&PORTB, (uint16_t)&PORTC, (uint16_t)&PORTD};
static const uint16_t PROGMEM port_mode[] = {(uint16_t)&DDRB, (uint16_t)&DDRC, (uint16_t)&DDRD};

#define REGISTER(table, port) ((volatile uint8_t *)pgm_read_word(&table[port]))

static __attribute__((noinline)) void pwm_off(uint8_t timer)
{
    switch (timer) {
    case TIMER0A: TCCR0A &= ~(1 << COM0A1); break;
    case TIMER0B: TCCR0A &= ~(1 << COM0B1); break;
    case TIMER1A: TCCR1A &= ~(1 << COM1A1); break;
    case TIMER1B: TCCR1A &= ~(1 << COM1B1); break;
    case TIMER2A: TCCR2A &= ~(1 << COM2A1); break;
    case TIMER2B: TCCR2A &= ~(1 << COM2B1); break;
    }
}

static __attribute__((noinline)) void digitalWrite(uint8_t pin, uint8_t level)
{
    uint8_t timer = pgm_read_byte(&pin_timer[pin]);
    uint8_t mask = pgm_read_byte(&pin_mask[pin]);
    volatile uint8_t *out = REGISTER(port_out, pgm_read_byte(&pin_port[pin]));
    if (timer != NO_TIMER)
        pwm_off(timer);
    uint8_t status = SREG;
    cli();
    if (level == LOW)
        *out &= ~mask;
    else
        *out |= mask;
    SREG = status;
}

static __attribute__((noinline)) int digitalRead(uint8_t pin)
{
    uint8_t timer = pgm_read_byte(&pin_timer[pin]);
    uint8_t mask = pgm_read_byte(&pin_mask[pin]);
    volatile uint8_t *in = REGISTER(port_in, pgm_read_byte(&pin_port[pin]));
    if (timer != NO_TIMER)
        pwm_off(timer);
    return *in & mask ? HIGH : LOW;
}

static __attribute__((noinline)) void pinMode(uint8_t pin, uint8_t mode)
{
    uint8_t mask = pgm_read_byte(&pin_mask[pin]);
    uint8_t port = pgm_read_byte(&pin_port[pin]);
    uint8_t status = SREG;
    cli();
    if (mode == OUTPUT) {
        *REGISTER(port_mode, port) |= mask;
    } else {
        *REGISTER(port_mode, port) &= ~mask;
        *REGISTER(port_out, port) |= mask;
    }
    SREG = status;
}

#endif
