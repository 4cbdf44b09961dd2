//! How often somebody may try a token that was not right before.

use crate::slots::network;
use std::collections::BTreeMap;
use std::net::IpAddr;
use std::time::{Duration, Instant};

/// So many tries from one address,
const TRIES: u32 = 5;
/// within this time.
const WITHIN: Duration = Duration::from_secs(60);
/// Addresses that are remembered. Of more, the one that began longest ago is forgotten.
const ADDRESSES: usize = 1_000;

/// The tries of each address, and when the first of them was.
#[derive(Debug, Default)]
pub(crate) struct Tries(BTreeMap<IpAddr, (u32, Instant)>);

impl Tries {
    /// Whether this address may try once more; that counts.
    pub fn may_try(&mut self, from: IpAddr, now: Instant) -> bool {
        self.0
            .retain(|_, (_, first)| now.saturating_duration_since(*first) < WITHIN);
        let from = network(from);
        if self.0.len() >= ADDRESSES && !self.0.contains_key(&from) {
            let oldest = self.0.iter().min_by_key(|(_, (_, first))| *first);
            if let Some(oldest) = oldest.map(|(address, _)| *address) {
                self.0.remove(&oldest);
            }
        }
        let (count, _) = self.0.entry(from).or_insert((0, now));
        *count += 1;
        *count <= TRIES
    }

    /// The last try of this address was right: it begins anew.
    pub fn was_right(&mut self, from: IpAddr) {
        self.0.remove(&network(from));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_may_try_a_few_times_a_minute() {
        let mut tries = Tries::default();
        let begin = Instant::now();
        let at = |seconds| begin + Duration::from_secs(seconds);
        let [one, other] = ["10.0.0.7", "10.0.0.8"].map(|of| of.parse().unwrap());
        for _ in 0..TRIES {
            assert!(tries.may_try(one, at(0)));
        }
        assert!(!tries.may_try(one, at(59)));
        assert!(tries.may_try(other, at(59)));
        assert!(tries.may_try(one, at(60)));
        for _ in 0..TRIES - 1 {
            tries.may_try(one, at(61));
        }
        tries.was_right(one);
        assert!(tries.may_try(one, at(62)));
        // Whoever has a network of IPv6 has one address here.
        for host in 0..TRIES {
            let of = format!("2001:db8::{host:x}").parse().unwrap();
            assert!(tries.may_try(of, at(70)));
        }
        assert!(!tries.may_try("2001:db8::99".parse().unwrap(), at(70)));
    }

    #[test]
    fn so_many_addresses_are_remembered_and_no_more() {
        let mut tries = Tries::default();
        let begin = Instant::now();
        for number in 0..3_000_u32 {
            let of = std::net::Ipv4Addr::from_bits(number).into();
            assert!(tries.may_try(of, begin + Duration::from_millis(number.into())));
        }
        assert_eq!(tries.0.len(), ADDRESSES);
    }
}
