//! Charts in PLCopen XML: what is written is read again as the same program, and what others write is taken.

use crate::codes;
use std::fs;
use std::path::Path;
use unoclp_core::Board;
use unoclp_lang::{Lang, TextLanguage, compile_text};
use unoclp_plcopen::{Imported, export_text, import};
use unoclp_testing::chart::sketch;
use unoclp_testing::held;

/// A board that any chart of a test fits on.
pub(crate) fn large() -> Board {
    Board {
        stored_bytes: 60_000,
        linked_bytes: 60_000,
        ..Board::PC
    }
}

/// What is told of a project.
fn told(made: &Imported) -> Vec<String> {
    let told = made.diagnostics.iter();
    told.map(|told| format!("{} {}", told.code, told.message(Lang::En)))
        .collect()
}

/// Tells where the project of a text makes other codes than the text; whether it compiles at all.
pub(crate) fn comes_back(text: &str, board: Board) -> bool {
    let own = compile_text(text, TextLanguage::St, board);
    let Some((own, _)) = own.program else {
        return false;
    };
    let xml = export_text(text, "test");
    let made = import(&xml, board);
    let Some((read, _)) = &made.program else {
        panic!("{:#?}\n{text}\n{xml}", told(&made));
    };
    let steps = |checked: &unoclp_checked::Checked| {
        let steps = checked.program().steps();
        steps
            .map(|step| step.codes().collect::<Vec<i32>>())
            .collect::<Vec<_>>()
    };
    assert_eq!(steps(&own), steps(read), "{text}\n{xml}");
    true
}

/// Projects with charts, an element a line.
pub(crate) fn charts() -> Vec<String> {
    let drawn = (0..6).map(|seed| export_text(&sketch(seed).text(seed % 2 == 0), "test"));
    let wired = "<leftPowerRail localId=\"10\"><connectionPointOut/></leftPowerRail>\n<contact localId=\"12\"><connectionPointIn><connection refLocalId=\"10\"/></connectionPointIn><connectionPointOut/><variable>a</variable></contact>\n";
    let condition = "<connection refLocalId=\"12\"/>";
    let valve = action(4, 3, "", "<reference name=\"q\"/>");
    let wired = project(&(two(condition, &valve) + wired), "");
    drawn.chain([wired.replace("><", ">\n<")]).collect()
}

#[test]
fn the_charts_of_courses_come_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/charts");
    let mut count = 0;
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_some_and(|end| end == "st") {
            assert!(comes_back(&fs::read_to_string(path).unwrap(), Board::UNO));
            count += 1;
        }
    }
    assert!(count >= 11, "{count}");
}

#[test]
fn random_charts_come_back() {
    let rounds = unoclp_testing::rounds(200);
    let seeds = 0..u64::from(rounds);
    let comes = |seed: u64| comes_back(&sketch(seed).text(seed.is_multiple_of(5)), large());
    let same = seeds.filter(|seed| held(|| comes(*seed)));
    let same = same.count() as u32;
    println!("{same} of {rounds}");
    assert!(same * 10 >= rounds * 8, "{same} of {rounds}");
}

/// A project of one program with this chart, and what else stands in its unit.
fn project(chart: &str, beside: &str) -> String {
    let variables = r#"
<variable name="a" address="%IX0.0"><type><BOOL/></type></variable>
<variable name="b" address="%IX0.1"><type><BOOL/></type></variable>
<variable name="q" address="%QX0.0"><type><BOOL/></type></variable>
<variable name="n"><type><INT/></type></variable>
<variable name="t"><type><derived name="TON"/></type></variable>
"#;
    let text = crate::project(variables, &format!("<SFC>{chart}</SFC>"));
    text.replace("</body>", &format!("</body>{beside}"))
}

fn step(id: u32, name: &str, from: &[u32]) -> String {
    let lines = lines(from);
    let initial = id == 1;
    format!(
        "<step localId=\"{id}\" name=\"{name}\" initialStep=\"{initial}\">{lines}<connectionPointOut/></step>"
    )
}

fn lines(from: &[u32]) -> String {
    let line = |id: &u32| {
        format!("<connectionPointIn><connection refLocalId=\"{id}\"/></connectionPointIn>")
    };
    from.iter().map(line).collect()
}

fn transition(id: u32, from: &[u32], condition: &str) -> String {
    let lines = lines(from);
    format!(
        "<transition localId=\"{id}\">{lines}<connectionPointOut/><condition>{condition}</condition></transition>"
    )
}

