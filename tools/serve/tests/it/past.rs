//! What points were, asked over HTTP.

use crate::common::http;
use crate::site::Site;
use serde_json::{Value, json};

/// Status, head and body of an answer.
fn get(site: &Site, path: &str) -> (u16, String, String) {
    let answer = http(site.page, path, &format!("Host: {}\r\n", site.page));
    let (head, body) = answer.split_once("\r\n\r\n").unwrap();
    let status = head.split(' ').nth(1).unwrap().parse().unwrap();
    (status, head.to_lowercase(), body.to_owned())
}

fn asked(site: &Site, query: &str) -> (u16, Value) {
    let (status, _, body) = get(site, &format!("/api/history?{query}"));
    (status, serde_json::from_str(&body).unwrap())
}

#[test]
fn a_point_is_told_over_a_time_in_steps_and_in_parts() {
    let site = Site::new(Vec::new());
    let (status, told) = asked(&site, "board=one&point=count&from=3000&to=7000");
    assert_eq!(status, 200);
    let row = |at: i64, last: Value| {
        let value = at as f64 / 1_000.0;
        json!({ "at": at, "least": value, "most": value, "last": last })
    };
    let rows = [
        row(3_000, json!(3.0)),
        row(4_000, json!(4.0)),
        row(5_000, Value::Null),
        row(6_000, json!(6.0)),
    ];
    assert_eq!(
        told,
        json!({ "board": "one", "point": "count", "rows": rows, "more": false })
    );
    let (_, told) = asked(
        &site,
        "board=one&point=count&from=0&to=60000&step=10s&most=2",
    );
    assert_eq!(told["rows"].as_array().unwrap().len(), 2);
    assert_eq!(
        (&told["rows"][1]["most"], &told["more"]),
        (&json!(19.0), &json!(true))
    );
    // The last hour, where nothing else is said: nothing has come since 1970.
    let (status, told) = asked(&site, "board=one&point=count");
    assert_eq!((status, &told["rows"]), (200, &json!([])));
    let (_, told) = asked(&site, "board=one&point=count&to=5000&last=2s");
    assert_eq!(told["rows"][0]["at"], 3_000);
    let (status, head, body) = get(
        &site,
        "/api/history.csv?board=one&point=count&from=4000&to=6000",
    );
    assert_eq!(status, 200);
    assert!(head.contains("content-type: text/csv"), "{head}");
    assert!(
        head.contains("attachment; filename=\"one.count.csv\""),
        "{head}"
    );
    assert_eq!(
        body,
        "time,least,most,last\n1970-01-01T00:00:04.000Z,4,4,4\n1970-01-01T00:00:05.000Z,5,5,\n"
    );
    let (_, _, points) = get(&site, "/api/points");
    let points: Value = serde_json::from_str(&points).unwrap();
    assert_eq!(points[0], json!({ "board": "one", "point": "count" }));
}

#[test]
fn what_makes_no_sense_is_refused_with_a_word() {
    let site = Site::new(Vec::new());
    for (query, status, why) in [
        ("board=one&point=level", 404, "no point"),
        ("board=two&point=count", 404, "no point"),
        ("board=one", 404, "no point"),
        ("", 404, "no point"),
        ("board=one&point=broken", 503, "failing"),
        ("board=one&point=count&from=yesterday", 400, "no time"),
        ("board=one&point=count&to=1e9", 400, "no time"),
        ("board=one&point=count&last=5", 400, "no time"),
        ("board=one&point=count&step=soon", 400, "no time"),
        ("board=one&point=count&most=0", 400, "no number"),
        ("board=one&point=count&most=100001", 400, "no number"),
        ("board=one&point=count&most=-1", 400, "no number"),
        ("board=%FF&point=%00", 404, "no point"),
    ] {
        let told = asked(&site, query);
        assert_eq!(told, (status, json!({ "why": why })), "{query}");
        let (csv, _, _) = get(&site, &format!("/api/history.csv?{query}"));
        assert_eq!(csv, status, "{query}");
    }
    // A name of a file says nothing but the name.
    let (_, told) = asked(&site, "board=a%22%0D%0Ab&point=..%2F");
    assert_eq!(told, json!({ "why": "no point" }));
}
