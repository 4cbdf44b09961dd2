/* Yardstick: the interpreter that the thesis describes, in its section 3.3 and as program C of its section 4.2: the
 * program in an array of long, read once; in each turn of the loop the inputs are read with digitalRead, every line goes
 * through a switch, and the outputs are written with digitalWrite.
 *
 * How a line is told apart is not in the text. Its equation (1) takes the number of the port by subtraction
 * (827311 - 827300 = 11); so does this. With -DDIVIDE the last two digits are split off by division instead.
 *
 * Left out, in favour of this yardstick: timers and OR blocks, the timer library's tick() in each turn, the Arduino
 * core's own timer interrupt, and any check of a point's number.
 *
 * program.inc, which the bench generates, holds the codes with a comma behind each. */

#include "arduino.h"
#include <stdbool.h>

#define FIRST_INPUT 2
#define FIRST_OUTPUT 6
#define POINTS 4

static long program[] = {
#include "program.inc"
};

static bool inputs[POINTS];
static bool outputs[POINTS];

#ifdef DIVIDE

static __attribute__((noinline)) void interpret_line(long line, bool *value)
{
    long command = line / 100;
    int8_t number = line - command * 100; /* avr-gcc makes a second division of a %. */
    uint8_t point = (number < 0 ? -number : number) - 1;
    switch (command) {
    case 0:
    case 7876:
        *value = true;
        break;
    case 8273:
        *value = *value && inputs[point];
        break;
    case -8273:
        *value = *value && !inputs[point];
        break;
    case 8279:
        *value = *value && outputs[point];
        break;
    case -8279:
        *value = *value && !outputs[point];
        break;
    case 8779:
        outputs[point] = *value;
        break;
    case 838779:
        if (*value)
            outputs[point] = true;
        break;
    case 828779:
        if (*value)
            outputs[point] = false;
        break;
    }
}

#else

static __attribute__((noinline)) void interpret_line(long line, bool *value)
{
    switch (line) {
    case 0:
    case 787600:
        *value = true;
        break;
    case 827301 ... 827304:
        *value = *value && inputs[line - 827301];
        break;
    case -827304 ... -827301:
        *value = *value && !inputs[-line - 827301];
        break;
    case 827901 ... 827904:
        *value = *value && outputs[line - 827901];
        break;
    case -827904 ... -827901:
        *value = *value && !outputs[-line - 827901];
        break;
    case 877901 ... 877904:
        outputs[line - 877901] = *value;
        break;
    case 83877901 ... 83877904:
        if (*value)
            outputs[line - 83877901] = true;
        break;
    case 82877901 ... 82877904:
        if (*value)
            outputs[line - 82877901] = false;
        break;
    }
}

#endif

static void loop(void)
{
    bool value = true;
    for (uint8_t n = 0; n < POINTS; n++)
        inputs[n] = digitalRead(FIRST_INPUT + n) == LOW;
    for (uint16_t n = 0; n < sizeof program / sizeof program[0]; n++)
        interpret_line(program[n], &value);
    for (uint8_t n = 0; n < POINTS; n++)
        digitalWrite(FIRST_OUTPUT + n, outputs[n]);
}

int main(void)
{
    for (uint8_t n = 0; n < POINTS; n++) {
        pinMode(FIRST_INPUT + n, INPUT_PULLUP);
        pinMode(FIRST_OUTPUT + n, OUTPUT);
    }
    for (;;)
        loop();
}
