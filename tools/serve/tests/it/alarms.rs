//! Alarms over HTTP: how they stand, who may acknowledge them, and what became of them.

use crate::common::{http, post, tokens};
use crate::site::{More, Site};
use serde_json::{Value, json};
use std::sync::Arc;
use tempfile::TempDir;
use unoclp_alarm::Alarms;
use unoclp_record::Record;
use unoclp_serve::Guard;
use unoclp_site::Files;

struct Folder;

impl Files for Folder {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String> {
        assert_eq!(name, "room.panel.toml");
        Ok(PANEL.into())
    }
}

const ALARMS: &str = "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"one\"\n\
    [[alarm]]\nname = \"full\"\nwhen = \"one.A0 > 900\"\nseverity = \"high\"\n\
    text = { en = \"the tank is full\", pt = \"o tanque está cheio\" }\n\
    [[alarm]]\nname = \"empty\"\nwhen = \"one.A0 < 5\"\ntext = \"empty\"\n\
    [[panel]]\nfile = \"room.panel.toml\"\n";
const PANEL: &str = "[[item]]\nshow = \"switch\"\npoint = \"one.Q1\"\n\
    [[item]]\nshow = \"set\"\npoint = \"one.Q2\"\nmost = 0.5\n\
    [[item]]\nshow = \"lamp\"\npoint = \"one.Q3\"\nat = [1, 2]\n";

