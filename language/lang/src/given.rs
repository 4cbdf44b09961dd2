//! Values as a person gives them to a symbol: `TRUE`, `5`, `T#20s`, `Red`, `'text'`.

use crate::st::literal;
use crate::typed::{Base, Value, convert_given};

/// The value of this text for a symbol of this type, whose enumeration has these values; none if it is none.
pub fn given(text: &str, base: Base, values: &[String]) -> Option<Value> {
    let text = text.trim();
    if let Some(at) = values
        .iter()
        .position(|name| name.eq_ignore_ascii_case(text))
    {
        return Some(Value::Int(at as i128));
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
    if base == Base::Bool {
        return match text.to_ascii_uppercase().as_str() {
            "TRUE" | "1" | "BOOL#TRUE" | "BOOL#1" => Some(Value::truth(true)),
            "FALSE" | "0" | "BOOL#FALSE" | "BOOL#0" => Some(Value::truth(false)),
            _ => None,
        };
    }
    let (sign, size) = match text.strip_prefix('-') {
        Some(size) => (-1, size),
        None => (1, text),
    };
    match literal::typed(text) {
        Some(read) => {
            let (from, value) = read.ok()?;
            let fits =
                from == base || base.is_real() && from.is_num() || base.is_int() && from.is_int();
            convert_given(value, base).filter(|_| fits || base.is_bits() && from.is_bits())
        }
        None => {
            let (_, value) = literal::number(size).ok()?;
            let value = match value {
                Value::Int(number) => Value::Int(number * i128::from(sign)),
                Value::Real(number) => Value::Real(number * f64::from(sign)),
                other => other,
            };
            convert_given(value, base)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_fits_its_type_or_is_none() {
        let colors = ["Red".to_owned(), "Green".to_owned()];
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
            assert_eq!(given(text, base, &[]), value, "{text}");
        }
        assert_eq!(given("green", Base::Int, &colors), Some(Value::Int(1)));
    }
}