fn inline(language: &str, text: &str) -> String {
    format!(
        "<inline name=\"\"><{language}><xhtml:p><![CDATA[{text}]]></xhtml:p></{language}></inline>"
    )
}

fn jump(id: u32, from: u32, to: &str) -> String {
    format!(
        "<jumpStep localId=\"{id}\" targetName=\"{to}\">{}</jumpStep>",
        lines(&[from])
    )
}

fn action(id: u32, step: u32, attributes: &str, what: &str) -> String {
    format!(
        "<actionBlock localId=\"{id}\">{}<action localId=\"0\" {attributes}>{what}</action></actionBlock>",
        lines(&[step])
    )
}

/// Two steps: `S1`, and `S2` with this action; this condition leads to it, and `b` back.
fn two(condition: &str, action: &str) -> String {
    let back = inline("ST", "b");
    [
        step(1, "S1", &[]),
        transition(2, &[1], condition),
        step(3, "S2", &[2]),
        action.to_owned(),
        transition(5, &[3], &back),
        jump(6, 5, "S1"),
    ]
    .concat()
}

/// The codes of the chart that this text is.
fn of_text(chart: &str) -> Vec<i32> {
    let variables = "a AT %IX1 : BOOL; b AT %IX2 : BOOL; q AT %QX1 : BOOL; n : INT; t : TON;";
    let text = format!("PROGRAM Main VAR {variables} END_VAR {chart} END_PROGRAM");
    let made = compile_text(&text, TextLanguage::St, Board::UNO);
    let file = made.file();
    codes(&file.unwrap_or_else(|| panic!("{:?}\n{text}", made.diagnostics)))
}

const BACK: &str = "TRANSITION FROM S2 TO S1 := b; END_TRANSITION";

#[test]
fn conditions_and_actions_are_what_they_are_in_each_language() {
    let body = |language: &str, text: &str| {
        format!("<body><{language}><xhtml:p><![CDATA[{text}]]></xhtml:p></{language}></body>")
    };
    let named = |language: &str, text: &str| {
        format!(
            "<transitions><transition name=\"go\">{}</transition></transitions>",
            body(language, text)
        )
    };
    let acts = |language: &str, text: &str| {
        format!(
            "<actions><action name=\"does\">{}</action></actions>",
            body(language, text)
        )
    };
    let does = action(4, 3, "qualifier=\"N\"", "<reference name=\"does\"/>");
    let valve = action(4, 3, "", "<reference name=\"q\"/>");
    let limited = action(
        4,
        3,
        "qualifier=\"L\" duration=\"T#2s\"",
        "<reference name=\"q\"/>",
    );
    let wired = "<connectionPointIn><connection refLocalId=\"12\"/></connectionPointIn>";
    let contacts = "<leftPowerRail localId=\"10\"><connectionPointOut/></leftPowerRail>\
        <contact localId=\"11\"><connectionPointIn><connection refLocalId=\"10\"/></connectionPointIn><connectionPointOut/><variable>a</variable></contact>\
        <contact localId=\"12\" negated=\"true\"><connectionPointIn><connection refLocalId=\"11\"/></connectionPointIn><connectionPointOut/><variable>b</variable></contact>";
    let ladder = "<body><LD><leftPowerRail localId=\"1\"><connectionPointOut/></leftPowerRail>\
        <contact localId=\"2\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn><connectionPointOut/><variable>a</variable></contact>\
        <coil localId=\"3\"><connectionPointIn><connection refLocalId=\"2\"/></connectionPointIn><variable>q</variable></coil></LD></body>";
    let chart = |condition: &str, what: &str, more: &str| {
        format!(
            "INITIAL_STEP S1: END_STEP STEP S2: {what} END_STEP \
             TRANSITION FROM S1 TO S2 := {condition}; END_TRANSITION {BACK} {more}"
        )
    };
    let reference = "<reference name=\"go\"/>";
    let cases = [
        (
            two(&inline("ST", "a AND NOT b"), &valve),
            String::new(),
            chart("a AND NOT b", "q(N);", ""),
        ),
        (
            two(&inline("ST", ":= a;"), &limited),
            String::new(),
            chart("a", "q(L, T#2s);", ""),
        ),
        (
            two(&inline("IL", "LD a\nANDN b"), &valve),
            String::new(),
            chart("a AND NOT b", "q(N);", ""),
        ),
        (
            two("<reference name=\"a\"/>", &valve),
            String::new(),
            chart("a", "q(N);", ""),
        ),
        (
            two(reference, &valve),
            named("ST", ":= a OR b;"),
            chart("a OR b", "q(N);", ""),
        ),
        (
            two(reference, &valve),
            named("IL", "LD a (* first *)\nOR( b\nAND n\n)").replace("AND n", "AND a"),
            chart("a OR b AND a", "q(N);", ""),
        ),
        (
            two(wired, &valve) + contacts,
            String::new(),
            chart("a AND NOT b", "q(N);", ""),
        ),
        (
            two(&inline("ST", "a"), &does),
            acts("ST", "n := n + 1;"),
            chart("a", "does(N);", "ACTION does: n := n + 1; END_ACTION"),
        ),
        (
            two(&inline("ST", "a"), &does),
            acts("IL", "LD n\nADD 1\nST n"),
            chart("a", "does(N);", "ACTION does: n := (n) + 1; END_ACTION"),
        ),
        (
            two(&inline("ST", "a"), &does),
            format!("<actions><action name=\"does\">{ladder}</action></actions>"),
            chart("a", "does(N);", "ACTION does: q := a; END_ACTION"),
        ),
        (
            two(reference, &valve),
            format!(
                "<transitions><transition name=\"go\"><body><FBD>{}</FBD></body></transition></transitions>",
                "<inVariable localId=\"1\"><connectionPointOut/><expression>a</expression></inVariable>\
                <block localId=\"2\" typeName=\"NOT\"><inputVariables><variable formalParameter=\"IN\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn></variable></inputVariables><inOutVariables/>\
                <outputVariables><variable formalParameter=\"OUT\"><connectionPointOut/></variable></outputVariables></block>\
                <outVariable localId=\"3\"><connectionPointIn><connection refLocalId=\"2\" formalParameter=\"OUT\"/></connectionPointIn><expression>go</expression></outVariable>"
            ),
            chart("NOT a", "q(N);", ""),
        ),
        (
            two(reference, &valve),
            format!(
                "<transitions><transition name=\"go\">{}</transition></transitions>",
                ladder.replace("<variable>q<", "<variable>go<")
            ),
            chart("a", "q(N);", ""),
        ),
        (
            two(
                &inline("ST", "a"),
                &action(4, 3, "qualifier=\"P\"", &inline("ST", "n := n + 1;")),
            ),
            String::new(),
            chart("a", "does(P);", "ACTION does: n := n + 1; END_ACTION"),
        ),
    ];
    for (chart, beside, text) in cases {
        let made = import(&project(&chart, &beside), Board::UNO);
        let code = made.code.as_deref().map(codes);
        assert_eq!(
            code,
            Some(of_text(&text)),
            "{:?}\n{text}\n{chart}",
            told(&made)
        );
    }
}

