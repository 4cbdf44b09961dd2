//! The same work on many items, with one thread per processor.
//!
//! Owns how the work is shared. Must not know what is done.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// What `make` makes of each, in their order.
pub fn map<T: Sync, R: Send>(all: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let count = thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicUsize::new(0);
    let (send, made) = mpsc::channel();
    let mut made: Vec<(usize, R)> = thread::scope(|scope| {
        for _ in 0..count.min(all.len()) {
            let (send, next, make) = (send.clone(), &next, &make);
            scope.spawn(move || {
                while let Some((place, one)) = take(all, next) {
                    // Whoever receives waits for all.
                    let _ = send.send((place, make(one)));
                }
            });
        }
        drop(send);
        made.iter().collect()
    });
    made.sort_by_key(|(place, _)| *place);
    made.into_iter().map(|(_, one)| one).collect()
}

/// The next one that nobody has taken.
fn take<'a, T>(all: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    all.get(place).map(|one| (place, one))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_made_once_and_stands_in_its_place() {
        let all: Vec<u32> = (0..1000).collect();
        assert_eq!(
            map(&all, |one| one * 2),
            all.iter().map(|one| one * 2).collect::<Vec<_>>()
        );
        assert_eq!(map(&[0u8; 0], |one| *one), [0u8; 0]);
    }
}
