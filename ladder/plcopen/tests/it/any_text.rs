//! No text makes the import panic, and none takes long: mutated projects, deep ones, large ones.

use crate::alike::projects;
use crate::cases::{Case, cases};
use crate::charts::charts;
use crate::project;
use unoclp_core::Board;
use unoclp_host_sim::random::Random;
use unoclp_plcopen::import;

#[test]
fn mutated_projects_are_told_or_imported() {
    let mut texts: Vec<String> = cases().iter().map(Case::text).collect();
    texts.extend(projects().into_iter().map(|(_, project, _)| project));
    texts.extend(charts());
    let mut random = Random::new(18);
    let mut imported = 0;
    for _ in 0..unoclp_testing::rounds(2_000) {
        let text = &texts[random.below(texts.len() as u32) as usize];
        let mut lines: Vec<&str> = text.lines().collect();
        for _ in 0..=random.below(3) {
            let at = random.below(lines.len() as u32) as usize;
            let other = random.below(lines.len() as u32) as usize;
            match random.below(3) {
                0 => drop(lines.remove(at)),
                1 => lines.swap(at, other),
                _ => lines.insert(at, lines[other]),
            }
        }
        let mut text = lines.join("\n");
        if random.percent(50) {
            // A number becomes another, so that wires lead elsewhere.
            let digits: Vec<usize> = text
                .match_indices("refLocalId=\"")
                .map(|(at, word)| at + word.len())
                .collect();
            if let Some(at) = random.pick(&digits) {
                let digit = char::from(b'1' + random.below(9) as u8);
                text.replace_range(at..=at, &digit.to_string());
            }
        }
        let made = import(&text, Board::UNO);
        assert!(
            made.program.is_some() || !made.diagnostics.is_empty(),
            "{text}"
        );
        imported += u32::from(made.program.is_some());
    }
    assert!(imported > 0);
}

