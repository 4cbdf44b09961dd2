//! What a person presses and sees.

use crate::kind::{COUNT, FLAG, Form, HAND, SHARE, Slot, kind};
use crate::moment::Moment;

/// The colours of lamps and buttons.
const COLOURS: &[&str] = &["green", "red", "yellow", "blue", "white"];

pub(crate) mod button {
    use super::*;
    kind! {
        "button" Panel "A push button, closed while it is pressed" "Um botão de pulso, fechado enquanto está apertado"
        [60, 72];
        fields {
            to: Form::Sense, "the input that it switches" "a entrada que ele aciona";
            colour: Form::Choice(super::COLOURS), "its colour" "a cor dele";
        }
        values { pressed: HAND, "whether it is pressed" "se está apertado"; }
        faults { Stuck Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.sense(F::to, m.is(V::pressed));
    }
}

pub(crate) mod switch {
    use super::*;
    kind! {
        "switch" Panel "A selector switch that stays in position" "Uma chave seletora com retenção"
        [60, 72];
        fields { to: Form::Sense, "the input that it switches" "a entrada que ela aciona"; }
        values { on: HAND, "whether it is turned on" "se está ligada"; }
        faults { Stuck Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.sense(F::to, m.is(V::on));
    }
}

pub(crate) mod key {
    use super::*;
    kind! {
        "key" Panel "A selector switch operated by a key" "Uma chave seletora com segredo"
        [60, 72];
        fields { to: Form::Sense, "the input that it switches" "a entrada que ela aciona"; }
        values { on: HAND, "whether it is turned on" "se está ligada"; }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.sense(F::to, m.is(V::on));
    }
}

pub(crate) mod emergency {
    use super::*;
    kind! {
        "emergency" Panel "An emergency stop button: once pressed, it latches until somebody twists it" "Uma botoeira de emergência: depois de apertada, fica retida até que alguém a gire"
        [60, 72];
        fields { to: Form::Sense, "the input of its contact, usually normally closed" "a entrada do contato, em geral normalmente fechado"; }
        values { pressed: HAND, "whether it is pressed" "se está apertada"; }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.sense(F::to, m.is(V::pressed));
    }
}

pub(crate) mod lamp {
    use super::*;
    use crate::kind::Fault;
    kind! {
        "lamp" Panel "An indicator lamp" "Uma lâmpada de sinalização"
        [60, 72];
        fields {
            by: Form::Drive, "what switches it on" "o que a acende";
            colour: Form::Choice(super::COLOURS), "its colour" "a cor dela";
        }
        values { lit: FLAG, "whether it is lit" "se está acesa"; }
        faults { Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.put(V::lit, m.drive(F::by) && !m.fails(Fault::Open));
    }
}

pub(crate) mod tower {
    use super::*;
    kind! {
        "tower" Panel "A signal tower with red, yellow and green lights" "Uma torre luminosa com luzes vermelha, amarela e verde"
        [44, 110];
        fields {
            red: Form::MayDrive, "what switches the red light on" "o que acende a luz vermelha";
            yellow: Form::MayDrive, "what switches the yellow light on" "o que acende a luz amarela";
            green: Form::MayDrive, "what switches the green light on" "o que acende a luz verde";
        }
        values {
            red: FLAG, "whether the red light is on" "se a luz vermelha está acesa";
            yellow: FLAG, "whether the yellow light is on" "se a luz amarela está acesa";
            green: FLAG, "whether the green light is on" "se a luz verde está acesa";
        }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.put(V::red, m.drive(F::red));
        m.put(V::yellow, m.drive(F::yellow));
        m.put(V::green, m.drive(F::green));
    }
}

pub(crate) mod buzzer {
    use super::*;
    use crate::kind::Fault;
    kind! {
        "buzzer" Panel "A buzzer" "Uma sirene"
        [60, 72];
        fields { by: Form::Drive, "what makes it sound" "o que a faz soar"; }
        values { sounds: FLAG, "whether it sounds" "se está soando"; }
        faults { Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.put(V::sounds, m.drive(F::by) && !m.fails(Fault::Open));
    }
}

pub(crate) mod dial {
    use super::*;
    use crate::kind::Limit;
    use crate::unit::Unit;
    kind! {
        "dial" Panel "A potentiometer" "Um potenciômetro"
        [60, 72];
        fields {
            to: Form::Reading, "the analogue input that it sets" "a entrada analógica à qual ele está ligado";
            first: Form::Number(Unit::Permille, 0, 1000, 500), "its initial position" "a posição inicial dele";
        }
        values { turned: Slot { by_hand: true, first: Limit::Of("first"), ..SHARE }, "how far it is turned" "quanto foi girado"; }
        faults { Stuck Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.reading(F::to, m.get(V::turned) * 1023 / 1000);
    }
}

pub(crate) mod bar {
    use super::*;
    kind! {
        "bar" Panel "A bar that shows a value" "Uma barra que mostra um valor"
        [44, 110];
        fields { of: Form::Value, "the value" "o valor"; }
        values { share: SHARE, "where the value lies in its range" "em que ponto da faixa está o valor"; }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if let Some((part, value)) = m.named(F::of) {
            m.set(V::share, m.share(part, value));
        }
    }
}

pub(crate) mod number {
    use super::*;
    kind! {
        "number" Panel "A display that shows a value as a number" "Um mostrador numérico de um valor"
        [84, 60];
        fields { of: Form::Value, "the value" "o valor"; }
        values { shown: Slot { low: crate::kind::Limit::Is(-1_000_000_000), high: crate::kind::Limit::Is(1_000_000_000), ..COUNT }, "the number shown" "o número mostrado"; }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if let Some((part, value)) = m.named(F::of) {
            m.set(V::shown, m.of(part, value));
        }
    }
}
