//! What carries things. A thing on a belt has a place, a nature and a filling; where a nature is 0, nothing is.

use crate::kind::{
    COUNT, DAMAGE, FLAG, Fault, Form, HAND, Limit, SHARE, Slot, inner, kind, number,
};
use crate::moment::Moment;
use crate::unit::Unit;

/// A belt carries no more things.
pub(crate) const MOST: usize = 12;
/// How long a thing is, mm.
pub(crate) const LONG: i32 = 80;

const BELTS: &[&str] = &["belt"];

/// The bits of a thing's nature.
pub(crate) const THING: i32 = 1;
pub(crate) const METAL: i32 = 2;
pub(crate) const TALL: i32 = 4;
pub(crate) const BOTTLE: i32 = 8;

pub(crate) mod bin {
    use super::*;
    kind! {
        "bin" Transport "A bin that counts what falls into it" "Uma caixa que conta o que cai nela"
        [110, 90];
        fields { wants: Form::Choice(&["any", "metal", "plastic", "tall", "short", "full", "tall plastic", "short plastic"]), "what belongs in it; `full` is a bottle filled to 90% or more" "o que deve cair nela; `full` é uma garrafa cheia pelo menos até 90%"; }
        values {
            count: COUNT, "how many items have fallen into it" "quantas peças caíram nela";
            right: COUNT, "how many items in it belong there" "quantas peças caíram nela corretamente";
            wrong: COUNT, "how many items in it do not belong there" "quantas peças caíram nela por engano";
        }
        faults { }
    }
    pub(crate) fn step(_: &mut Moment<'_>) {}

    /// A thing falls into a bin.
    pub(crate) fn take(m: &mut Moment<'_>, bin: usize, nature: i32, fill: i32) {
        let is_right = match m.number_of(bin, F::wants) {
            1 => nature & METAL != 0,
            2 => nature & METAL == 0,
            3 => nature & TALL != 0,
            4 => nature & TALL == 0,
            5 => fill >= 900,
            6 => nature & (METAL | TALL) == TALL,
            7 => nature & (METAL | TALL) == 0,
            _ => true,
        };
        m.add_of(bin, V::count, 1);
        m.add_of(bin, if is_right { V::right } else { V::wrong }, 1);
    }
}

pub(crate) mod belt {
    use super::*;
    kind! {
        "belt" Transport "A conveyor belt; at its end, items move onto the next belt, fall into a bin, or fall on the floor" "Uma esteira; no fim dela, as peças passam para a próxima esteira, caem em uma caixa ou caem no chão"
        [320, 80];
        fields {
            run: Form::Duty, "what drives it" "o que a aciona";
            onto: Form::MayPart(&["belt", "bin"]), "the belt or bin at its end" "a esteira ou a caixa no fim dela";
            long: Form::Number(Unit::Mm, 200, 20_000, 2000), "its length" "o comprimento";
            speed: Form::Number(Unit::MmPerS, 10, 3000, 300), "its speed" "a velocidade";
            run_up: Form::Number(Unit::Ms, 1, 20_000, 200), "how long it takes to reach full speed" "quanto tempo leva para atingir a velocidade plena";
        }
        values {
            runs: FLAG, "whether it is moving" "se está em movimento";
            items: number(Unit::Count, 0, MOST as i32), "how many items are on it" "quantas peças estão nela";
            jammed: DAMAGE, "whether items have piled up on it" "se há peças acumuladas nela";
            fallen: COUNT, "how many items have fallen on the floor" "quantas peças caíram no chão";
            way: number(Unit::Mm, 0, 1_000_000_000), "how far it has moved" "quanto já andou";
            pace: inner(0, 1000), "its speed, as a share of full speed" "a fração da velocidade plena";
            rise: inner(0, 1_000_000), "its speed in small steps" "a velocidade em passos pequenos";
            rest: inner(0, 999_999), "how far it has moved beyond a whole millimetre" "quanto andou além de um milímetro inteiro";
            place: Slot { count: MOST, ..inner(0, 20_000_000) }, "where each thing is, µm" "onde está cada peça, µm";
            nature: Slot { count: MOST, ..inner(0, 15) }, "what each thing is" "o que é cada peça";
            fill: Slot { count: MOST, ..inner(0, 1200) }, "how full each thing is" "quanto está cheia cada peça";
        }
        faults { Jammed Slow Open Stuck }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let mut to = if m.fails(Fault::Open) {
            0
        } else {
            m.duty(F::run) * 1000
        };
        if m.fails(Fault::Stuck) && m.get(V::rise) > 0 {
            to = 1_000_000;
        }
        let by = (1_000_000 / m.number(F::run_up)).max(1);
        m.approach(V::rise, to, by);
        if m.fails(Fault::Jammed) {
            m.set(V::rise, 0);
        }
        m.set(V::pace, m.get(V::rise) / 1000 / m.drag());
        let moved = m.number(F::speed) * m.get(V::pace) / 1000;
        m.put(V::runs, moved > 0);
        let rest = m.get(V::rest) + moved;
        m.add(V::way, rest / 1000);
        m.set(V::rest, rest % 1000);
        let long = m.number(F::long) * 1000;
        let mut items = 0;
        for at in 0..MOST {
            let nature = m.row(V::nature, at);
            if nature == 0 {
                continue;
            }
            items += 1;
            let place = m.row(V::place, at) + moved;
            m.set_row(V::place, at, place);
            if place < long {
                continue;
            }
            let fill = m.row(V::fill, at);
            match m.other(F::onto) {
                Some(belt) if m.is_kind(belt, "belt") => {
                    if !lay(m, belt, nature, fill) {
                        // It stands at the end, and what comes after it piles up.
                        m.set_row(V::place, at, long);
                        m.put(V::jammed, true);
                        continue;
                    }
                }
                Some(bin) => bin::take(m, bin, nature, fill),
                None => m.add(V::fallen, 1),
            }
            m.set_row(V::nature, at, 0);
            items -= 1;
        }
        m.set(V::items, items);
    }

