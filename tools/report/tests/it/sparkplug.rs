//! An edge node of Sparkplug B, as pysparkplug and sparkplug-payload read it from mosquitto.

use crate::broker::{Broker, Heard, Listener};
use crate::site::{HOT, Reporting, hot, site};
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Stdio};
use unoclp_report::Refusal;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn python() -> Command {
    let mut python = Command::new(format!("{ROOT}/target/python/bin/python3"));
    python.arg(format!("{ROOT}/tools/report/tests/sparkplug.py"));
    python
}

/// What these messages say: pysparkplug and npm's sparkplug-payload read the same.
fn decoded(heard: &[Heard]) -> Vec<Value> {
    let read = decoded_by(&mut python(), heard);
    let mut node = Command::new("node");
    node.arg(format!("{ROOT}/tools/report/tests/sparkplug.mjs"));
    assert_eq!(decoded_by(&mut node, heard), read);
    read
}

fn decoded_by(reader: &mut Command, heard: &[Heard]) -> Vec<Value> {
    let mut child = reader
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("`cargo xtask setup` brings Node, pysparkplug and sparkplug-payload");
    let mut lines = child.stdin.take().unwrap();
    for Heard { topic, hex, .. } in heard {
        let parts: Vec<&str> = topic.split('/').collect();
        let device = parts.get(4).unwrap_or(&"");
        writeln!(lines, "{} {device} {hex}", parts[2]).unwrap();
    }
    drop(lines);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

/// A command as pysparkplug writes it.
fn command(name: &str, kind: &str, value: &str) -> Vec<u8> {
    let output = python().args([name, kind, value]).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let hex = String::from_utf8(output.stdout).unwrap();
    let hex = hex.trim();
    let bytes = (0..hex.len()).step_by(2);
    bytes
        .map(|at| u8::from_str_radix(&hex[at..at + 2], 16).unwrap())
        .collect()
}

fn begin(broker: &Broker, more: &str, outcome: Result<(), Refusal>) -> Reporting {
    let url = format!("mqtt://127.0.0.1:{}", broker.port);
    Reporting::new(&site(&url, more), None, outcome)
}

const TANK: &[(&str, Option<f64>)] = &[
    ("level", Some(1.5)),
    ("target", Some(-7.0)),
    ("valve", Some(1.0)),
];

#[test]
fn births_deaths_and_data_are_read_by_another() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "spBv1.0/#");
    let mut reporting = begin(
        &broker,
        "sparkplug = { group = \"lab\", node = \"room\" }\n",
        Ok(()),
    );
    let mut heard = vec![listener.next()];
    reporting.reporter.presence("tank", true);
    reporting.change("tank", TANK, 10);
    heard.push(listener.next());
    reporting.change("tank", &[("level", Some(2.5)), ("valve", Some(0.0))], 20);
    heard.push(listener.next());
    reporting.change("tank", &[("level", None)], 30);
    heard.push(listener.next());
    reporting.reporter.presence("tank", false);
    heard.push(listener.next());
    // What was while it was away comes after its birth.
    reporting.change("tank", &[("target", Some(9.0))], 40);
    reporting.change("tank", &[("target", Some(10.0))], 50);
    reporting.reporter.presence("tank", true);
    heard.extend([listener.next(), listener.next()]);
    let rebirth = command("Node Control/Rebirth", "BOOLEAN", "true");
    broker.publish("spBv1.0/lab/NCMD/room", &rebirth, &[]);
    heard.push(listener.next_at("NBIRTH/room"));
    heard.push(listener.next());
    // A goodbye that is meant is the death of that birth.
    reporting = {
        drop(reporting);
        begin(&broker, "", Ok(()))
    };
    heard.push(listener.next());
    drop(reporting);
    let topics: Vec<&str> = heard
        .iter()
        .map(|heard| &heard.topic["spBv1.0/lab/".len()..])
        .collect();
    assert_eq!(
        topics,
        [
            "NBIRTH/room",
            "DBIRTH/room/tank",
            "DDATA/room/tank",
            "DDATA/room/tank",
            "DDEATH/room/tank",
            "DBIRTH/room/tank",
            "DDATA/room/tank",
            "NBIRTH/room",
            "DBIRTH/room/tank",
            "NDEATH/room",
        ]
    );
    assert!(heard.iter().all(|heard| !heard.retained));
    let qos: Vec<u8> = heard.iter().map(|heard| heard.qos).collect();
    assert_eq!(qos, [0, 0, 0, 0, 0, 0, 0, 0, 0, 1]);
    let told = decoded(&heard);
    let seq: Vec<Option<u64>> = told.iter().map(|told| told["seq"].as_u64()).collect();
    let numbers = [0, 1, 2, 3, 4, 5, 6, 0, 1].map(Some);
    assert_eq!(seq[..9], numbers);
    let bd_seq = &told[0]["metrics"]["bdSeq"];
    assert_eq!(bd_seq[0], "INT64");
    assert_eq!(
        (&bd_seq[1], &told[7]["metrics"]["bdSeq"]),
        (&told[9]["bd_seq"], bd_seq)
    );
    assert_eq!(
        told[0]["metrics"]["Node Control/Rebirth"],
        json!(["BOOLEAN", false, false, false])
    );
    assert_eq!(
        told[1]["metrics"],
        json!({
            "level": ["FLOAT", 1.5, false, false],
            "target": ["INT32", -7, false, false],
            "valve": ["BOOLEAN", true, false, false],
        })
    );
    assert_eq!(
        told[2]["metrics"],
        json!({
            "level": ["FLOAT", 2.5, false, false],
            "valve": ["BOOLEAN", false, false, false],
        })
    );
    assert_eq!(
        told[3]["metrics"],
        json!({ "level": ["FLOAT", null, false, true] })
    );
    assert_eq!(told[5]["metrics"]["target"][1], 10);
    assert_eq!(
        told[6]["metrics"],
        json!({ "target": ["INT32", 9, true, false] })
    );
    assert_eq!(
        told[8]["metrics"]["level"],
        json!(["FLOAT", null, false, true])
    );
}

