//! What flows. A millilitre in a second is a microlitre in a millisecond, and that is what moves.

use crate::kind::{DAMAGE, FLAG, Fault, Form, HAND, Limit, SHARE, Slot, inner, kind, number};
use crate::moment::{FULL, Moment};
use crate::unit::Unit;

const TANKS: &[&str] = &["tank"];

pub(crate) mod tank {
    use super::*;
    kind! {
        "tank" Fluid "A tank that overflows when it is full" "Um tanque que transborda quando está cheio"
        [120, 160];
        fields {
            holds: Form::Number(Unit::Ml, 100, 2_000_000, 100_000), "its capacity" "a capacidade dele";
            first: Form::Number(Unit::Permille, 0, 1000, 0), "how full it is at the start" "quanto está cheio no começo";
        }
        values {
            level: Slot { first: Limit::Of("first"), ..SHARE }, "how full it is" "quanto está cheio";
            overflowed: DAMAGE, "whether it has overflowed" "se transbordou";
            spilt: number(Unit::Ml, 0, 100_000_000), "how much has spilt on the floor" "quanto caiu no chão";
            mixed: SHARE, "how well its contents are mixed" "quanto o conteúdo está misturado";
            empty: FLAG, "whether it is empty" "se está vazio";
            volume: Slot { high: Limit::Thousand("holds"), ..inner(0, 0) }, "what is in it" "o que tem dentro";
            drops: inner(0, 999), "what has been spilt, in thousandths" "o que transbordou, em milésimos";
            begun: inner(0, 1), "whether it has been filled for the first time" "se já recebeu o conteúdo inicial";
        }
        faults { Leaking }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let holds = m.number(F::holds);
        if !m.is(V::begun) {
            m.put(V::begun, true);
            m.set(V::volume, holds.saturating_mul(m.number(F::first)));
        }
        if m.fails(Fault::Leaking) {
            m.add(V::volume, -(holds / 100));
        }
        let volume = m.get(V::volume);
        m.set(V::level, volume / holds.max(1));
        m.put(V::empty, volume < holds);
        if volume < holds {
            m.set(V::mixed, 0);
        }
    }

    /// Adds this much to a tank, µl; what does not fit is spilt.
    pub(crate) fn pour(m: &mut Moment<'_>, tank: usize, amount: i32) {
        let holds = m.number_of(tank, F::holds).saturating_mul(1000);
        let volume = m.of(tank, V::volume);
        let room = holds - volume;
        m.set_of(tank, V::volume, volume + amount.min(room));
        if amount > room {
            m.set_of(tank, V::overflowed, 1);
            let drops = m.of(tank, V::drops) + (amount - room);
            m.add_of(tank, V::spilt, drops / 1000);
            m.set_of(tank, V::drops, drops % 1000);
        }
        // What is new is not mixed.
        if amount > 0 && m.of(tank, V::mixed) > 0 {
            let less = m.of(tank, V::mixed) - 1;
            m.set_of(tank, V::mixed, less);
        }
    }

    /// Takes this much out of a tank, µl, or as much as it has.
    pub(crate) fn draw(m: &mut Moment<'_>, tank: usize, amount: i32) -> i32 {
        let volume = m.of(tank, V::volume);
        let gone = amount.min(volume);
        m.set_of(tank, V::volume, volume - gone);
        gone
    }
}

