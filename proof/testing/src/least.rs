//! The least random numbers that a test fails with, in place of those that it has found: fewer, then lower ones.
//!
//! A random program is as its author draws it, so less that is drawn is a smaller program, and a right one. That holds for
//! whatever draws: programs, documents, inputs, times.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::env;
use std::panic::{self, AssertUnwindSafe, Location, catch_unwind, resume_unwind};
use std::sync::Once;
use unoclp_random::tape;

/// How often a test that fails is run again, where the environment does not say another number.
const TRIES: usize = 3_000;
/// `cargo xtask mutants` wants to know that a test fails, and no more.
const OTHER_TRIES: &str = "UNOCLP_TRIES";
/// How many times a number is halved in search of its least.
const HALVES: usize = 12;

/// What a test comes to. Where that is an error, it is the one of the least random numbers with which it is one.
///
/// # Errors
/// Those of the test.
pub fn least<T, E>(mut test: impl FnMut() -> Result<T, E>) -> Result<T, E> {
    test().map_err(|found| {
        let mut error = found;
        let (_, first) = tape::record(&mut test);
        let mut fails = |given: &[u64]| {
            let (came, drawn) = tape::play(given.to_vec(), &mut test);
            came.err().map(|why| (why, drawn))
        };
        let mut search = Search {
            best: first,
            tries: tries(),
            fails: |given: &[u64], best: &[u64]| {
                let (why, drawn) = fails(given)?;
                (weight(&drawn) < weight(best)).then(|| {
                    error = why;
                    drawn
                })
            },
        };
        while search.delete() | search.lower() {}
        error
    })
}

fn tries() -> usize {
    env::var(OTHER_TRIES).map_or(TRIES, |tries| tries.parse().expect("a number"))
}

/// Fewer numbers are less, then fewer that are not 0, then lower ones.
fn weight(numbers: &[u64]) -> (usize, usize, &[u64]) {
    let not_0 = numbers.iter().filter(|number| **number != 0).count();
    (numbers.len(), not_0, numbers)
}

/// The same of a test that panics: it panics as it does with the least, at the same place.
///
/// # Panics
/// If the test does.
pub fn held<T>(mut test: impl FnMut() -> T) -> T {
    let place: RefCell<Option<String>> = RefCell::new(None);
    let came = least(|| {
        let found = place.borrow().is_some();
        match caught(found, &mut test) {
            Ok(value) => Ok(Some(value)),
            // Another mistake than the one that was found.
            Err(panic) if place.borrow().as_ref().is_some_and(|at| *at != panic.at) => Ok(None),
            Err(panic) => {
                place.replace(Some(panic.at));
                Err(panic.payload)
            }
        }
    });
    match came {
        Ok(value) => value.expect("the first run has no place to compare"),
        Err(payload) => resume(payload),
    }
}

fn resume(payload: Box<dyn Any + Send>) -> ! {
    let text = payload.downcast_ref::<String>().cloned();
    let text = text.or_else(|| {
        payload
            .downcast_ref::<&str>()
            .map(|text| (*text).to_owned())
    });
    match text {
        Some(text) => panic!("at the least:\n{text}"),
        None => resume_unwind(payload),
    }
}

struct Panic {
    at: String,
    payload: Box<dyn Any + Send>,
}

thread_local! {
    /// Whether panics of this thread are told.
    static QUIET: Cell<bool> = const { Cell::new(false) };
    /// Where the last one was.
    static AT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// What this comes to, or its panic: told or not.
fn caught<T>(quiet: bool, test: impl FnOnce() -> T) -> Result<T, Panic> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            AT.set(info.location().map(Location::to_string).unwrap_or_default());
            if !QUIET.get() {
                usual(info);
            }
        }));
    });
    QUIET.set(quiet);
    let came = catch_unwind(AssertUnwindSafe(test));
    QUIET.set(false);
    came.map_err(|payload| Panic {
        at: AT.take(),
        payload,
    })
}

/// A search from these numbers on. `fails` is given numbers and the best so far, and tells those that the test has drawn
/// if it fails with less.
struct Search<F> {
    best: Vec<u64>,
    tries: usize,
    fails: F,
}

