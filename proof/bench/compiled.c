/* Yardstick: the same logic by hand in C, compiled. It bounds what a PLC can reach that turns its program into C and
 * flashes it: one reading and one writing of each port, and nothing beside the logic: no clock, no watchdog, no check.
 *
 * Each point of the images is a byte of RAM, 0 or 1, and volatile: the compiler can neither leave out a coil that
 * another overwrites nor merge two rungs, so each rung is work that is really done.
 *
 * rungs.inc, which the bench generates, holds a statement for each rung, such as
 *   q[0] = i[0] & i[1];                 input 01 and input 02 to output 01
 *   q[3] = NOT(q[3]);                   the rung that toggles output 04 */

#include <avr/io.h>
#include <stdint.h>

#define NOT(bit) ((bit) ^ 1)

static volatile uint8_t i[4], q[4];

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

#include "rungs.inc"

        PORTD = 0x3C | q[1] << 7 | q[0] << 6;
        PORTB = q[3] << 1 | q[2];
    }
}