/// As OpenPLC Editor and Beremiz have it: a block that leads to a condition is called in each scan.
#[test]
fn a_timer_before_a_condition_is_called_in_each_scan() {
    let block = "<leftPowerRail localId=\"10\"><connectionPointOut/></leftPowerRail>\
        <contact localId=\"11\"><connectionPointIn><connection refLocalId=\"10\"/></connectionPointIn><connectionPointOut/><variable>S1.X</variable></contact>\
        <inVariable localId=\"13\"><connectionPointOut/><expression>T#2s</expression></inVariable>\
        <block localId=\"12\" typeName=\"TON\" instanceName=\"t\"><inputVariables>\
        <variable formalParameter=\"IN\"><connectionPointIn><connection refLocalId=\"11\"/></connectionPointIn></variable>\
        <variable formalParameter=\"PT\"><connectionPointIn><connection refLocalId=\"13\"/></connectionPointIn></variable>\
        </inputVariables><outputVariables><variable formalParameter=\"Q\"><connectionPointOut/></variable></outputVariables></block>";
    let wired = "<connection refLocalId=\"12\" formalParameter=\"Q\"/>";
    let valve = action(4, 3, "", "<reference name=\"q\"/>");
    let made = import(&project(&(two(wired, &valve) + block), ""), Board::UNO);
    let text = format!(
        "INITIAL_STEP S1: calls(S); END_STEP STEP S2: q(N); END_STEP \
         TRANSITION FROM S1 TO S2 := t.Q; END_TRANSITION {BACK} \
         ACTION calls: t(IN := S1.X, PT := T#2s); END_ACTION"
    );
    assert_eq!(
        made.code.as_deref().map(codes),
        Some(of_text(&text)),
        "{:?}",
        told(&made)
    );
}

