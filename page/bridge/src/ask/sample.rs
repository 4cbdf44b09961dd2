//! Asks that are made at random of the table, so that each new one is asked from its birth: what is right is answered,
//! and what is not quite right is told.

use super::{First, More, Row, WORDS};
use crate::board::orders;
use crate::edit::acts;
use crate::given::Given;
use crate::{Boards, answer};
use serde_json::{Map, Value, json};
use std::path::Path;
use std::{env, fs};
use unoclp_core::Board;
use unoclp_testing::{Random, rounds};

const MOTOR: &str = include_str!("../../../../programs/plants/motor.toml");
const FIND: &str = include_str!("../../../../programs/exercises/find/01-motor.toml");
const EXERCISE: &str = include_str!("../../../../programs/exercises/01-contacts.toml");
const CHART: &str = include_str!("../../../../programs/charts/filling.st");
const PROJECT: &str = include_str!("../../../web/test/page/plc.xml");
const HEX: &str = include_str!("../../../../firmware/unoclp-uno.hex");

/// A page that asks.
struct Page {
    boards: Boards,
    random: Random,
    board: Value,
    now: u32,
    /// All that was asked.
    asked: Vec<String>,
}

impl Page {
    fn new(seed: u64) -> Page {
        let mut page = Page {
            boards: Boards::default(),
            random: Random(seed),
            board: Value::Null,
            now: 0,
            asked: Vec::new(),
        };
        page.board = page.ok(&json!({ "ask": "open", "core": true, "reset": false }));
        page
    }

    fn told(&mut self, request: &Value) -> Value {
        let request = request.to_string();
        let told = answer(request.as_bytes(), &mut self.boards);
        self.asked.push(request);
        serde_json::from_str(&told).expect("JSON")
    }

    fn ok(&mut self, request: &Value) -> Value {
        let told = self.told(request);
        assert!(told.get("ok").is_some(), "{request}: {told}");
        told["ok"].clone()
    }

    fn any(&mut self, values: &[Value]) -> Value {
        values[self.random.below(values.len())].clone()
    }

    /// The name of a program, and its text: a few rungs.
    fn program(&mut self) -> (&'static str, String) {
        let rungs = 1 + self.random.below(4);
        let mut point = |most| 1 + self.random.below(most);
        let rungs: Vec<[usize; 3]> = (0..rungs).map(|_| [point(8), point(8), point(4)]).collect();
        let list = |[a, b, q]: &[usize; 3]| format!("LD I{a}\nANDN I{b}\nST Q{q}\n");
        let structured = |[a, b, q]: &[usize; 3]| {
            format!("%QX0.{} := %IX0.{} AND NOT %IX0.{};\n", q - 1, a - 1, b - 1)
        };
        match self.random.below(2) {
            0 => ("a.il", rungs.iter().map(list).collect()),
            _ => {
                let body: String = rungs.iter().map(structured).collect();
                ("a.st", format!("PROGRAM p\n{body}END_PROGRAM\n"))
            }
        }
    }

    /// What has to be there before this is asked.
    fn prepare(&mut self, ask: &str) {
        match ask {
            "edit" | "drawn" | "find" => {
                let (base, width) = (json!({ "name": "a.il", "text": "LD I1\nST Q1\n" }), 80);
                self.ok(&json!({ "ask": "draw", "base": base, "log": [], "width": width }));
            }
            "step" | "order" | "lose" | "close" => {
                self.board = self.ok(&json!({ "ask": "open", "core": true, "reset": false }));
            }
            "slowly" => {
                self.board = self.ok(&json!({ "ask": "open", "core": true, "reset": false }));
                let text = json!({ "ask": "text", "name": "a.il", "text": "LD I1\nST Q1\n" });
                let version = self.ok(&text);
                let order = json!({ "do": "upload", "version": version });
                self.ok(&json!({ "ask": "order", "board": self.board, "order": order }));
                self.ok(&json!({ "ask": "step", "board": self.board, "now": 0, "came": [] }));
            }
            "machine" => {}
            _ if ask.starts_with("machine") => {
                self.ok(
                    &json!({ "ask": "machine", "name": "m.toml", "text": MOTOR, "find": FIND }),
                );
            }
            _ => {}
        }
    }

