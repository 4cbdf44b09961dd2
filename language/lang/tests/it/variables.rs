//! Where the board keeps what a text names.

use unoclp_lang::typed::Base;
use unoclp_lang::{Holding, TextLanguage, compile_text, literal};
use unoclp_point::Address;

#[test]
fn a_name_of_a_register_has_its_own_type() {
    let text = "VAR x AT %MD1 : REAL; n AT %MD1 : DINT; w AT %MW2 : WORD; END_VAR\n\
                x := x + 1.0; n := n + 1; w := 1;";
    let board = unoclp_core::Board::UNO;
    let made = compile_text(text, TextLanguage::St, board);
    let holding = made.variables.iter().map(|of| of.holding.clone());
    let one = |number, base| Holding::One((Address::Register(number), base));
    assert_eq!(
        holding.collect::<Vec<_>>(),
        [one(1, Base::Real), one(1, Base::Dint), one(2, Base::Word)]
    );
    let shown = made
        .variables
        .iter()
        .map(|of| of.shown(|_| Some(0x4020_0000)));
    let shown: Vec<String> = shown.flatten().collect();
    assert_eq!(shown, ["2.5", "1075838976", "16#40200000"]);
}

#[test]
fn what_a_point_holds_is_a_literal_of_its_type() {
    let text = "TYPE Color : (Red, Green, Blue); END_TYPE\nPROGRAM main\nVAR c : Color; n : INT; END_VAR\n\
                c := Green; n := 2;\nEND_PROGRAM";
    let made = compile_text(text, TextLanguage::St, unoclp_core::Board::UNO);
    let color = made.variables.iter().find(|of| of.name == "c");
    assert_eq!(literal(2, Base::Int, color), "Blue");
    assert_eq!(literal(7, Base::Int, color), "7");
    assert_eq!(literal(2, Base::Int, None), "2");
    assert_eq!(literal(2, Base::Bool, None), "TRUE");
    assert_eq!(literal(-1, Base::Udint, None), "4294967295");
    assert_eq!(literal(0x3FC0_0000, Base::Real, None), "1.5");
    assert_eq!(literal(1500, Base::Time, None), "T#1s500ms");
}

#[test]
fn codes_are_those_of_the_program_file() {
    let text = "VAR n : DINT; END_VAR\nIF %IX1 THEN n := n + 70000; END_IF;";
    let made = compile_text(text, TextLanguage::St, unoclp_core::Board::UNO);
    let file = made.file().unwrap();
    let lines = file
        .lines()
        .filter_map(|line| line.split_whitespace().next());
    let codes = lines.filter_map(|code| code.parse().ok());
    assert_eq!(made.codes(), codes.collect::<Vec<i32>>(), "{file}");
}

#[test]
fn what_print_shows_is_watched() {
    let text = "BLOCO INT i; INT j; i := i + 1; j := i; PRINT(i); END_BLOCK";
    let made = compile_text(text, TextLanguage::Iscl, unoclp_core::Board::UNO);
    let watched = made.variables.iter().filter(|of| of.is_watched);
    let names: Vec<&str> = watched.map(|of| &*of.name).collect();
    assert_eq!(names, ["i"], "{:?}", made.diagnostics);
}
