//! Bodies of text, and those that are not imported.

use crate::{Pou, codes, project, project_of};
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
fn a_type_of_the_project_goes_before_one_of_a_screen() {
    let number = r#"<variable name="t"><type><derived name="HMI_STRING"/></type><initialValue><simpleValue value="5"/></initialValue></variable>"#;
    let body = "<ST><xhtml:p>q := a AND t = 5;</xhtml:p></ST>";
    let own = r#"<dataTypes><dataType name="Hmi_String"><baseType><INT/></baseType></dataType></dataTypes>"#;
    let text = project(&format!("{VARIABLES}{number}"), body).replace("<dataTypes/>", own);
    let made = import(&text, Board::UNO);
    assert!(made.program.is_some(), "{:?}", made.diagnostics);
}

#[test]
fn a_body_may_say_again_what_its_unit_is() {
    let compiled = |text: &str| import(text, Board::UNO).code.map(|code| codes(&code));
    let wanted = compiled(&of("ST", "q := a;"));
    for body in [
        "PROGRAM Main\nVAR a AT %IX0.0 : BOOL; q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n",
        "(* made by a tool *) program Main VAR_INPUT\n END_VAR VAR END_VAR q := a; end_program;",
        "PROGRAM Main q := a; END_PROGRAM",
    ] {
        assert_eq!(compiled(&of("ST", body)), wanted, "{body}");
    }
    // Where nothing else declares them, its variables are those of the body.
    let body = "<ST><xhtml:p>PROGRAM Main\nVAR a AT %IX0.0 : BOOL; q AT %QX0.0 : BOOL; END_VAR\nq := a;\nEND_PROGRAM</xhtml:p></ST>";
    assert!(compiled(&project("", body)).is_some());
    // What is wrong in it stands at its place.
    let text = of(
        "ST",
        "PROGRAM Main\nVAR x : BOOL; END_VAR\nq := nothing;\nEND_PROGRAM\n",
    );
    let told = import(&text, Board::UNO).diagnostics;
    assert_eq!(&text[told.first().unwrap().span.range()], "nothing");
}

