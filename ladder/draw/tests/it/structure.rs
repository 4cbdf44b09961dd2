//! What each form of code looks like.

use unoclp_checked::numeric;
use unoclp_core::{Board, Loader};
use unoclp_draw::edit::{Document, Drawn};
use unoclp_draw::{Ladder, Medium, Names, Style, listing, to_svg};
use unoclp_point::Address;

/// Draws the codes of one rung; in the editor's document they look the same.
fn drawn(codes: &str, names: &[(Address, &str)], width: usize) -> String {
    let file = format!("0\n{}\n", codes.replace(' ', "\n"));
    let mut memory = vec![0; 2_000];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    file.bytes().for_each(|byte| loader.push(byte).unwrap());
    let program = loader.finish().unwrap();
    let ladder = Ladder::new(program.steps());
    let names: Names = names
        .iter()
        .map(|(point, name)| (*point, (*name).to_owned()))
        .collect();
    let drawing = ladder.draw(&Style {
        width,
        names: &names,
        medium: Medium::PLAIN,
    });
    let picture = drawing.rungs[0].to_string();
    let document = Document::of_steps(program.steps());
    let back: Vec<String> = (document.codes().unwrap().iter().skip(1))
        .map(i32::to_string)
        .collect();
    assert_eq!(back.join(" "), codes);
    let edited = Drawn::of(&document);
    let edited = edited.draw(width, &names);
    // The editor shows where an element can still be put.
    let edited = edited.rungs[0].to_string().replace("┤ ? ├", "─────");
    assert_eq!(edited, picture, "{codes}");
    picture
}

