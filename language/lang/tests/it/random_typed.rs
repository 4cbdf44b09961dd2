//! Random typed programs: the board's core does what the interpreter does, scan by scan. `uno-sim` has the firmware do
//! the same.
//!
//! `UNOCLP_SEED` is the first seed.

use crate::board::{Twins, compiled, errors, large, none_differs, with_plc};
use unoclp_core::Board;
use unoclp_lang::{TextLanguage, compile_text};
use unoclp_testing::{Random, rounds, typed_program};

const PROGRAMS: u32 = 500;
const SCANS: u32 = 20;

/// Whether the program of this seed ran on this board.
///
/// # Errors
/// What differs.
fn compared(seed: u64, board: Board) -> Result<bool, String> {
    let text = typed_program(seed, 4 + seed as usize % 9);
    let made = compile_text(&text, TextLanguage::St, board);
    // Constants that do not fit are told, and so is what the board lacks.
    if let Some(errors) = errors(&made) {
        return match errors.contains("IL-") {
            true => Err(format!("seed {seed} does not compile: {errors}\n{text}")),
            false => Ok(false),
        };
    }
    let places = made.places();
    let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
        return Ok(false);
    };
    let lines = made.lines.iter();
    let lines = lines.map(|l| format!("{} {} {}\n", l.code, l.letters, l.symbol));
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &places);
        let random = &mut Random(seed ^ 0x5EED);
        let mut now = 0;
        for scan in 0..SCANS {
            if scan > 0 {
                twins.stir(plc, random);
            }
            match twins.scan(plc, now) {
                Ok(()) => {}
                Err(why) if why == "stopped" => return Ok(scan > 0),
                Err(why) => {
                    let listing: String = lines.collect();
                    return Err(format!(
                        "seed {seed}, scan {scan}: {why}\n{text}\n{listing}"
                    ));
                }
            }
            now += random.below(60) as u32;
        }
        Ok(true)
    })
}

#[test]
fn random_programs_are_alike_on_the_core_and_in_the_interpreter() {
    all_are_alike(large());
}

/// What has no marker stands in a register.
#[test]
fn random_programs_are_alike_where_most_bits_stand_in_registers() {
    all_are_alike(Board {
        markers: 3,
        ..large()
    });
}

fn all_are_alike(board: Board) {
    none_differs(rounds(PROGRAMS), 50, |seed| compared(seed, board));
}

/// Counters that are called again: each call asks what has changed since the one before, and what it does not give stays.
const AGAIN: &str = "
FUNCTION Late : BOOL
VAR_INPUT on : BOOL; END_VAR
VAR_IN_OUT c : CTU; END_VAR
c(CU := on, PV := 2);
Late := c.Q;
END_FUNCTION
PROGRAM main
VAR u, l : CTU; d : CTD; b : CTUD; q, r : BOOL; n : INT; x, y, z : INT; END_VAR
u(CU := %IX1, R := %IX4, PV := 3);
q := u.Q;
IF %IX3 THEN u(CU := %IX2, PV := 5); END_IF;
d(CD := %IX1, LD := %IX3, PV := 4);
d(CD := %IX2);
n := (n + 1) MOD 4;
b(CU := %IX1, CD := %IX2, R := %IX4, PV := n);
b(LD := %IX3, CU := b.QU);
r := Late(%IX1, l) AND Late(%IX2, l);
%QX1 := u.Q;
%QX2 := d.Q;
%QX3 := b.QU;
%QX4 := b.QD;
x := u.CV;
y := d.CV;
z := b.CV;
END_PROGRAM
";

/// Timers that are called again: in branches, in loops, with presets of their own, and asked between the calls.
const TIMERS: [&str; 4] = [
    "
VAR t : TON; step, n : INT; q : BOOL; x, y : TIME; END_VAR
CASE step OF
  0: t(IN := %IX1, PT := T#50ms);
  1: t(IN := NOT %IX2, PT := T#20ms);
ELSE t(IN := TRUE, PT := T#5ms);
END_CASE;
q := t.Q;
IF t.Q THEN step := (step + 1) MOD 3; t(IN := FALSE); END_IF;
x := t.ET;
%QX1 := q;
",
    "
VAR t : TOF; u : TP; v : TON; i : INT; p, q, r : BOOL; x, y, z : TIME; END_VAR
FOR i := 1 TO 3 DO
  t(IN := %IX1 AND i = 2, PT := T#30ms);
  IF i <> 1 THEN u(IN := %IX2 XOR i = 3, PT := T#20ms); END_IF;
END_FOR;
IF %IX3 THEN t(IN := u.Q); u(PT := T#70ms); END_IF;
v(IN := %IX1);
v(IN := %IX1 OR %IX2, PT := x);
x := t.ET;
y := u.ET;
z := v.ET;
p := t.Q; q := u.Q; r := v.Q;
%QX1 := t.Q XOR u.Q;
%QX2 := v.Q;
",
    "
FUNCTION_BLOCK Late
VAR_INPUT on : BOOL; after : TIME; END_VAR
VAR_OUTPUT is : BOOL; END_VAR
VAR t : TON; u : TOF; END_VAR
t(IN := on, PT := after);
u(IN := t.Q, PT := after);
is := u.Q;
END_FUNCTION_BLOCK
PROGRAM main
VAR a, b : Late; n : INT; p, q : BOOL; END_VAR
a(on := %IX1, after := T#20ms);
p := a.is;
IF %IX3 THEN a(on := %IX2, after := -T#1ms); END_IF;
b(on := a.is, after := T#15ms);
q := a.is XOR b.is;
%QX1 := q;
END_PROGRAM
",
    "
VAR t, u : TON; p, q : BOOL; n : INT; x : TIME; END_VAR
IF %IX2 THEN t(IN := FALSE, PT := T#40ms); END_IF;
t(IN := %IX1, PT := T#40ms);
p := t.Q;
IF t.Q THEN t(IN := FALSE); n := n + 1; END_IF;
x := t.ET;
IF %IX3 THEN u(IN := FALSE, PT := T#5ms); ELSE u(IN := %IX4); END_IF;
q := u.Q AND u.IN;
%QX1 := t.Q OR q;
",
];

/// A text does on the core what it does in the interpreter, whatever comes in.
fn stays_alike(text: &str, step: u32) {
    let made = compiled(text, TextLanguage::St);
    assert_eq!(errors(&made), None, "{text}");
    let places = made.places();
    let (tree, (mut checked, _)) = (made.tree.unwrap(), made.program.unwrap());
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &places);
        let random = &mut Random(7);
        for scan in 0..2_000 {
            let same = twins.scan(plc, scan * step);
            assert_eq!(same, Ok(()), "scan {scan} of{text}");
            twins.stir(plc, random);
        }
    });
}

#[test]
fn timers_are_called_again() {
    for text in TIMERS {
        stays_alike(text, 3);
        stays_alike(text, 10);
    }
}

#[test]
fn counters_are_called_again() {
    stays_alike(AGAIN, 10);
}
