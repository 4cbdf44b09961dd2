//! From the bytes of a file to text.

/// The text of a file, without its byte-order mark: UTF-8; UTF-16, where the mark says so; else Latin-1.
pub fn decode(file: &[u8]) -> String {
    let wide = |unit: fn([u8; 2]) -> u16, bytes: &[u8]| {
        let units: Vec<u16> = bytes.as_chunks().0.iter().map(|&pair| unit(pair)).collect();
        String::from_utf16_lossy(&units)
    };
    match file {
        [0xFF, 0xFE, text @ ..] => wide(u16::from_le_bytes, text),
        [0xFE, 0xFF, text @ ..] => wide(u16::from_be_bytes, text),
        [0xEF, 0xBB, 0xBF, text @ ..] | text => match std::str::from_utf8(text) {
            Ok(text) => text.to_owned(),
            Err(_) => text.iter().copied().map(char::from).collect(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_usual_encoding_is_read() {
        assert_eq!(decode("Início".as_bytes()), "Início");
        assert_eq!(decode(b"\xEF\xBB\xBFIn\xC3\xADcio"), "Início");
        assert_eq!(decode(b"In\xEDcio"), "Início");
        assert_eq!(decode(b"\xFF\xFEL\0D\0"), "LD");
        assert_eq!(decode(b"\xFE\xFF\0L\0D"), "LD");
    }
}
