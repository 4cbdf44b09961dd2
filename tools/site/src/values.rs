//! The value of a point, and the words that hold it.

use crate::points::{Kind, Place};
use unoclp_modbus::map::Width;

impl Kind {
    /// The words in which this place holds a value; none where it cannot hold it.
    pub fn words(self, place: Place, value: f64) -> Option<Vec<u16>> {
        if self == Kind::Real {
            let real = value as f32;
            let bits = real.is_finite().then(|| real.to_bits())?;
            return Some(both(bits));
        }
        let (least, most) = self.range(place.width);
        let is_whole = value.fract() == 0.0 && (least..=most).contains(&value);
        if !is_whole {
            return None;
        }
        // Whole and in range, so nothing is lost; a sign is in the two's complement.
        let bits = (value as i64) as u32;
        Some(match place.width {
            Width::Bit | Width::Word => vec![bits as u16],
            Width::Long => both(bits),
        })
    }

    /// The least and the most that a value of this width can be.
    pub fn range(self, width: Width) -> (f64, f64) {
        match (self, width) {
            (Kind::Real, _) => (f32::MIN.into(), f32::MAX.into()),
            (_, Width::Bit) => (0.0, 1.0),
            (Kind::Unsigned, Width::Word) => (0.0, u16::MAX.into()),
            (Kind::Unsigned, Width::Long) => (0.0, u32::MAX.into()),
            (Kind::Signed, Width::Word) => (i16::MIN.into(), i16::MAX.into()),
            (Kind::Signed, Width::Long) => (i32::MIN.into(), i32::MAX.into()),
        }
    }
}

/// The more significant word first, as the map has it.
fn both(bits: u32) -> Vec<u16> {
    vec![(bits >> 16) as u16, bits as u16]
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::{Table, map};

    #[test]
    fn what_a_place_cannot_hold_has_no_words() {
        let place = |width| Place {
            table: Table::HoldingRegisters,
            first: 0,
            width,
        };
        let words = |kind: Kind, width, value| kind.words(place(width), value);
        use Kind::{Real, Signed, Unsigned};
        use Width::{Bit, Long, Word};
        for (kind, width, value, held) in [
            (Unsigned, Bit, 1.0, Some(vec![1])),
            (Unsigned, Bit, 2.0, None),
            (Unsigned, Bit, 0.5, None),
            (Unsigned, Word, 65535.0, Some(vec![0xFFFF])),
            (Unsigned, Word, -1.0, None),
            (Signed, Long, -2.0, Some(vec![0xFFFF, 0xFFFE])),
            (Signed, Long, 2_147_483_648.0, None),
            (Unsigned, Long, 65536.0, Some(vec![1, 0])),
            (Real, Long, 1.5, Some(vec![0x3FC0, 0])),
            (Real, Long, 1e39, None),
            (Real, Long, f64::NAN, None),
            (Signed, Long, f64::NAN, None),
            (Signed, Long, f64::INFINITY, None),
        ] {
            assert_eq!(
                words(kind, width, value),
                held,
                "{kind:?} {width:?} {value}"
            );
        }
        let held = words(Signed, Long, -123_456.0).unwrap_or_default();
        let long = map::long(held[0], held[1]);
        assert_eq!(long.cast_signed(), -123_456);
    }
}
