//! Sizes as a person writes them: `64MB`, `2GB`.

/// The bytes of this text; none of what is no size.
pub(crate) fn size(text: &str) -> Option<u64> {
    let letters = text.find(|ch: char| !ch.is_ascii_digit())?;
    let (number, unit) = text.split_at(letters);
    let bytes: u64 = match unit {
        "MB" => 1_000_000,
        "GB" => 1_000_000_000,
        _ => return None,
    };
    number.parse::<u64>().ok()?.checked_mul(bytes)
}

/// A size as it is written, in the largest unit that is whole.
pub(crate) fn written(bytes: u64) -> String {
    match bytes.is_multiple_of(1_000_000_000) {
        true => format!("{}GB", bytes / 1_000_000_000),
        false => format!("{}MB", bytes.div_ceil(1_000_000)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_a_number_and_its_unit() {
        for (text, bytes) in [
            ("64MB", Some(64_000_000)),
            ("2GB", Some(2_000_000_000)),
            ("64", None),
            ("MB", None),
            ("", None),
            ("1.5GB", None),
            ("-1MB", None),
            ("64 MB", None),
            ("64mb", None),
            ("99999999999999999999GB", None),
            ("18446744073709551615GB", None),
        ] {
            assert_eq!(size(text), bytes, "{text}");
        }
        for text in ["64MB", "2GB", "1500MB"] {
            assert_eq!(size(text).map(written).as_deref(), Some(text));
        }
    }
}
