//! Contactors, and what they switch.

use crate::kind::{DAMAGE, FLAG, Fault, Form, HAND, inner, kind, number};
use crate::moment::Moment;
use crate::unit::Unit;

/// What flows in a short circuit, mA.
const SHORT: i32 = 900_000;

pub(crate) mod fuse {
    use super::*;
    kind! {
        "fuse" Electric "A fuse: it blows at once on a short circuit, and after some time on an overload" "Um fusível: queima na hora em um curto-circuito e, depois de algum tempo, em uma sobrecarga"
        [60, 80];
        fields { rated: Form::Number(Unit::Ma, 100, 100_000, 10_000), "the current it can carry continuously" "a corrente que ele suporta continuamente"; }
        values {
            blown: DAMAGE, "whether it has blown" "se queimou";
            current: number(Unit::Ma, 0, 1_000_000), "the current through it" "a corrente que passa por ele";
            heat: inner(0, 1_000_000), "how hot it is" "quanto esquentou";
            drawn: inner(0, 1_000_000), "the current drawn in this millisecond" "a corrente consumida neste milissegundo";
        }
        faults { Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let current = m.get(V::drawn);
        m.set(V::drawn, 0);
        m.set(V::current, current);
        // Ten times the current: half a second; forty times and more: at once.
        let times = current * 10 / m.number(F::rated).max(1);
        match times {
            ..=85 => m.add(V::heat, -200),
            _ => m.add(V::heat, times * times / 5),
        }
        if m.get(V::heat) >= 1_000_000 || times >= 400 || m.fails(Fault::Open) {
            m.put(V::blown, true);
        }
    }
}

pub(crate) mod contactor {
    use super::*;
    kind! {
        "contactor" Electric "A contactor, which takes some time to close and to open" "Um contator, que leva algum tempo para fechar e para abrir"
        [80, 80];
        fields {
            by: Form::Drive, "what drives its coil" "o que comanda a bobina";
            pull_in: Form::Number(Unit::Ms, 0, 500, 20), "how long it takes to close" "quanto tempo leva para fechar";
            drop_out: Form::Number(Unit::Ms, 0, 500, 30), "how long it takes to open" "quanto tempo leva para abrir";
            aux: Form::Sense, "the input that its auxiliary contact switches" "a entrada que o contato auxiliar aciona";
        }
        values {
            closed: FLAG, "whether its contacts are closed" "se os contatos estão fechados";
            coil: FLAG, "whether its coil is driven" "se a bobina está energizada";
            timer: inner(0, 2000), "how long it has been moving" "há quanto tempo se move";
        }
        faults { Welded Open Slow Stuck }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let coil = m.drive(F::by) && !m.fails(Fault::Open);
        m.put(V::coil, coil);
        let closed = m.is(V::closed);
        let held = m.fails(Fault::Stuck) || (closed && m.fails(Fault::Welded));
        if coil == closed || held {
            m.set(V::timer, 0);
        } else {
            m.add(V::timer, 1);
            let takes = m.number(if coil { F::pull_in } else { F::drop_out }) * m.drag();
            if m.get(V::timer) > takes {
                m.put(V::closed, coil);
                m.set(V::timer, 0);
            }
        }
        m.sense(F::aux, m.is(V::closed));
    }
}

pub(crate) mod overload {
    use super::*;
    kind! {
        "overload" Electric "A thermal overload relay: it trips when its motor draws too much current for some time" "Um relé térmico: desarma quando a corrente do motor fica alta demais por algum tempo"
        [80, 80];
        fields {
            rated: Form::Number(Unit::Ma, 100, 100_000, 4000), "the current it can carry continuously" "a corrente que ele suporta continuamente";
            contact: Form::Sense, "the input of its contact, usually normally closed" "a entrada do contato, em geral normalmente fechado";
        }
        values {
            tripped: FLAG, "whether it has tripped" "se desarmou";
            reset: HAND, "whether its reset button is pressed" "se o botão de rearme está apertado";
            heat: number(Unit::Permille, 0, 1000), "its accumulated heat; it trips at 1000" "o calor acumulado; desarma em 1000";
            current: number(Unit::Ma, 0, 1_000_000), "the current through it" "a corrente que passa por ele";
            warmth: inner(0, 2_000_000), "its heat in small steps" "o calor em passos pequenos";
            drawn: inner(0, 1_000_000), "the current drawn in this millisecond" "a corrente consumida neste milissegundo";
        }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let current = m.get(V::drawn);
        m.set(V::drawn, 0);
        m.set(V::current, current);
        let times = (current * 10 / m.number(F::rated).max(1)).min(200);
        // Six times the current: seven seconds.
        match times {
            ..=11 => m.add(V::warmth, -100),
            _ => m.add(V::warmth, times * times / 25),
        }
        m.set(V::heat, m.get(V::warmth) / 1000);
        if m.get(V::warmth) >= 1_000_000 {
            m.put(V::tripped, true);
        }
        if m.is(V::reset) && m.get(V::heat) < 500 {
            m.put(V::tripped, false);
        }
        m.sense(F::contact, m.is(V::tripped));
    }
}

pub(crate) mod motor {
    use super::*;
    use crate::parts::electric::{contactor, fuse, overload};
    kind! {
        "motor" Electric "A three-phase motor with inertia, for direct, reversing or star-delta starting" "Um motor trifásico com inércia, para partida direta, com reversão ou estrela-triângulo"
        [80, 100];
        fields {
            line: Form::Part(&["contactor"]), "its line contactor" "o contator de linha";
            reverse: Form::MayPart(&["contactor"]), "its reversing contactor, which swaps two phases" "o contator de reversão, que troca duas fases";
            star: Form::MayPart(&["contactor"]), "its star contactor" "o contator de estrela";
            delta: Form::MayPart(&["contactor"]), "its delta contactor" "o contator de triângulo";
            fuse: Form::MayPart(&["fuse"]), "its fuse" "o fusível dele";
            overload: Form::MayPart(&["overload"]), "its overload relay" "o relé térmico dele";
            rated: Form::Number(Unit::Ma, 100, 50_000, 4000), "its current at full speed" "a corrente dele em rotação plena";
            full: Form::Number(Unit::Rpm, 100, 3600, 1740), "its full speed" "a rotação plena";
            run_up: Form::Number(Unit::Ms, 50, 60_000, 1500), "how long it takes to reach full speed" "quanto tempo leva para atingir a rotação plena";
            run_down: Form::Number(Unit::Ms, 50, 60_000, 3000), "how long it takes to stop" "quanto tempo leva para parar";
        }
        values {
            runs: FLAG, "whether it turns at about 90% of its full speed or more" "se gira a cerca de 90% da rotação plena ou mais";
            turns: FLAG, "whether it turns at all" "se está girando";
            speed: number(Unit::Rpm, -3600, 3600), "its speed, negative in reverse" "a rotação, negativa no sentido reverso";
            current: number(Unit::Ma, 0, 1_000_000), "its current" "a corrente dele";
            milli: inner(-3_600_000, 3_600_000), "its speed in thousandths" "a rotação em milésimos";
            angle: inner(0, 359_999), "the angle of its shaft" "onde está o eixo";
        }
        faults { Jammed }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let closed = |m: &Moment<'_>, field: F| {
            m.other(field)
                .is_some_and(|part| m.of(part, contactor::V::closed) != 0)
        };
        let (line, reverse) = (closed(m, F::line), closed(m, F::reverse));
        let (star, delta) = (closed(m, F::star), closed(m, F::delta));
        let by_star = m.has(F::star);
        let blown = m
            .other(F::fuse)
            .is_some_and(|fuse| m.of(fuse, fuse::V::blown) != 0);
        let fed = (line || reverse) && !blown;
        let shorted = fed && (line && reverse || star && delta);
        let (rated, full) = (m.number(F::rated), m.number(F::full) * 1000);
        let wound = !by_star || star || delta;
        let drives = fed && wound && !shorted;
        // In a star a third of the pull is left, and a third of the current.
        let third = if by_star && star { 3 } else { 1 };
        let to = match (drives, reverse) {
            (false, _) => 0,
            (true, false) => full,
            (true, true) => -full,
        };
        let to = if third == 3 { to / 10 * 9 } else { to };
        let jammed = m.fails(Fault::Jammed);
        let speed = m.get(V::milli);
        let same_way = (speed > 0) == (to > 0) || speed == 0;
        let takes = match to {
            0 => m.number(F::run_down),
            _ => m.number(F::run_up) * third,
        };
        if jammed {
            m.set(V::milli, 0);
        } else {
            m.approach(V::milli, to, (full / takes.max(1)).max(1));
        }
        let slip =
            (i64::from(to) - i64::from(m.get(V::milli))).abs() * 1000 / i64::from(full.max(1));
        let current = if shorted {
            SHORT
        } else if drives {
            // At rest six times the current, against its turning eight times.
            let times = 1000 + 5 * slip.min(1000) + if same_way { 0 } else { 2000 };
            (i64::from(rated) * times / 1000) as i32 / third
        } else {
            0
        };
        m.set(V::current, current);
        if let Some(fuse) = m.other(F::fuse) {
            m.add_of(fuse, fuse::V::drawn, current);
        }
        if let Some(relay) = m.other(F::overload) {
            m.add_of(relay, overload::V::drawn, if shorted { 0 } else { current });
        }
        let milli = m.get(V::milli);
        m.set(V::speed, milli / 1000);
        m.put(V::turns, milli.abs() > 20_000);
        m.put(V::runs, milli.abs() >= full / 10 * 9 - 20_000);
        m.set(
            V::angle,
            (m.get(V::angle) + milli / 170).rem_euclid(360_000),
        );
    }
}