    /// What may stand there; none where it is left out.
    fn value(&mut self, ask: &str, key: &str, of: &str) -> Option<Value> {
        if of.ends_with('?') && ask != "alter" && self.random.below(2) == 0 {
            return None;
        }
        let program = self.program();
        Some(match (ask, key) {
            ("machine" | "picture", "text") | (_, "plantText") => json!(MOTOR),
            ("machine" | "picture", "name") | (_, "plant") => json!("motor.toml"),
            ("read", "name") => json!("STATE.TXT"),
            (_, "name") => json!(program.0),
            // A name that is there, and another.
            ("rename", "version") => {
                let text = "PROGRAM p\nVAR a AT %QX1 : BOOL; END_VAR\na := %IX1;\nEND_PROGRAM\n";
                self.ok(&json!({ "ask": "text", "name": "a.st", "text": text }))
            }
            ("rename", "at") => json!(14),
            ("rename", "to") => json!("motor"),
            ("chart", "chart") => json!(0),
            ("chart", "at") => self.any(&["s0", "s1", "t0", "j1.0"].map(Value::from)),
            ("chart", "what") => return None,
            ("chart", "version") => {
                let text = json!({ "ask": "text", "name": "c.st", "text": CHART });
                self.ok(&text)
            }
            ("project" | "unit" | "alter", "version") => {
                let text = json!({ "ask": "text", "name": "plc.xml", "text": PROJECT });
                self.ok(&text)
            }
            ("unit" | "alter", "unit") => json!("Main"),
            ("alter", "what") => self.any(&["name", "kind", "place", "comment"].map(Value::from)),
            ("alter", "at") => json!("start"),
            (_, "version") => {
                let text = json!({ "ask": "text", "name": program.0, "text": program.1 });
                self.ok(&text)
            }
            ("step" | "order" | "lose" | "close", "board") => self.board.clone(),
            ("board", "board") => self.any(&[json!("uno"), json!("nano"), json!("pc")]),
            ("slowly", "board") => self.board.clone(),
            (_, "board") => self.any(&[json!("uno"), json!("nano")]),
            (_, "base") => json!({ "name": "a.il", "text": "LD I1\nST Q1\n" }),
            (_, "log") => json!([{ "do": "insert", "what": "contact", "place": "behind" }]),
            (_, "point") => json!("D1"),
            (_, "number") => json!(1 + self.random.below(8)),
            ("comment" | "title", "text") => json!("pump\nof a well"),
            ("text", "text") => json!(program.1),
            (_, "act") => self.act(),
            (_, "order") => self.order(),
            (_, "blocks") => json!([[0, "00ff"], [7, ""]]),
            (_, "hex") => json!(HEX),
            (_, "model") => json!("uno"),
            (_, "program") => json!("0\n827301\n877901\n"),
            (_, "find") => json!(FIND),
            (_, "scenario") => json!(EXERCISE),
            (_, "fault") => json!("welded"),
            (_, "now") => {
                self.now += 20;
                json!(self.now)
            }
            ("slowly", "to") => self.any(&[json!([0, 2]), Value::Null]),
            (_, "left") => json!([[0, 1, true, 7, 3, 16], [2, 2, false, null, null, null]]),
            (_, "came") => json!([]),
            (_, "address") => json!(1 + self.random.below(247)),
            (_, "rate") => json!(115_200),
            (_, "parity") => json!(self.random.below(3)),
            _ => match of.trim_end_matches('?') {
                "string" => json!("x"),
                "number" => json!(self.random.below(200)),
                "boolean" => json!(self.random.below(2) == 0),
                "boolean | null" => self.any(&[json!(true), json!(false), Value::Null]),
                "Edge | null" => self.any(&[json!("rising"), Value::Null]),
                "Speak" => self.any(&[json!("en"), json!("pt")]),
                "Settings" => {
                    json!({ "address": 1, "rate": 9600, "parity": 0, "direction": false, "lock": null })
                }
                list if list.starts_with("readonly {") => {
                    json!([{ "key": "point", "value": "I1" }])
                }
                word if WORDS.iter().any(|(name, _)| *name == word) => {
                    let (_, words) = WORDS
                        .iter()
                        .find(|(name, _)| *name == word)
                        .expect("it is there");
                    json!(words[self.random.below(words.len())])
                }
                _ => panic!("nothing is known that could stand in {ask} {key}: {of}"),
            },
        })
    }

    /// Something that can be done to a drawing whatever it is.
    fn act(&mut self) -> Value {
        let (name, text) = ("a.il", "LD I2\nST Q2\n");
        self.any(&[
            Value::Null,
            json!({ "do": "move", "to": "right" }),
            json!({ "do": "out" }),
            json!({ "do": "insert", "what": "contact", "place": "before" }),
            json!({ "do": "insertRung", "along": "forth" }),
            json!({ "do": "comment", "text": "pump" }),
            json!({ "do": "title", "text": "pumps\nof a well" }),
            json!({ "do": "name", "point": "I1", "name": "start", "comment": "green" }),
            json!({ "do": "text", "name": name, "text": text }),
        ])
    }

    /// One of several that are told by a word, which is right.
    fn one_of(&mut self, row: &Row) -> Value {
        let mut one = Map::new();
        one.insert("do".to_owned(), row.ask.into());
        for (key, of) in &row.fields {
            if let Some(value) = self.value(row.ask, key, of) {
                one.insert((*key).to_owned(), value);
            }
        }
        Value::Object(one)
    }

