//! What `/api/openapi.json` says is what is answered.

use crate::common::http;
use crate::site::Site;
use serde_json::Value;
use std::collections::BTreeSet;

fn get(site: &Site, path: &str) -> (u16, String) {
    let answer = http(site.page, path, &format!("Host: {}\r\n", site.page));
    let (head, body) = answer.split_once("\r\n\r\n").unwrap();
    let status = head.split(' ').nth(1).unwrap().parse().unwrap();
    (status, body.to_owned())
}

/// Whether a value is one of this schema, which names others of the same page.
fn fits(page: &Value, schema: &Value, value: &Value) -> bool {
    if let Some(name) = schema["$ref"].as_str() {
        let other = page.pointer(name.trim_start_matches('#'));
        return fits(page, other.expect(name), value);
    }
    let kinds: Vec<&str> = match &schema["type"] {
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect(),
        kind => kind.as_str().into_iter().collect(),
    };
    let kind = match value {
        Value::Null => "null",
        Value::Bool(_) => "boolean",
        Value::Number(number) if number.is_i64() || number.is_u64() => "integer",
        Value::Number(_) => "number",
        Value::String(_) => "string",
        Value::Array(_) => "array",
        Value::Object(_) => "object",
    };
    let is_kind = kinds.contains(&kind) || (kind == "integer" && kinds.contains(&"number"));
    let inside = match value {
        Value::Array(items) => items.iter().all(|item| fits(page, &schema["items"], item)),
        Value::Object(members) => {
            let required = schema["required"].as_array().into_iter().flatten();
            let mut required = required.filter_map(Value::as_str);
            required.all(|name| members.contains_key(name))
                && members.iter().all(|(name, member)| {
                    let known = schema["properties"].get(name);
                    known
                        .or(schema.get("additionalProperties"))
                        .is_some_and(|schema| fits(page, schema, member))
                })
        }
        _ => true,
    };
    is_kind && inside
}

#[test]
fn each_path_answers_as_it_is_described() {
    let (site, _folder) = crate::alarms::site(None);
    let page: Value = serde_json::from_str(&get(&site, "/api/openapi.json").1).unwrap();
    assert!(page["openapi"].as_str().unwrap().starts_with("3.1"));
    let paths = page["paths"].as_object().unwrap();
    let mut checked = 0;
    for (path, of) in paths {
        if of["get"].is_null() {
            // What is brought, and answered, has tests of its own.
            let ways = ["/api/alarms/acknowledge", "/api/write"];
            assert!(ways.contains(&&**path), "{path}");
            continue;
        }
        let responses = of["get"]["responses"].as_object().unwrap();
        for query in [
            "",
            "?board=one&point=count&from=0&to=9000",
            "?board=one&point=count&step=x",
            "?board=one&point=broken",
            "?board=none&point=none",
        ] {
            let (status, body) = get(&site, &format!("{path}{query}"));
            let described = responses.get(&status.to_string());
            let described = described.unwrap_or_else(|| panic!("{path}{query}: {status}"));
            if let Some(schema) = described.pointer("/content/application~1json/schema") {
                let value: Value = serde_json::from_str(&body).unwrap();
                assert!(
                    fits(&page, schema, &value),
                    "{path}{query}: {body} is no {schema}"
                );
                checked += 1;
            }
        }
        let parameters = of["get"]["parameters"].as_array();
        let names: Vec<&str> = parameters
            .into_iter()
            .flatten()
            .map(|parameter| parameter["name"].as_str().unwrap())
            .collect();
        let takes_some = path.contains("history") || path.contains("deeds");
        assert_eq!(names.is_empty(), !takes_some, "{path}");
    }
    assert!(checked >= 39, "{checked}");
    // A value of another kind does not fit.
    let schema = &page["components"]["schemas"]["Health"];
    assert!(!fits(&page, schema, &serde_json::json!({ "boards": 1 })));
    assert!(!fits(
        &page,
        schema,
        &serde_json::json!({ "boards": "1", "up": 1 })
    ));
    // Each way that there is, is described.
    let source = include_str!("../../src/api/paths.rs");
    let ways = source.split(".route(\"").skip(1);
    let ways: BTreeSet<&str> = ways.map(|way| way.split('"').next().unwrap()).collect();
    let described: BTreeSet<&str> = paths.keys().map(|path| &**path).collect();
    assert_eq!(ways, described);
    // The pages name them too.
    for docs in [
        include_str!("../../../../docs/site.md"),
        include_str!("../../../../docs/site.pt-BR.md"),
    ] {
        for way in &ways {
            assert!(docs.contains(&format!("`{way}")), "{way}");
        }
    }
}
