//! VAR RETAIN is kept, all of it, or refused (NC-12, NC-21).

use crate::common::{plc, program};
use unoclp_core::{Image, Number, Profile};
use unoclp_lang::{Code, Options, compile};

/// Scans this program; cuts the power before each scan that is to come behind the first few.
fn run(text: &str, scans: &[(u16, bool)]) -> Vec<[i32; 3]> {
    let compiled = program(text, &Options::default());
    let mut memory = [0; Profile::UNO.plc_bytes()];
    let mut plc = plc(&compiled.file().unwrap(), &mut memory, Profile::UNO);
    let mut now = 0;
    let scan = |&(inputs, cut): &(u16, bool)| {
        if cut {
            plc.restart();
        }
        now += 1;
        plc.scan(Image(inputs), now).unwrap();
        *plc.registers().first_chunk().unwrap()
    };
    scans.iter().map(scan).collect()
}

/// `%MW1` to `%MW3` show what is kept.
const SHOWN: &str =
    "LD kept\nST %MW1\nLD parts.CV\nST %MW2\nLD flag\nST M1\nLD %MB1\nAND 1\nST %MW3\n";

fn text(declared: &str) -> String {
    format!(
        "{declared}\nCAL parts (CU:=I1, PV:=100)\nLD I1\nR flag\nLD kept\nADD 1\nST kept\n{SHOWN}"
    )
}

#[test]
fn first_values_hold_where_nothing_has_been_kept() {
    let text = text("VAR RETAIN kept : DINT := 70000; parts : CTU; flag : BOOL := TRUE; END_VAR");
    let shown = run(
        &text,
        &[(0, false), (1, false), (0, true), (1, false), (0, true)],
    );
    assert_eq!(
        shown,
        [
            [70001, 0, 1],
            [70002, 1, 0],
            [70003, 1, 0],
            [70004, 2, 0],
            [70005, 2, 0]
        ]
    );
}

#[test]
fn without_first_values_all_begins_with_0() {
    let text = text("VAR RETAIN kept : INT; parts : CTU; flag : BOOL; END_VAR");
    let shown = run(&text, &[(0, false), (1, true)]);
    assert_eq!(shown, [[1, 0, 0], [2, 1, 0]]);
}

#[test]
fn what_is_not_retained_begins_anew() {
    let text = text("VAR kept : INT := 5; parts : CTU; flag : BOOL; END_VAR");
    let shown = run(&text, &[(1, false), (0, true)]);
    assert_eq!(shown, [[6, 1, 0], [6, 0, 0]]);
}

/// Registers, counters, and one register more where there are first values.
#[test]
fn what_is_kept_is_named_at_the_head() {
    let kept = |text: &str| -> Vec<Number> {
        let compiled = program(text, &Options::default());
        let checked = compiled.program.as_ref().unwrap();
        checked.0.program().kept().collect()
    };
    let (register, counter) = (Number::Register, Number::Counter);
    let plain = "VAR RETAIN a AT %MW7 : INT; b : CTU; c : INT; END_VAR\nLD I1\nST Q1";
    assert_eq!(kept(plain), [register(7), counter(1), register(1)]);
    let first = "VAR RETAIN a : INT := 1; END_VAR\nLD I1\nST Q1";
    assert_eq!(kept(first), [register(1), register(2)]);
    let markers = "VAR RETAIN a : BOOL; b AT %MX57 : BOOL; END_VAR\nLD I1\nST Q1";
    assert_eq!(kept(markers), []);
}

#[test]
fn what_cannot_be_kept_is_refused() {
    for declared in [
        "t : TON",
        "t : TONR",
        "e : R_TRIG",
        "m AT %MX3 : BOOL",
        "m AT %MX56 : BOOL",
        "q AT %QX1 : BOOL",
        "i AT %IX1 : BOOL",
    ] {
        let text = format!("VAR RETAIN {declared}; END_VAR\nLD I2\nST Q2");
        let told = compile(&text, &Options::default());
        let refused = told.diagnostics.iter().any(|d| d.code == Code::NotRetained);
        assert!(refused && told.has_errors(), "{declared}");
    }
}
