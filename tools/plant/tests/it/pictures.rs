//! Drawings are right SVG, name what changes once, and say the same as their changes.

use crate::{folder, plant, plants};
use roxmltree::Document;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use unoclp_core::Image;
use unoclp_plant::{Change, KINDS, Outputs, Run, live, picture, symbol};
use unoclp_words::Lang;

#[test]
fn every_moment_is_drawn_and_each_name_stands_once() {
    for (name, plant) in plants() {
        let mut run = Run::new(&plant, 1);
        let before = live(&run, Lang::Pt);
        let begin = texts(&picture(&run, Lang::Pt).svg());
        let outputs = Outputs {
            points: Image(0b0101),
            ..Outputs::default()
        };
        (0..9000).for_each(|_| {
            run.step(&outputs);
        });
        let after = live(&run, Lang::Pt);
        let svg = picture(&run, Lang::Pt).svg();
        let page = Document::parse(&svg).unwrap_or_else(|error| panic!("{name}: {error}"));
        let names: Vec<&str> = page
            .descendants()
            .filter_map(|node| node.attribute("id"))
            .collect();
        let unique: BTreeSet<&str> = names.iter().copied().collect();
        assert_eq!(names.len(), unique.len(), "{name}");
        let changes = after.changes(&before, &plant);
        assert!(changes.iter().any(|change| change.id == "time"), "{name}");
        for change in &changes {
            let own = page
                .descendants()
                .find(|node| node.attribute("id") == Some(&*change.id))
                .unwrap();
            match change.attribute {
                Some(attribute) => {
                    assert_eq!(own.attribute(attribute), Some(&*change.value), "{name}")
                }
                None => assert_eq!(own.text().unwrap_or_default(), change.value, "{name}"),
            }
        }
        assert_eq!(after.changes(&after, &plant), []);
        // With them the drawing of before is that of now.
        let mut shown = begin;
        for Change {
            id,
            attribute,
            value,
        } in changes
        {
            let attribute = attribute.unwrap_or_default().to_owned();
            assert!(shown.insert((id, attribute), value).is_some(), "{name}");
        }
        assert_eq!(shown, texts(&svg), "{name}");
    }
}

/// What a drawing says of each element that changes: its attributes, and its text without a name.
fn texts(svg: &str) -> BTreeMap<(String, String), String> {
    let page = Document::parse(svg).unwrap();
    let mut all = BTreeMap::new();
    for node in page.descendants() {
        let Some(id) = node.attribute("id") else {
            continue;
        };
        for attribute in node.attributes() {
            let (name, value) = (attribute.name().to_owned(), attribute.value().to_owned());
            all.insert((id.to_owned(), name), value);
        }
        let text = node.text().unwrap_or_default().to_owned();
        all.insert((id.to_owned(), String::new()), text);
    }
    all
}

#[test]
fn what_a_file_says_is_text_and_nothing_else() {
    let text = "title = \"<script>alert(1)</script>\"\n[[part]]\nname = \"b\"\nkind = \"button\"\nlabel = \"\\\"><script>x\\u0007</script>\"\n";
    let plant = plant(text);
    let svg = picture(&Run::new(&plant, 1), Lang::En).svg();
    let page = Document::parse(&svg).unwrap();
    assert!(
        !page
            .descendants()
            .any(|node| node.tag_name().name() == "script")
    );
}

/// What a person presses or turns is found by its name, as it is seen and as it is said: nothing else is written on it but
/// signs.
#[test]
fn a_control_says_its_name_and_nothing_else() {
    let mut count = 0;
    for kind in KINDS {
        if !kind.values.iter().any(|slot| slot.by_hand) {
            continue;
        }
        let svg = symbol(kind, Lang::En).unwrap().svg();
        let page = Document::parse(&svg).unwrap();
        let symbol = page
            .descendants()
            .find(|node| node.attribute("data-part").is_some())
            .unwrap();
        let words = symbol.descendants().filter(|node| node.is_text());
        let words: Vec<&str> = words.filter_map(|node| node.text()).collect();
        let is_word = |text: &&&str| text.chars().any(char::is_alphanumeric);
        let said: Vec<&&str> = words.iter().filter(is_word).collect();
        assert_eq!(said, [&kind.name], "{}", kind.name);
        count += 1;
    }
    assert!(count >= 8, "{count}");
}

/// The pictures of `docs/plants/`, which the pages show. With UPDATE=1 they are written.
#[test]
fn each_kind_has_its_picture_in_the_docs() {
    let docs = folder("docs/plants");
    let mut names = BTreeSet::new();
    for kind in KINDS {
        let svg = symbol(kind, Lang::En)
            .unwrap_or_else(|| panic!("{}", kind.name))
            .svg();
        let file = docs.join(format!("{}.svg", kind.name));
        if std::env::var_os("UPDATE").is_some() {
            fs::create_dir_all(&docs).unwrap();
            fs::write(&file, &svg).unwrap();
        }
        let kept = fs::read_to_string(&file).unwrap_or_default();
        assert_eq!(
            kept, svg,
            "{}: UPDATE=1 cargo test -p unoclp-plant writes it",
            kind.name
        );
        names.insert(format!("{}.svg", kind.name));
    }
    let entries = fs::read_dir(&docs).unwrap();
    let there: BTreeSet<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(there, names);
}