#[test]
fn a_node_waits_for_its_primary_host() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "spBv1.0/lab/#");
    let more = "sparkplug = { group = \"lab\", node = \"room\", host = \"scada\" }\n";
    let reporting = begin(&broker, more, Ok(()));
    reporting.until(|state| state.connected == 2);
    reporting.change("tank", TANK, 10);
    let state = |online: bool, at: u64| {
        let state = json!({ "online": online, "timestamp": at }).to_string();
        broker.publish("spBv1.0/STATE/scada", state.as_bytes(), &["-r"]);
    };
    state(true, 5);
    let mut heard: Vec<_> = (0..2).map(|_| listener.next()).collect();
    // An older word of its end counts for nothing.
    state(false, 4);
    reporting.change("tank", &[("level", Some(3.5))], 20);
    heard.push(listener.next_at("DDATA/room/tank"));
    assert_eq!(decoded(&heard[1..])[1]["metrics"]["level"][1], 3.5);
    state(false, 6);
    let death = listener.next();
    // It comes back by another connection, and is born with the host.
    state(true, 7);
    let birth = listener.next();
    let told = decoded(&[heard[0].clone(), death.clone(), birth.clone()]);
    assert_eq!(
        (&*death.topic, &*birth.topic),
        ("spBv1.0/lab/NDEATH/room", "spBv1.0/lab/NBIRTH/room")
    );
    let first = &told[0]["metrics"]["bdSeq"][1];
    assert_eq!(&told[1]["bd_seq"], first);
    let next = (first.as_u64().unwrap() + 1) % 256;
    assert_eq!(told[2]["metrics"]["bdSeq"][1], next);
    assert_eq!(told[2]["seq"], 0);
}

#[test]
fn what_a_host_has_not_heard_outlasts_a_restart_of_the_gateway() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "spBv1.0/lab/#");
    let more = "sparkplug = { group = \"lab\", node = \"room\", host = \"scada\" }\n";
    let of_site = site(&format!("mqtt://127.0.0.1:{}", broker.port), more);
    let reporting = Reporting::new(&of_site, None, Ok(()));
    reporting.until(|state| state.connected == 2);
    reporting.change("tank", &[("target", Some(1.0))], 10);
    reporting.change("tank", &[("target", Some(2.0))], 20);
    // No host has come, and the gateway begins again.
    let reporting = reporting.again(&of_site);
    reporting.until(|state| state.connected == 2);
    reporting.change("tank", &[("target", Some(3.0))], 30);
    let state = json!({ "online": true, "timestamp": 5 }).to_string();
    broker.publish("spBv1.0/STATE/scada", state.as_bytes(), &["-r"]);
    let heard: Vec<_> = (0..4).map(|_| listener.next()).collect();
    let told = decoded(&heard);
    assert_eq!(told[1]["metrics"]["target"][1], 3);
    let past: Vec<_> = told[2..]
        .iter()
        .map(|told| &told["metrics"]["target"])
        .collect();
    let historical = |value: i32| json!(["INT32", value, true, false]);
    assert_eq!(past, [&historical(1), &historical(2)]);
    // Nothing of it comes again after the next restart.
    reporting.until(|state| state.waiting == 0);
    let reporting = reporting.again(&of_site);
    reporting.change("tank", &[("target", Some(4.0))], 40);
    let birth = loop {
        let heard = listener.next();
        assert!(!heard.topic.contains("DDATA"), "{heard:?}");
        if heard.topic.contains("DBIRTH") {
            break heard;
        }
    };
    assert_eq!(decoded(&[birth])[0]["metrics"]["target"][1], 4);
    drop(reporting);
}

