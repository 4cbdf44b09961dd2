; The words behind the interrupt vectors, up to those that handlers of `more.s` begin in.

        .section .progmem.gcc.engine, "ax", @progbits
engine_begins:

