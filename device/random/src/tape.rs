//! A tape of the random numbers that a thread draws: what was drawn is drawn again, or less of it.

use core::cell::RefCell;
use std::vec::Vec;

std::thread_local! {
    static TAPE: RefCell<Option<Tape>> = const { RefCell::new(None) };
}

struct Tape {
    /// What is drawn first, from whichever state.
    given: Vec<u64>,
    drawn: Vec<u64>,
}

/// After what is given come so many zeros: of most that is drawn 0 is the simplest. Who waits for another number gets its own
/// then.
const ZEROS: usize = 1_000;

/// Runs this with these numbers in place of the first that it draws on this thread, whatever its seeds are. With it come
/// the numbers that it has drawn.
///
/// It must not panic, or the tape stays.
pub fn play<T>(mut given: Vec<u64>, run: impl FnOnce() -> T) -> (T, Vec<u64>) {
    given.resize(given.len() + ZEROS, 0);
    during(given, run)
}

/// Runs this with its own numbers. With it come those that it has drawn.
///
/// It must not panic, or the tape stays.
pub fn record<T>(run: impl FnOnce() -> T) -> (T, Vec<u64>) {
    during(Vec::new(), run)
}

fn during<T>(given: Vec<u64>, run: impl FnOnce() -> T) -> (T, Vec<u64>) {
    let drawn = Vec::new();
    TAPE.set(Some(Tape { given, drawn }));
    let came = run();
    let tape = TAPE.take();
    (came, tape.map_or_else(Vec::new, |tape| tape.drawn))
}

/// The next number, where the state itself comes to this one.
pub(crate) fn next(own: u64) -> u64 {
    TAPE.with_borrow_mut(|tape| {
        let Some(tape) = tape else {
            return own;
        };
        let number = tape.given.get(tape.drawn.len()).copied().unwrap_or(own);
        tape.drawn.push(number);
        number
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits;

    #[test]
    fn what_is_given_comes_first_then_zeros_then_its_own() {
        let draw = || {
            let mut states = [7, 8];
            [(); 2_000].map(|()| states.each_mut().map(bits))
        };
        let (own, drawn) = record(draw);
        assert_eq!(drawn, own.as_flattened());
        let (came, drawn) = play(Vec::from([1, 2, 3]), draw);
        assert_eq!(drawn, came.as_flattened());
        assert_eq!(drawn[..5], [1, 2, 3, 0, 0]);
        assert_eq!(drawn[ZEROS + 3..], own.as_flattened()[ZEROS + 3..]);
        assert_eq!(draw(), own, "the tape is gone");
    }
}
