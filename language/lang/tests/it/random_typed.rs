//! Random typed programs: the board's core does what the interpreter does, scan by scan. `uno-sim` has the firmware do
//! the same.
//!
//! `UNOCLP_SEED` is the first seed.

use crate::board::{Twins, compiled, errors, large, with_plc};
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
    let first = std::env::var("UNOCLP_SEED").map_or(1, |seed| seed.parse().expect("a number"));
    let count = u64::from(rounds(PROGRAMS));
    let (mut ran, mut wrong) = (0, Vec::new());
    for seed in first..first + count {
        match compared(seed, board) {
            Ok(did) => ran += u64::from(did),
            Err(why) => wrong.push(why),
        }
    }
    wrong.sort_by_key(String::len);
    println!("{ran} of {count} ran, {} differ", wrong.len());
    let first = wrong.iter().filter_map(|why| why.lines().next());
    let first: Vec<&str> = first.take(30).collect();
    let shortest = wrong.first().map_or("", String::as_str);
    assert!(
        wrong.is_empty(),
        "{} differ:\n{}\nthe shortest:\n{shortest}",
        wrong.len(),
        first.join("\n")
    );
    assert!(ran * 2 > count, "only {ran} of {count} ran");
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

#[test]
fn counters_are_called_again() {
    let made = compiled(AGAIN, TextLanguage::St);
    assert_eq!(errors(&made), None);
    let places = made.places();
    let (tree, (mut checked, _)) = (made.tree.unwrap(), made.program.unwrap());
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &places);
        let random = &mut Random(7);
        for scan in 0..2_000 {
            let same = twins.scan(plc, scan * 10);
            assert_eq!(same, Ok(()), "scan {scan}");
            twins.stir(plc, random);
        }
    });
}