/// Branches that stand in each other, and a circle of them.
#[test]
fn charts_of_branches_without_steps_end() {
    let branch = |id: usize, from: &[usize]| {
        let lines: String = from
            .iter()
            .map(|id| {
                format!(r#"<connectionPointIn><connection refLocalId="{id}"/></connectionPointIn>"#)
            })
            .collect();
        format!(
            r#"<selectionConvergence localId="{id}">{lines}<connectionPointOut/></selectionConvergence>"#
        )
    };
    let first = r#"<step localId="0" name="S" initialStep="true"><connectionPointOut/></step>"#;
    let row: String = (1..3_000)
        .map(|id| branch(id, &[id - 1, id.saturating_sub(2)]))
        .collect();
    let circle = branch(1, &[2]) + &branch(2, &[1]);
    for (branches, last) in [(row, 2_999), (circle, 2)] {
        let ends: String = (0..200)
            .map(|id| format!(
                r#"<transition localId="{}"><connectionPointIn><connection refLocalId="{last}"/></connectionPointIn><connectionPointOut/><condition><reference name="x"/></condition></transition>"#,
                10_000 + id
            ))
            .collect();
        let made = import(
            &project("", &format!("<SFC>{first}{branches}{ends}</SFC>")),
            Board::UNO,
        );
        assert!(made.program.is_none());
        assert!(!made.diagnostics.is_empty());
    }
}

#[test]
fn deep_and_large_projects_end() {
    let rail =
        r#"<leftPowerRail localId="0"><connectionPointOut formalParameter=""/></leftPowerRail>"#;
    let contact = |id: usize, from: &[usize]| {
        let wires: String = from
            .iter()
            .map(|from| format!(r#"<connection refLocalId="{from}"/>"#))
            .collect();
        format!(
            r#"<contact localId="{id}"><connectionPointIn>{wires}</connectionPointIn><connectionPointOut/><variable>%IX0.0</variable></contact>"#
        )
    };
    let series: String = (1..5_000).map(|id| contact(id, &[id - 1])).collect();
    // Each looks at the two before it: as series and parallel it doubles at each step.
    let tangled: String = (1..3_000)
        .map(|id| contact(id, &[id - 1, id.saturating_sub(2)]))
        .collect();
    let beside: String = (1..5_000).map(|id| contact(id, &[0])).collect();
    for body in [series, tangled, beside] {
        let made = import(&project("", &format!("<LD>{rail}{body}</LD>")), Board::UNO);
        assert!(
            made.program.is_none() && !made.diagnostics.is_empty(),
            "{:?}",
            made.diagnostics.iter().take(3).collect::<Vec<_>>()
        );
    }
    let deep = format!("{}{}", "<a>".repeat(100_000), "</a>".repeat(100_000));
    for text in [deep, "<a>".repeat(200_000), " ".repeat(2_000_000)] {
        let made = import(&text, Board::UNO);
        assert!(made.program.is_none() && !made.diagnostics.is_empty());
    }
}

/// A body that a board could not hold ends by what it makes the import look at, and is told.
#[test]
fn each_kind_of_size_is_bounded() {
    let rail = r#"<leftPowerRail localId="r"><connectionPointOut/></leftPowerRail>"#;
    let a = r#"<variable name="a" address="%IX0.0"><type><BOOL/></type></variable>"#;
    let many = |count: usize, of: &dyn Fn(usize) -> String| (0..count).map(of).collect::<String>();
    let value =
        r#"<inVariable localId="v"><connectionPointOut/><expression>1</expression></inVariable>"#;
    let ladder = |body: String| project(a, &format!("<LD>{rail}{body}</LD>"));
    let diagram = |body: String| project(a, &format!("<FBD>{value}{body}</FBD>"));
    let element = |kind: &str, id: usize, from: &str, variable: &str| {
        format!(
            r#"<{kind} localId="{id}"><connectionPointIn><connection refLocalId="{from}"/></connectionPointIn><connectionPointOut/><variable>{variable}</variable></{kind}>"#
        )
    };
    let numbered = |id: usize| element("coil", id, "r", "%QX0.0");
    let inputs = |count| {
        many(count, &|_| {
            r#"<variable formalParameter="IN1"><connectionPointIn><connection refLocalId="v"/></connectionPointIn></variable>"#.to_owned()
        })
    };
    let long = "x".repeat(300_000);
    let pairs = |count: usize, back: usize| {
        many(count, &|id| {
            let from = match id.checked_sub(back) {
                Some(before) => before.to_string(),
                None => "r".to_owned(),
            };
            element("contact", 2 * id, &from, "a") + &element("coil", 2 * id + 1, &from, "%QX0.0")
        })
    };
    let function = |id: usize, from: Option<usize>| {
        let from = from.map_or("v".to_owned(), |from| format!("f{from}"));
        format!(
            r#"<block localId="f{id}" typeName="MAX"><inputVariables><variable formalParameter="IN1"><connectionPointIn><connection refLocalId="{from}" formalParameter="OUT"/></connectionPointIn></variable><variable formalParameter="IN2"><connectionPointIn><connection refLocalId="v"/></connectionPointIn></variable></inputVariables><outputVariables><variable formalParameter="OUT"><connectionPointOut/></variable></outputVariables></block>"#
        )
    };
    let output = |from: usize| {
        format!(
            r#"<outVariable localId="o{from}"><connectionPointIn><connection refLocalId="f{from}" formalParameter="OUT"/></connectionPointIn><expression>%MW1</expression></outVariable>"#
        )
    };
    // Each looks at the two before it, and has a coil.
    let contacts = |id: usize, before: usize| {
        let from = if id == 0 {
            "r".to_owned()
        } else {
            before.to_string()
        };
        let far = before.saturating_sub(1);
        let far = if id < 2 {
            "r".to_owned()
        } else {
            far.to_string()
        };
        format!(
            r#"<contact localId="{id}"><connectionPointIn><connection refLocalId="{from}"/><connection refLocalId="{far}"/></connectionPointIn><connectionPointOut/><variable>a</variable></contact>"#
        ) + &element("coil", id + 100_000, &id.to_string(), "a")
    };
    let project_text = project(a, "<LD/>");
    let with = |from: &str, to: &str| project_text.replacen(from, to, 1);
    let texts = [
        // The text itself.
        with(
            "<project ",
            &format!(
                "<project {} ",
                many(20_000, &|n| format!(r#"xmlns:n{n}="u" "#))
            ),
        ),
        with(
            "<types>",
            &many(20_000, &|n| format!(r#"<n xmlns:n{n}="u{n}"/>"#)),
        ),
        with(
            "<project ",
            &format!("<project {} ", many(90_000, &|n| format!(r#"n{n}="" "#))),
        ),
        with(
            "<LD/>",
            &format!(
                "{}{}",
                "<arrayValue><value>".repeat(15_000),
                "</value></arrayValue>".repeat(15_000)
            ),
        ),
        with("name=\"Main\"", &format!("name=\"{long}\"")),
        // What it declares and runs.
        with(
            "<pous>",
            &format!(
                "<pous>{}",
                many(15_000, &|n| format!(
                    r#"<pou name="p{n}" pouType="program"/>"#
                ))
            ),
        ),
        with(
            "<instances>",
            &format!(
                "<instances>{}",
                "<pouInstance typeName=\"Main\"/>".repeat(25_000)
            ),
        ),
        // Elements, wires and inputs.
        ladder(many(5_000, &numbered)),
        ladder(many(8_000, &|id| {
            format!(r#"<continuation localId="{id}" name="c{id}"/>"#)
        })),
        ladder(format!(
            "{value}<block localId=\"1\" typeName=\"GT\"><inputVariables>{}</inputVariables></block>",
            inputs(7_000)
        )),
        ladder(format!(
            "{value}<block localId=\"1\" typeName=\"AND\"><inputVariables>{}</inputVariables></block>",
            inputs(7_000)
        )),
        ladder(pairs(2_400, 2)),
        // What becomes a text: functions after each other, beside each other, in circles.
        ladder(
            value.to_owned() + &many(3_000, &|id| function(id, id.checked_sub(1))) + &output(2_999),
        ),
        ladder(value.to_owned() + &many(3_000, &|id| function(id, None) + &output(id))),
        ladder(value.to_owned() + &many(3_000, &|id| function(id, Some((id + 1) % 3_000)))),
        ladder(
            value.to_owned()
                + &function(0, None)
                + &many(3_000, &|id| contacts(id, id.saturating_sub(1)))
                + &output(0),
        ),
        ladder(pairs(2_400, 0)),
        ladder(
            element("contact", 1, "r", "a")
                + &many(4_000, &|id| element("coil", id + 2, "1", "%QX0.0")),
        ),
        // Diagrams: functions after each other, beside each other, in circles; connectors.
        diagram(many(3_000, &|id| function(id, id.checked_sub(1))) + &output(2_999)),
        diagram(many(3_000, &|id| function(id, None) + &output(id))),
        diagram(many(3_000, &|id| function(id, Some((id + 1) % 3_000))) + &output(0)),
        diagram(many(8_000, &|id| {
            format!(
                r#"<continuation localId="{id}" name="c{id}"/><connector localId="k{id}" name="c{}"><connectionPointIn><connection refLocalId="{id}"/></connectionPointIn></connector>"#,
                id + 1
            )
        })),
        ladder(element("contact", 1, "r", &long) + &element("coil", 2, "1", "%QX0.0")),
    ];
    for (index, text) in texts.iter().enumerate() {
        let made = import(text, Board::UNO);
        assert!(!made.diagnostics.is_empty(), "{index}");
    }
}