    /// Lays a thing at the beginning of a belt, and tells whether there was room.
    pub(crate) fn lay(m: &mut Moment<'_>, belt: usize, nature: i32, fill: i32) -> bool {
        let mut free = None;
        for at in 0..MOST {
            match m.row_of(belt, V::nature, at) {
                0 => free = free.or(Some(at)),
                _ if m.row_of(belt, V::place, at) < LONG * 1000 => return false,
                _ => {}
            }
        }
        let Some(at) = free else {
            return false;
        };
        m.set_row_of(belt, V::nature, at, nature);
        m.set_row_of(belt, V::place, at, 0);
        m.set_row_of(belt, V::fill, at, fill);
        true
    }

    /// The thing whose middle is no further than half its length from this place, mm.
    pub(crate) fn thing(m: &Moment<'_>, belt: usize, place: i32) -> Option<usize> {
        (0..MOST).find(|at| {
            let off = m.row_of(belt, V::place, *at) - place * 1000;
            m.row_of(belt, V::nature, *at) != 0 && off.abs() <= LONG * 500
        })
    }
}

pub(crate) mod feeder {
    use super::*;
    kind! {
        "feeder" Transport "A feeder: it puts items on a belt while the belt runs" "Um alimentador: põe peças em uma esteira enquanto ela anda"
        [90, 90];
        fields {
            onto: Form::Part(BELTS), "the belt" "a esteira";
            every: Form::Number(Unit::Mm, 100, 10_000, 400), "the minimum distance between items; a random extra of up to a fifth is added" "a distância mínima entre as peças; soma-se um acréscimo aleatório de até um quinto";
            things: Form::Choice(&["boxes", "mixed", "bottles"]), "what it feeds; `mixed` means tall and short items of metal and plastic, in random order" "o que ele põe; `mixed` são peças altas e baixas, de metal e de plástico, em ordem aleatória";
            most: Form::Number(Unit::Count, 0, 1_000_000, 1_000_000), "how many items it has" "quantas peças ele tem";
        }
        values {
            made: COUNT, "how many items it has fed" "quantas peças ele já pôs";
            closed: HAND, "whether somebody holds it closed" "se alguém o mantém fechado";
            next: inner(0, 1_000_000_000), "how far the belt has moved when the next thing comes" "quanto a esteira terá andado na próxima peça";
        }
        faults { Jammed }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let Some(belt) = m.other(F::onto) else {
            return;
        };
        let way = m.of(belt, belt::V::way);
        let is_due = way >= m.get(V::next) && m.of(belt, belt::V::runs) != 0;
        if !is_due
            || m.is(V::closed)
            || m.fails(Fault::Jammed)
            || m.get(V::made) >= m.number(F::most)
        {
            return;
        }
        let nature = match m.number(F::things) {
            1 => THING | (m.chance(4) * METAL),
            2 => THING | BOTTLE,
            _ => THING,
        };
        if belt::lay(m, belt, nature, 0) {
            m.add(V::made, 1);
            // A fifth more or less, by chance.
            let every = m.number(F::every);
            let more = m.chance(every / 5 + 1);
            m.set(V::next, way.saturating_add(every + more));
        }
    }
}

/// Whether what a sensor stands for is before it.
fn sees(m: &Moment<'_>, belt: Option<usize>, place: i32, mask: i32) -> bool {
    let Some(belt) = belt else {
        return false;
    };
    let thing = belt::thing(m, belt, place);
    thing.is_some_and(|at| m.row_of(belt, belt::V::nature, at) & mask != 0)
}

macro_rules! sensor {
    ($module:ident $name:literal $en:literal $pt:literal $mask:expr) => {
        pub(crate) mod $module {
            use super::*;
            kind! {
                $name Transport $en $pt
                [40, 70];
                fields {
                    of: Form::Part(BELTS), "its belt" "a esteira";
                    place: Form::Number(Unit::Mm, 0, 20_000, 1000), "its position along the belt" "a posição ao longo da esteira";
                    to: Form::Sense, "the input that it switches" "a entrada que ele aciona";
                }
                values { sees: FLAG, "whether it detects something" "se detecta algo"; }
                faults { Stuck Open Short Bouncing }
            }
            pub(crate) fn step(m: &mut Moment<'_>) {
                if !m.fails(Fault::Stuck) {
                    let sees = sees(m, m.other(F::of), m.number(F::place), $mask);
                    m.put(V::sees, sees);
                }
                m.sense(F::to, m.is(V::sees));
            }
        }
    };
}

sensor! { eye "eye" "A photo-eye beside a belt" "Um sensor óptico ao lado de uma esteira" THING }
sensor! { inductive "inductive" "An inductive sensor: it detects only metal" "Um sensor indutivo: só detecta metal" METAL }
sensor! { height "height" "A photo-eye above a belt: it detects only tall items" "Um sensor óptico acima de uma esteira: só detecta peças altas" TALL }

pub(crate) mod pusher {
    use super::*;
    kind! {
        "pusher" Transport "A pusher: it pushes items from a belt into a bin" "Um empurrador: empurra peças de uma esteira para uma caixa"
        [60, 110];
        fields {
            by: Form::Drive, "what extends it; a spring retracts it" "o que o avança; uma mola o recua";
            of: Form::Part(BELTS), "the belt" "a esteira";
            place: Form::Number(Unit::Mm, 0, 20_000, 1000), "its position along the belt" "a posição ao longo da esteira";
            into: Form::Part(&["bin"]), "the bin" "a caixa";
            takes: Form::Number(Unit::Ms, 50, 10_000, 250), "how long it takes to extend" "quanto tempo leva para avançar";
            is_in: Form::Sense, "the input of its retracted limit switch" "a entrada do fim de curso de recuo";
            is_out: Form::Sense, "the input of its extended limit switch" "a entrada do fim de curso de avanço";
        }
        values {
            position: SHARE, "how far it is extended" "quanto está avançado";
            at_home: Slot { first: Limit::Is(1), ..FLAG }, "whether it is fully retracted" "se está totalmente recuado";
            out: FLAG, "whether it is fully extended" "se está totalmente avançado";
            hits: DAMAGE, "whether something has run into it while it was extended" "se algo bateu nele enquanto estava avançado";
            fine: inner(0, 1_000_000), "its position in small steps" "a posição em passos pequenos";
            alone: inner(0, 1), "whether its way was free when it set out" "se o caminho estava livre ao avançar";
        }
        faults { Stuck Slow }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let before = m.get(V::fine);
        if !m.fails(Fault::Stuck) {
            let to = if m.drive(F::by) { 1_000_000 } else { 0 };
            let by = (1_000_000 / (m.number(F::takes) * m.drag()).max(1)).max(1);
            m.approach(V::fine, to, by);
        }
        let fine = m.get(V::fine);
        m.set(V::position, fine / 1000);
        m.put(V::at_home, fine == 0);
        m.put(V::out, fine == 1_000_000);
        m.sense(F::is_in, fine <= 20_000);
        m.sense(F::is_out, fine >= 980_000);
        let (Some(belt), Some(bin)) = (m.other(F::of), m.other(F::into)) else {
            return;
        };
        let thing = belt::thing(m, belt, m.number(F::place));
        let crosses = before < 500_000 && fine >= 500_000;
        match thing {
            Some(at) if crosses => {
                let nature = m.row_of(belt, belt::V::nature, at);
                let fill = m.row_of(belt, belt::V::fill, at);
                m.set_row_of(belt, belt::V::nature, at, 0);
                bin::take(m, bin, nature, fill);
            }
            Some(_) if fine >= 500_000 => m.put(V::hits, true),
            _ => {}
        }
    }
}

pub(crate) mod filler {
    use super::*;
    kind! {
        "filler" Transport "A filler: it pours into the bottle below it, or onto the belt" "Um bico de enchimento: despeja na garrafa abaixo dele, ou na esteira"
        [70, 110];
        fields {
            by: Form::Drive, "what opens it" "o que o abre";
            of: Form::Part(BELTS), "the belt" "a esteira";
            place: Form::Number(Unit::Mm, 0, 20_000, 1000), "its position along the belt" "a posição ao longo da esteira";
            takes: Form::Number(Unit::Ms, 100, 60_000, 2000), "how long it takes to fill a bottle" "quanto tempo leva para encher uma garrafa";
        }
        values {
            pours: FLAG, "whether it is pouring" "se está despejando";
            spills: FLAG, "whether it is pouring outside a bottle, or into a full one" "se está despejando fora de uma garrafa, ou em uma cheia";
            spilt: number(Unit::Ms, 0, 3_600_000), "how long it has poured outside a bottle, or into a full one" "por quanto tempo despejou fora de uma garrafa ou em uma cheia";
            fine: inner(0, 1_000_000), "what it has poured, in small steps" "o que despejou, em passos pequenos";
        }
        faults { Stuck Leaking Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if !m.fails(Fault::Stuck) {
            let pours = m.drive(F::by) && !m.fails(Fault::Open);
            m.put(V::pours, pours);
        }
        let mut amount = if m.is(V::pours) {
            1_000_000 / m.number(F::takes)
        } else {
            0
        };
        if m.fails(Fault::Leaking) {
            amount = amount.max(100_000 / m.number(F::takes));
        }
        m.put(V::spills, false);
        if amount == 0 {
            return;
        }
        m.add(V::fine, amount);
        let steps = m.get(V::fine) / 1000;
        m.set(V::fine, m.get(V::fine) % 1000);
        let belt = m.other(F::of);
        let thing = belt.and_then(|belt| Some((belt, belt::thing(m, belt, m.number(F::place))?)));
        let mut spills = thing.is_none();
        if let Some((belt, at)) = thing {
            let fill = m.row_of(belt, belt::V::fill, at) + steps;
            m.set_row_of(belt, belt::V::fill, at, fill);
            spills = fill > 1000;
        }
        m.put(V::spills, spills);
        if spills {
            m.add(V::spilt, 1);
        }
    }
}

pub(crate) mod counter {
    use super::*;
    kind! {
        "counter" Transport "A counter: it counts how many times a value becomes true" "Um contador: conta quantas vezes um valor se torna verdadeiro"
        [84, 60];
        fields { of: Form::Drive, "what it counts" "o que ele conta"; }
        values {
            count: COUNT, "the count so far" "a contagem até agora";
            was: inner(0, 1), "whether the value was true before" "se o valor era verdadeiro antes";
        }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let is = m.drive(F::of);
        if is && !m.is(V::was) {
            m.add(V::count, 1);
        }
        m.put(V::was, is);
    }
}
