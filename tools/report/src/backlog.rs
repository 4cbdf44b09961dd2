//! What waits in memory, in order; of too much, the oldest goes, and is counted.

use std::collections::VecDeque;

/// Samples that wait at most.
pub(crate) const MOST: usize = 100_000;

/// What waits.
#[derive(Debug)]
pub(crate) struct Backlog<T> {
    waiting: VecDeque<T>,
    most: usize,
    dropped: u64,
}

impl<T> Backlog<T> {
    /// Nothing waits; at most so many will.
    pub fn new(most: usize) -> Backlog<T> {
        Backlog {
            waiting: VecDeque::new(),
            most,
            dropped: 0,
        }
    }

    /// This waits too, after all others.
    pub fn push(&mut self, item: T) {
        if self.waiting.len() >= self.most && self.waiting.pop_front().is_some() {
            self.dropped += 1;
        }
        self.waiting.push_back(item);
    }

    /// The one that has waited longest.
    pub fn pop(&mut self) -> Option<T> {
        self.waiting.pop_front()
    }

    /// One that will not be sent is given up.
    pub fn give_up(&mut self) {
        self.dropped += 1;
    }

    /// How many wait.
    pub fn len(&self) -> usize {
        self.waiting.len()
    }

    /// How many were given up.
    pub fn dropped(&self) -> u64 {
        self.dropped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_too_much_the_oldest_goes_and_is_counted() {
        let mut backlog = Backlog::new(3);
        (0..5).for_each(|number| backlog.push(number));
        assert_eq!((backlog.len(), backlog.dropped()), (3, 2));
        backlog.give_up();
        assert_eq!((backlog.len(), backlog.dropped()), (3, 3));
        let all: Vec<_> = std::iter::from_fn(|| backlog.pop()).collect();
        assert_eq!(all, [2, 3, 4]);
    }
}
