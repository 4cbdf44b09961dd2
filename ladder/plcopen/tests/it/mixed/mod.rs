//! Random projects with bodies in all five languages, beside the same in Structured Text: the same outputs on random inputs,
//! scan by scan, as in `alike`. What is exported of the text comes back as the same codes.

mod expression;

use crate::alike::agree;
use crate::charts::{comes_back, large};
use expression::{Drawing, Expression};
use std::fmt::Write;
use unoclp_testing::{Random, rounds, typed_program};

const LANGUAGES: [&str; 5] = ["LD", "FBD", "SFC", "ST", "IL"];

/// The inputs of each block, and what it remembers.
const NAMES: [&str; 4] = ["x", "y", "w", "m"];

/// What the program gives its blocks.
const GIVEN: [&str; 4] = ["i0", "i1", "i2", "i3"];

/// A body in XML, and the same in Structured Text.
struct Body {
    xml: String,
    text: String,
}

fn text(language: &str, text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    format!("<{language}><xhtml:p>{text}</xhtml:p></{language}>")
}

/// `z := first; m := second;`
fn assigned(language: &str, first: &Expression, second: &Expression) -> Body {
    let said = format!("z := {};\nm := {};\n", first.text(), second.text());
    let mut drawing = Drawing::default();
    let xml = match language {
        "ST" => text("ST", &said),
        "IL" => {
            let (mut lines, second) = (first.list(), second.list());
            lines.push("ST z".to_owned());
            lines.extend(second);
            lines.push("ST m".to_owned());
            text("IL", &lines.join("\n"))
        }
        "LD" => {
            let rail = drawing.rail();
            for (of, name) in [(first, "z"), (second, "m")] {
                let from = drawing.contacts(of, false, vec![rail]);
                drawing.coil(name, &from);
            }
            format!("<LD>{}</LD>", drawing.xml)
        }
        _ => {
            for (of, name) in [(first, "z"), (second, "m")] {
                let from = drawing.blocks(of);
                drawing.variable(name, from);
            }
            format!("<FBD>{}</FBD>", drawing.xml)
        }
    };
    Body { xml, text: said }
}

/// A chart of two steps; in the second `z` is TRUE, or what `does` says. Its conditions and what it does are in ST or IL.
fn chart([there, back]: [&Expression; 2], does: Option<&Expression>, random: &mut Random) -> Body {
    let mut inline = |said: &Expression, end: &str| {
        let body = match random.percent(50) {
            true => text("ST", &(end.replace("{}", &said.text()))),
            false => {
                let store = if end == "{}" { "" } else { "\nST z" };
                text("IL", &(said.list().join("\n") + store))
            }
        };
        format!("<inline name=\"Does\">{body}</inline>")
    };
    let from =
        |id| format!("<connectionPointIn><connection refLocalId=\"{id}\"/></connectionPointIn>");
    let action = match does {
        Some(does) => inline(does, "z := {};"),
        None => "<reference name=\"z\"/>".to_owned(),
    };
    let (there_in, back_in) = (inline(there, "{}"), inline(back, "{}"));
    let xml = format!(
        "<SFC><step localId=\"1\" name=\"A\" initialStep=\"true\"><connectionPointOut/></step>
<transition localId=\"2\">{}<condition>{there_in}</condition></transition>
<step localId=\"3\" name=\"B\">{}<connectionPointOut/></step>
<actionBlock localId=\"4\">{}<action qualifier=\"N\">{action}</action></actionBlock>
<transition localId=\"5\">{}<condition>{back_in}</condition></transition>
<jumpStep localId=\"6\" targetName=\"A\">{}</jumpStep></SFC>",
        from(1),
        from(2),
        from(3),
        from(3),
        from(5)
    );
    let (name, body) = match does {
        Some(does) => (
            "Does",
            format!("ACTION Does: z := {}; END_ACTION\n", does.text()),
        ),
        None => ("z", String::new()),
    };
    let text = format!(
        "INITIAL_STEP A: END_STEP\nSTEP B: {name}(N); END_STEP
TRANSITION FROM A TO B := {}; END_TRANSITION
TRANSITION FROM B TO A := {}; END_TRANSITION\n{body}",
        there.text(),
        back.text()
    );
    Body { xml, text }
}

