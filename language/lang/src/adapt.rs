//! A text of another PLC with its points on this board.
//!
//! Owns where a text of each language writes points. Must not know which point goes where: `moved`.

use crate::TextLanguage;
use crate::languages::colours;
use std::ops::Range;
use unoclp_core::Board;
use unoclp_text::colour::Colour;
use unoclp_text::moved::{Adapted, adapt_at};

/// Languages whose points can be told by how they are written.
const ADAPTED: [TextLanguage; 3] = [TextLanguage::St, TextLanguage::Scl, TextLanguage::Il];

/// The text with a free point of this board in the place of each that the board lacks; none in a language whose points are
/// names of its own.
pub fn adapt(text: &str, language: TextLanguage, board: Board) -> Option<Adapted> {
    if !ADAPTED.contains(&language) {
        return None;
    }
    let adapted = adapt_at(text, &written_points(text, language), board);
    let table = adapted.table();
    let table = match table.is_empty() {
        true => table,
        false => format!("(* unoclp adapt, {}:\n{table}*)\n", board.name),
    };
    Some(Adapted {
        text: table + &adapted.text,
        ..adapted
    })
}

/// Where a text in one of these languages writes points.
pub fn written_points(text: &str, language: TextLanguage) -> Vec<Range<usize>> {
    let points = colours(text, language).into_iter();
    points
        .filter(|(_, colour)| *colour == Colour::Point)
        .map(|(span, _)| span.range())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn adapted(text: &str) -> Adapted {
        adapt(text, TextLanguage::St, Board::UNO).unwrap()
    }

    fn pairs(of: &[(String, String)]) -> Vec<(&str, &str)> {
        let pairs = of.iter().map(|(old, new)| (&**old, &**new));
        pairs.collect()
    }

    #[test]
    fn points_that_lack_take_free_ones_by_order_of_use() {
        let made = adapted(
            "VAR a AT %QX1.3 : BOOL; b AT %QX0.0 : BOOL; END_VAR\na := %IX2.0 AND %qx1.3; (* %QX9.9 *)\n",
        );
        let moved = [("%QX1.3", "%QX0.1"), ("%IX2.0", "%IX0.0")];
        assert_eq!(pairs(&made.moved), moved);
        let text = "(* unoclp adapt, UNO:\n   %QX1.3 -> %QX0.1\n   %IX2.0 -> %IX0.0\n*)\n\
                    VAR a AT %QX0.1 : BOOL; b AT %QX0.0 : BOOL; END_VAR\na := %IX0.0 AND %QX0.1; (* %QX9.9 *)\n";
        assert_eq!(made.text, text);
        assert!(made.left.is_empty());
    }

    #[test]
    fn a_pin_is_given_once() {
        // PWM 01 has the pin of output 01, A 00 that of input 05.
        let made = adapted(
            "x := %QX0.0; y := %QW0; z := %IW0; a := %IX5.0; b := %IX5.1; c := %IX5.2; d := %IX5.3; e := %IX5.4;",
        );
        let places: Vec<&str> = made.moved.iter().map(|(_, new)| new.as_str()).collect();
        assert_eq!(
            places,
            ["%QW4", "%IX0.0", "%IX0.1", "%IX0.2", "%IX0.3", "%IX0.5"]
        );
    }

    #[test]
    fn an_input_or_output_of_32_bits_is_a_register() {
        let made = adapted(
            "VAR a AT %MD1 : DINT; b AT %QD1 : REAL; c AT %ID1 : DINT; END_VAR\nb := %qd1 + 1.0;\n",
        );
        let moved = [("%QD1", "%MD2"), ("%ID1", "%MD3")];
        assert_eq!(pairs(&made.moved), moved);
        assert!(made.text.ends_with("b := %MD2 + 1.0;\n"));
    }

    #[test]
    fn what_finds_no_place_stays_and_is_told() {
        let made = adapted(
            "a := %QX1.0; b := %QX1.1; c := %QX1.2; d := %QX1.3; e := %QX1.4; f := %QX1.4;",
        );
        assert_eq!(made.left, ["%QX1.4"]);
        assert!(made.text.ends_with("e := %QX1.4; f := %QX1.4;"));
    }

    #[test]
    fn a_text_that_lacks_nothing_stays_as_it_is() {
        let text = "VAR a AT %QX0.0 : BOOL; END_VAR\na := NOT a;\n";
        assert_eq!(adapted(text).text, text);
        assert_eq!(adapt(text, TextLanguage::Lce, Board::UNO), None);
    }
}