impl<F: FnMut(&[u64], &[u64]) -> Option<Vec<u64>>> Search<F> {
    /// Whether the test fails with these too, which are the best then.
    fn fails(&mut self, given: &[u64]) -> bool {
        let Some(tries) = self.tries.checked_sub(1) else {
            return false;
        };
        self.tries = tries;
        let less = (self.fails)(given, &self.best);
        let found = less.is_some();
        self.best = less.unwrap_or_else(|| std::mem::take(&mut self.best));
        found
    }

    /// Leaves out half of the numbers, a quarter, and so on: the last first.
    fn delete(&mut self) -> bool {
        let mut found = false;
        let mut size = self.best.len() / 2;
        while size > 0 {
            let mut at = self.best.len().saturating_sub(size);
            loop {
                let end = (at + size).min(self.best.len());
                let without = [&self.best[..at], &self.best[end..]].concat();
                found |= self.fails(&without);
                if at == 0 || self.tries == 0 {
                    break;
                }
                at = at.min(self.best.len()).saturating_sub(size);
            }
            size /= 2;
        }
        found
    }

    /// Makes each number as low as it can be alone.
    fn lower(&mut self) -> bool {
        let mut found = false;
        for at in 0.. {
            let Some(&number) = self.best.get(at) else {
                break;
            };
            if number == 0 || self.lowered(at, 0) {
                found |= number != 0;
                continue;
            }
            let (mut low, mut high) = (0, number);
            for _ in 0..HALVES {
                let middle = low + (high - low) / 2;
                match self.lowered(at, middle) {
                    true => (high, found) = (middle, true),
                    false => low = middle,
                }
            }
        }
        found
    }

    fn lowered(&mut self, at: usize, number: u64) -> bool {
        let mut given = self.best.clone();
        let Some(slot) = given.get_mut(at) else {
            return false;
        };
        *slot = number;
        self.fails(&given)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Random, typed_program};

    /// Some numbers below 1000.
    fn numbers(seed: u64) -> Vec<usize> {
        let mut random = Random(seed);
        (0..random.below(100))
            .map(|_| random.below(1_000))
            .collect()
    }

    #[test]
    fn what_is_left_is_what_the_test_fails_with() {
        for seed in 0..20 {
            let test = || {
                let numbers = numbers(seed);
                let large = numbers.iter().filter(|number| **number >= 300).count();
                if large < 3 { Ok(()) } else { Err(numbers) }
            };
            let Err(numbers) = least(test) else { continue };
            assert_eq!(numbers.len(), 3, "seed {seed}");
            assert!(
                numbers.iter().all(|n| (300..310).contains(n)),
                "{numbers:?}"
            );
        }
    }

    #[test]
    fn a_program_comes_down_to_the_statement_that_matters() {
        let takes_root = |seed: u64| {
            let text = typed_program(seed, 12);
            text.contains(":= SQRT(").then_some(text)
        };
        let (seed, found) = (0..)
            .find_map(|seed| Some((seed, takes_root(seed)?)))
            .unwrap();
        let test = || takes_root(seed).map_or(Ok(()), Err);
        let least = least(test).expect_err("it takes a root");
        let [found, least] = [&found, &least].map(|text| {
            let body = text.split_once("PROGRAM main").map(|(_, body)| body);
            body.and_then(|body| body.split_once("END_VAR"))
                .unwrap()
                .1
                .len()
        });
        assert!(least * 3 < found, "{least} of {found} bytes");
    }

    #[test]
    fn a_panic_is_that_of_the_least_at_the_same_place() {
        let test = || {
            let numbers = numbers(3);
            assert!(!numbers.is_empty(), "another mistake");
            assert!(numbers.len() < 5, "{}", numbers.len());
        };
        let told = catch_unwind(|| held(test)).expect_err("more than 5");
        assert_eq!(told.downcast_ref::<String>().unwrap(), "at the least:\n5");
        assert_eq!(held(|| 7), 7);
    }
}
