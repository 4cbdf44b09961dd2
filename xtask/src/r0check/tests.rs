//! The check on short pieces of machine code, as avr-as assembles them, at address 0.

use super::Origin::{self, Call, Entry, Product, Status};
use super::decode::{Flow, Read, Write, decode};
use super::elf::Code;
use super::{Report, flow};

fn bytes(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn check(words: &[u16]) -> anyhow::Result<Report> {
    let mut code = Code::default();
    code.add_block(0, &bytes(words));
    flow::check(&code, 0)
}

/// What it is, the code, and the findings: address and where the wrong value comes from.
type Case = (
    &'static str,
    &'static [u16],
    &'static [(u32, &'static [Origin])],
);

#[rustfmt::skip]
const CASES: &[Case] = &[
    ("the minimal case: mul; eor r1,r1; in r0,SREG; adiw; ldd; sbiw; out SREG,r0; add r24,r0; ret",
        &[0x9f89, 0x2411, 0xb60f, 0x9629, 0xad8e, 0x9729, 0xbe0f, 0x0d80, 0x9508],
        &[(14, &[Status(4)])]),
    ("the minimal case right: mul; mov r18,r0; …; add r24,r18; ret",
        &[0x9f89, 0x2d20, 0x2411, 0xb60f, 0x9629, 0xad8e, 0x9729, 0xbe0f, 0x0f82, 0x9508],
        &[]),
    ("lost on one path: mul; eor; cpi; breq 1f; in r0,SREG; cli; out SREG,r0; 1: mov r24,r0; ret",
        &[0x9f89, 0x2411, 0x3060, 0xf019, 0xb60f, 0x94f8, 0xbe0f, 0x2d80, 0x9508],
        &[(14, &[Status(8)])]),
    ("lost where a skip is not taken: mul; eor; sbrc r22,0; in r0,SREG; movw r24,r0; ret",
        &[0x9f89, 0x2411, 0xfd60, 0xb60f, 0x01c0, 0x9508],
        &[(8, &[Status(6)])]),
    ("a skip over two words: mul; eor; in r0,SREG; cpse; sts; mul; mov r24,r0; ret",
        &[0x9f89, 0x2411, 0xb60f, 0x1367, 0x9380, 0x0100, 0x9f88, 0x2d80, 0x9508],
        &[]),
    ("lost around a loop: ldi; 1: add r24,r0; mul; in r0,SREG; dec; brne 1b; ret",
        &[0xe028, 0x0d80, 0x9f89, 0xb60f, 0x952a, 0xf7d9, 0x9508],
        &[(2, &[Status(6)])]),
    ("a call that uses r0: mul; call f; add r24,r0; ret; f: clr r0; ret",
        &[0x9f89, 0x940e, 0x0005, 0x0d80, 0x9508, 0x2400, 0x9508],
        &[(6, &[Call(2)])]),
    ("a call that does not: mul; call f; add r24,r0; ret; f: clr r24; ret",
        &[0x9f89, 0x940e, 0x0005, 0x0d80, 0x9508, 0x2788, 0x9508],
        &[]),
    ("a call through a pointer: mul; icall; add r24,r0; ret",
        &[0x9f89, 0x9509, 0x0d80, 0x9508],
        &[(4, &[Call(2)])]),
    ("r0 used two calls down: mul; rcall f; add r24,r0; ret; f: rcall g; ret; g: lpm; ret",
        &[0x9f89, 0xd002, 0x0d80, 0x9508, 0xd001, 0x9508, 0x95c8, 0x9508],
        &[(4, &[Call(2)])]),
    ("a call that does not return: mul; tst; brne 1f; call f; 1: add r24,r0; ret; f: clr r0; 2: rjmp 2b",
        &[0x9f89, 0x2388, 0xf411, 0x940e, 0x0007, 0x0d80, 0x9508, 0x2400, 0xcfff],
        &[]),
    ("data behind a call that does not return: rcall f; .word 0xffff; f: rjmp f",
        &[0xd001, 0xffff, 0xcfff],
        &[]),
    ("recursion: f: mul; dec; breq 1f; rcall f; 1: add r24,r0; ret",
        &[0x9f89, 0x958a, 0xf009, 0xdffc, 0x0d80, 0x9508],
        &[(8, &[Call(6)])]),
    ("a function that takes r0 does not get it: in r0,SREG; cli; out SREG,r0; rcall f; ret; f: add r24,r0; ret",
        &[0xb60f, 0x94f8, 0xbe0f, 0xd001, 0x9508, 0x0d80, 0x9508],
        &[(6, &[Status(0)])]),
    ("a function that takes r0 gets it: mul; rcall f; ret; f: add r24,r0; ret",
        &[0x9f89, 0xd001, 0x9508, 0x0d80, 0x9508],
        &[]),
    ("the same with a jump: in r0,SREG; cli; out SREG,r0; jmp f; f: mov r24,r0; ret",
        &[0xb60f, 0x94f8, 0xbe0f, 0x940c, 0x0005, 0x2d80, 0x9508],
        &[(10, &[Status(0)])]),
    ("an interrupt: push r0; in r0,SREG; push r0; push r1; eor; lds; mul; sts r0; clr r1; pop r1; \
      pop r0; out SREG,r0; pop r0; reti",
        &[0x920f, 0xb60f, 0x920f, 0x921f, 0x2411, 0x9180, 0x0100, 0x9f88, 0x9200, 0x0100, 0x2411,
          0x901f, 0x900f, 0xbe0f, 0x900f, 0x9518],
        &[]),
    ("a product in place of the status: in r0,SREG; mul; out SREG,r0; ret",
        &[0xb60f, 0x9f89, 0xbe0f, 0x9508],
        &[(4, &[Product(2)])]),
    ("a callee's r0 in place of the status: in r0,SREG; rcall f; out SREG,r0; ret; f: lpm; ret",
        &[0xb60f, 0xd002, 0xbe0f, 0x9508, 0x95c8, 0x9508],
        &[(4, &[Call(2)])]),
    ("a status that nothing saved: out SREG,r0; ret",
        &[0xbe0f, 0x9508],
        &[(0, &[Entry])]),
    ("room on the stack is no call: mul; rcall .+0; mov r24,r0; pop r1; pop r1; ret",
        &[0x9f89, 0xd000, 0x2d80, 0x901f, 0x901f, 0x9508],
        &[]),
    ("r0 cleared, and set from the carry: in r0,SREG; eor r0,r0; add r24,r0; sbc r0,r0; mov r25,r0; ret",
        &[0xb60f, 0x2400, 0x0d80, 0x0800, 0x2d90, 0x9508],
        &[]),
];

