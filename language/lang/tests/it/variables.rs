//! Where the board keeps what a text names.

use unoclp_lang::typed::Base;
use unoclp_lang::{Holding, TextLanguage, compile_text};
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