    fn order(&mut self) -> Value {
        let rows = orders::declared().rows;
        let at = self.random.below(rows.len());
        self.one_of(&rows[at])
    }

    /// An ask of this row that is right.
    fn sample(&mut self, row: &Row) -> Value {
        self.prepare(row.ask);
        let mut ask = Map::new();
        ask.insert("ask".to_owned(), row.ask.into());
        for (key, of) in &row.fields {
            if let Some(value) = self.value(row.ask, key, of) {
                ask.insert((*key).to_owned(), value);
            }
        }
        // What a text is called says its language.
        if row.ask == "text" {
            let (name, text) = self.program();
            ask.insert("name".to_owned(), name.into());
            ask.insert("text".to_owned(), text.into());
        }
        Value::Object(ask)
    }
}

fn rows() -> Vec<Row> {
    First::rows().into_iter().chain(More::rows()).collect()
}

/// What a drawing does with it depends on where its cursor is; what is asked is understood anywhere.
#[test]
fn each_act_and_each_order_that_is_right_is_read() {
    let mut page = Page::new(19);
    for _ in 0..rounds(20) {
        for row in &acts::declared().rows {
            let act = page.one_of(row);
            let mut given = Given::of(act.clone()).expect("an object");
            let read = acts::read(&mut given, Board::UNO);
            assert!(read.is_ok(), "{act}: {:?}", read.err());
        }
        for row in &orders::declared().rows {
            let order = page.one_of(row);
            let mut given = Given::of(order.clone()).expect("an object");
            let read = orders::read(&mut given, &mut page.boards.workspace);
            assert!(read.is_ok(), "{order}: {:?}", read.err());
        }
    }
}

#[test]
fn each_ask_that_is_right_is_answered() {
    let mut page = Page::new(17);
    let rows = rows();
    for _ in 0..rounds(60) {
        for row in &rows {
            let ask = page.sample(row);
            page.ok(&ask);
        }
    }
}

/// Something of it is another thing, or missing.
fn changed(ask: &mut Value, random: &mut Random) {
    let odd = [
        Value::Null,
        json!(true),
        json!(-1),
        json!(1e300),
        json!(u64::MAX),
        json!("é😀"),
        json!([[0, "zz"], 7]),
        json!({}),
    ];
    match ask {
        Value::Object(values) if !values.is_empty() && random.below(8) > 0 => {
            let key = values.keys().nth(random.below(values.len())).cloned();
            let key = key.expect("one of those that are there");
            match random.below(4) {
                0 => drop(values.remove(&key)),
                _ => changed(&mut values[&key], random),
            }
        }
        Value::Array(values) if !values.is_empty() && random.below(4) > 0 => {
            let at = random.below(values.len());
            changed(&mut values[at], random);
        }
        value => *value = odd[random.below(odd.len())].clone(),
    }
}

#[test]
fn an_ask_that_is_not_quite_right_is_told() {
    let mut page = Page::new(18);
    let rows = rows();
    for _ in 0..rounds(20) {
        for row in &rows {
            let mut ask = page.sample(row);
            for _ in 0..=page.random.below(3) {
                changed(&mut ask, &mut page.random);
            }
            let told = page.told(&ask);
            let keys: Vec<&String> = told.as_object().expect("an object").keys().collect();
            assert!(
                matches!(keys[..], [key] if key == "ok" || key == "error"),
                "{ask}: {told}"
            );
        }
    }
}

/// The corpus of the fuzz target `asks` begins with pages that ask for each thing once. This test writes it with UPDATE=1.
#[test]
fn the_corpus_of_the_fuzz_target_has_each_ask() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../proof/fuzz/corpus/asks");
    let rows = rows();
    if env::var_os("UPDATE").is_some() {
        fs::create_dir_all(&folder).unwrap();
        for (number, row) in rows.iter().enumerate() {
            let mut page = Page::new(number as u64);
            let ask = page.sample(row);
            page.ok(&ask);
            let short = page.asked.iter().filter(|ask| !ask.contains(":100000"));
            let asked: Vec<&str> = short.map(String::as_str).collect();
            fs::write(folder.join(row.ask), asked.join("\n")).unwrap();
        }
    }
    for row in &rows {
        let seed = fs::read_to_string(folder.join(row.ask));
        let seed = seed.unwrap_or_else(|_| panic!("{}: UPDATE=1 writes it", row.ask));
        let mut boards = Boards::default();
        let mut last = Value::Null;
        for ask in seed.lines() {
            last = serde_json::from_str(ask).unwrap_or_else(|why| panic!("{}: {why}", row.ask));
            let told: Value = serde_json::from_str(&answer(ask.as_bytes(), &mut boards)).unwrap();
            assert!(
                told.get("ok").is_some(),
                "{}: UPDATE=1 writes it again: {told}",
                row.ask
            );
        }
        // What comes before it makes a page that can ask for this.
        assert_eq!(last["ask"], row.ask);
    }
}
