//! The pages on plants list every kind as the table has it, and what they show is right.

use crate::{folder, plant};
use std::fs;
use unoclp_plant::guide;
use unoclp_words::Lang;

/// Between these the list stands, which this test writes with UPDATE=1.
const MARKS: [&str; 2] = ["<!-- kinds -->\n", "<!-- end of kinds -->\n"];

#[test]
fn the_pages_list_every_kind() {
    for (name, lang) in [("plants.md", Lang::En), ("plants.pt-BR.md", Lang::Pt)] {
        let file = folder("docs").join(name);
        let page = fs::read_to_string(&file).unwrap();
        let (before, rest) = page.split_once(MARKS[0]).unwrap();
        let (_, after) = rest.split_once(MARKS[1]).unwrap();
        let now = format!("{before}{}\n{}{}{after}", MARKS[0], guide(lang), MARKS[1]);
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&file, &now).unwrap();
        }
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            now,
            "{name}: UPDATE=1 cargo test -p unoclp-plant writes it"
        );
    }
}

#[test]
fn the_example_of_the_pages_is_a_plant() {
    let example = |name: &str| {
        let page = fs::read_to_string(folder("docs").join(name)).unwrap();
        let blocks = page.split("```toml\n").skip(1);
        blocks
            .filter_map(|block| block.split("```").next())
            .collect::<String>()
    };
    let english = example("plants.md");
    assert_eq!(english, example("plants.pt-BR.md"));
    let plant = plant(&english);
    assert_eq!((plant.nevers.len(), plant.goals.len()), (2, 1));
}
