//! A program that this computer runs for a page, on the core: without a line, by the page's clock.

#![cfg(feature = "full")]

mod asked;

use asked::told;
use serde_json::{Value, json};
use unoclp_bridge::Boards;
use unoclp_core::{Board, Inputs, Point};
use unoclp_host_sim::engine::{Engine, HostEngine};
use unoclp_host_sim::random::{Random, random_inputs_on, random_program_on};
use unoclp_testing::{held, rounds};

/// A page with such a board, at a time in ms.
struct Page {
    boards: Boards,
    board: Value,
    now: u64,
}

impl Page {
    fn new(board: &str) -> Page {
        let mut page = Page {
            boards: Boards::default(),
            board: Value::Null,
            now: 0,
        };
        let open =
            json!({ "ask": "open", "core": true, "board": board, "program": null, "reset": false });
        page.board = page.ok(open);
        page.after(0);
        page
    }

    fn ok(&mut self, request: Value) -> Value {
        let told = told(&mut self.boards, request);
        assert!(told.get("ok").is_some(), "{told}");
        told["ok"].clone()
    }

    /// What is seen so many ms later, and the news before it.
    fn after(&mut self, ms: u64) -> (Value, Vec<Value>) {
        self.now += ms;
        let step = json!({ "ask": "step", "board": self.board, "now": self.now, "came": [] });
        let step = self.ok(step);
        assert_eq!(step["send"], json!([]));
        let mut news = step["news"].as_array().unwrap().clone();
        (news.pop().unwrap(), news)
    }

    /// Has something done; gives what there is to say of it, and what is seen then. What is refused at once is undone too.
    fn order(&mut self, order: Value) -> (Value, Value) {
        let request = json!({ "ask": "order", "board": self.board, "order": order });
        let told = told(&mut self.boards, request);
        let (seen, news) = self.after(0);
        if let Some(why) = told.get("error") {
            return (json!({ "news": "undone", "why": why }), seen);
        }
        let number = told["ok"].clone();
        let told = news.iter().find(|news| news["order"] == number).unwrap();
        (told.clone(), seen)
    }

    fn upload(&mut self, name: &str, text: &str, board: &str) -> Value {
        self.order(json!({ "do": "upload", "name": name, "text": text, "board": board }))
            .0
    }
}

const WIDE: &str = "LD I99\nST Q65\nLD I12\nTON T1, 100\nST Q99\nLD IW17\nST D98\n";

#[test]
fn points_that_no_board_has_are_pressed_and_seen() {
    let mut page = Page::new("pc");
    let (seen, _) = page.after(5);
    assert_eq!(
        (&seen["state"], &seen["same"]),
        (&json!("EMPTY"), &json!(null))
    );
    assert_eq!(page.upload("wide.il", WIDE, "pc")["news"], "done");
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["state"], &seen["outputs"]),
        (&json!("RUN"), &json!([]))
    );
    page.order(json!({ "do": "press", "input": 99, "closed": true }));
    page.order(json!({ "do": "press", "input": 12, "closed": true }));
    page.order(json!({ "do": "turn", "input": 17, "reading": 700 }));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["inputs"], &seen["outputs"]),
        (&json!([12, 99]), &json!([65]))
    );
    assert_eq!(
        (&seen["registers"][97], &seen["analogue"][17]),
        (&json!(700), &json!(700))
    );
    // The delay ends by the page's clock, not by the number of its steps.
    let (seen, _) = page.after(99);
    assert_eq!(seen["outputs"], json!([65]));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["outputs"], &seen["timers"]),
        (&json!([65, 99]), &json!([[100, 100]]))
    );
    assert!(
        seen["live"]["lines"]
            .as_array()
            .is_some_and(|lines| !lines.is_empty()),
        "{seen}"
    );
}

#[test]
fn points_are_forced_and_set() {
    let mut page = Page::new("pc");
    page.upload("wide.il", WIDE, "pc");
    let force = |output: bool, number: u8, to: Value| json!({ "do": "force", "output": output, "number": number, "to": to });
    page.order(force(false, 99, json!(true)));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["outputs"], &seen["forcedInputs"]),
        (&json!([65]), &json!([[99, true]]))
    );
    page.order(force(true, 65, json!(false)));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["outputs"], &seen["forcedOutputs"]),
        (&json!([]), &json!([[65, false]]))
    );
    page.order(json!({ "do": "release" }));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["outputs"], &seen["forcedInputs"]),
        (&json!([]), &json!([]))
    );
    for (point, value) in [("M99", 1), ("D5", -7), ("T1", 20)] {
        let (told, _) = page.order(json!({ "do": "set", "point": point, "value": value }));
        assert_eq!(told["news"], "done", "{point}: {told}");
    }
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["markers"], &seen["registers"][4]),
        (&json!([99]), &json!(-7))
    );
    assert_eq!(seen["timers"], json!([[0, 20]]));
    for point in ["I1", "T2", "D99", "M100", "C1", "x"] {
        let (told, _) = page.order(json!({ "do": "set", "point": point, "value": 1 }));
        assert_eq!(told["news"], "undone", "{point}: {told}");
    }
    for number in [0, 100] {
        assert_eq!(
            page.order(force(false, number, json!(true))).0["news"],
            "undone"
        );
    }
}

