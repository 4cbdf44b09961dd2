//! A page draws charts, and changes them.

use serde_json::{Value, json};
use unoclp_bridge::{Boards, answer};

const FILLING: &str = include_str!("../../../programs/charts/filling.st");

struct Page(Boards);

impl Page {
    fn told(&mut self, request: &Value) -> Value {
        serde_json::from_str(&answer(request.to_string().as_bytes(), &mut self.0)).unwrap()
    }

    fn chart(&mut self, text: &str, more: Value) -> Value {
        let version = self.told(&json!({ "ask": "text", "name": "a.st", "text": text }));
        let mut ask = json!({ "ask": "chart", "version": version["ok"], "chart": 0 });
        ask.as_object_mut()
            .unwrap()
            .extend(more.as_object().unwrap().clone());
        self.told(&ask)
    }
}

#[test]
fn a_chart_is_drawn_with_its_points_and_changed() {
    let mut page = Page(Boards::default());
    let drawn = page.chart(FILLING, json!({}));
    let chart = &drawn["ok"]["charts"][0];
    assert_eq!(chart["unit"], "filling");
    assert_eq!(chart["parts"][0]["name"], "Wait");
    assert_eq!(chart["parts"][0]["initial"], true);
    assert!(
        chart["points"][0][0].as_str().unwrap().starts_with('M'),
        "{}",
        chart["points"]
    );
    // Settle measures its time.
    assert!(chart["points"][3][1].is_string(), "{}", chart["points"]);
    // What each part has become; nobody knows that of what has just been drawn.
    let count = |part: &Value| part["steps"].as_array().unwrap().len();
    let parts = chart["parts"].as_array().unwrap();
    for part in parts.iter().filter(|part| part["kind"] == "transition") {
        assert!(count(part) > 0, "{part}");
    }
    let done = page.chart(FILLING, json!({ "what": "after", "at": "s0" }));
    let after = done["ok"]["charts"][0]["parts"].as_array().unwrap();
    assert!(after.iter().all(|part| count(part) == 0));
    assert_eq!(done["ok"]["select"], "s5");
    let text = done["ok"]["text"].as_str().unwrap();
    assert!(text.contains("STEP S1: END_STEP"), "{text}");
    let done = page.chart(
        text,
        json!({ "what": "condition", "at": "t0", "say": "start AND bottle" }),
    );
    assert!(
        done["ok"]["text"]
            .as_str()
            .unwrap()
            .contains(":= start AND bottle;"),
        "{done}"
    );
    for (more, told) in [
        (
            json!({ "what": "condition", "at": "t0", "say": "" }),
            "a condition or a time is missing",
        ),
        (
            json!({ "what": "rename", "at": "s0", "say": "IF" }),
            "this is not a valid name; use letters, digits and _",
        ),
        (
            json!({ "what": "after", "at": "s99" }),
            "the selected element no longer exists",
        ),
    ] {
        assert_eq!(page.chart(FILLING, more)["error"]["en"], told);
    }
    assert_eq!(page.chart("x := 1;", json!({}))["ok"]["charts"], json!([]));
}
