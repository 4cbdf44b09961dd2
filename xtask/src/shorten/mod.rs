//! Makes the firmware's assembly shorter, between the compiler and the assembler.

pub mod assembly;
pub mod body;
mod copies;
pub mod effects;
pub mod frame;
mod jumps;
pub mod link;
mod liveness;
mod order;
mod parts;
mod reach;
mod saves;
mod tails;

use assembly::{Line, Unit};

/// Shortens assembly. The same text always gives the same.
pub fn shorten(text: &str) -> String {
    let mut unit = Unit::parse(text);
    let size = |unit: &Unit| -> usize {
        unit.functions()
            .flat_map(|f| f.body.iter().filter_map(Line::instruction))
            .map(effects::bytes)
            .sum()
    };
    eprintln!("start {}", size(&unit));
    for f in unit.functions() {
        if !frame::is_understood(f) {
            eprintln!("not understood: {}", f.name);
        }
    }
    if std::env::var("ST").map_or(true, |v| v.contains('c')) {copies::drop_superfluous(&mut unit);}
    eprintln!("copies {}", size(&unit));
    let on = |c| std::env::var("ST").map_or(true, |v| v.contains(c));
    if on('s') { saves::share(&mut unit); }
    eprintln!("saves {}", size(&unit));
    if on('j') {jumps::shorten(&mut unit);}
    eprintln!("jumps {}", size(&unit));
    let mut tails = 0;
    let mut parts = 0;
    while on('t') && tails::merge(&mut unit, &mut tails) {
        eprintln!("tails {}", size(&unit));
        jumps::shorten(&mut unit);
        eprintln!("jumps {}", size(&unit));
    }
    while on('p') && parts::take_out(&mut unit, &mut parts) {
        eprintln!("parts {}", size(&unit));
        jumps::shorten(&mut unit);
        eprintln!("jumps {}", size(&unit));
        tails::merge(&mut unit, &mut tails);
        jumps::shorten(&mut unit);
        eprintln!("tails {}", size(&unit));
    }
    reach::mend(&mut unit);
    eprintln!("reach {}", size(&unit));
    order::arrange(&mut unit);
    unit.to_string()
}