#[test]
fn each_form_of_code_has_its_picture() {
    #[rustfmt::skip]
    let cases = [
        ("paths of one join, however nested",
         "827301 40 827302 40 827303 41 41 40 827304 41 877901", "\
├──┤ I1 ├──┬────────────────────────────────────( Q1 )─┤
├──┤ I2 ├──┤                                           │
├──┤ I3 ├──┤                                           │
├──┤ I4 ├──┘                                           │
"),
        ("a path from a stored point",
         "827303 404101 827301 40 404101 -827302 41 877901", "\
├──┤ I3 ├──┬──┤ I1 ├──┬─────────────────────────( Q1 )─┤
│          └──┤/I2 ├──┘                                │
"),
        ("the same within another join",
         "827301 404101 827302 40 827303 41 40 404101 827304 41 877902", "\
├──┤ I1 ├──┬──┤ I2 ├──┬──┬──────────────────────( Q2 )─┤
│          └──┤ I4 ├──┘  │                             │
├──┤ I3 ├────────────────┘                             │
"),
        ("a path that no wire leads to",
         "827301 404101 827302 40 827303 41 -827901 40 404101 827304 41 877902", "\
├──┤ I1 ├──•1──┤ I2 ├──┬──┤/Q1 ├──┬─────────────( Q2 )─┤
├──┤ I3 ├──────────────┘          │                    │
│ •1──┤ I4 ├──────────────────────┘                    │
"),
        ("a path from the rail within one from a point",
         "827301 404101 827302 40 404101 827303 40 827304 41 828301 41 877901", "\
├──┤ I1 ├──┬──┤ I2 ├──────────────────┬─────────( Q1 )─┤
│          └─────┤ I3 ├────┬──┤ S1 ├──┘                │
│               ├──┤ I4 ├──┘                           │
"),
        ("a point that nothing begins at",
         "827301 404102 404102 877901", "\
├──┤ I1 ├──•2──•2.2─────────────────────────────( Q1 )─┤
"),
        ("a point that nothing begins at keeps its number from others",
         "827301 404101 827302 404102 827303 40 404102 827304 41 877901", "\
├──┤ I1 ├──•1──┤ I2 ├──┬──┤ I3 ├──┬─────────────( Q1 )─┤
│                      └──┤ I4 ├──┘                    │
"),
        ("a block that is nothing but its contents in series",
         "827301 6540 827302 40 -827303 41 41 877901", "\
├──┤ I1 ├──┬──┤ I2 ├──┬─────────────────────────( Q1 )─┤
│          └──┤/I3 ├──┘                                │
"),
        ("a block that looks at what stands before",
         "827301 6540 827302 6985 41 877901", "\
├──┤ I1 ├───────[ AND ]─────────────────────────( Q1 )─┤
├──┤ I2 ├──┤P├─────┘                                   │
"),
        ("an exclusive OR",
         "827301 8840 827302 40 827303 41 41 787984 6968 877901", "\
├──┤ I1 ├─────[ XOR ]──┤NOT├──┤N├───────────────( Q1 )─┤
├──┤ I2 ├──┬─────┘                                     │
├──┤ I3 ├──┘                                           │
"),
        ("a chain of coils",
         "827301 877901 -877902 827302 83877903 82877904", "\
├──┤ I1 ├──┬────────────────────────────────────( Q1 )─┤
│          ├────────────────────────────────────(/Q2 )─┤
│          └──┤ I2 ├──┬─────────────────────────(S Q3)─┤
│                     └─────────────────────────(R Q4)─┤
"),
        ("a coil within a path",
         "827301 877901 40 827302 41 877902", "\
├──┤ I1 ├──( Q1 )──┬────────────────────────────( Q2 )─┤
├──┤ I2 ├──────────┘                                   │
"),
        ("paths that end in coils",
         "827301 404101 827302 877901 40 404101 827303 877902 41", "\
├──┤ I1 ├──┬──┤ I2 ├────────────────────────────( Q1 )─┤
│          └──┤ I3 ├────────────────────────────( Q2 )─┤
"),
        ("timers in a row",
         "827301 847978 5000 7901 8480 100 7702", "\
├──┤ I1 ├──[ TON T1 5000 ms ]──┬────────────────────( Q1 )─┤
│                              └──[ TP T2 100 ms ]──( M2 )─┤
"),
        ("a comparison together with its load, and one of the same value",
         "76686500 716900 500 877901 768400 100 877902", "\
├──[ A0 >= 500 ]──┬─────────────────────────────( Q1 )─┤
│                 └──[ A0 < 100 ]───────────────( Q2 )─┤
"),
        ("jumps and returns",
         "766601 827301 74778001 -74778001 826984 -826984", "\
├──┤ I1 ├──┬─────────────────────────────────────>> L1─┤
│          ├──────────────────────────────┤NOT├──>> L1─┤
│          ├─────────────────────────────────────<RET>─┤
│          └──────────────────────────────┤NOT├──<RET>─┤
"),
        ("a block move and a drum", "827301 77798601 6803 2 68827702 2 1000 11", "\
├──┤ I1 ├──[ MOV D1-2 to D3-4 ]────────[ DRM D2 ]──────┤
│                                        0:1000 1:0011 │
"),
        ("a rung without an output", "827301", "\
├──┤ I1 ├                                              │
"),
        ("an empty branch", "827301 40 41 877901", "\
├──┤ I1 ├──┬────────────────────────────────────( Q1 )─┤
├──────────┘                                           │
"),
    ];
    for (what, codes, expected) in cases {
        let picture = drawn(codes, &[], 80);
        assert_eq!(picture, expected, "{what}\n{picture}");
    }
}

#[test]
fn names_stand_above_and_long_ones_are_cut() {
    let names = [
        (Address::Input(1), "início"),
        (Address::Output(1), "a name of twenty-two c"),
    ];
    let expected = "\
│  início                         a name of twenty-tw… │
├──┤ I1 ├────────────────────────────────( Q1 )────────┤
";
    assert_eq!(drawn("827301 877901", &names, 80), expected);
}

#[test]
fn a_rung_that_is_too_wide_goes_on_by_name() {
    let row = "827301 827302 827303 827304 827901 827902";
    let expected = "\
├──┤ I1 ├──┤ I2 ├──┤ I3 ├──┤ I4 ├──┤ Q1 ├──→a          │
│ a→──┤ Q2 ├────────────────────────────────────( Q1 )─┤
";
    assert_eq!(drawn(&format!("{row} 877901"), &[], 56), expected);
    let expected = "\
├──┤ I1 ├──┤ I2 ├──┤ I3 ├──┤ I4 ├──┤ Q1 ├──→b          │
│ b→──┤ Q2 ├──→a                                       │
├──┤ I1 ├──┤ I2 ├──┤ I3 ├──┤ I4 ├──┤ Q1 ├──→c          │
│ c→──┤ Q2 ├──→a                                       │
│ a→────────────────────────────────────────────( Q1 )─┤
";
    assert_eq!(
        drawn(&format!("{row} 40 {row} 41 877901"), &[], 56),
        expected
    );
    let expected = "\
├──┤ I1 ├──┤ I2 ├──┤ I3 ├──┤ I4 ├──┤ Q1 ├──→c          │
│ c→──┤ Q2 ├──→a                                       │
├──┤ I1 ├──┤ I2 ├──┤ I3 ├──┤ I4 ├──┤ Q1 ├──→d          │
│ d→──┤ Q2 ├──→b                                       │
│ a→────────[ XOR ]─────────────────────────────( Q1 )─┤
│       b→─────┘                                       │
";
    assert_eq!(
        drawn(&format!("{row} 8840 {row} 41 877901"), &[], 56),
        expected
    );
}

#[test]
fn a_listing_tells_rungs_lines_comments_and_labels() {
    let file = "/ Motor\n/ I1  start\n\n0\n/ Forward, as long as\n/ the button is held\n827301\n877901\n\
        787600 / NL\n766603\n\n/ Off\n827302\n847978\n5\n7902";
    let (checked, map) = numeric(file.as_bytes(), Board::UNO).unwrap();
    let program = checked.program();
    let ladder = Ladder::new(program.steps());
    let names = Names::from([(Address::Label(3), "again".to_owned())]);
    let style = Style {
        width: 80,
        names: &names,
        medium: Medium::PLAIN,
    };
    let drawing = ladder.draw(&style);
    let expected = "\
Motor
I1  start

Rung 1, lines 7 to 8: Forward, as long as the button is held
├──┤ I1 ├───────────────────────────────────────( Q1 )─┤

Rung 2, lines 9 to 16
L3: again
├──┤ I2 ├──[ TON T1 5 ms ]──────────────────────( Q2 )─┤
";
    let title = |number: usize, lines: Option<(usize, usize)>| {
        let (from, to) = lines.unwrap();
        format!("Rung {number}, lines {from} to {to}")
    };
    assert_eq!(listing(&drawing, &map, &names, &title), expected);
    let medium = Medium::Paper;
    let drawing = ladder.draw(&Style { medium, ..style });
    let svg = to_svg(&drawing, &map, &names, &title, "A < B & C");
    // A timer is a box with pins, its address above it.
    for part in [
        "<svg ",
        "A &lt; B &amp; C",
        "Rung 2, lines 9 to 16",
        "L3: again",
        ">T1</text>",
        ">TON</text>",
        ">IN</text>",
        ">PT</text>",
        ">T#5ms</text>",
        ">Q</text>",
        ">ET</text>",
    ] {
        assert!(svg.contains(part), "{part} is missing in\n{svg}");
    }
    assert!(!svg.contains("TON T1"), "{svg}");
}

/// The wires of another branch make the rows between them higher.
#[test]
fn a_name_stands_at_the_address_of_its_symbol() {
    let codes = "0 827301 40 827901 41 877901 847978 5000 7904";
    let (checked, map) = numeric(codes.replace(' ', "\n").as_bytes(), Board::UNO).unwrap();
    let ladder = Ladder::new(checked.program().steps());
    let names = Names::from([
        (Address::Timer(1), "late".to_owned()),
        (Address::Output(4), "over".to_owned()),
    ]);
    let drawing = ladder.draw(&Style {
        width: 80,
        names: &names,
        medium: Medium::Paper,
    });
    let svg = to_svg(&drawing, &map, &names, &|_, _| String::new(), "two");
    let height = |text: &str| -> f32 {
        let (before, _) = svg.split_once(&format!(">{text}</text>")).unwrap();
        let (_, y) = before.rsplit_once(" y=\"").unwrap();
        y.trim_end_matches('"').parse().unwrap()
    };
    for (name, address) in [("late", "T1"), ("over", "Q4")] {
        let apart = height(address) - height(name);
        assert!((15.0..18.0).contains(&apart), "{name}: {apart}\n{svg}");
    }
}

/// What is wider than that is scrolled; coils stand at the right rail of all.
#[test]
fn a_drawing_for_a_screen_takes_the_columns_that_there_are() {
    let codes = "0 827301 877901 787600 827302 67848503 10 877902";
    let (checked, _) = numeric(codes.replace(' ', "\n").as_bytes(), Board::UNO).unwrap();
    let ladder = Ladder::new(checked.program().steps());
    for (width, taken) in [(30, 44), (44, 44), (100, 100)] {
        let drawing = ladder.draw(&Style {
            width,
            names: &Names::new(),
            medium: Medium::Screen,
        });
        assert_eq!(drawing.width, taken);
        for rung in &drawing.rungs {
            let axis: String = rung.rows[rung.axis].iter().map(|cell| cell.ch).collect();
            assert!(axis.ends_with("─┤") && axis.contains("( Q"), "{axis}");
            assert!(rung.rows.iter().all(|row| row.len() == taken));
        }
    }
}
