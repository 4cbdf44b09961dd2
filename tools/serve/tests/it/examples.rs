//! The files for other programs in `docs/site/` name what the gateway has.

use serde_json::Value;

const HISTORY: &str = include_str!("../../../history/src/postgres/form.rs");
const PAGE: &str = include_str!("../../../../docs/site.md");

#[test]
fn topics_are_those_of_the_page() {
    let flow: Value =
        serde_json::from_str(include_str!("../../../../docs/site/node-red.json")).unwrap();
    let nodes = flow.as_array().unwrap();
    let topics: Vec<&str> = nodes
        .iter()
        .filter_map(|node| node["topic"].as_str())
        .collect();
    assert_eq!(topics.len(), 4);
    for topic in topics {
        let shown = topic.replace("alarm/+", "alarm/NAME");
        assert!(PAGE.contains(&format!("`{shown}`")), "{topic}");
    }
    // Each wire leads to a node of the flow.
    let ids: Vec<&str> = nodes
        .iter()
        .filter_map(|node| node["id"].as_str())
        .collect();
    for wire in nodes.iter().filter_map(|node| node["wires"][0][0].as_str()) {
        assert!(ids.contains(&wire), "{wire}");
    }
    let home = include_str!("../../../../docs/site/home-assistant.yaml");
    for topic in ["unoclp/$alarm/target-high", "unoclp/$status"] {
        assert!(home.contains(&format!("\"{topic}\"")), "{topic}");
    }
    assert!(PAGE.contains("name = \"target-high\""));
}

#[test]
fn a_panel_of_grafana_asks_for_tables_that_there_are() {
    let panel = include_str!("../../../../docs/site/grafana.json");
    let _: Value = serde_json::from_str(panel).unwrap();
    let tables: Vec<&str> = panel
        .split("FROM ")
        .skip(1)
        .filter_map(|rest| rest.split_whitespace().next())
        .collect();
    assert_eq!(tables, ["unoclp.point", "unoclp.point", "unoclp.value"]);
    for table in tables {
        assert!(
            ["CREATE TABLE", "CREATE VIEW"]
                .iter()
                .any(|made| HISTORY.contains(&format!("{made} {table}"))),
            "{table}"
        );
    }
}

#[test]
fn prometheus_watches_metrics_that_there_are() {
    let rules = include_str!("../../../../docs/site/prometheus.yml");
    let of_name = |ch: char| ch.is_ascii_lowercase() || ch == '_';
    let names: Vec<&str> = rules
        .split(|ch| !of_name(ch))
        .filter(|word| word.starts_with("unoclp_"))
        .collect();
    assert_eq!(names.len(), 8);
    for name in names {
        assert!(PAGE.contains(&format!("`{name}`")), "{name}");
    }
}
