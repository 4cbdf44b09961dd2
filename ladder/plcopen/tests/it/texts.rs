//! Bodies of text, and those that are not imported.

use crate::{codes, project};
use unoclp_core::Board;
use unoclp_lang::Lang;
use unoclp_plcopen::import;

const VARIABLES: &str = r#"
<variable name="a" address="%IX0.0"><type><BOOL/></type></variable>
<variable name="q" address="%QX0.0"><type><BOOL/></type></variable>
<variable name="n"><type><INT/></type><initialValue><simpleValue value="3"/></initialValue></variable>
"#;

fn of(language: &str, body: &str) -> String {
    let body = format!("<{language}><xhtml:p><![CDATA[{body}]]></xhtml:p></{language}>");
    project(VARIABLES, &body)
}

#[test]
fn structured_text_and_instruction_list_are_compiled() {
    for (language, body) in [("ST", "q := a;\n"), ("IL", "LD a\nST q\n")] {
        let text = of(language, body);
        let made = import(&text, Board::UNO);
        let told: Vec<String> = made
            .diagnostics
            .iter()
            .map(|t| t.message(Lang::En))
            .collect();
        let code = codes(&made.code.unwrap_or_else(|| panic!("{language}: {told:?}")));
        assert!(code.ends_with(&[827301, 877901]), "{language}: {code:?}");
        let (_, map) = made.program.unwrap();
        let last = map.steps.last().unwrap();
        let line = text.lines().nth(last.line - 1).unwrap();
        assert!(line.contains("q := a") || line.contains("ST q"), "{line}");
    }
}

#[test]
fn a_mistake_in_a_body_is_told_at_its_place_in_the_file() {
    let text = of("ST", "q := a AND nothing;\n");
    let made = import(&text, Board::UNO);
    assert!(made.program.is_none());
    let told = made.diagnostics.first().unwrap();
    assert_eq!(&text[told.span.range()], "nothing");
}

#[test]
fn addresses_in_a_body_count_as_in_every_language() {
    for (body, code, written) in [
        ("q := %IX1.0;\n", "ST-138", "%IX1.0"),
        ("q := a AND %IX1;\n", "ST-142", "%IX1"),
    ] {
        let text = of("ST", body);
        let made = import(&text, Board::UNO);
        let told = made.diagnostics.first().unwrap();
        assert_eq!(told.code.to_string(), code, "{body}");
        assert_eq!(&text[told.span.range()], written);
    }
}

#[test]
fn what_is_no_ladder_and_no_text_is_refused_by_its_name() {
    let bodies = ["<SFC/>", "<FBD/>", "<LD/></body><body><LD/>"];
    for (body, code) in bodies.map(|body| (body, "XML-504")) {
        let made = import(&project("", body), Board::UNO);
        let told: Vec<String> = made
            .diagnostics
            .iter()
            .map(|t| t.code.to_string())
            .collect();
        assert_eq!(told, [code], "{body}");
    }
    for (text, code) in [
        ("<a", "XML-501"),
        ("<a/>", "XML-502"),
        ("<project/>", "XML-503"),
        ("", "XML-501"),
        (
            "<!DOCTYPE a [<!ENTITY b 'c'>]><project>&b;</project>",
            "XML-501",
        ),
    ] {
        let made = import(text, Board::UNO);
        let told: Vec<String> = made
            .diagnostics
            .iter()
            .map(|t| t.code.to_string())
            .collect();
        assert_eq!(told, [code], "{text}");
    }
}