/// The left branch of a selection goes first, wherever it stands in the file; sequences that part and meet again.
#[test]
fn branches_are_read_from_left_to_right() {
    let at =
        |text: String, x: u32| text.replacen("><", &format!("><position x=\"{x}\" y=\"0\"/><"), 1);
    let branch = |kind: &str, id: u32, from: &[u32]| {
        format!(
            "<{kind} localId=\"{id}\">{}<connectionPointOut/></{kind}>",
            lines(from)
        )
    };
    let st = |text: &str| inline("ST", text);
    let chart = [
        step(1, "S1", &[]),
        branch("selectionDivergence", 2, &[1]),
        at(transition(3, &[2], &st("a")), 100),
        at(transition(4, &[2], &st("b")), 50),
        jump(5, 3, "S1"),
        branch("simultaneousDivergence", 6, &[4]),
        at(step(7, "R", &[6]), 90),
        at(step(8, "L", &[6]), 40),
        branch("simultaneousConvergence", 9, &[8, 7]),
        transition(10, &[9], &st("a AND b")),
        jump(11, 10, "S1"),
    ]
    .concat();
    let made = import(&project(&chart, ""), Board::UNO);
    let text = "INITIAL_STEP S1: END_STEP STEP R: END_STEP STEP L: END_STEP \
         TRANSITION FROM S1 TO (L, R) := b; END_TRANSITION TRANSITION FROM S1 TO S1 := a; END_TRANSITION \
         TRANSITION FROM (L, R) TO S1 := a AND b; END_TRANSITION";
    assert_eq!(
        made.code.as_deref().map(codes),
        Some(of_text(text)),
        "{:?}",
        told(&made)
    );
}

#[test]
fn what_is_wrong_is_told_by_the_names_of_steps_and_transitions() {
    let st = |text: &str| inline("ST", text);
    let valve = action(4, 3, "", "<reference name=\"q\"/>");
    let good = two(&st("a"), &valve);
    let macro_step = "<macroStep localId=\"30\" name=\"M1\"/>";
    let cases = [
        (
            good.clone() + macro_step,
            "XML-540 `Main`, macro step `M1`: a macro step cannot be imported",
        ),
        (
            good.clone() + &transition(30, &[], &st("a")),
            "XML-541 `Main`, a transition: no step comes before it",
        ),
        (
            good.clone() + &transition(30, &[3], &st("a")),
            "XML-541 `Main`, transition after `S2`: no step comes after it",
        ),
        (
            good.clone() + &action(30, 99, "", "<reference name=\"q\"/>"),
            "XML-541 `Main`, actions `q`: no step comes before it",
        ),
        (
            two("", &valve),
            "XML-542 `Main`, transition after `S1`: an empty body cannot be imported as a condition",
        ),
        (
            two(&st(" "), &valve),
            "XML-542 `Main`, transition after `S1`: an empty body cannot be imported as a condition",
        ),
        (
            two(&inline("IL", "CAL t"), &valve),
            "XML-542 `Main`, transition after `S1`: `CAL` in IL cannot be imported as a condition",
        ),
        (
            two(&inline("SFC", ""), &valve),
            "XML-542 `Main`, transition after `S1`: code in SFC cannot be imported as a condition",
        ),
        (
            two(&st("a"), &action(4, 3, "", &inline("IL", "JMP x"))),
            "XML-543 `Main`, action `S2_does`: a jump to `x`, which is not a label, cannot be imported as the body of an action",
        ),
        (
            two(&st("a"), &action(4, 3, "", "")),
            "XML-543 `Main`, action of `S2`: an empty body cannot be imported as the body of an action",
        ),
        (
            good.replace("targetName=\"S1\"", "targetName=\"S9\""),
            "ST-241 `S9` is not a step of this chart",
        ),
        (
            good.replace("initialStep=\"true\"", ""),
            "ST-242 this chart has no initial step, so nothing in it would ever run",
        ),
        (two(&st("c"), &valve), "ST-130 `c` is not declared"),
        (
            two(
                &st("a"),
                &action(4, 3, "qualifier=\"X\"", "<reference name=\"q\"/>"),
            ),
            "ST-246 `X` is not an action qualifier",
        ),
        (
            String::new(),
            "XML-504 the body of `Main` cannot be imported: it is empty",
        ),
    ];
    for (chart, wanted) in cases {
        let text = project(&chart, "");
        let made = import(&text, Board::UNO);
        let told = told(&made);
        assert!(made.program.is_none(), "{wanted}: {told:?}");
        assert!(
            told.iter().any(|told| told.starts_with(wanted)),
            "{wanted}: {told:#?}"
        );
        for told in made.diagnostics.iter() {
            assert!(text.get(told.span.range()).is_some(), "{told:?}");
        }
    }
}
