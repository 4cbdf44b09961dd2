//! The live ladder's readings of the firmware, on the board's own time: how many a second a line of 115,200 baud carries.

use crate::common::line::{meet, talk};
use crate::common::{card, uno};
use std::fmt::Write;
use std::time::Duration;
use unoclp_client::live::{Live, Parts};
use unoclp_client::watch::Scope;
use unoclp_uno_sim::Slot;

/// Fifty rungs of four contacts: inputs, outputs and markers.
fn two_hundred_contacts() -> String {
    let mut text = "0\n".to_owned();
    for rung in 0..50 {
        let (input, output) = (rung % 4 + 1, rung % 3 + 1);
        let [near, far, coil] = [1, 4, 8].map(|by| (rung + by) % 60 + 1);
        write!(
            text,
            "787600\n8273{input:02}\n-8277{near:02}\n8277{far:02}\n8279{output:02}\n8777{coil:02}\n"
        )
        .unwrap();
    }
    text
}

#[test]
fn two_hundred_live_contacts_are_read_25_times_a_second() {
    let mut uno = uno(Slot::Card(card(&two_hundred_contacts())));
    meet(&mut uno);
    let parts = Parts {
        markers: true,
        ..Parts::default()
    };
    let mut begins: Vec<Duration> = Vec::new();
    let mut uptime = 0;
    let mut live = Live::default();
    for _ in 0..45 {
        let reading = talk(&mut uno, async |client| {
            let reading = live.round(client, Scope::default(), parts).await?.clone();
            live.pause(client, || false).await?;
            Ok::<_, unoclp_client::Failure>(reading)
        });
        let now = reading.unwrap().diagnostics.uptime;
        begins.push(Duration::from_millis((now - uptime).into()));
        uptime = now;
    }
    // The first is of everything, and the time before it is that of the start.
    let gaps = &begins[2..];
    let most = *gaps.iter().max().unwrap();
    let mean = gaps.iter().sum::<Duration>() / gaps.len() as u32;
    assert!(mean <= Duration::from_millis(40), "{mean:?}");
    assert!(most <= Duration::from_millis(50), "{most:?}");
}