/// What a program gives an input of a block: an input of the board, or what a block before it gives.
#[derive(Clone, Copy)]
enum Given {
    Input(&'static str),
    Block(usize),
}

impl Given {
    fn text(self) -> String {
        match self {
            Given::Input(name) => name.to_owned(),
            Given::Block(at) => format!("u{at}.z"),
        }
    }
}

/// The program: calls the blocks one after the other, and shows what each gives.
fn main(language: &str, calls: &[[Given; 3]]) -> Body {
    let pins = |given: &[Given; 3], sign: &str| {
        let pins = NAMES.iter().zip(given);
        let pins: Vec<String> = pins
            .map(|(pin, of)| format!("{pin} {sign} {}", of.text()))
            .collect();
        pins.join(", ")
    };
    let mut said = String::new();
    for (at, given) in calls.iter().enumerate() {
        let _ = write!(said, "u{at}({});\nq{at} := u{at}.z;\n", pins(given, ":="));
    }
    let mut drawing = Drawing::default();
    let xml = match language {
        "ST" => text("ST", &said),
        "IL" => {
            let mut list = String::new();
            for (at, given) in calls.iter().enumerate() {
                let _ = write!(
                    list,
                    "CAL u{at}({})\nLD u{at}.z\nST q{at}\n",
                    pins(given, ":=")
                );
            }
            text("IL", &list)
        }
        language => {
            let rail = (language == "LD").then(|| drawing.rail());
            let mut given_by = Vec::new();
            for (at, given) in calls.iter().enumerate() {
                let mut pins = Vec::new();
                for (pin, of) in NAMES.iter().zip(given) {
                    let from = match (of, rail) {
                        (Given::Block(at), _) => given_by[*at],
                        (Given::Input(name), Some(rail)) => drawing.contact(name, false, &[rail]),
                        (Given::Input(name), None) => drawing.value(name),
                    };
                    pins.push(((*pin).to_owned(), vec![from]));
                }
                let (kind, name) = (format!("U{at}"), format!("u{at}"));
                let from = drawing.block(&kind, Some(&name), &pins, "z");
                given_by.push(from);
                match rail {
                    Some(_) => drawing.coil(&format!("q{at}"), &[from]),
                    None => drawing.variable(&format!("q{at}"), from),
                }
            }
            format!("<{language}>{}</{language}>", drawing.xml)
        }
    };
    Body { xml, text: said }
}

/// A project and its text.
fn project(seed: u64) -> (String, String) {
    let mut random = Random(seed + 1);
    let (mut pous, mut texts) = (String::new(), String::new());
    let mut calls = Vec::new();
    for at in 0..4 {
        let mut any = |depth| Expression::random(&NAMES, depth, &mut random);
        let (first, second, third) = (any(3), any(2), any(2));
        let given = |random: &mut Random| match random.percent(40) && at > 0 {
            true => Given::Block(random.below(at)),
            false => Given::Input(random.pick(&GIVEN)),
        };
        calls.push([0; 3].map(|_| given(&mut random)));
        let body = match random.pick(&LANGUAGES) {
            "SFC" => {
                let does = random.percent(40).then_some(&third);
                chart([&first, &second], does, &mut random)
            }
            language => assigned(language, &first, &second),
        };
        let variable =
            |name: &str| format!("<variable name=\"{name}\"><type><BOOL/></type></variable>");
        let [x, y, w, m] = NAMES.map(variable);
        let z = variable("z");
        let _ = write!(
            pous,
            "<pou name=\"U{at}\" pouType=\"functionBlock\"><interface><inputVars>{x}{y}{w}</inputVars><outputVars>{z}</outputVars><localVars>{m}</localVars></interface><body>{}</body></pou>\n",
            body.xml
        );
        let _ = write!(
            texts,
            "FUNCTION_BLOCK U{at}\nVAR_INPUT x, y, w : BOOL; END_VAR\nVAR_OUTPUT z : BOOL; END_VAR\nVAR m : BOOL; END_VAR\n{}END_FUNCTION_BLOCK\n",
            body.text
        );
    }
    let language = random.pick(&["LD", "FBD", "ST", "IL"]);
    let body = main(language, &calls);
    let (mut xml, mut declared) = (String::new(), String::new());
    for at in 0..4 {
        for (name, place) in [(format!("i{at}"), "I"), (format!("q{at}"), "Q")] {
            let _ = write!(
                xml,
                "<variable name=\"{name}\" address=\"%{place}X0.{at}\"><type><BOOL/></type></variable>"
            );
            let _ = write!(declared, "{name} AT %{place}X0.{at} : BOOL; ");
        }
        let _ = write!(
            xml,
            "<variable name=\"u{at}\"><type><derived name=\"U{at}\"/></type></variable>"
        );
        let _ = write!(declared, "u{at} : U{at}; ");
    }
    let project = crate::project(&xml, &body.xml).replace("<pous>", &format!("<pous>\n{pous}"));
    let text = format!(
        "{texts}PROGRAM Main\nVAR {declared}END_VAR\n{}END_PROGRAM\n",
        body.text
    );
    (project, text)
}

#[test]
fn random_projects_of_all_languages_mean_what_their_texts_mean() {
    let mut changes = 0;
    for seed in 0..u64::from(rounds(120)) {
        let (project, text) = project(seed);
        changes |= agree(&format!("seed {seed}"), &project, &text, 60);
        assert!(comes_back(&text, large()), "seed {seed}");
    }
    assert!(changes == 0b1111 || rounds(120) < 120);
}

#[test]
fn random_texts_come_back() {
    let all = rounds(120);
    let same = (0..u64::from(all)).filter(|seed| comes_back(&typed_program(*seed, 8), large()));
    let same = same.count();
    println!("{same} of {all} compile");
    assert!(all < 120 || same * 2 >= all as usize, "{same} of {all}");
}