#[test]
fn the_form_before_version_two_and_small_letters_are_read() {
    let text = of("st", "q := a;").replace("typeName=", "type=");
    assert!(text.contains(" type=\"Main\""));
    assert_eq!(
        import(&text, Board::UNO).code,
        import(&of("ST", "q := a;"), Board::UNO).code
    );
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
    let bodies = ["<SFC/>", "<CFC/>", "<LD/></body><body><LD/>"];
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

/// What is told of a project, in both languages, without its help.
fn told(text: &str) -> Vec<[String; 2]> {
    let made = import(text, Board::UNO);
    let told = made.diagnostics.iter();
    let messages = told.map(|told| [told.message(Lang::En), told.message(Lang::Pt)]);
    messages.collect()
}

#[test]
fn messages_name_the_rung_and_the_element() {
    let rail = |id: u32, y: u32| {
        format!(
            r#"<leftPowerRail localId="{id}"><position x="0" y="{y}"/><connectionPointOut/></leftPowerRail>"#
        )
    };
    let wire = |from: u32| {
        format!("<connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn>")
    };
    let a = wire(700);
    let body = [
        "<LD>".to_owned(),
        rail(700, 10),
        format!(r#"<contact localId="701"><position x="9" y="10"/>{a}<connectionPointOut/><variable>a</variable></contact>"#),
        format!(r#"<coil localId="702"><position x="90" y="10"/>{}<variable>q</variable></coil>"#, wire(701)),
        rail(710, 90),
        format!(
            r#"<block localId="711" typeName="TON" instanceName="lamp"><position x="50" y="90"/><inputVariables><variable formalParameter="IN">{}</variable></inputVariables><outputVariables><variable formalParameter="Q"><connectionPointOut/></variable></outputVariables></block>"#,
            wire(710)
        ),
        r#"<coil localId="712"><position x="90" y="90"/><connectionPointIn><connection refLocalId="711" formalParameter="Q"/></connectionPointIn><variable>q</variable></coil>"#.to_owned(),
        rail(720, 200),
        format!(r#"<block localId="721" typeName="DELAY"><position x="50" y="200"/><inputVariables><variable formalParameter="X">{}</variable></inputVariables><outputVariables/></block>"#, wire(720)),
        "</LD>".to_owned(),
    ]
    .concat();
    let variables = format!(
        "{VARIABLES}<variable name=\"lamp\"><type><derived name=\"TON\"/></type></variable>"
    );
    assert_eq!(
        told(&project(&variables, &body)),
        [
            [
                "`Main`, rung 2, block `lamp` (TON): nothing is connected to PT",
                "`Main`, degrau 2, bloco `lamp` (TON): nada está ligado a PT"
            ],
            [
                "`Main`, rung 3, block `DELAY`: the block `DELAY` cannot be imported",
                "`Main`, degrau 3, bloco `DELAY`: o bloco `DELAY` não pode ser importado"
            ],
        ]
    );
}

#[test]
fn a_body_on_several_sheets_is_told_with_what_to_do() {
    let text = project("", "<ST/></body><body><ST/>");
    let en = "the body of `Main` cannot be imported: it is on several sheets";
    let pt = "o corpo de `Main` não pode ser importado: está dividido em várias folhas";
    assert_eq!(told(&text), [[en.to_owned(), pt.to_owned()]]);
    let made = import(&text, Board::UNO);
    assert_eq!(made.diagnostics[0].help(Lang::En), "put it on one sheet");
}

/// A project of a program in Instruction List and one in Structured Text.
fn beside(list: &str) -> String {
    let list = format!("<IL><xhtml:p><![CDATA[{list}]]></xhtml:p></IL>");
    let text = "<ST><xhtml:p>r := NOT b;</xhtml:p></ST>";
    let others = r#"
<variable name="b" address="%IX0.1"><type><BOOL/></type></variable>
<variable name="r" address="%QX0.1"><type><BOOL/></type></variable>"#;
    let pou = |name, variables, body| Pou {
        name,
        variables,
        body,
    };
    let pous = [pou("Main", VARIABLES, &list), pou("Other", others, text)];
    project_of(&pous, &["Main", "Other"])
}

#[test]
fn what_a_list_beside_other_languages_cannot_have_is_told_at_its_place() {
    for (list, code, place) in [
        ("LD a\nagain: ST q\nJMP again\n", "XML-505", "JMP"),
        ("LD a\nJMPC nowhere\nST q\n", "XML-505", "JMPC"),
        ("ST q\nLD a\n", "XML-505", "ST"),
        ("LD a\nJMPC on\non: ADD 1\n", "XML-505", "ADD"),
        ("LD a\nAND\nST q\n", "XML-505", "AND"),
        ("LD n\nEQ 4\nJMPC on\nCAL t\non: ST q\n", "XML-505", "ST"),
        ("LD a\n)\nST q\n", "XML-505", ")"),
        ("LD a\nAND nothing\nST q\n", "ST-130", "nothing"),
    ] {
        let text = beside(list);
        let made = import(&text, Board::UNO);
        let told = made.diagnostics.first().unwrap();
        let found = (told.code.to_string(), &text[told.span.range()]);
        assert_eq!(found, (code.to_owned(), place), "{list}");
        for lang in [Lang::En, Lang::Pt] {
            assert!(!told.message(lang).contains('{'), "{list}");
        }
        assert!(made.program.is_none());
    }
}

#[test]
fn a_line_of_a_list_beside_other_languages_knows_its_place() {
    let text = beside("LD a (* a\ncomment *)\nANDN %IX0.2\nST q // the lamp\n");
    let (_, map) = import(&text, Board::UNO).program.unwrap();
    let mut lines = map
        .steps
        .iter()
        .filter_map(|step| text.lines().nth(step.line - 1));
    assert!(lines.any(|line| line.contains("ST q")));
}

#[test]
fn no_list_makes_the_way_long() {
    let deep = "AND( a\n".repeat(3_000) + &")\n".repeat(3_000);
    let lists = [
        format!("LD a\n{}ST q\n", "ADD 1\nMUL n\n".repeat(5_000)),
        format!("LD a\n{deep}ST q\n"),
        format!("LD a\n{}", "(".repeat(20_000)),
        format!("LD a\n{}ST q\n", "NOT\n".repeat(20_000)),
        "x: ".repeat(20_000),
        "(*".repeat(20_000),
    ];
    for list in lists {
        let _ = import(&beside(&list), Board::UNO);
    }
}

#[test]
fn a_mistake_in_an_unused_unit_counts_only_where_the_unit_is_compiled() {
    let library = "<pou name=\"Own\" pouType=\"function\"><interface><returnType><BOOL/></returnType></interface><body><ST>Own := nobody;</ST></body></pou>";
    let variables = "<variable name=\"a\" address=\"%IX0.0\"><type><BOOL/></type></variable><variable name=\"q\" address=\"%QX0.0\"><type><BOOL/></type></variable>";
    let value =
        "<inVariable localId=\"1\"><connectionPointOut/><expression>a</expression></inVariable>";
    let blocks = format!(
        "<FBD>{value}<outVariable localId=\"2\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn><expression>q</expression></outVariable></FBD>"
    );
    for (body, is_program) in [
        (&*blocks, true),
        ("<ST>q := a;</ST>", false),
        (&blocks.replace("<expression>a", "<expression>Own()"), false),
    ] {
        let text = project(variables, body).replace("<pous>", &format!("<pous>{library}"));
        let made = import(&text, Board::UNO);
        assert_eq!(made.program.is_some(), is_program, "{:?}", made.diagnostics);
        assert_eq!(
            made.diagnostics.iter().count(),
            usize::from(!is_program),
            "{text}"
        );
    }
}
