//! What no scenario can wait for: weeks of a timer's life (NC-9).

use unoclp_core::{Board, Delay, Image, Loader, Plc};

const INPUT: Image = Image(1);
const NONE: Image = Image(0);

fn with_plc(codes: &str, test: impl FnOnce(&mut Plc<'_>)) {
    let mut memory = [0; 100];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    for byte in codes.bytes() {
        loader.push(byte).unwrap();
    }
    test(&mut Plc::new(loader.finish().unwrap()));
}

#[test]
fn a_ton_held_for_longer_than_the_counter_stays_done() {
    with_plc("0\n827301\n847978\n1000\n7901\n", |plc| {
        let mut now = 0u32;
        plc.scan(INPUT, now).unwrap();
        // Three wraps of the counter in steps of 11.6 days, and some that land close to the start.
        for step in [
            1000,
            1_000_000_000,
            1_000_000_000,
            1_000_000_000,
            1_294_966_300,
            5,
        ] {
            now = now.wrapping_add(step);
            assert_eq!(plc.scan(INPUT, now).unwrap().0, 1, "at {now}");
        }
        assert_eq!(plc.scan(NONE, now).unwrap().0, 0);
        assert_eq!(plc.scan(INPUT, now.wrapping_add(1)).unwrap().0, 0);
    });
}

#[test]
fn a_tof_that_is_over_stays_over() {
    with_plc("0\n827301\n847970\n1000\n7901\n", |plc| {
        assert_eq!(plc.scan(INPUT, 0).unwrap().0, 1);
        assert_eq!(plc.scan(NONE, 10).unwrap().0, 1);
        assert_eq!(plc.scan(NONE, 1010).unwrap().0, 0);
        for now in [0, 9, 500, 1009, 1010, u32::MAX] {
            assert_eq!(plc.scan(NONE, now).unwrap().0, 0, "at {now}");
        }
    });
}

#[test]
fn the_longest_preset_is_exact() {
    let longest = i32::MAX as u32;
    for start in [0, 1, u32::MAX - 5, u32::MAX / 2] {
        with_plc("0\n827301\n847978\n2147483647\n7901\n", |plc| {
            plc.scan(INPUT, start).unwrap();
            assert_eq!(
                plc.scan(INPUT, start.wrapping_add(longest - 1)).unwrap().0,
                0
            );
            assert_eq!(plc.scan(INPUT, start.wrapping_add(longest)).unwrap().0, 1);
        });
    }
}

#[test]
fn the_state_of_a_timer_can_be_watched() {
    with_plc(
        "0\n827301\n847978\n100\n7901\n787600\n827301\n847970\n50\n7902\n",
        |plc| {
            let mut watch = |inputs, now| -> Vec<(Delay, u32, bool)> {
                plc.scan(inputs, now).unwrap();
                plc.timers(now).map(|t| (t.delay, t.elapsed, t.q)).collect()
            };
            assert_eq!(
                watch(NONE, 0),
                [(Delay::On, 0, false), (Delay::Off, 0, false)]
            );
            assert_eq!(
                watch(INPUT, 10),
                [(Delay::On, 0, false), (Delay::Off, 0, true)]
            );
            assert_eq!(
                watch(INPUT, 60),
                [(Delay::On, 50, false), (Delay::Off, 0, true)]
            );
            assert_eq!(
                watch(INPUT, 200),
                [(Delay::On, 100, true), (Delay::Off, 0, true)]
            );
            assert_eq!(
                watch(NONE, 210),
                [(Delay::On, 0, false), (Delay::Off, 0, true)]
            );
            assert_eq!(
                watch(NONE, 230),
                [(Delay::On, 0, false), (Delay::Off, 20, true)]
            );
            assert_eq!(
                watch(NONE, 260),
                [(Delay::On, 0, false), (Delay::Off, 0, false)]
            );
        },
    );
}
