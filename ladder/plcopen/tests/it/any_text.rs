//! No text makes the import panic, and none takes long: mutated projects, deep ones, large ones.

use crate::cases::{Case, cases};
use crate::project;
use unoclp_core::Profile;
use unoclp_host_sim::random::Random;
use unoclp_plcopen::import;

#[test]
fn mutated_projects_are_told_or_imported() {
    let texts: Vec<String> = cases().iter().map(Case::text).collect();
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
        let made = import(&text, Profile::UNO);
        assert!(
            made.program.is_some() || !made.diagnostics.is_empty(),
            "{text}"
        );
        imported += u32::from(made.program.is_some());
    }
    assert!(imported > 0);
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
        let made = import(
            &project("", &format!("<LD>{rail}{body}</LD>")),
            Profile::UNO,
        );
        assert!(made.program.is_none() && !made.diagnostics.is_empty());
    }
    let deep = format!("{}{}", "<a>".repeat(100_000), "</a>".repeat(100_000));
    for text in [deep, "<a>".repeat(200_000), " ".repeat(2_000_000)] {
        let made = import(&text, Profile::UNO);
        assert!(made.program.is_none() && !made.diagnostics.is_empty());
    }
}
