//! Writing of single points: outputs, markers, registers, presets.

use crate::client::{Client, Failure};
use crate::map::{Span, Width, coil, holding};
use unoclp_modbus::Exception;
use unoclp_point::Address;

/// Where the map has a point that a client may write, and which of the span it is; of a timer or counter its preset.
/// None where a board has no such point.
fn place(point: Address) -> Option<(Span, u16)> {
    let span = match point {
        Address::Output(_) => coil::OUTPUTS,
        Address::Marker(_) => coil::MARKERS,
        Address::Register(_) => holding::REGISTERS,
        Address::Timer(_) => holding::TIMERS,
        Address::Counter(_) => holding::COUNTERS,
        _ => return None,
    };
    let index = u16::from(point.number()).checked_sub(1)?;
    (index < span.values).then_some((span, index))
}

/// Whether a client may write this point.
pub fn is_written(point: Address) -> bool {
    place(point).is_some()
}

/// Writes a point; a bit is 0 where the value is. An output keeps it until a rung writes it.
///
/// # Errors
/// [`Failure`]; of a point that no client may write, that it is refused.
pub async fn set(client: &mut Client, point: Address, value: i32) -> Result<(), Failure> {
    // No point that has a name is one word.
    let refused = Err(Failure::Refused(Exception::IllegalDataAddress));
    match place(point) {
        Some((span, index)) if span.width == Width::Bit => {
            client.set_bit(span.first + index, value != 0).await
        }
        Some((span, index)) if span.width == Width::Long => {
            let value = value.cast_unsigned();
            let words = [(value >> 16) as u16, value as u16];
            let first = span.first + 2 * index;
            client.set_words(Span { first, ..span }, &words).await
        }
        _ => refused,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Conversation, Line, Patience};
    use std::time::Duration;

    /// The first frame that is sent to set this point.
    fn frame(name: &str, value: i32) -> Vec<u8> {
        let point = Address::parse(name).expect(name);
        let talk = async move |client: &mut Client| set(client, point, value).await;
        let mut conversation = Conversation::new(Line::default(), Patience::default(), talk);
        let gap = Duration::from_millis(10);
        let first = conversation.step(Duration::ZERO, &[]);
        assert!(first.send.is_empty(), "the line is silent before a frame");
        let mut sent = conversation.step(gap, &[]).send;
        sent.truncate(sent.len() - 2);
        sent
    }

    #[test]
    fn only_points_of_the_map_are_written() {
        let is = |name: &str| is_written(Address::parse(name).expect(name));
        assert_eq!(["Q2", "M1", "D2", "T1", "C2"].map(is), [true; 5]);
        assert_eq!(["I1", "S1"].map(is), [false; 2]);
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
            let point = Address::parse(name).filter(|point| is_written(*point));
            assert_eq!(point, None, "{name}");
        }
    }
}