#[test]
fn exactly_the_lost_values_are_found() {
    for (what, words, expected) in CASES {
        let report = check(words).expect(what);
        let found: Vec<_> = report
            .findings
            .iter()
            .map(|finding| (finding.address, &finding.origins[..]))
            .collect();
        assert_eq!(found, *expected, "{what}");
    }
}

#[test]
fn what_is_no_code_is_refused() {
    let cases: [(&str, &[u16], &str); 3] = [
        (
            "no instruction: rjmp 1f; .word 0xffff; 1: nop; .word 0xffff",
            &[0xc001, 0xffff, 0x0000, 0xffff],
            "0x0006",
        ),
        ("beyond the end: nop", &[0x0000], "0x0002"),
        ("half an instruction: call", &[0x940e], "0x0000"),
    ];
    for (what, words, address) in cases {
        let error = check(words).expect_err(what).to_string();
        assert!(error.contains(address), "{what}: {error}");
    }
}

#[test]
fn code_is_followed_from_symbols_and_behind_jumps_to_pointers() {
    // ld r30,X+; ijmp; 1: ld r30,X+; ijmp; 2: ret; .byte 1; 3: ret
    let words = [0x91ed, 0x9409, 0x91ed, 0x9409, 0x9508, 0x0001, 0x9508];
    let mut code = Code::default();
    code.add_block(0, &bytes(&words));
    code.add_constant(10, 2);
    code.add_label(10, "constant", false);
    let report = flow::check(&code, 0).expect("code");
    assert_eq!((report.followed, report.code), (10, 12));

    code.add_label(12, "by_hand", false);
    let report = flow::check(&code, 0).expect("code");
    assert_eq!((report.followed, report.code), (12, 12));
}