/// A site of two alarms and a panel, and the folder of its record.
pub fn site(guard: Option<Guard>) -> (Site, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let record = Record::begin(
        &folder.path().join("site.record"),
        u64::MAX,
        Box::new(|_| ()),
    );
    let record = Arc::new(record.unwrap());
    let read = unoclp_site::read(ALARMS, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    let alarms = Alarms::begin(read.alarms, record.clone(), Box::new(|_, _| ())).unwrap();
    let more = More {
        guard,
        alarms: Some(Arc::new(alarms)),
        record: Some(record),
        panels: read.panels,
    };
    (Site::with(Vec::new(), more), folder)
}

/// Status and body of an answer.
pub fn of(answer: &str) -> (u16, Value) {
    let (head, body) = answer.split_once("\r\n\r\n").unwrap();
    let status = head.split(' ').nth(1).unwrap().parse().unwrap();
    (status, serde_json::from_str(body).unwrap_or(Value::Null))
}

fn get(site: &Site, path: &str) -> (u16, Value) {
    of(&http(site.page, path, &format!("Host: {}\r\n", site.page)))
}

fn acknowledge(site: &Site, more: &str, body: &str) -> (u16, Value) {
    let head = format!("Host: {}\r\n{more}", site.page);
    of(&post(site.page, "/api/alarms/acknowledge", &head, body))
}

/// The level of the tank is this, and alarms have been judged.
fn level(site: &Site, value: f64) {
    let alarms = site.alarms.as_ref().unwrap();
    alarms.changed(vec![unoclp_alarm::Value {
        board: "one".into(),
        point: "A0".into(),
        value: Some(value),
    }]);
    // It has been heard once this is answered.
    assert!(alarms.acknowledge("nobody", "").is_err());
}

#[test]
fn an_alarm_is_seen_acknowledged_and_remembered() {
    let (site, _folder) = site(None);
    assert_eq!(get(&site, "/api/alarms").1[0]["state"], "normal");
    assert_eq!(
        acknowledge(&site, "", r#"{"alarm":"full"}"#),
        (409, json!({ "why": "nothing to acknowledge" }))
    );
    level(&site, 901.0);
    let (status, alarms) = get(&site, "/api/alarms");
    assert_eq!(status, 200);
    let full = &alarms[0];
    assert_eq!(
        (&full["name"], &full["state"], &full["severity"]),
        (&json!("full"), &json!("active"), &json!("high"))
    );
    assert_eq!(full["text"]["pt"], "o tanque está cheio");
    assert!(full["since"].as_i64().is_some_and(|since| since > 0));
    assert_eq!(alarms[1]["since"], Value::Null);
    let metrics = http(site.page, "/metrics", &format!("Host: {}\r\n", site.page));
    for line in [
        "unoclp_alarm_active{alarm=\"full\",severity=\"high\"} 1",
        "unoclp_alarm_unacknowledged{alarm=\"full\",severity=\"high\"} 1",
        "unoclp_alarm_active{alarm=\"empty\",severity=\"medium\"} 0",
    ] {
        assert!(metrics.lines().any(|of| of == line), "{line}\n{metrics}");
    }
    assert_eq!(
        acknowledge(&site, "", r#"{"alarm":"full"}"#),
        (200, json!({ "state": "acknowledged" }))
    );
    assert_eq!(get(&site, "/api/alarms").1[0]["who"], "$local");
    level(&site, 900.0);
    site.record.as_ref().unwrap().end();
    let (_, past) = get(&site, "/api/alarms/history");
    let past = past.as_array().unwrap();
    let told: Vec<_> = past
        .iter()
        .map(|of| [&of["change"], &of["state"], &of["who"]].map(|of| of.as_str().unwrap_or("")))
        .collect();
    assert_eq!(
        told,
        [
            ["came", "active", ""],
            ["acknowledged", "acknowledged", "$local"],
            ["gone", "normal", ""],
        ]
    );
    let (_, last) = get(&site, "/api/alarms/history?last=1h&most=1");
    assert_eq!(last.as_array().unwrap().len(), 1);
    let (_, deeds) = get(&site, "/api/deeds");
    assert_eq!(
        (&deeds[0]["who"], &deeds[0]["what"], &deeds[0]["of"]),
        (&json!("$local"), &json!("acknowledge"), &json!("full"))
    );
    let host = format!("Host: {}\r\n", site.page);
    let csv = http(site.page, "/api/alarms/history.csv", &host);
    assert!(csv.contains("filename=\"alarms.csv\""), "{csv}");
    assert!(
        csv.contains(",full,acknowledged,acknowledged,$local\n"),
        "{csv}"
    );
    let csv = http(site.page, "/api/deeds.csv", &host);
    assert!(
        csv.contains(",$local,127.0.0.1,full,acknowledge,\n"),
        "{csv}"
    );
}

#[test]
fn what_acknowledges_nothing_is_refused_with_a_word() {
    let (site, _folder) = site(None);
    level(&site, 901.0);
    let long = format!(r#"{{"alarm":"{}"}}"#, "x".repeat(2_000));
    for (body, status, why) in [
        ("", 400, "no value"),
        ("full", 400, "no value"),
        ("{}", 400, "no value"),
        (r#"{"alarm":5}"#, 400, "no value"),
        (&long, 400, "no value"),
        (r#"{"alarm":"low"}"#, 404, "no alarm"),
        (r#"{"alarm":"empty"}"#, 409, "nothing to acknowledge"),
    ] {
        let told = acknowledge(&site, "", body);
        assert_eq!(told, (status, json!({ "why": why })), "{body}");
    }
    for query in ["from=yesterday", "to=1e9", "last=5", "from=%FF"] {
        let told = get(&site, &format!("/api/alarms/history?{query}"));
        assert_eq!(told, (400, json!({ "why": "no time" })), "{query}");
    }
    let told = get(&site, "/api/deeds?most=0");
    assert_eq!(told, (400, json!({ "why": "no number" })));
    // A page of another host acknowledges nothing through somebody's browser.
    let foreign = acknowledge(
        &site,
        "Origin: http://evil.example\r\n",
        r#"{"alarm":"full"}"#,
    );
    assert_eq!(foreign.0, 403);
    assert_eq!(get(&site, "/api/alarms").1[0]["state"], "active");
    let none = Site::new(Vec::new());
    assert_eq!(get(&none, "/api/alarms"), (200, json!([])));
    for path in ["/api/alarms/history", "/api/deeds", "/api/deeds.csv"] {
        assert_eq!(get(&none, path), (404, json!({ "why": "no record" })));
    }
    let told = acknowledge(&none, "", r#"{"alarm":"full"}"#);
    assert_eq!(told, (404, json!({ "why": "no alarm" })));
}

#[test]
fn whoever_watches_acknowledges_nothing() {
    let (site, _folder) = site(Some(Guard::Tokens(tokens())));
    level(&site, 901.0);
    let with = |token: &str| {
        let head = format!("Authorization: Bearer {token}\r\n");
        acknowledge(&site, &head, r#"{"alarm":"full"}"#)
    };
    assert_eq!(with("x").0, 401);
    assert_eq!(
        with(&tokens().watch),
        (403, json!({ "why": "not allowed" }))
    );
    assert_eq!(with(&tokens().control).0, 200);
}
