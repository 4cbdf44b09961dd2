//! Writing of single points: outputs, markers, registers, presets.

use crate::client::{Client, Failure};
use crate::map::{Span, Width, coil, holding};
use unoclp_modbus::Exception;

/// A point that a client may write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    span: Span,
    index: u16,
}

impl Point {
    /// The point of this name: `Q1`, `M5`, `D12`, the preset of `T1` or `C2`; none where a board has no such point.
    pub fn named(name: &str) -> Option<Point> {
        let letter = name.chars().next()?;
        let number: u16 = name.get(letter.len_utf8()..)?.parse().ok()?;
        let span = match letter {
            'Q' => coil::OUTPUTS,
            'M' => coil::MARKERS,
            'D' => holding::REGISTERS,
            'T' => holding::TIMERS,
            'C' => holding::COUNTERS,
            _ => return None,
        };
        let index = number.checked_sub(1).filter(|&index| index < span.values)?;
        Some(Point { span, index })
    }

    /// Writes it; a bit is 0 where the value is. An output keeps it until a rung writes it.
    ///
    /// # Errors
    /// [`Failure`].
    pub async fn set(self, client: &mut Client, value: i32) -> Result<(), Failure> {
        let Point { span, index } = self;
        match span.width {
            Width::Bit => client.set_bit(span.first + index, value != 0).await,
            Width::Long => {
                let value = value.cast_unsigned();
                let words = [(value >> 16) as u16, value as u16];
                let first = span.first + 2 * index;
                client.set_words(Span { first, ..span }, &words).await
            }
            // No point that has a name is one word.
            Width::Word => Err(Failure::Refused(Exception::IllegalDataAddress)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Conversation, Line, Patience};
    use std::time::Duration;

    /// The first frame that is sent to set this point.
    fn frame(name: &str, value: i32) -> Vec<u8> {
        let point = Point::named(name).expect(name);
        let talk = async move |client: &mut Client| point.set(client, value).await;
        let mut conversation = Conversation::new(Line::default(), Patience::default(), talk);
        let gap = Duration::from_millis(10);
        let first = conversation.step(Duration::ZERO, &[]);
        assert!(first.send.is_empty(), "the line is silent before a frame");
        let mut sent = conversation.step(gap, &[]).send;
        sent.truncate(sent.len() - 2);
        sent
    }

    #[test]
    fn a_point_is_written_where_the_map_has_it() {
        assert_eq!(frame("Q2", 1), [1, 5, 0, 1, 0xFF, 0]);
        assert_eq!(frame("M1", 0), [1, 5, 0, 16, 0, 0]);
        let register = [1, 16, 0x07, 0xD2, 0, 2, 4, 0xFF, 0xFF, 0xFF, 0xFE];
        assert_eq!(frame("D2", -2), register);
        assert_eq!(
            frame("T1", 5000),
            [1, 16, 0, 128, 0, 2, 4, 0, 0, 0x13, 0x88]
        );
        assert_eq!(frame("C2", 3), [1, 16, 0x01, 0x42, 0, 2, 4, 0, 0, 0, 3]);
    }

    #[test]
    fn a_point_that_no_board_has_has_no_place() {
        for name in [
            "", "Q", "Q0", "Q5", "M65", "D99", "C17", "T88", "I1", "é1", "Q-1", "D1.5",
        ] {
            assert_eq!(Point::named(name), None, "{name}");
        }
    }
}