#[test]
fn a_finding_names_place_instruction_and_cause() {
    let mut code = Code::default();
    code.add_block(0x100, &bytes(CASES[0].1));
    code.add_label(0x100, "case", true);
    let report = flow::check(&code, 0x100).expect("code");
    assert_eq!(
        report.to_string(),
        "0x010e in case: `add r24, r0` reads r0, which by then holds the status register, saved at \
         0x0104\nr0 check: 1 functions, 9 instructions, 1 of them mul; 18 of 18 B followed: \
         1 value in r0 IS LOST"
    );
}

#[test]
fn instructions_are_decoded_with_what_they_do_to_r0() {
    use Flow::{Branch, Call, CallIndirect, Jump, JumpIndirect, Next, Return, Skip};
    let (value, saves, restores) = (
        Some(Read::Value),
        Some(Read::Saves),
        Some(Read::RestoresStatus),
    );
    let (product, status, other) = (
        Some(Write::Product),
        Some(Write::Status),
        Some(Write::Other),
    );
    #[rustfmt::skip]
    let cases = [
        (&[0x0000_u16][..],  "nop",          None,     None,    Next),
        (&[0x9f89],          "mul r24, r25", None,     product, Next),
        (&[0x0289],          "muls r24, r25", None,    product, Next),
        (&[0x9c01],          "mul r0, r1",   value,    product, Next),
        (&[0x2d80],          "mov r24, r0",  value,    None,    Next),
        (&[0x2e08],          "mov r0, r24",  None,     other,   Next),
        (&[0x01c0],          "movw r24, r0", value,    None,    Next),
        (&[0x010c],          "movw r0, r24", None,     other,   Next),
        (&[0x0d80],          "add r24, r0",  value,    None,    Next),
        (&[0x0e08],          "add r0, r24",  value,    other,   Next),
        (&[0x1580],          "cp r24, r0",   value,    None,    Next),
        (&[0x2400],          "eor r0, r0",   None,     other,   Next),
        (&[0x2000],          "and r0, r0",   value,    other,   Next),
        (&[0xb60f],          "in r0, SREG",  None,     status,  Next),
        (&[0xb60d],          "in r0",        None,     other,   Next),
        (&[0xbe0f],          "out SREG, r0", restores, None,    Next),
        (&[0xbe0d],          "out r0",       value,    None,    Next),
        (&[0x9000, 0x005f],  "lds r0, SREG", None,     status,  Next),
        (&[0x9200, 0x005f],  "sts SREG, r0", restores, None,    Next),
        (&[0x9200, 0x0100],  "sts r0",       value,    None,    Next),
        (&[0x920f],          "push r0",      saves,    None,    Next),
        (&[0x900f],          "pop r0",       None,     other,   Next),
        (&[0x95c8],          "lpm",          None,     other,   Next),
        (&[0x9004],          "lpm r0",       None,     other,   Next),
        (&[0x95e8],          "spm",          value,    None,    Next),
        (&[0x9629],          "adiw r28",     None,     None,    Next),
        (&[0x1000],          "cpse r0, r0",  value,    None,    Skip),
        (&[0xfc00],          "sbrc r0",      value,    None,    Skip),
        (&[0xf7d9],          "brbc",         None,     None,    Branch(0x1000 - 8)),
        (&[0xf019],          "brbs",         None,     None,    Branch(0x1008)),
        (&[0xcfff],          "rjmp",         None,     None,    Jump(0x1000)),
        (&[0xd7ff],          "rcall",        None,     None,    Call(0x2000)),
        (&[0x940c, 0x1234],  "jmp",          None,     None,    Jump(0x2468)),
        (&[0x940e, 0x0005],  "call",         None,     None,    Call(0x000a)),
        (&[0x9409],          "ijmp",         None,     None,    JumpIndirect),
        (&[0x9509],          "icall",        None,     None,    CallIndirect),
        (&[0x9518],          "reti",         None,     None,    Return),
    ];
    for (words, text, read, write, flow) in cases {
        let instruction = decode(0x1000, &bytes(words)).expect(text);
        assert_eq!(instruction.to_string(), text);
        assert_eq!(instruction.length as usize, 2 * words.len(), "{text}");
        assert_eq!(instruction.read, read, "{text}");
        assert_eq!(instruction.write, write, "{text}");
        assert_eq!(instruction.flow, flow, "{text}");
    }
}
