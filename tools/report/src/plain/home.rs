//! What Home Assistant finds: one device a board, one component a point (*MQTT discovery, device discovery payload*); and one
//! for the alarms of the gateway.

use super::topics::Topics;
use crate::boards::{Board, Shape, shape};
use crate::command::Rights;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use unoclp_site::Point;

/// Where Home Assistant looks, and says that it is there.
const ABOVE: &str = "homeassistant";

/// What Home Assistant has been told.
#[derive(Debug)]
pub(super) struct Home {
    gateway: String,
    /// The components of each board, and their platforms. One that is no more is removed by name.
    told: BTreeMap<String, BTreeMap<String, &'static str>>,
    /// The same of the alarms.
    told_alarms: BTreeMap<String, &'static str>,
}

/// The components of an alarm.
const PROBLEM: &str = "binary_sensor";
const ACKNOWLEDGE: &str = "button";

fn acknowledging(alarm: &str) -> String {
    format!("{alarm}$acknowledge")
}

impl Home {
    pub fn new(gateway: &str) -> Home {
        Home {
            gateway: gateway.to_owned(),
            told: BTreeMap::new(),
            told_alarms: BTreeMap::new(),
        }
    }

    /// Where it says that it is there.
    pub fn status(&self) -> String {
        format!("{ABOVE}/status")
    }

    /// The topic and the payload that tell it of a board; none as long as the points of the board are not known.
    pub fn config(
        &mut self,
        board: &Board,
        rights: &Rights,
        topics: &Topics,
    ) -> Option<(String, String)> {
        if board.points().is_empty() {
            return None;
        }
        let id = format!("{}_{}", self.gateway, board.name);
        let mut components = Map::new();
        let mut told = BTreeMap::new();
        for point in board.points() {
            let is_writable = rights.of(&board.name, &point.name).is_some();
            let platform = platform(point, is_writable);
            let mut component = json!({
                "p": platform,
                "unique_id": format!("{id}_{}", point.name),
                "name": point.name,
                "state_topic": topics.point(&board.name, &point.name),
            });
            if let Some(component) = component.as_object_mut() {
                component.extend(details(point, is_writable, &board.name, topics));
            }
            components.insert(point.name.clone(), component);
            told.insert(point.name.clone(), platform);
        }
        let before = self.told.insert(board.name.clone(), told);
        remove(&mut components, before.unwrap_or_default());
        let online = [topics.gateway(), topics.board(&board.name)];
        Some(device(&id, &board.name, &online, components))
    }

    /// An alarm that this site no longer has.
    pub fn forget_alarm(&mut self, alarm: &str) {
        self.told_alarms.insert(alarm.to_owned(), PROBLEM);
        self.told_alarms.insert(acknowledging(alarm), ACKNOWLEDGE);
    }

    /// The topic and the payload that tell it of these alarms; none where there were and are none.
    pub fn alarms<'a>(
        &mut self,
        alarms: impl Iterator<Item = &'a str>,
        rights: &Rights,
        topics: &Topics,
    ) -> Option<(String, String)> {
        let id = &self.gateway;
        let mut components = Map::new();
        let mut told = BTreeMap::new();
        for alarm in alarms {
            let state = topics.alarm(alarm);
            components.insert(alarm.to_owned(), json!({
                "p": PROBLEM,
                "device_class": "problem",
                "unique_id": format!("{id}$alarm_{alarm}"),
                "name": alarm,
                "state_topic": state,
                "value_template": "{{ 'ON' if value_json.state in ['active', 'acknowledged'] else 'OFF' }}",
                "json_attributes_topic": state,
            }));
            told.insert(alarm.to_owned(), PROBLEM);
            if rights.acknowledge {
                let key = acknowledging(alarm);
                components.insert(
                    key.clone(),
                    json!({
                        "p": ACKNOWLEDGE,
                        "unique_id": format!("{id}$alarm_{key}"),
                        "name": format!("{alarm}: acknowledge"),
                        "command_topic": topics.acknowledge(alarm),
                        "payload_press": "true",
                    }),
                );
                told.insert(key, ACKNOWLEDGE);
            }
        }
        let before = std::mem::replace(&mut self.told_alarms, told);
        remove(&mut components, before);
        if components.is_empty() {
            return None;
        }
        Some(device(id, id, &[topics.gateway()], components))
    }
}

/// The topic and the payload that tell of a device. It is there while each of these topics says so.
fn device(
    id: &str,
    name: &str,
    online: &[String],
    components: Map<String, Value>,
) -> (String, String) {
    let online: Vec<Value> = online
        .iter()
        .map(|topic| json!({ "topic": topic }))
        .collect();
    let config = json!({
        "dev": { "ids": [id], "name": name, "mf": "unoclp", "mdl": "unoclp" },
        "o": { "name": "unoclp", "sw": env!("CARGO_PKG_VERSION") },
        "availability": online,
        "availability_mode": "all",
        "qos": 1,
        "cmps": components,
    });
    (format!("{ABOVE}/device/{id}/config"), config.to_string())
}

/// Those that there were, and are no more: with nothing but its platform a component is removed.
fn remove(components: &mut Map<String, Value>, before: BTreeMap<String, &'static str>) {
    for (name, platform) in before {
        components
            .entry(name)
            .or_insert_with(|| json!({ "p": platform }));
    }
}

fn platform(point: &Point, is_writable: bool) -> &'static str {
    match (shape(point), is_writable) {
        (Shape::Bit, false) => "binary_sensor",
        (Shape::Bit, true) => "switch",
        (_, false) => "sensor",
        (_, true) => "number",
    }
}

fn details(
    point: &Point,
    is_writable: bool,
    board: &str,
    topics: &Topics,
) -> impl Iterator<Item = (String, Value)> {
    let shape = shape(point);
    let value = match shape {
        // What is not known is neither.
        Shape::Bit => {
            "{{ value_json.v if value_json.v is none else ('ON' if value_json.v else 'OFF') }}"
        }
        _ => "{{ value_json.v }}",
    };
    let mut details = vec![("value_template", json!(value))];
    if is_writable {
        details.push(("command_topic", json!(topics.command(board, &point.name))));
        if shape == Shape::Bit {
            let more = [
                ("payload_on", "true"),
                ("payload_off", "false"),
                ("state_on", "ON"),
                ("state_off", "OFF"),
            ];
            details.extend(more.map(|(key, text)| (key, json!(text))));
        } else {
            let (least, most) = point.kind.range(point.read.width);
            let step = if shape == Shape::Real { 0.001 } else { 1.0 };
            let more = [("min", least), ("max", most), ("step", step)];
            details.extend(more.map(|(key, number)| (key, json!(number))));
            details.push(("mode", json!("box")));
        }
    } else if shape != Shape::Bit {
        details.push(("state_class", json!("measurement")));
    }
    details
        .into_iter()
        .map(|(key, value)| (key.to_owned(), value))
}
