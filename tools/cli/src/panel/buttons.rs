//! The inputs of the board, as buttons that keys press.

use std::time::Duration;
use unoclp_core::{Image, Point};

/// How a momentary button learns that its key was let go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeyUp {
    /// The terminal tells it.
    Told,
    /// The terminal only repeats a key that is held, so the silence after it must tell.
    Guessed,
}

/// How long a button stays closed after a key's first event where its end is guessed: as long as
/// keyboards commonly wait before they repeat.
const BEFORE_REPEATS: Duration = Duration::from_millis(600);

/// How long it stays closed after each repeat.
const BETWEEN_REPEATS: Duration = Duration::from_millis(300);

/// The buttons on the inputs. Times are readings of one clock that never goes back.
#[derive(Clone, Debug)]
pub struct Buttons {
    closed: Image,
    momentary: bool,
    key_up: KeyUp,
    /// The momentary buttons that are closed, each with the time at which it opens by itself.
    pressed: Vec<(Point, Duration)>,
}

impl Buttons {
    /// All open; each key toggles.
    pub fn new(key_up: KeyUp) -> Buttons {
        Buttons {
            closed: Image::default(),
            momentary: false,
            key_up,
            pressed: Vec::new(),
        }
    }

    /// The inputs that are closed.
    pub fn closed(&self) -> Image {
        self.closed
    }

    /// Whether a button is closed only while its key is held.
    pub fn momentary(&self) -> bool {
        self.momentary
    }

    /// Changes between keys that toggle and keys that are held. Buttons that were held open.
    pub fn switch_mode(&mut self) {
        self.momentary = !self.momentary;
        for (input, _) in self.pressed.drain(..) {
            self.closed.set(input, false);
        }
    }

    /// A key goes down, or repeats without the terminal saying so.
    pub fn press(&mut self, input: Point, at: Duration) {
        if !self.momentary {
            self.closed.set(input, !self.closed.get(input));
            return;
        }
        let repeated = self.is_pressed(input);
        self.close_until(input, at, repeated);
    }

    /// The terminal says that a key repeats.
    pub fn repeat(&mut self, input: Point, at: Duration) {
        if self.momentary && self.is_pressed(input) {
            self.close_until(input, at, true);
        }
    }

    /// The terminal says that a key went up.
    pub fn release(&mut self, input: Point) {
        if self.is_pressed(input) {
            self.open(input);
        }
    }

    /// Opens the buttons whose time is over.
    pub fn pass(&mut self, now: Duration) {
        if self.key_up == KeyUp::Guessed {
            let closed = &mut self.closed;
            self.pressed.retain(|&(input, until)| {
                let held = now < until;
                closed.set(input, held);
                held
            });
        }
    }

    fn is_pressed(&self, input: Point) -> bool {
        self.pressed.iter().any(|&(pressed, _)| pressed == input)
    }

    fn close_until(&mut self, input: Point, at: Duration, repeated: bool) {
        let stay = if repeated {
            BETWEEN_REPEATS
        } else {
            BEFORE_REPEATS
        };
        self.open(input);
        self.closed.set(input, true);
        self.pressed.push((input, at + stay));
    }

    fn open(&mut self, input: Point) {
        self.closed.set(input, false);
        self.pressed.retain(|&(pressed, _)| pressed != input);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(number: u8) -> Point {
        Point::new(number, Point::MOST).unwrap()
    }

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    fn momentary(key_up: KeyUp) -> Buttons {
        let mut buttons = Buttons::new(key_up);
        buttons.switch_mode();
        buttons
    }

    #[test]
    fn a_key_toggles_its_input() {
        let mut buttons = Buttons::new(KeyUp::Guessed);
        buttons.press(input(2), ms(0));
        buttons.press(input(4), ms(0));
        buttons.pass(ms(60_000));
        assert_eq!(buttons.closed(), Image(0b1010));
        buttons.release(input(2));
        buttons.repeat(input(2), ms(60_000));
        assert_eq!(buttons.closed(), Image(0b1010));
        buttons.press(input(2), ms(60_000));
        assert_eq!(buttons.closed(), Image(0b1000));
    }

    #[test]
    fn a_held_key_keeps_its_input_closed_until_its_repeats_end() {
        let mut buttons = momentary(KeyUp::Guessed);
        for at in [0, 500, 530, 560, 590] {
            buttons.press(input(1), ms(at));
            buttons.pass(ms(at + 1));
            assert_eq!(buttons.closed(), Image(1), "{at}");
        }
        buttons.pass(ms(889));
        assert_eq!(buttons.closed(), Image(1));
        buttons.pass(ms(890));
        assert_eq!(buttons.closed(), Image(0));
    }

    #[test]
    fn two_inputs_open_each_at_its_own_time() {
        let mut buttons = momentary(KeyUp::Guessed);
        buttons.press(input(1), ms(0));
        buttons.press(input(2), ms(100));
        for (at, closed) in [(599, 0b11), (600, 0b10), (699, 0b10), (700, 0)] {
            buttons.pass(ms(at));
            assert_eq!(buttons.closed(), Image(closed), "{at}");
        }
    }

    #[test]
    fn where_the_terminal_tells_a_release_only_that_opens() {
        let mut buttons = momentary(KeyUp::Told);
        buttons.press(input(3), ms(0));
        buttons.pass(ms(60_000));
        assert_eq!(buttons.closed(), Image(0b100));
        buttons.release(input(3));
        assert_eq!(buttons.closed(), Image(0));
    }

    #[test]
    fn leaving_the_momentary_mode_opens_what_was_held() {
        let mut buttons = Buttons::new(KeyUp::Told);
        buttons.press(input(1), ms(0));
        buttons.switch_mode();
        buttons.press(input(2), ms(0));
        buttons.switch_mode();
        assert_eq!(buttons.closed(), Image(1));
    }
}