#[test]
fn it_stops_scans_once_and_begins_anew() {
    let mut page = Page::new("pc");
    page.upload("count.il", "LDN M1\nST M1\nLD D1\nADD 1\nST D1\n", "pc");
    let (seen, _) = page.after(10);
    assert_eq!(seen["registers"][0], 10);
    let (_, seen) = page.order(json!({ "do": "stop" }));
    assert_eq!(
        (&seen["state"], &seen["registers"][0]),
        (&json!("STOP"), &json!(0))
    );
    page.after(50);
    let (_, seen) = page.order(json!({ "do": "scan" }));
    assert_eq!(
        (&seen["state"], &seen["registers"][0]),
        (&json!("STOP"), &json!(1))
    );
    let (_, seen) = page.order(json!({ "do": "run" }));
    assert_eq!(
        (&seen["state"], &seen["registers"][0]),
        (&json!("RUN"), &json!(0))
    );
    // In RUN it stops, and goes on from where the program is.
    page.after(4);
    let (_, seen) = page.order(json!({ "do": "scan" }));
    assert_eq!(
        (&seen["state"], &seen["registers"][0]),
        (&json!("STOP"), &json!(5))
    );
    page.order(json!({ "do": "run" }));
    // A page that was away for long does not make up for all of it.
    let (seen, _) = page.after(60_000);
    assert_eq!(seen["registers"][0], 250);
}

#[test]
fn a_fault_stops_it_with_its_line() {
    let mut page = Page::new("pc");
    page.upload("loop.il", "LD I1\nST Q1\nagain: LD I1\nJMPC again\n", "pc");
    page.order(json!({ "do": "press", "input": 1, "closed": true }));
    let (seen, _) = page.after(1);
    assert_eq!(
        (&seen["state"], &seen["outputs"]),
        (&json!("FAULT"), &json!([])),
        "{seen}"
    );
    assert_eq!(seen["fault"]["line"], 4, "{seen}");
}

#[test]
fn what_needs_a_program_or_a_board_is_refused() {
    let mut page = Page::new("pc");
    for order in [
        json!({ "do": "run" }),
        json!({ "do": "scan" }),
        json!({ "do": "set", "point": "M1", "value": 1 }),
        json!({ "do": "settings" }),
        json!({ "do": "upload", "name": "a.il", "text": "LDD I1", "board": "pc" }),
    ] {
        let (told, seen) = page.order(order);
        assert_eq!(
            (&told["news"], &seen["state"]),
            (&json!("undone"), &json!("EMPTY")),
            "{told}"
        );
        assert!(
            told["why"]["pt"]
                .as_str()
                .is_some_and(|why| !why.is_empty()),
            "{told}"
        );
    }
}

/// What a page shows is what a scenario sees: the same core, scan by scan.
#[test]
fn it_does_what_the_core_does() {
    let run = |seed: u32| {
        let mut random = Random::new(seed.into());
        let code = random_program_on(&mut random, Board::PC);
        let mut page = Page::new("pc");
        page.upload("P.TXT", &code, "pc");
        let mut engine = HostEngine::new(Board::PC);
        assert!(engine.load(code.as_bytes()).unwrap().is_ok(), "{code}");
        let needs = engine.machine().unwrap().plc().needs();
        let mut inputs = Inputs::default();
        for now in 1..60 {
            let before = inputs;
            inputs = random_inputs_on(&mut random, (needs, Board::PC), before);
            // Of its own time a page tells nothing.
            inputs.scan_time = 0;
            for input in 1..=99 {
                let point = Point::new(input, 99).unwrap();
                let closed = inputs.points.get(point);
                if closed != before.points.get(point) {
                    page.order(json!({ "do": "press", "input": input, "closed": closed }));
                }
            }
            let readings = inputs.analogue.iter().zip(before.analogue);
            for (input, (&reading, before)) in readings.enumerate() {
                if reading != before {
                    page.order(json!({ "do": "turn", "input": input, "reading": reading }));
                }
            }
            let (seen, _) = page.after(1);
            let Ok(outputs) = engine.scan(&inputs, now).unwrap() else {
                assert_eq!(seen["state"], "FAULT", "{now}: {code}");
                break;
            };
            let on = |bits: u128| {
                (1..=99)
                    .filter(|n| bits >> (n - 1) & 1 != 0)
                    .collect::<Vec<u8>>()
            };
            assert_eq!(seen["outputs"], json!(on(outputs.0)), "{now}: {code}");
            let plc = engine.machine().unwrap().plc();
            assert_eq!(seen["markers"], json!(on(plc.markers())), "{now}: {code}");
            assert_eq!(
                seen["registers"],
                json!(plc.registers()[..]),
                "{now}: {code}"
            );
        }
    };
    (0..rounds(40)).for_each(|seed| held(|| run(seed)));
}
