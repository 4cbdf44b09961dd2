//! A point that the board lacks is told by the same message at its place, in every language and every door.

use crate::project;
use serde::Deserialize;
use unoclp_core::Board;
use unoclp_lang::{Diagnostic, Dialect, Lang, Options, TextLanguage, Told, compile, compile_text};
use unoclp_plcopen::import;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    point: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// As the standard writes it.
    written: String,
    /// Whether it is a number.
    #[serde(default)]
    number: bool,
    /// The first board that has it, where one has.
    board: Option<String>,
    /// What to do.
    en: String,
    pt: String,
    /// As LCE writes such a point, and what to do there.
    lce: Option<String>,
    lce_en: Option<String>,
}

impl Case {
    /// What ends the message of a point that another board has.
    fn elsewhere(&self) -> (String, String) {
        self.board.as_ref().map_or_else(Default::default, |board| {
            (
                format!("; the {board} has this one"),
                format!("; a placa {board} tem este ponto"),
            )
        })
    }
}

/// A door, a text that comes in by it, and what it is told.
type Came = (&'static str, String, Told);

/// The text through every door that takes the notation of the standard.
fn doors(case: &Case) -> Vec<Came> {
    let (at, ty) = (&case.written, if case.number { "INT" } else { "BOOL" });
    let board = Board::UNO;
    let typed = |language, text: String| {
        let told = compile_text(&text, language, board).diagnostics;
        (text, told)
    };
    let listed = |text: String| {
        let options = Options {
            dialect: Some(Dialect::Iec),
            board,
        };
        let told = compile(&text, TextLanguage::Il, &options).diagnostics;
        (text, told)
    };
    let imported = |text: String| {
        let told = import(&text, board).diagnostics;
        (text, told)
    };
    let declared = format!(r#"<variable name="p" address="{at}"><type><{ty}/></type></variable>"#);
    let contact = format!(
        r#"<LD><leftPowerRail localId="1"><connectionPointOut formalParameter=""/></leftPowerRail>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>{at}</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>%QX0.0</variable></coil></LD>"#
    );
    let st = format!("VAR p AT {at} : {ty}; END_VAR\np := p;\n");
    let body = |text: &str| format!("<ST><xhtml:p><![CDATA[{text}]]></xhtml:p></ST>");
    [
        ("ST, declared", typed(TextLanguage::St, st)),
        (
            "ST, read",
            typed(
                TextLanguage::St,
                format!("VAR x : {ty}; END_VAR\nx := {at};\n"),
            ),
        ),
        (
            "InterSCL",
            typed(
                TextLanguage::Iscl,
                format!("BLOCO\n{ty} p AT {at};\nEND_BLOCK\n"),
            ),
        ),
        ("IL", listed(format!("LD {at}\nST M1\n"))),
        (
            "IL, declared",
            listed(format!("VAR p AT {at} : {ty}; END_VAR\nLD M1\nST M2\n")),
        ),
        (
            "IL with types",
            typed(
                TextLanguage::Il,
                format!("VAR r : REAL; p AT {at} : {ty}; END_VAR\nLD p\n"),
            ),
        ),
        (
            "XML, declared and used",
            imported(project(&declared, &body("p := p;\n"))),
        ),
        ("XML, a contact", imported(project("", &contact))),
        (
            "XML, a text",
            imported(project("", &body(&format!("%QX0.0 := {at};\n")))),
        ),
    ]
    .into_iter()
    .map(|(door, (text, told))| (door, text, told))
    .collect()
}

/// What is told without the element that XML names before.
fn message(told: &Diagnostic, lang: Lang) -> String {
    let message = told.message(lang);
    let said = message.split_once(": ").map(|(_, said)| said.to_owned());
    said.unwrap_or(message)
}

fn cases() -> Vec<Case> {
    let table: Table = toml::from_str(include_str!("../no-such-points.toml")).unwrap();
    table.point
}

#[test]
fn one_fault_has_one_message_in_every_door() {
    for case in cases() {
        let at = &case.written;
        for (door, text, told) in doors(&case) {
            let about = format!("{door}: {text}");
            let first = told
                .iter()
                .find(|told| told.message(Lang::En).contains(at.as_str()));
            let first = first.unwrap_or_else(|| panic!("{about}"));
            let message = |lang| message(first, lang);
            assert_eq!(
                message(Lang::En),
                format!("there is no point `{at}` on this board"),
                "{about}"
            );
            assert_eq!(
                message(Lang::Pt),
                format!("não existe o ponto `{at}` nesta placa"),
                "{about}"
            );
            assert_eq!(
                first.help(Lang::En),
                case.en.clone() + &case.elsewhere().0,
                "{about}"
            );
            assert_eq!(
                first.help(Lang::Pt),
                case.pt.clone() + &case.elsewhere().1,
                "{about}"
            );
            let place = &text[first.span.range()];
            assert!(
                place.contains(at.as_str())
                    || place.contains("\"p\"")
                    || place == "<contact localId=\"2\">",
                "{about}\n{place}"
            );
        }
    }
}

#[test]
fn lce_says_the_same_of_its_own_notation() {
    for case in cases() {
        let (Some(at), Some(help)) = (&case.lce, &case.lce_en) else {
            continue;
        };
        let text = format!("V0 := {at};\n");
        let told = compile_text(&text, TextLanguage::Lce, Board::UNO).diagnostics;
        let [first] = &told[..] else {
            panic!("{text}: {told:?}");
        };
        assert_eq!(
            first.message(Lang::En),
            format!("there is no point `{at}` on this board")
        );
        assert_eq!(first.help(Lang::En), help.clone() + &case.elsewhere().0);
        assert_eq!(&text[first.span.range()], at);
    }
}
