//! The result of a run, for a program: one object.

use super::ran::{Ran, Row};
use unoclp_lang::typed::{Base, Value};

pub(super) fn json(ran: &Ran) -> String {
    let printed = ran.printed.iter();
    let printed: Vec<String> = printed.map(|(held, base)| value(held, *base)).collect();
    let symbol = |row: &Row| {
        format!(
            r#"{{"name": {}, "type": {}, "value": {}, "place": {}}}"#,
            quoted(&row.name),
            quoted(&row.type_name),
            row.named
                .as_deref()
                .map_or_else(|| value(&row.value, row.base), quoted),
            row.place
                .as_deref()
                .map_or_else(|| "null".to_owned(), quoted)
        )
    };
    let symbols: Vec<String> = ran.symbols.iter().map(symbol).collect();
    format!(
        "{{\"scans\": {}, \"printed\": [{}], \"symbols\": [{}]}}\n",
        ran.scans,
        printed.join(", "),
        symbols.join(", ")
    )
}

/// Numbers as numbers, BOOL as true and false, TIME in ms, all else as strings.
fn value(held: &Value, base: Base) -> String {
    match (held, base) {
        (Value::Int(truth), Base::Bool) => (*truth != 0).to_string(),
        (Value::Int(number), _) if !base.is_date() => number.to_string(),
        // JSON has no number for what is not finite.
        (Value::Real(number), _) if number.is_finite() => held.shown(base),
        (Value::Text(text), _) => quoted(text),
        _ => quoted(&held.shown(base)),
    }
}

fn quoted(text: &str) -> String {
    let mut all = String::from('"');
    for character in text.chars() {
        match character {
            '"' => all.push_str("\\\""),
            '\\' => all.push_str("\\\\"),
            '\n' => all.push_str("\\n"),
            c if c < ' ' => all.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => all.push(c),
        }
    }
    all.push('"');
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_json() {
        for (held, base, json) in [
            (Value::Int(1), Base::Bool, "true"),
            (Value::Int(-5), Base::Int, "-5"),
            (Value::Int(255), Base::Byte, "255"),
            (Value::Int(1500), Base::Time, "1500"),
            (Value::Int(0), Base::Date, "\"D#1970-01-01\""),
            (Value::Real(2.5), Base::Real, "2.5"),
            (Value::Real(1e20), Base::Lreal, "1E20"),
            (
                Value::Text("a\"b\\\t".into()),
                Base::Str,
                "\"a\\\"b\\\\\\u0009\"",
            ),
        ] {
            assert_eq!(value(&held, base), json);
        }
    }
}
