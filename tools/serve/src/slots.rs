//! Slots, shared out among the addresses that they are taken from: whoever has many makes room for whoever has few.

use std::cmp::Reverse;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::watch;

/// So many slots.
#[derive(Clone, Debug)]
pub(crate) struct Slots {
    /// At a time,
    total: usize,
    /// and of one address.
    each: usize,
    table: Arc<Mutex<Table>>,
}

#[derive(Debug, Default)]
struct Table {
    /// The number of the next slot, or of its next use.
    next: u64,
    taken: Vec<Taken>,
}

#[derive(Debug)]
struct Taken {
    number: u64,
    network: IpAddr,
    /// The number of its last use.
    used: u64,
    /// With it the slot learns that it is taken away.
    _keeps: watch::Sender<()>,
}

/// A slot, until it is dropped.
#[derive(Debug)]
pub(crate) struct Slot {
    number: u64,
    kept: watch::Receiver<()>,
    table: Arc<Mutex<Table>>,
}

impl Slots {
    /// So many, and so many of one address.
    pub fn new(total: usize, each: usize) -> Slots {
        Slots {
            total,
            each,
            table: Arc::default(),
        }
    }

    /// A slot for this address. Where all are taken, the address that has the most gives up the one that was used longest
    /// ago; where this address has its share, it gives up its own.
    pub fn take(&self, address: IpAddr) -> Slot {
        let network = network(address);
        let mut table = lock(&self.table);
        if table.count(network) >= self.each {
            table.give_up(|taken| taken.network == network);
        } else if table.taken.len() >= self.total {
            table.give_up(|_| true);
        }
        self.enter(table, network)
    }

    /// The same, but nothing where all are taken, and no address has more than this one would have.
    pub fn ask(&self, address: IpAddr) -> Option<Slot> {
        let network = network(address);
        let mut table = lock(&self.table);
        let own = table.count(network);
        if own >= self.each {
            return None;
        }
        if table.taken.len() >= self.total {
            let counts = table.taken.iter().map(|taken| table.count(taken.network));
            if counts.max() <= Some(own + 1) {
                return None;
            }
            table.give_up(|_| true);
        }
        Some(self.enter(table, network))
    }

    fn enter(&self, mut table: MutexGuard<'_, Table>, network: IpAddr) -> Slot {
        let number = table.number();
        let (keeps, kept) = watch::channel(());
        table.taken.push(Taken {
            number,
            network,
            used: number,
            _keeps: keeps,
        });
        let table = self.table.clone();
        Slot {
            number,
            kept,
            table,
        }
    }
}

impl Slot {
    /// It is used now: it is not the next one to be given up.
    pub fn is_used(&self) {
        let mut table = lock(&self.table);
        let used = table.number();
        let own = |taken: &&mut Taken| taken.number == self.number;
        if let Some(taken) = table.taken.iter_mut().find(own) {
            taken.used = used;
        }
    }

    /// Waits until it is given up for another.
    pub async fn is_given_up(&self) {
        // Nothing is ever sent: it ends with the other side.
        while self.kept.clone().changed().await.is_ok() {}
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let number = self.number;
        lock(&self.table)
            .taken
            .retain(|taken| taken.number != number);
    }
}

impl Table {
    fn number(&mut self) -> u64 {
        self.next += 1;
        self.next
    }

    fn count(&self, network: IpAddr) -> usize {
        let same = |taken: &&Taken| taken.network == network;
        self.taken.iter().filter(same).count()
    }

    /// Gives up one of these: of the address that has the most, the one that was used longest ago.
    fn give_up(&mut self, may: impl Fn(&Taken) -> bool) {
        let candidates = self.taken.iter().filter(|taken| may(taken));
        let last = candidates.max_by_key(|taken| (self.count(taken.network), Reverse(taken.used)));
        if let Some(number) = last.map(|taken| taken.number) {
            self.taken.retain(|taken| taken.number != number);
        }
    }
}

fn lock(table: &Mutex<Table>) -> MutexGuard<'_, Table> {
    table.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What counts as one address: of IPv6 one network, since each host there has as many addresses as it likes.
pub(crate) fn network(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(address) => Ipv6Addr::from_bits(address.to_bits() >> 64 << 64).into(),
        address => address,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Ipv4Addr;

    fn of(host: u8) -> IpAddr {
        Ipv4Addr::new(10, 0, 0, host).into()
    }

    /// Whether each slot is still kept.
    fn kept(slots: &[Slot]) -> Vec<bool> {
        let is_kept = |slot: &Slot| slot.kept.has_changed().is_ok();
        slots.iter().map(is_kept).collect()
    }

    #[test]
    fn who_has_many_makes_room_for_who_has_few() {
        let slots = Slots::new(4, 3);
        let mut taken: Vec<Slot> = [1, 2, 2, 2].map(|host| slots.take(of(host))).into();
        // The second is used, so the third makes room.
        taken[1].is_used();
        taken.push(slots.take(of(3)));
        assert_eq!(kept(&taken), [true, true, false, true, true]);
        // It has its share, and room is not what it lacks.
        taken.push(slots.take(of(2)));
        assert_eq!(kept(&taken), [true, true, false, false, true, true]);
        drop(taken.remove(0));
        taken.push(slots.take(of(2)));
        taken.push(slots.take(of(2)));
        assert_eq!(kept(&taken), [false, false, false, true, true, true, true]);
        assert_eq!(lock(&slots.table).taken.len(), 4);
    }

    #[test]
    fn who_asks_gets_none_of_those_who_have_no_more() {
        let slots = Slots::new(4, 3);
        let mut taken: Vec<Slot> = [1, 2, 2, 2].map(|host| slots.ask(of(host)).unwrap()).into();
        assert!(slots.ask(of(2)).is_none());
        taken.push(slots.ask(of(3)).unwrap());
        assert_eq!(kept(&taken), [true, false, true, true, true]);
        // Two of one address, and one of each other.
        taken.push(slots.ask(of(4)).unwrap());
        assert_eq!(kept(&taken), [true, false, false, true, true, true]);
        assert!(slots.ask(of(5)).is_none());
        taken.clear();
        assert!(slots.ask(of(5)).is_some());
    }

    #[test]
    fn a_network_of_ipv6_is_one_address() {
        for (one, other, same) in [
            ("2001:db8::1", "2001:db8::ffff:1", true),
            ("2001:db8::1", "2001:db8:0:1::1", false),
            ("::ffff:10.0.0.1", "10.0.0.1", true),
            ("::ffff:10.0.0.1", "::ffff:10.0.0.2", false),
        ] {
            let [a, b] = [one, other].map(|address| network(address.parse().unwrap()));
            assert_eq!(a == b, same, "{one} {other}");
        }
    }
}