pub(crate) mod valve {
    use super::*;
    kind! {
        "valve" Fluid "A valve between two tanks; without `from`, the mains feeds it, and without `to`, it empties into the drain" "Uma válvula entre dois tanques; sem `from`, a rede a alimenta, e sem `to`, ela descarrega no ralo"
        [60, 60];
        fields {
            by: Form::Duty, "what opens it" "o que a abre";
            from: Form::MayPart(TANKS), "the tank upstream" "o tanque a montante";
            to: Form::MayPart(TANKS), "the tank downstream" "o tanque a jusante";
            flow: Form::Number(Unit::MlPerS, 1, 100_000, 1000), "its flow when fully open" "a vazão com ela toda aberta";
            travel: Form::Number(Unit::Ms, 1, 60_000, 300), "how long it takes to open" "quanto tempo leva para abrir";
        }
        values {
            open: FLAG, "whether it is open at all" "se está aberta";
            position: SHARE, "how far it is open" "quanto ela está aberta";
            flow: number(Unit::MlPerS, 0, 100_000), "the flow through it" "a vazão";
            turned: HAND, "whether somebody holds it open by hand" "se alguém a mantém aberta à mão";
            fine: inner(0, 1_000_000), "its position in small steps" "a posição em passos pequenos";
        }
        faults { Stuck Leaking Slow Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let driven = if m.fails(Fault::Open) {
            0
        } else {
            m.duty(F::by)
        };
        let to = if m.is(V::turned) { 1000 } else { driven };
        if !m.fails(Fault::Stuck) {
            let takes = m.number(F::travel) * m.drag();
            m.approach(V::fine, to * 1000, (1_000_000 / takes).max(1));
        }
        m.set(V::position, m.get(V::fine) / 1000);
        let leak = if m.fails(Fault::Leaking) { 100 } else { 0 };
        let position = m.get(V::position);
        m.put(V::open, position > 0);
        let wanted = (i64::from(m.number(F::flow)) * i64::from(position.max(leak)) / 1000) as i32;
        let came = match m.other(F::from) {
            Some(tank) => tank::draw(m, tank, wanted),
            None => wanted,
        };
        if let Some(tank) = m.other(F::to) {
            tank::pour(m, tank, came);
        }
        m.set(V::flow, came);
    }
}

pub(crate) mod pump {
    use super::*;
    kind! {
        "pump" Fluid "A pump that breaks if it runs dry for too long" "Uma bomba que quebra se trabalha a seco por tempo demais"
        [80, 70];
        fields {
            by: Form::Duty, "what drives it" "o que a aciona";
            from: Form::Part(TANKS), "the tank that it empties" "o tanque que ela esvazia";
            to: Form::MayPart(TANKS), "the tank that it fills" "o tanque que ela enche";
            flow: Form::Number(Unit::MlPerS, 1, 100_000, 1000), "its flow at full speed" "a vazão em rotação plena";
            bears: Form::Number(Unit::Ms, 100, 60_000, 3000), "how long it may run dry" "por quanto tempo ela suporta trabalhar a seco";
        }
        values {
            runs: FLAG, "whether it runs" "se está ligada";
            dry: FLAG, "whether it runs dry" "se está trabalhando a seco";
            broken: DAMAGE, "whether it has broken" "se quebrou";
            flow: number(Unit::MlPerS, 0, 100_000), "the flow through it" "a vazão";
            since: inner(0, 60_000), "how long it has run dry" "há quanto tempo trabalha a seco";
            angle: inner(0, 359), "where its wheel stands" "onde está o rotor";
        }
        faults { Jammed Open Welded }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let mut duty = m.duty(F::by);
        if m.fails(Fault::Welded) {
            duty = 1000;
        }
        let still = m.is(V::broken) || m.fails(Fault::Jammed) || m.fails(Fault::Open);
        if still {
            duty = 0;
        }
        m.put(V::runs, duty > 0);
        let wanted = (i64::from(m.number(F::flow)) * i64::from(duty) / 1000) as i32;
        let came = match m.other(F::from) {
            Some(tank) => tank::draw(m, tank, wanted),
            None => 0,
        };
        if let Some(tank) = m.other(F::to) {
            tank::pour(m, tank, came);
        }
        m.set(V::flow, came);
        let dry = duty > 0 && came * 2 < wanted;
        m.put(V::dry, dry);
        m.add(V::since, if dry { 1 } else { -1 });
        if m.get(V::since) >= m.number(F::bears) {
            m.put(V::broken, true);
        }
        m.set(V::angle, (m.get(V::angle) + duty / 250) % 360);
    }
}

pub(crate) mod stirrer {
    use super::*;
    kind! {
        "stirrer" Fluid "A stirrer in a tank" "Um misturador em um tanque"
        [40, 140];
        fields {
            by: Form::Drive, "what drives it" "o que o aciona";
            within: Form::Part(TANKS), "its tank" "o tanque dele";
            takes: Form::Number(Unit::Ms, 100, 600_000, 5000), "how long it takes to mix" "quanto tempo leva para misturar";
        }
        values {
            runs: FLAG, "whether it runs" "se está ligado";
            fine: inner(0, 1_000_000), "what it has mixed, in small steps" "o que misturou, em passos pequenos";
            angle: inner(0, 359), "where its blades stand" "onde estão as pás";
        }
        faults { Jammed Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let runs = m.drive(F::by) && !m.fails(Fault::Jammed) && !m.fails(Fault::Open);
        m.put(V::runs, runs);
        if !runs {
            return;
        }
        m.set(V::angle, (m.get(V::angle) + 2) % 360);
        let Some(tank) = m
            .other(F::within)
            .filter(|tank| m.of(*tank, tank::V::empty) == 0)
        else {
            return;
        };
        m.add(V::fine, (1_000_000 / m.number(F::takes)).max(1));
        let steps = m.get(V::fine) / 1000;
        m.set(V::fine, m.get(V::fine) % 1000);
        m.add_of(tank, tank::V::mixed, steps);
    }
}

pub(crate) mod float {
    use super::*;
    kind! {
        "float" Fluid "A float switch: actuated while the level is above it" "Uma chave-boia: acionada enquanto o nível está acima dela"
        [90, 30];
        fields {
            of: Form::Part(TANKS), "its tank" "o tanque dela";
            height: Form::Number(Unit::Permille, 0, 1000, 500), "its height in the tank" "a altura dela no tanque";
            to: Form::Sense, "the input that it switches" "a entrada que ela aciona";
        }
        values { up: FLAG, "whether the level is above it" "se o nível está acima dela"; }
        faults { Stuck Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if let Some(tank) = m.other(F::of).filter(|_| !m.fails(Fault::Stuck)) {
            // Waves do not make it chatter.
            let height = m.number(F::height) - if m.is(V::up) { 5 } else { 0 };
            m.put(V::up, m.of(tank, tank::V::level) >= height.max(1));
        }
        m.sense(F::to, m.is(V::up));
    }
}

pub(crate) mod level {
    use super::*;
    kind! {
        "level" Fluid "A level transmitter with an output of 0 to 10 V or 4 to 20 mA" "Um transmissor de nível com saída de 0 a 10 V ou de 4 a 20 mA"
        [50, 50];
        fields {
            of: Form::Part(TANKS), "its tank" "o tanque dele";
            to: Form::Reading, "the analogue input that it sets" "a entrada analógica à qual ele está ligado";
            signal: Form::Choice(&["0-10V", "4-20mA"]), "its output signal" "o sinal de saída dele";
        }
        values { reading: number(Unit::Count, 0, 1023), "the reading of its input" "a leitura da entrada"; }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if let Some(tank) = m.other(F::of).filter(|_| !m.fails(Fault::Stuck)) {
            let holds = m.number_of(tank, tank::F::holds).max(1);
            let volume = m.of(tank, tank::V::volume) / holds;
            let low = if m.number(F::signal) == 1 {
                FULL / 5
            } else {
                0
            };
            m.set(V::reading, low + (FULL - low) * volume / 1000);
        }
        let came = m.reading(F::to, m.get(V::reading));
        m.set(V::reading, came);
    }
}
