# How simavr's core is compiled, which nearly all time of the tests goes through. `.cargo/config.toml` has make read this
# before the Makefile of simavr, whose own flags stay in force: nothing there takes one flag more from outside.
# Functions that nobody replaces may stand where they are called.
%/sim_core.o: override CFLAGS += -O3 -fno-semantic-interposition
