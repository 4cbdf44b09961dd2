/* Yardstick: single pieces of work by hand in C, compiled, beside the same in numeric code. As in compiled.c each point is
 * a byte of RAM, 0 or 1; numbers have 32 bits, as the board's registers have. All are volatile: each piece is really done.
 * REAL is avr-libc's float.
 *
 * work.inc, which the bench generates, holds one piece as often as it is measured. */

#include <avr/io.h>
#include <stdint.h>

#define NOT(bit) ((bit) ^ 1)

static volatile uint8_t i[4], q[4], m[3];
static volatile int32_t d[33];
static volatile float r[5];

int main(void)
{
    PORTD = 0x3C; /* pull-ups of D2 to D5 */
    DDRD = 0xC0;
    DDRB = 0x03;
    for (;;) {
        /* A closed button pulls its pin low and reads as 1. */
        uint8_t pins = ~PIND;
        i[0] = pins >> 2 & 1;
        i[1] = pins >> 3 & 1;
        i[2] = pins >> 4 & 1;
        i[3] = pins >> 5 & 1;
        m[1] = i[0];
        m[2] = i[1];
        d[1] = 12345;
        d[2] = -678;
        r[1] = 1.7f;
        r[2] = -2.3f;
        r[4] = 40.1f;

#include "work.inc"

        q[3] = NOT(q[3]);
        PORTD = 0x3C | q[1] << 7 | q[0] << 6;
        PORTB = q[3] << 1 | q[2];
    }
}
