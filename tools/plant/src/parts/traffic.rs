//! What drives and walks.

use crate::kind::{COUNT, DAMAGE, FLAG, Fault, Form, HAND, Slot, inner, kind, number};
use crate::moment::Moment;
use crate::unit::Unit;

pub(crate) mod light {
    use super::*;
    kind! {
        "light" Traffic "A traffic light; without `red`, it is red while it is neither green nor yellow" "Um semáforo; sem `red`, ele fica vermelho se não está verde nem amarelo"
        [50, 130];
        fields {
            red: Form::MayDrive, "what switches the red light on" "o que acende a luz vermelha";
            yellow: Form::MayDrive, "what switches the yellow light on" "o que acende a luz amarela";
            green: Form::Drive, "what switches the green light on" "o que acende a luz verde";
            shows: Form::Choice(&["cars", "walk"]), "who it is for" "para quem ele é";
        }
        values {
            red: FLAG, "whether it is red" "se está vermelho";
            yellow: FLAG, "whether it is yellow" "se está amarelo";
            green: FLAG, "whether it is green" "se está verde";
            since: number(Unit::Ms, 0, 3_600_000), "how long it has been in its present state" "há quanto tempo está assim";
            was: inner(0, 7), "how it was before" "como estava antes";
        }
        faults { Open }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let (green, yellow) = (m.drive(F::green), m.drive(F::yellow));
        let red = match m.has(F::red) {
            true => m.drive(F::red) && !m.fails(Fault::Open),
            false => !green && !yellow,
        };
        m.put(V::red, red);
        m.put(V::yellow, yellow);
        m.put(V::green, green);
        let is = i32::from(red) | i32::from(yellow) << 1 | i32::from(green) << 2;
        m.add(V::since, if is == m.get(V::was) { 1 } else { -3_600_000 });
        m.set(V::was, is);
    }
}

pub(crate) mod road {
    use super::*;
    kind! {
        "road" Traffic "A road where cars arrive at random and wait at a traffic light" "Uma rua com carros que chegam em momentos aleatórios e esperam em um semáforo"
        [420, 90];
        fields {
            light: Form::Part(&["light"]), "its traffic light" "o semáforo dela";
            every: Form::Number(Unit::Ms, 500, 600_000, 5000), "the mean time between cars" "o tempo médio entre os carros";
            takes: Form::Number(Unit::Ms, 200, 60_000, 2000), "how long a car takes to cross" "quanto tempo um carro leva para passar";
        }
        values {
            waiting: number(Unit::Count, 0, 20), "how many cars are waiting" "quantos carros estão esperando";
            passes: FLAG, "whether a car is on the crossing" "se há um carro passando";
            passed: COUNT, "how many cars have passed" "quantos carros passaram";
            hit: DAMAGE, "whether a car has hit somebody" "se um carro atingiu alguém";
            on: inner(0, 60_000), "how much longer the car on the crossing takes" "quanto tempo falta ao carro que passa";
            next: inner(0, 1_200_000), "the time until the next car" "o tempo até o próximo carro";
        }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.add(V::next, -1);
        if m.get(V::next) == 0 {
            m.add(V::waiting, 1);
            let every = m.number(F::every);
            let more = m.chance(every);
            m.set(V::next, every / 2 + more);
        }
        m.add(V::on, -1);
        let green = m
            .other(F::light)
            .is_some_and(|light| m.of(light, light::V::green) != 0);
        if m.get(V::on) == 0 {
            if m.is(V::passes) {
                m.add(V::passed, 1);
            }
            let goes = green && m.get(V::waiting) > 0;
            m.put(V::passes, goes);
            if goes {
                m.add(V::waiting, -1);
                m.set(V::on, m.number(F::takes));
            }
        }
    }
}

pub(crate) mod junction {
    use super::*;
    kind! {
        "junction" Traffic "A junction of two roads: cars arrive at random on both, and crash if a car from each road is in the junction" "Um cruzamento de duas ruas: os carros chegam em momentos aleatórios nas duas e batem se houver no cruzamento um de cada rua"
        [520, 330];
        fields {
            across: Form::Part(&["light"]), "the light of the road drawn horizontally" "o semáforo da rua desenhada na horizontal";
            down: Form::Part(&["light"]), "the light of the road drawn vertically" "o semáforo da rua desenhada na vertical";
            every: Form::Number(Unit::Ms, 500, 600_000, 5000), "the mean time between cars on each road" "o tempo médio entre os carros em cada rua";
            takes: Form::Number(Unit::Ms, 200, 60_000, 2000), "how long a car takes to cross" "quanto tempo um carro leva para passar pelo cruzamento";
        }
        values {
            waiting_across: number(Unit::Count, 0, 20), "how many cars are waiting on the horizontal road" "quantos carros estão esperando na rua horizontal";
            waiting_down: number(Unit::Count, 0, 20), "how many cars are waiting on the vertical road" "quantos carros estão esperando na rua vertical";
            passes_across: FLAG, "whether a car from the horizontal road is in the junction" "se há um carro da rua horizontal no cruzamento";
            passes_down: FLAG, "whether a car from the vertical road is in the junction" "se há um carro da rua vertical no cruzamento";
            passed_across: COUNT, "how many cars have passed on the horizontal road" "quantos carros passaram pela rua horizontal";
            passed_down: COUNT, "how many cars have passed on the vertical road" "quantos carros passaram pela rua vertical";
            crashed: DAMAGE, "whether two cars have crashed" "se dois carros bateram";
            hit: DAMAGE, "whether a car has hit somebody" "se um carro atingiu alguém";
            on: Slot { count: 2, ..inner(0, 60_000) }, "how much longer the car of each road takes on the crossing" "quanto tempo falta ao carro de cada rua no cruzamento";
            next: Slot { count: 2, ..inner(0, 1_200_000) }, "the time until the next car of each road" "o tempo até o próximo carro de cada rua";
        }
        faults { }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        for (road, light, waiting, passes, passed) in [
            (
                0,
                F::across,
                V::waiting_across,
                V::passes_across,
                V::passed_across,
            ),
            (1, F::down, V::waiting_down, V::passes_down, V::passed_down),
        ] {
            one(
                m,
                road,
                light.into(),
                [waiting, passes, passed].map(usize::from),
            );
        }
        if m.is(V::passes_across) && m.is(V::passes_down) {
            m.put(V::crashed, true);
        }
    }

