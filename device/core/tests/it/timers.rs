//! What no scenario can wait for: weeks of a timer's life (NC-9).

use unoclp_core::{Board, Delay, Image, Loader, Plc, Snapshot};

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
fn a_tor_gathers_only_while_it_is_on() {
    with_plc("0\n827301\n847982\n100\n7901\n", |plc| {
        for (input, now, q, elapsed) in [
            (INPUT, 0, 0, 0),
            (NONE, 60, 0, 60),
            (NONE, 500, 0, 60),
            (INPUT, 1000, 0, 60),
            (INPUT, 1039, 0, 99),
            (INPUT, 1040, 1, 100),
            (NONE, 1050, 1, 100),
        ] {
            assert_eq!(plc.scan(input, now).unwrap().0, q, "at {now}");
            assert_eq!(plc.timers(now).next().unwrap().elapsed, elapsed, "at {now}");
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

/// What another board tells: elapsed time, and the state of what the timer drives.
#[test]
fn a_timer_that_is_taken_over_has_the_q_of_its_kind() {
    let cases = [
        ("847978", [(0, 0, 0), (999, 0, 0), (1000, 1, 1)]),
        ("847982", [(0, 0, 0), (999, 0, 0), (1000, 1, 1)]),
        ("847970", [(0, 0, 0), (0, 1, 1), (999, 1, 1)]),
        ("8480", [(0, 0, 0), (999, 1, 1), (1000, 0, 0)]),
    ];
    for (code, cases) in cases {
        for (elapsed, on, q) in cases {
            for target in ["7901", "7701"] {
                with_plc(&format!("0\n827301\n{code}\n1000\n{target}\n"), |plc| {
                    let is_output = target == "7901";
                    let board = Snapshot {
                        outputs: if is_output { Image(on) } else { NONE },
                        markers: if is_output { 0 } else { on },
                        timers: &[(elapsed, 1000)],
                        ..Snapshot::default()
                    };
                    plc.adopt(&board, 5_000);
                    let timer = plc.timers(5_000).next().unwrap();
                    let seen = (timer.elapsed, timer.preset, u128::from(timer.q));
                    assert_eq!(seen, (elapsed, 1000, q), "{code} {target} {on}");
                });
            }
        }
    }
}
