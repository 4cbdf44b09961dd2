//! What warms and cools. Temperatures are thousandths of a degree, and inside an oven millionths.

use crate::kind::{DAMAGE, FLAG, Fault, Form, Limit, SHARE, Slot, inner, kind, number};
use crate::moment::{FULL, Moment};
use crate::unit::Unit;

const OVENS: &[&str] = &["oven"];
/// How many pieces the dead time of an oven has.
const PIECES: usize = 16;

pub(crate) mod oven {
    use super::*;
    kind! {
        "oven" Heat "An oven with thermal lag and dead time" "Um forno com inércia térmica e tempo morto"
        [140, 120];
        fields {
            outside: Form::Number(Unit::MilliC, -20_000, 50_000, 25_000), "the ambient temperature" "a temperatura ambiente";
            lag: Form::Number(Unit::Ms, 1000, 3_600_000, 60_000), "its time constant" "a constante de tempo";
            dead: Form::Number(Unit::Ms, 0, 60_000, 2000), "the dead time before heat has an effect" "o tempo morto até o calor fazer efeito";
            bears: Form::Number(Unit::MilliC, 30_000, 400_000, 300_000), "the temperature that damages it" "a temperatura que o danifica";
        }
        values {
            temperature: Slot { first: Limit::Of("outside"), ..number(Unit::MilliC, -50_000, 450_000) }, "its temperature in thousandths of a degree" "a temperatura em milésimos de grau";
            burnt: DAMAGE, "whether it has overheated" "se superaqueceu";
            fine: inner(-50_000_000, 450_000_000), "its temperature in millionths" "a temperatura em milionésimos";
            power: inner(0, 1_000_000), "how far it would warm up with what it is given now" "quanto esquentaria com o que recebe agora";
            loss: inner(0, 9), "how much more it loses" "quanto perde a mais";
            begun: inner(0, 1), "whether it has begun" "se já começou";
            tick: inner(0, 60_000), "the time in the piece of the dead time" "o tempo no pedaço do tempo morto";
            head: inner(0, 15), "the piece of the dead time that is written" "o pedaço do tempo morto que se grava";
            pieces: Slot { count: PIECES, ..inner(0, 1_000_000) }, "the heat on its way" "o calor a caminho";
        }
        faults { Leaking }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let outside = m.number(F::outside);
        if !m.is(V::begun) {
            m.put(V::begun, true);
            m.set(V::fine, outside * 1000);
        }
        let head = m.get(V::head) as usize;
        m.set_row(V::pieces, head, m.get(V::power));
        let felt = match m.number(F::dead) {
            0 => m.get(V::power),
            _ => m.row(V::pieces, (head + 1) % PIECES),
        };
        m.set(V::power, 0);
        m.add(V::tick, 1);
        if m.get(V::tick) * PIECES as i32 >= m.number(F::dead) {
            m.set(V::tick, 0);
            m.set(V::head, ((head + 1) % PIECES) as i32);
        }
        let leak = if m.fails(Fault::Leaking) { 2 } else { 0 };
        let loss = 1 + i64::from(m.get(V::loss)) + leak;
        m.set(V::loss, 0);
        let fine = i64::from(m.get(V::fine));
        let above = fine - i64::from(outside) * 1000;
        let change = (i64::from(felt) * 1000 - above * loss) / i64::from(m.number(F::lag).max(1));
        m.set(
            V::fine,
            (fine + change).clamp(-50_000_000, 450_000_000) as i32,
        );
        m.set(V::temperature, m.get(V::fine) / 1000);
        if m.get(V::temperature) >= m.number(F::bears) {
            m.put(V::burnt, true);
        }
    }
}

pub(crate) mod heater {
    use super::*;
    kind! {
        "heater" Heat "A heater in an oven" "Uma resistência de aquecimento em um forno"
        [80, 50];
        fields {
            by: Form::Duty, "what drives it" "o que a aciona";
            within: Form::Part(OVENS), "its oven" "o forno dela";
            warms: Form::Number(Unit::MilliC, 1000, 500_000, 250_000), "the final rise in temperature at full power" "a elevação final da temperatura em plena potência";
        }
        values { power: SHARE, "its power, as a share of full power" "a fração da potência plena que ela fornece"; }
        faults { Open Welded }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let mut duty = m.duty(F::by);
        if m.fails(Fault::Welded) {
            duty = 1000;
        }
        if m.fails(Fault::Open) {
            duty = 0;
        }
        m.set(V::power, duty);
        if let Some(oven) = m.other(F::within) {
            let warms = i64::from(m.number(F::warms)) * i64::from(duty) / 1000;
            m.add_of(oven, oven::V::power, warms as i32);
        }
    }
}

pub(crate) mod fan {
    use super::*;
    kind! {
        "fan" Heat "A fan that cools an oven" "Um ventilador que resfria um forno"
        [60, 60];
        fields {
            by: Form::Drive, "what drives it" "o que o aciona";
            within: Form::Part(OVENS), "its oven" "o forno dele";
        }
        values {
            runs: FLAG, "whether it runs" "se está ligado";
            angle: inner(0, 359), "where its blades stand" "onde estão as pás";
        }
        faults { Jammed Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let runs = m.drive(F::by) && !m.fails(Fault::Jammed) && !m.fails(Fault::Open);
        m.put(V::runs, runs);
        if runs {
            m.set(V::angle, (m.get(V::angle) + 4) % 360);
            if let Some(oven) = m.other(F::within) {
                m.add_of(oven, oven::V::loss, 3);
            }
        }
    }
}

pub(crate) mod thermometer {
    use super::*;
    kind! {
        "thermometer" Heat "A temperature sensor with a transmitter" "Um sensor de temperatura com transmissor"
        [50, 50];
        fields {
            of: Form::Part(OVENS), "its oven" "o forno dele";
            to: Form::Reading, "the analogue input that it sets" "a entrada analógica à qual ele está ligado";
            span: Form::Number(Unit::MilliC, 10_000, 400_000, 400_000), "the temperature at which the input reads 1023; it reads 0 at 0 °C" "a temperatura em que a entrada lê 1023; a 0 °C ela lê 0";
        }
        values { reading: number(Unit::Count, 0, 1023), "the reading of its input" "a leitura da entrada"; }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if let Some(oven) = m.other(F::of).filter(|_| !m.fails(Fault::Stuck)) {
            let temperature = i64::from(m.of(oven, oven::V::temperature).max(0));
            let reading = temperature * i64::from(FULL) / i64::from(m.number(F::span).max(1));
            m.set(V::reading, reading.min(FULL.into()) as i32);
        }
        let came = m.reading(F::to, m.get(V::reading));
        m.set(V::reading, came);
    }
}