    /// A millisecond of one of the roads.
    fn one(m: &mut Moment<'_>, road: usize, light: usize, values: [usize; 3]) {
        let [waiting, passes, passed] = values;
        let next = m.row(V::next, road) - 1;
        m.set_row(V::next, road, next);
        if next <= 0 {
            m.add(waiting, 1);
            let every = m.number(F::every);
            let more = m.chance(every);
            m.set_row(V::next, road, every / 2 + more);
        }
        let on = m.row(V::on, road) - 1;
        m.set_row(V::on, road, on);
        if on > 0 {
            return;
        }
        if m.is(passes) {
            m.add(passed, 1);
        }
        let green = m
            .other(light)
            .is_some_and(|light| m.of(light, light::V::green) != 0);
        let goes = green && m.get(waiting) > 0;
        m.put(passes, goes);
        if goes {
            m.add(waiting, -1);
            m.set_row(V::on, road, m.number(F::takes));
        }
    }
}

pub(crate) mod walk {
    use super::*;
    use crate::parts::traffic::{junction, light, road};
    kind! {
        "walk" Traffic "A pedestrian crossing: people arrive at random, press the button, and cross on green" "Uma faixa de pedestres: as pessoas chegam em momentos aleatórios, apertam o botão e atravessam no verde"
        [120, 200];
        fields {
            light: Form::Part(&["light"]), "its traffic light" "o semáforo dela";
            over: Form::Part(&["road", "junction"]), "the road; for a junction, the horizontal one" "a rua; em um cruzamento, a horizontal";
            button: Form::Sense, "the input of the button" "a entrada do botão";
            every: Form::Number(Unit::Ms, 1000, 600_000, 20_000), "the mean time between people" "o tempo médio entre as pessoas";
            takes: Form::Number(Unit::Ms, 500, 60_000, 5000), "how long it takes to cross" "quanto tempo leva a travessia";
        }
        values {
            waiting: number(Unit::Count, 0, 9), "how many people are waiting" "quantas pessoas estão esperando";
            walks: FLAG, "whether somebody is crossing" "se há alguém atravessando";
            crossed: COUNT, "how many people have crossed" "quantas pessoas atravessaram";
            waited: number(Unit::Ms, 0, 3_600_000), "how long the first person has been waiting" "há quanto tempo a primeira pessoa espera";
            pressed: HAND, "whether somebody is pressing the button" "se alguém está apertando o botão";
            on: inner(0, 60_000), "how much longer the people crossing take" "quanto tempo ainda falta a quem atravessa";
            group: inner(0, 9), "how many people are crossing" "quantas pessoas estão atravessando";
            next: inner(0, 1_200_000), "the time until the next person" "o tempo até a próxima pessoa";
            presses: inner(0, 10_000), "how long the button is still pressed" "quanto tempo o botão ainda fica apertado";
        }
        faults { Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.add(V::next, -1);
        m.add(V::presses, -1);
        if m.get(V::next) == 0 {
            // The first one comes after a while.
            let every = m.number(F::every);
            let more = m.chance(every);
            m.set(V::next, every / 2 + more);
            m.add(V::waiting, 1);
            m.set(V::presses, 400);
        }
        let green = m
            .other(F::light)
            .is_some_and(|light| m.of(light, light::V::green) != 0);
        m.add(V::on, -1);
        if m.get(V::on) == 0 && m.is(V::walks) {
            m.add(V::crossed, m.get(V::group));
            m.put(V::walks, false);
            m.set(V::group, 0);
        }
        if green && m.get(V::waiting) > 0 && !m.is(V::walks) {
            m.put(V::walks, true);
            m.set(V::group, m.get(V::waiting));
            m.set(V::waiting, 0);
            m.set(V::on, m.number(F::takes));
        }
        m.add(
            V::waited,
            if m.get(V::waiting) > 0 { 1 } else { -3_600_000 },
        );
        if let Some(road) = m.other(F::over)
            && m.is(V::walks)
        {
            let (passes, hit) = match m.is_kind(road, "junction") {
                true => (junction::V::passes_across.into(), junction::V::hit.into()),
                false => (usize::from(road::V::passes), usize::from(road::V::hit)),
            };
            if m.of(road, passes) != 0 {
                m.set_of(road, hit, 1);
            }
        }
        m.sense(F::button, m.is(V::pressed) || m.get(V::presses) > 0);
    }
}

/// So long after a car the next one follows it through a gate, ms.
const NEXT: i32 = 1500;

pub(crate) mod lane {
    use super::*;
    use crate::parts::motion::gate;
    kind! {
        "lane" Traffic "The entry lane of a car park: cars arrive at a gate, park, and leave by a separate exit" "A entrada de um estacionamento: os carros chegam a uma cancela, estacionam e vão embora por uma saída separada"
        [420, 110];
        fields {
            gate: Form::Part(&["gate"]), "the gate" "a cancela";
            spaces: Form::Number(Unit::Count, 1, 20, 5), "the number of spaces" "o número de vagas";
            every: Form::Number(Unit::Ms, 1000, 600_000, 8000), "the mean time between cars" "o tempo médio entre os carros";
            stays: Form::Number(Unit::Ms, 1000, 3_600_000, 60_000), "how long a car stays on average" "por quanto tempo um carro fica, em média";
            takes: Form::Number(Unit::Ms, 500, 60_000, 3000), "how long a car takes to pass the gate" "quanto tempo um carro leva para passar pela cancela";
            at_gate: Form::Sense, "the input of the sensor in front of the gate" "a entrada do sensor antes da cancela";
            under: Form::Sense, "the input of the sensor under the gate" "a entrada do sensor debaixo da cancela";
            leaves: Form::Sense, "the input of the sensor at the exit" "a entrada do sensor da saída";
        }
        values {
            waiting: number(Unit::Count, 0, 20), "how many cars are waiting at the gate" "quantos carros estão esperando na cancela";
            passes: FLAG, "whether a car is under the gate" "se há um carro debaixo da cancela";
            inside: number(Unit::Count, 0, 40), "how many cars are inside" "quantos carros estão dentro";
            overfull: DAMAGE, "whether there are more cars inside than spaces" "se há mais carros dentro do que vagas";
            hit: DAMAGE, "whether the gate has come down on a car" "se a cancela desceu sobre um carro";
            entered: COUNT, "how many cars have come in" "quantos carros entraram";
            on: inner(0, 60_000), "how much longer the car under the gate takes" "quanto tempo falta ao carro debaixo da cancela";
            next: inner(0, 1_200_000), "the time until the next car" "o tempo até o próximo carro";
            out: inner(0, 1000), "how much longer the car at the exit is detected" "por quanto tempo o carro na saída ainda é detectado";
            rest: Slot { count: 20, ..inner(0, 7_200_000) }, "how much longer each car stays" "quanto tempo cada carro ainda fica";
        }
        faults { Stuck Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        m.add(V::next, -1);
        if m.get(V::next) == 0 {
            m.add(V::waiting, 1);
            let every = m.number(F::every);
            let more = m.chance(every);
            m.set(V::next, every / 2 + more);
        }
        let position = m
            .other(F::gate)
            .map_or(0, |gate| m.of(gate, gate::V::position));
        let lowers = m
            .other(F::gate)
            .is_some_and(|gate| m.of(gate, gate::V::lowers) != 0);
        m.add(V::on, -1);
        if m.is(V::passes) {
            if lowers && position < 600 {
                m.put(V::hit, true);
            }
            if m.get(V::on) == 0 {
                m.put(V::passes, false);
                m.set(V::on, NEXT);
                m.add(V::inside, 1);
                m.add(V::entered, 1);
                let stays = m.number(F::stays);
                let more = m.chance(stays);
                if let Some(at) = (0..20).find(|at| m.row(V::rest, *at) == 0) {
                    m.set_row(V::rest, at, (stays / 2 + more).max(1));
                }
            }
        } else if position >= 900 && !lowers && m.get(V::waiting) > 0 && m.get(V::on) == 0 {
            m.put(V::passes, true);
            m.add(V::waiting, -1);
            m.set(V::on, m.number(F::takes));
        }
        m.add(V::out, -1);
        for at in 0..20 {
            let rest = m.row(V::rest, at);
            // One leaves after the other.
            if rest > 1 || rest == 1 && m.get(V::out) == 0 {
                m.set_row(V::rest, at, rest - 1);
                if rest == 1 {
                    m.add(V::inside, -1);
                    m.set(V::out, 1000);
                }
            }
        }
        if m.get(V::inside) > m.number(F::spaces) {
            m.put(V::overfull, true);
        }
        m.sense(F::at_gate, m.get(V::waiting) > 0 && !m.is(V::passes));
        m.sense(F::under, m.is(V::passes));
        m.sense(F::leaves, m.get(V::out) > 400);
    }
}
