//! Panels: those of files, those that boards have without one, and every kind of mistake in a file.

use unoclp_program::Lang;
use unoclp_site::{Does, Files, Look, Site, plan, read};

const TANK: &str = "PROGRAM tank VAR level AT %IW0 : INT; valve AT %QX0.0 : BOOL; target : DINT; END_VAR\n\
    valve := level > target; END_PROGRAM\n";
const SITE: &str = "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"x\"\nprogram = \"tank.st\"\n\
    [[line.board]]\nname = \"y\"\naddress = 2\nunit = 2\n[[panel]]\nfile = \"room/tank.panel.toml\"\n";

/// A folder with a panel in it.
struct Folder<'p>(&'p str);

impl Files for Folder<'_> {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String> {
        match name {
            "tank.st" => Ok(TANK.into()),
            "room/tank.panel.toml" => Ok(self.0.into()),
            "tank.svg" => {
                Ok("<svg xmlns=\"http://www.w3.org/2000/svg\"><rect id=\"tank\"/></svg>".into())
            }
            _ => Err("no such file".into()),
        }
    }
}

fn site(panel: &str) -> Site {
    read(SITE, &Folder(panel)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{panel}"))
}

/// What is told of a panel, without what stands before the line of its file.
fn told(panel: &str) -> Vec<String> {
    let wrong = read(SITE, &Folder(panel)).expect_err(panel);
    let text = wrong.iter().map(|wrong| {
        assert_ne!(wrong.reason(Lang::En), wrong.reason(Lang::Pt));
        wrong.reason(Lang::En).replace("room/tank.panel.toml:", "")
    });
    text.collect()
}

#[test]
fn a_file_says_what_stands_where_and_how_it_is_written() {
    let panel = "title = { en = \"Tank\", pt = \"Tanque\" }\ncolumns = 3\ndrawing = \"tank.svg\"\n\
        [[item]]\nshow = \"bar\"\npoint = \"x.LEVEL\"\nunit = \"cm\"\nmost = 1023\nat = [2, 1]\n\
        [[item]]\nshow = \"set\"\npoint = \"x.target\"\nleast = -5\nmost = 7.5\nlabel = \"Alvo\"\n\
        [[bind]]\nid = \"tank\"\npoint = \"x.level\"\ndoes = \"level\"\nmost = 1023\n";
    let site = site(panel);
    let [tank, x, y] = &site.panels[..] else {
        panic!("{:?}", site.panels);
    };
    assert_eq!((&*tank.name, &*tank.title.pt), ("tank", "Tanque"));
    assert!(tank.drawing.as_ref().unwrap().contains("<rect"));
    let [bar, set] = &tank.items[..] else {
        panic!("{tank:?}");
    };
    assert_eq!(
        (bar.look, &*bar.point, &*bar.unit),
        (Look::Bar, "level", "cm")
    );
    assert_eq!(
        (bar.range, bar.at, &bar.grant),
        ([0.0, 1023.0], Some([2, 1]), &None)
    );
    assert_eq!((&*set.label.en, set.range), ("Alvo", [-5.0, 7.5]));
    let grant = set.grant.as_ref().unwrap();
    // The name holds while the board keeps the program that gives it.
    assert_eq!(grant.while_kept, site.lines[0].boards[0].points.program);
    assert_eq!((grant.unit, &*grant.name), (1, "x.target"));
    assert_eq!(tank.binds[0].does, Does::Level);
    // Boards have one of their names, which writes nothing.
    let points = |panel: &unoclp_site::Panel| -> Vec<String> {
        panel.items.iter().map(|item| item.point.clone()).collect()
    };
    assert_eq!(points(x), ["level", "target", "valve"]);
    assert_eq!(points(y).len(), 17);
    assert!(x.is_made && y.is_made && !tank.is_made);
    assert!(
        x.items
            .iter()
            .chain(&y.items)
            .all(|item| item.grant.is_none())
    );
    assert!(plan(&site, Lang::En).contains("panel tank (items: 3)\n"));
}

#[test]
fn each_mistake_is_told_with_its_line_in_the_file() {
    let item = |more: &str| format!("[[item]]\nshow = \"lamp\"\npoint = \"x.valve\"\n{more}\n");
    for (panel, says) in [
        ("[[item]\n".to_owned(), "1: this is not TOML"),
        (
            "colums = 4\n".into(),
            "1: there is no key `colums` here; known keys: `title`",
        ),
        (
            "columns = 13\n".into(),
            "1: `columns` is out of range; use a number from 1 to 12",
        ),
        (
            "title = { en = \"Tank\" }\n".into(),
            "1: the key `pt` is missing",
        ),
        (
            "drawing = \"gone.svg\"\n".into(),
            "1: gone.svg cannot be read",
        ),
        (
            "[[bind]]\nid = \"a\"\npoint = \"x.valve\"\ndoes = \"light\"\n".into(),
            "1: the key `drawing` is missing",
        ),
        (
            "[[item]]\npoint = \"x.valve\"\n".into(),
            "1: the key `show` is missing",
        ),
        (
            item("").replace("lamp", "lamps"),
            "2: `show` cannot be lamps; choose \"lamp\", \"value\"",
        ),
        (
            item("").replace("x.valve", "valve"),
            "3: valve names no point",
        ),
        (
            item("").replace("x.valve", "z.valve"),
            "3: there is no board z; known boards: x, y",
        ),
        (
            item("").replace("x.valve", "x.valves"),
            "3: x has no point valves to show; known points: level, target, valve",
        ),
        (
            item("")
                .replace("lamp", "set")
                .replace("x.valve", "x.level"),
            "3: level cannot be written; you can write target, valve",
        ),
        (
            item("at = [5, 1]"),
            "4: `at` is out of range; use a number from 1 to 4",
        ),
        (
            item("at = [1]"),
            "4: `at` takes a different kind of value; write `at = [1, 1]`",
        ),
        (
            item("least = 5\nmost = 5"),
            "5: `least` must be below `most`",
        ),
        (
            item("most = nan"),
            "4: `most` takes a different kind of value",
        ),
        (
            item("label = 7"),
            "4: `label` takes a different kind of value",
        ),
    ] {
        let told = told(&panel);
        assert_eq!(told.len(), 1, "{told:?}\n{panel}");
        assert!(told[0].starts_with(says), "{told:?}\n{panel}");
    }
}

#[test]
fn no_panel_brings_the_reader_down() {
    let whole =
        "columns = 3\n[[item]]\nshow = \"bar\"\npoint = \"x.level\"\nmost = 1e3\nat = [2, 1]\n";
    let right = (0..whole.len()).filter(|&end| read(SITE, &Folder(&whole[..end])).is_ok());
    assert!((1..whole.len()).contains(&right.count()));
}
