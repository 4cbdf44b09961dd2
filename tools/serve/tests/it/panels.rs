//! Panels over HTTP: what stands on them, and who may set what.

use crate::alarms::{of, site};
use crate::common::{Visitor, http, post};
use crate::site::Site;
use crate::users::users;
use serde_json::{Value, json};
use unoclp_modbus::client::Request;

fn set(site: &Site, token: &str, body: &Value) -> (u16, Value) {
    let head = format!("Host: {}\r\nAuthorization: Bearer {token}\r\n", site.page);
    of(&post(site.page, "/api/write", &head, &body.to_string()))
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
    let last = deeds.as_array().unwrap().first().unwrap();
    let told = ["who", "of", "what", "detail"].map(|key| last[key].as_str().unwrap());
    assert_eq!(told, ["eva", "one", "write", "Q1 = 1"]);
}