#[test]
fn a_host_sets_what_the_site_lets_it_set() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "spBv1.0/lab/#");
    let more = "sparkplug = { group = \"lab\", node = \"room\" }\nwrite = [\"tank.target\"]\n";
    let reporting = begin(&broker, more, Ok(()));
    reporting.change("tank", TANK, 10);
    let birth = listener.next_at("DBIRTH/room/tank");
    let topic = "spBv1.0/lab/DCMD/room/tank";
    broker.publish(topic, &command("target", "INT32", "-41"), &[]);
    let got = reporting.commands.recv().unwrap();
    assert_eq!(
        (&*got.board, &*got.grant.point, got.value),
        ("tank", "target", -41.0)
    );
    // What is no message, or not allowed, moves nothing; the host is told what the point is.
    broker.publish(topic, b"\xFF\xFF", &[]);
    broker.publish(topic, &command("valve", "BOOLEAN", "false"), &[]);
    let told = listener.next_at("DDATA/room/tank");
    let told = decoded(&[birth, told]);
    assert_eq!(
        told[1]["metrics"],
        json!({ "valve": ["BOOLEAN", true, false, false] })
    );
    assert!(reporting.commands.try_recv().is_err());
}

#[test]
fn alarms_are_metrics_of_the_node_and_a_host_acknowledges_them() {
    let broker = Broker::new();
    let listener = Listener::new(&broker, "spBv1.0/lab/#");
    let sparkplug = "sparkplug = { group = \"lab\", node = \"room\" }\n";
    let reporting = begin(
        &broker,
        &format!("acknowledge = true\n{sparkplug}{HOT}"),
        Ok(()),
    );
    reporting.until(|state| state.connected == 2);
    let birth = listener.next_at("NBIRTH/room");
    reporting.reporter.alarm(&hot("active", 5));
    let told = decoded(&[birth, listener.next_at("NDATA/room")]);
    let [state, active, acknowledge] =
        ["State", "Active", "Acknowledge"].map(|end| format!("Alarms/hot/{end}"));
    let born = &told[0]["metrics"];
    assert_eq!(born[&state], json!(["STRING", null, false, true]));
    assert_eq!(born[&acknowledge], json!(["BOOLEAN", false, false, false]));
    let now = &told[1]["metrics"];
    assert_eq!(now[&state], json!(["STRING", "active", false, false]));
    assert_eq!(now[&active], json!(["BOOLEAN", true, false, false]));
    let topic = "spBv1.0/lab/NCMD/room";
    broker.publish(topic, &command(&acknowledge, "BOOLEAN", "true"), &[]);
    assert_eq!(reporting.acknowledged.recv().unwrap(), "hot");
    drop(reporting);
    // Where the site does not let it, there is no such metric, and the host is told how the alarm stands.
    let reporting = begin(&broker, &format!("{sparkplug}{HOT}"), Ok(()));
    reporting.until(|state| state.connected == 2);
    let birth = listener.next_at("NBIRTH/room");
    reporting.reporter.alarm(&hot("gone", 6));
    let gone = listener.next_at("NDATA/room");
    broker.publish(topic, &command(&acknowledge, "BOOLEAN", "true"), &[]);
    let told = decoded(&[birth, gone, listener.next_at("NDATA/room")]);
    assert_eq!(told[0]["metrics"].get(&acknowledge), None);
    assert_eq!(told[2]["metrics"], told[1]["metrics"]);
    assert_eq!(told[2]["metrics"][&active][1], false);
    assert!(reporting.acknowledged.try_recv().is_err());
}
