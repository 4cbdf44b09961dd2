//! Panels over HTTP: what is on them, and who may set what.

use crate::alarms::{of, site};
use crate::common::{Visitor, http, post};
use crate::site::Site;
use crate::users::users;
use serde_json::{Value, json};
use std::time::Instant;
use unoclp_modbus::client::Request;

fn set(site: &Site, token: &str, body: &Value) -> (u16, Value) {
    let head = format!("Host: {}\r\nAuthorization: Bearer {token}\r\n", site.page);
    of(&post(site.page, "/api/write", &head, &body.to_string()))
}

/// What a deed of the record says.
fn told(deed: &Value) -> [&str; 4] {
    ["who", "of", "what", "detail"].map(|key| deed[key].as_str().unwrap())
}

#[test]
fn what_a_panel_has_is_set_by_who_operates_and_recorded() {
    let (guard, [ana, eva, _]) = users();
    let (site, _folder) = site(Some(guard));
    let get = |path, token: &str| {
        let head = format!("Host: {}\r\nAuthorization: Bearer {token}\r\n", site.page);
        of(&http(site.page, path, &head))
    };
    assert_eq!(
        get("/api/who", &ana).1,
        json!({ "name": "ana", "may": "watch" })
    );
    let (_, panels) = get("/api/panels", &ana);
    assert_eq!(
        (&panels[0]["name"], &panels[0]["made"]),
        (&json!("room"), &json!(false))
    );
    assert_eq!(panels[0]["items"][2]["at"], json!([1, 2]));
    assert_eq!(
        (&panels[1]["name"], &panels[1]["made"]),
        (&json!("one"), &json!(true))
    );
    let value =
        |point: &str, value: Value| json!({ "board": "one", "point": point, "value": value });
    let taken = json!({ "value": 1.0 });
    assert_eq!(set(&site, &eva, &value("Q1", json!(1))), (200, taken));
    assert_eq!(site.ask(1, &[1, 0, 0, 0, 4]), [1, 1, 0b0001]);
    for (token, body, status, why) in [
        (&ana, value("Q1", json!(0)), 403, "not allowed"),
        (&eva, value("Q1", json!(2)), 400, "no value"),
        (&eva, value("Q1", json!("1")), 400, "no value"),
        (&eva, value("Q2", json!(1)), 400, "no value"),
        (&eva, value("Q2", json!(0.5)), 400, "no value"),
        (&eva, value("Q3", json!(1)), 404, "not on a panel"),
        (&eva, value("M1", json!(1)), 404, "not on a panel"),
        (
            &eva,
            json!({ "board": "two", "point": "Q1", "value": 1 }),
            404,
            "not on a panel",
        ),
        (&eva, json!({ "board": "x".repeat(2000) }), 400, "no value"),
    ] {
        assert_eq!(
            set(&site, token, &body),
            (status, json!({ "why": why })),
            "{body}"
        );
    }
    assert_eq!(site.ask(1, &[1, 0, 0, 0, 4]), [1, 1, 0b0001]);
    // A person at the board's own page goes before it.
    let (mut person, _) = Visitor::new_at(site.page, "/line/one", &eva);
    person.ask(&Request::write_word(3, 400, 2));
    let controlled = json!({ "why": "controlled" });
    assert_eq!(set(&site, &eva, &value("Q1", json!(0))), (409, controlled));
    drop(person);
    while set(&site, &eva, &value("Q1", json!(0))).0 == 409 {}
    site.boards.unplug(true);
    while set(&site, &eva, &value("Q1", json!(1))).0 == 200 {}
    let away = json!({ "why": "away" });
    assert_eq!(set(&site, &eva, &value("Q1", json!(1))), (503, away));
    let (_, deeds) = get("/api/deeds", &ana);
    assert_eq!(told(&deeds[0]), ["eva", "one", "write", "Q1 = 1"]);
}

#[test]
fn a_button_is_let_go_once_whoever_presses_it_is_not_heard_any_more() {
    let (guard, [_, eva, _]) = users();
    let (site, _folder) = site(Some(guard));
    let hold = |hold: &str| {
        let body = json!({ "board": "one", "point": "Q1", "value": 1, "hold": hold });
        set(&site, &eva, &body)
    };
    let is_on = || site.ask(1, &[1, 0, 0, 0, 1]) == [1, 1, 1];
    let not_held = (409, json!({ "why": "not held" }));
    assert_eq!(hold("still"), not_held);
    assert!(!is_on());
    let taken = (200, json!({ "value": 1.0 }));
    assert_eq!(hold("begin"), taken);
    // It is heard for longer than it is held without a word.
    let begun = Instant::now();
    while begun.elapsed().as_secs() < 4 {
        assert_eq!(hold("still"), taken);
        assert!(is_on());
    }
    // Whoever lets go as it should leaves nothing behind.
    let release = json!({ "board": "one", "point": "Q1", "value": 0 });
    assert_eq!(set(&site, &eva, &release).0, 200);
    assert_eq!((hold("still"), is_on()), (not_held.clone(), false));
    // Whoever is gone is let go, though the board is away when it is time.
    assert_eq!(hold("begin"), taken);
    site.boards.unplug(true);
    let gone = Instant::now();
    while gone.elapsed().as_secs() < 4 {
        assert_eq!(site.boards.board(3).outputs, 1);
    }
    assert_eq!(hold("still"), not_held);
    site.boards.unplug(false);
    while site.boards.board(3).outputs != 0 {}
    let head = format!("Host: {}\r\nAuthorization: Bearer {eva}\r\n", site.page);
    loop {
        let (_, deeds) = of(&http(site.page, "/api/deeds", &head));
        let last = deeds.as_array().unwrap().last().unwrap();
        if told(last) == ["eva", "one", "release", "Q1 = 0"] {
            break;
        }
    }
}
