//! Timers, counters, functions, jumps and numbers do what the standard says of them, on the board's own engine.

use crate::common::{LARGE, inputs, large, plc, program};
use unoclp_core::{Board, Image, Plc};
use unoclp_lang::{Code, Dialect, Options, TextLanguage, compile, compile_text};

/// Runs a text, and gives the outputs of scans with these inputs at these times, as bits.
fn run(text: &str, scans: &[(u32, u8)]) -> Vec<u128> {
    let file = program(text, &large()).file().unwrap();
    let mut memory = vec![0; 64_000];
    let mut plc = plc(&file, &mut memory, LARGE);
    scans
        .iter()
        .map(|&(at, points)| plc.scan(Image(points.into()), at).unwrap().0)
        .collect()
}

/// Runs a text on one scan after another, 1 ms apart.
fn steps(text: &str, points: &[u8]) -> Vec<u128> {
    let scans: Vec<(u32, u8)> = (0..).zip(points.iter().copied()).collect();
    run(text, &scans)
}

fn with_plc<T>(text: &str, act: impl FnOnce(&mut Plc<'_>) -> T) -> T {
    let file = program(text, &large()).file().unwrap();
    let mut memory = vec![0; 64_000];
    act(&mut plc(&file, &mut memory, LARGE))
}

#[test]
fn timers_of_every_kind() {
    let ton = "CAL T1 (IN:=%IX1, PT:=T#20ms, Q=>Q1)";
    assert_eq!(run(ton, &[(0, 1), (19, 1), (20, 1), (21, 0)]), [0, 0, 1, 0]);
    let tof = "VAR T1 : TOF; END_VAR\nCAL T1 (I1, T#20ms)\nLD T1.Q\nST Q1";
    assert_eq!(run(tof, &[(0, 1), (5, 0), (24, 0), (25, 0)]), [1, 1, 1, 0]);
    let tp = "LD I1\nTP T1, 20\nST Q1";
    assert_eq!(run(tp, &[(0, 1), (5, 0), (19, 0), (20, 0)]), [1, 1, 1, 0]);
    let tonr = "LD I1\nTONR T1, 20\nST Q1\nLD I2\nR T1";
    assert_eq!(
        run(tonr, &[(0, 1), (10, 0), (50, 1), (60, 1), (61, 2), (62, 0)]),
        [0, 0, 0, 1, 1, 0]
    );
}

#[test]
fn a_preset_may_be_a_variable_and_the_time_may_be_read() {
    let text = "VAR wait : TIME := T#30ms; END_VAR\nCAL T1 (IN:=I1, PT:=wait)\nLD T1.Q\nST Q1\nLD T1.ET\nGE 10\nST Q2";
    assert_eq!(
        run(text, &[(0, 1), (9, 1), (10, 1), (29, 1), (30, 1)]),
        [0, 0, 2, 2, 3]
    );
}

#[test]
fn a_timers_preset_on_an_s7_200_counts_its_steps() {
    for (timer, ms) in [("T32", 1), ("T33", 10), ("T37", 100)] {
        let text = format!("LD I0.0\nTON {timer}, 3\nLD {timer}\n= Q0.0");
        let codes = program(&text, &large()).codes();
        assert_eq!(codes[3], 3 * ms, "{timer}");
    }
    // The accumulator stays what it is there, and is Q by the standard.
    let text = "LD I0.0\nTON T37, 1\n= Q0.0\nLD T37\n= Q0.1";
    assert_eq!(run(text, &[(0, 1), (99, 1), (100, 1)]), [1, 1, 3]);
}

#[test]
fn counters_of_every_form() {
    let scans = [1, 0, 1, 0, 2, 0, 1];
    let expected = [0, 0, 1, 1, 0, 0, 0];
    for text in [
        "CAL C1 (CU:=I1, R:=I2, PV:=2)\nLD C1.Q\nST Q1",
        "CAL C1 (I1, I2, 2)\nLD C1\nST Q1",
        "LD I1\nCTU C1, I2, 2\nST Q1",
        "VAR n : CTU := (PV := 2); END_VAR\nCAL n (CU:=I1, R:=I2, Q=>Q1)",
        "LD I0.0\nLD I0.1\nCTU C1, 2\nLD C1\n= Q0.0",
        "VAR %C8 : CTU := 2; END_VAR\nBLK %C8\nLD %I0.1\nR\nLD %I0.0\nCU\nEND_BLK\nLD %C8.D\nST %Q0.0",
        "VAR C1 : CTU := 2; END_VAR\nLD I1\nCU C1\nLD I2\nR C1\nLD C1.Q\nST Q1",
    ] {
        assert_eq!(steps(text, &scans), expected, "{text}");
    }
    let down = "CAL C1 (CD:=I1, LD:=I2, PV:=2, Q=>Q1)";
    assert_eq!(steps(down, &[2, 0, 1, 0, 1, 0]), [0, 0, 0, 0, 1, 1]);
    let both = "CAL C1 (CU:=I1, CD:=I2, R:=I3, LD:=I4, PV:=2, QU=>Q1, QD=>Q2)";
    assert_eq!(
        steps(both, &[0, 1, 0, 1, 0, 2, 0, 8, 4]),
        [2, 0, 0, 1, 1, 0, 0, 1, 2]
    );
}

/// A counter that resets itself is asked before it counts, as the standard evaluates a call.
#[test]
fn a_counter_that_resets_itself() {
    let text = "CAL C1 (CU:=I1, R:=C1.Q, PV:=2)\nLD C1.Q\nST Q1";
    assert_eq!(steps(text, &[1, 0, 1, 0, 1]), [0, 0, 1, 0, 0]);
}

#[test]
fn the_stack_of_the_makers() {
    // (I1 + I2) (I3 + I4), in three makers' words.
    for text in [
        "LD I0.0\nO I0.1\nLD I0.2\nO I0.3\nALD\n= Q0.0",
        "LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0",
        "LD 0.00\nOR 0.01\nLD 0.02\nOR 0.03\nAND LD\nOUT 10.00",
    ] {
        for points in 0..16_u8 {
            let expected = points & 3 != 0 && points & 12 != 0;
            assert_eq!(
                steps(text, &[points]),
                [u128::from(expected)],
                "{text} {points}"
            );
        }
    }
}

#[test]
fn functions_and_blocks_of_the_users_own() {
    let function = "\
        LD I1\nBoth I2\nST Q1\nCAL Both (a:=I3, b:=NOT I4)\nST Q2\n\
        FUNCTION Both : BOOL\nVAR_INPUT a, b : BOOL; END_VAR\n\
        LD a\nAND b\nST Both\nEND_FUNCTION";
    assert_eq!(steps(function, &[1, 3, 4, 12]), [0, 1, 2, 0]);

    let block = "\
        PROGRAM main\nVAR x, y : Latch; END_VAR\n\
        CAL x (on:=I1, off:=I2, state=>Q1)\nCAL y (on:=I3, off:=I4)\nLD y.state\nST Q2\nEND_PROGRAM\n\
        FUNCTION_BLOCK Latch\nVAR_INPUT on, off : BOOL; END_VAR\nVAR_OUTPUT state : BOOL; END_VAR\n\
        LD off\nR state\nRETC\nLD on\nS state\nEND_FUNCTION_BLOCK";
    assert_eq!(steps(block, &[1, 0, 4, 2, 0, 9]), [1, 1, 3, 2, 2, 1]);
}

#[test]
fn calls_and_returns_on_a_condition() {
    let text = "LD I1\nCALC f\nLD I1\nCALCN g\nLD I3\nRETC\nLD I2\nST Q3\n\
        FUNCTION f : BOOL\nLD I2\nST Q1\nEND_FUNCTION\n\
        FUNCTION g : BOOL\nLD I4\nRETCN\nLD I2\nST Q2\nEND_FUNCTION";
    // Inputs 1 2 3 4 are bits 1 2 4 8.
    assert_eq!(steps(text, &[3]), [0b101]);
    assert_eq!(steps(text, &[2]), [0b100]);
    assert_eq!(steps(text, &[2 | 8]), [0b110]);
    assert_eq!(steps(text, &[2 | 8 | 4]), [0b010]);
}

#[test]
fn a_loop_runs_within_one_scan() {
    let text = "LD 0\nST D1\nST D2\nagain:\nLD D1\nADD 1\nST D1\nADD D2\nST D2\nLD D1\nLT 10\nJMPC again\nLD D2\nEQ 55\nST Q1";
    assert_eq!(steps(text, &[0]), [1]);
}

#[test]
fn a_number_as_a_condition() {
    let text = "LD IB0\nAND 12\nJMPCN none\nLD TRUE\nST Q1\nRET\nnone: LD FALSE\nST Q1";
    assert_eq!(steps(text, &[3, 4, 8, 0]), [0, 1, 1, 0]);
}

#[test]
fn numbers() {
    let text = "LD IW0\nMUL( IW1\nSUB 3\n)\nST D1\nLD D1\nSHL 2\nNEG\nST D2\nLD 16\nSQRT\nST D3\nLDN D3\nST D4";
    with_plc(text, |plc| {
        plc.scan(inputs(0, [7, 13, 0, 0, 0]), 0).unwrap();
        assert_eq!(plc.registers()[..4], [70, -280, 4, !4]);
    });
}

#[test]
fn edges_and_first_values() {
    let text = "VAR r : R_TRIG; f : F_TRIG; on : BOOL := TRUE; n : INT := 7; END_VAR\nVAR RETAIN kept : BOOL; END_VAR\n\
        CAL r (CLK:=I1)\nLD r.Q\nST Q1\nCAL f (I1)\nLD f.Q\nST Q2\nLD on\nST Q3\nST kept\nLD n\nEQ 7\nST Q4";
    assert_eq!(steps(text, &[1, 1, 0, 0]), [0b1101, 0b1100, 0b1110, 0b1100]);
    with_plc(text, |plc| {
        plc.scan(Image(0), 0).unwrap();
        assert_eq!(plc.retained(), 1);
    });
}

/// The accumulator is the same after a label, whichever way leads there.
#[test]
fn the_accumulator_over_a_label() {
    let choose = "LD I1\nJMPC first\nLD I2\nJMP last\nfirst: LD I3\nlast: ST Q1";
    for points in 0..8_u128 {
        let (a, b, c) = (points & 1, points >> 1 & 1, points >> 2 & 1);
        let expected = if a == 1 { c } else { b };
        assert_eq!(steps(choose, &[points as u8]), [expected], "{points}");
    }
    let either = "LD I1\nJMPC done\nLD I2\ndone: ST Q1";
    assert_eq!(steps(either, &[0, 1, 2, 3]), [0, 1, 1, 1]);
    let count = "LD 0\nST D1\nmore: ADD 3\nST D1\nLD D1\nGE 10\nJMPC done\nLD D1\nJMP more\ndone: LD D1\nEQ 12\nST Q1";
    assert_eq!(steps(count, &[0]), [1]);
    let told = compile("LD D1\nJMP a\nLD I1\na: ST Q1", TextLanguage::Il, &large()).diagnostics;
    assert!(told.iter().any(|d| d.code == Code::WrongType), "{told:?}");
}

/// The next state of a rung does not disturb what waits between parentheses.
#[test]
fn a_store_between_parentheses() {
    let text = "LD I1\nAND( I2\nST Q2\nOR I3\n)\nST Q1";
    for points in 0..8_u128 {
        let (a, b, c) = (points & 1, points >> 1 & 1, points >> 2 & 1);
        assert_eq!(
            steps(text, &[points as u8]),
            [a & (b | c) | b << 1],
            "{points}"
        );
    }
}

#[test]
fn any_spelling_in_any_case() {
    let text = "0010 ld % ix1\n0020 &n I.2\n\n0030 St\t%qx1 (* done *)\n";
    assert_eq!(
        program(text, &large()).codes(),
        [0, 827301, -827302, 877901]
    );
}

#[test]
fn warnings_that_help() {
    let told = |text: &str| -> Vec<Code> {
        let compiled = compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO);
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
        compiled.diagnostics.iter().map(|d| d.code).collect()
    };
    assert_eq!(told("LD I1\nST Q1\nLD I2\nST Q1"), [Code::WrittenTwice]);
    assert_eq!(told("LD I1\nS Q1\nLD I2\nR Q1"), []);
    // Two ways, of which a scan takes one.
    assert_eq!(
        told("LD I1\nJMPC a\nLD I2\nST Q1\nRET\na: LD I3\nST Q1"),
        []
    );
    assert_eq!(told("LD I1\nST I2\nST Q1"), [Code::StoreToInput]);
}

#[test]
fn several_errors_in_one_run() {
    let text = "LD I9\nANDD I2\nST Q1\nLD I1\nST Q9\nJMP nowhere\n)";
    let compiled = compile_text(text, TextLanguage::Il, unoclp_core::Board::UNO);
    let codes: Vec<Code> = compiled.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(
        codes,
        [
            Code::NoSuchPoint,
            Code::UnknownOperator,
            Code::NoSuchPoint,
            Code::NoSuchLabel,
            Code::CloseWithoutOpen
        ]
    );
    assert_eq!(compiled.file(), None);
}

#[test]
fn a_dialect_may_be_said() {
    let options = |dialect| Options {
        dialect: Some(dialect),
        board: Board::UNO,
    };
    let text = "LD M0\nST Q1";
    assert!(compile(text, TextLanguage::Il, &options(Dialect::Iec)).has_errors());
    assert_eq!(
        compile(text, TextLanguage::Il, &options(Dialect::Twido)).codes(),
        [0, 827701, 877901]
    );
    for dialect in Dialect::ALL {
        assert_eq!(Dialect::named(dialect.name()), Some(dialect));
    }
}
