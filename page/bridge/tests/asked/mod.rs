//! Asks as the page makes them: those about a text name its version.

use serde_json::{Value, json};
use unoclp_bridge::{Boards, answer};

/// What is answered, where a text may stand in place of its version.
pub fn told(boards: &mut Boards, mut request: Value) -> Value {
    let is_machine = ["machine", "picture", "text"].map(Value::from);
    if !is_machine.contains(&request["ask"]) {
        version(boards, &mut request);
    }
    // The board of a conversation is a number.
    version(boards, &mut request["order"]);
    if request["program"].is_object() {
        let mut program = request["program"].take();
        version(boards, &mut program);
        request["version"] = program["version"].take();
    }
    answered(boards, &request)
}

fn answered(boards: &mut Boards, request: &Value) -> Value {
    serde_json::from_str(&answer(request.to_string().as_bytes(), boards)).expect("JSON")
}

fn version(boards: &mut Boards, request: &mut Value) {
    let Some(asked) = request.as_object_mut() else {
        return;
    };
    if !(asked.contains_key("name") && asked.contains_key("text")) {
        return;
    }
    let [name, text] = ["name", "text"].map(|key| asked.remove(key));
    let text =
        json!({ "ask": "text", "name": name, "text": text, "board": asked.get("board").cloned() });
    let told = answered(boards, &text);
    // What is refused so is refused by what asks for it too.
    asked.insert("version".to_owned(), told["ok"].clone());
}
