//! Values as a person gives them to a symbol: `TRUE`, `5`, `T#20s`, `Red`, `'text'`.

use crate::{Base, Enumeration, Value, literal};

/// The value of this text for a symbol of this type, whose enumeration has these values; none if it is none.
pub fn given(text: &str, base: Base, values: &Enumeration) -> Option<Value> {
    let text = text.trim();
    if let Some(number) = values.number_of(|name| name.eq_ignore_ascii_case(text)) {
        return Some(Value::Int(number.into()));
    }
    if base.is_text() {
        let quoted =
            text.len() >= 2 && text.starts_with(['\'', '"']) && text.ends_with(['\'', '"']);
        let inner = if quoted {
            text.get(1..text.len() - 1)?
        } else {
            text
        };
        return literal::characters(inner).map(Value::Text);
    }
    literal::spelled(text, base)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_fits_its_type_or_is_none() {
        let colors = Enumeration::new(vec![("Red".to_owned(), 0), ("Green".to_owned(), 1)]);
        for (text, base, value) in [
            ("1", Base::Bool, Some(Value::Int(1))),
            ("-5", Base::Int, Some(Value::Int(-5))),
            ("40000", Base::Int, None),
            ("1.5", Base::Int, None),
            ("3", Base::Real, Some(Value::Real(3.0))),
            ("T#2s", Base::Time, Some(Value::Int(2000))),
            ("500", Base::Time, Some(Value::Int(500))),
            ("16#FF", Base::Byte, Some(Value::Int(255))),
            ("'a b'", Base::Str, Some(Value::Text("a b".into()))),
            ("on", Base::Bool, None),
            ("T#2s", Base::Int, None),
        ] {
            assert_eq!(given(text, base, &Enumeration::default()), value, "{text}");
        }
        assert_eq!(given("green", Base::Int, &colors), Some(Value::Int(1)));
    }
}
