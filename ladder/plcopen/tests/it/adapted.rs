//! Points that another PLC has get a place on the board.

use crate::project_of;
use crate::{Pou, project};
use unoclp_core::Board;
use unoclp_lang::Code;
use unoclp_plcopen::{adapt, import};

/// A contact and a coil, both on another PLC's points, one of them declared.
const LADDER: &str = r#"<LD><leftPowerRail localId="1"><connectionPointOut/></leftPowerRail>
<comment localId="9"><content><xhtml:p>%QX100.0 is the lamp</xhtml:p></content></comment>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><connectionPointOut/><variable>%IX100.1</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><connectionPointOut/><variable>lamp</variable></coil></LD>"#;
const LAMP: &str = r#"<variable name="lamp" address="%QX100.0"><type><BOOL/></type><documentation><xhtml:p>was %QX100.0</xhtml:p></documentation></variable>"#;

#[test]
fn declarations_elements_and_texts_take_the_same_places() {
    let text = "<ST><xhtml:p><![CDATA[%QX0.0 := %IX100.1 AND %MW400 > 3; (* %IX100.1 *)\n]]></xhtml:p></ST>";
    let drawn = Pou {
        name: "Drawn",
        variables: LAMP,
        body: LADDER,
    };
    let written = Pou {
        name: "Written",
        variables: "",
        body: text,
    };
    let other = project_of(&[drawn, written], &["Drawn", "Written"]);
    assert!(import(&other, Board::UNO).program.is_none());
    let made = adapt(&other, Board::UNO).unwrap();
    let moved = [
        ("%QX100.0", "%QX0.1"),
        ("%IX100.1", "%IX0.0"),
        ("%MW400", "%MW1"),
    ];
    let moved = moved.map(|(old, new)| (old.to_owned(), new.to_owned()));
    assert_eq!(made.moved, moved);
    assert!(made.left.is_empty());
    assert!(
        made.text
            .starts_with("<?xml version='1.0' encoding='utf-8'?>\n<!-- unoclp adapt, UNO:\n")
    );
    let head = made.text.find("<project").unwrap();
    assert_eq!(
        made.text[head..],
        other[other.find("<project").unwrap()..]
            .replace("address=\"%QX100.0\"", "address=\"%QX0.1\"")
            .replace("<variable>%IX100.1", "<variable>%IX0.0")
            .replace("%IX100.1 AND %MW400", "%IX0.0 AND %MW1")
    );
    let again = import(&made.text, Board::UNO);
    assert!(again.program.is_some(), "{:?}", again.diagnostics);
}

#[test]
fn what_lacks_nothing_stays_as_it_is_and_what_is_no_xml_is_not_touched() {
    let mine = project(&LAMP.replace("100", "0"), &LADDER.replace("100", "0"));
    let made = adapt(&mine, Board::UNO).unwrap();
    assert_eq!((made.text, made.moved.len()), (mine, 0));
    assert!(adapt("<a", Board::UNO).is_none());
}

#[test]
fn on_a_pc_they_take_their_places_by_themselves() {
    let drawn = project(LAMP, LADDER);
    let text = "<ST><xhtml:p><![CDATA[%QX0.0 := %IX100.1; lamp := %MW0.1 > %MW0.2 AND %QW1 > 0;\n]]></xhtml:p></ST>";
    for (project, told) in [(drawn, 2), (project(LAMP, text), 5)] {
        let made = import(&project, Board::PC);
        assert!(made.program.is_some(), "{:?}", made.diagnostics);
        let moved = made.diagnostics.iter();
        let moved = moved.filter(|told| told.code == Code::StMoved).count();
        assert_eq!(moved, told, "{:?}", made.diagnostics);
    }
}
