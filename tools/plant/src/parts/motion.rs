//! What moves to and fro.

use crate::kind::{DAMAGE, FLAG, Fault, Form, HAND, Limit, SHARE, Slot, inner, kind, number};
use crate::moment::Moment;
use crate::unit::Unit;

/// A position in steps as small as the slowest motion asks for.
const FINE: Slot = inner(0, 1_000_000);

/// The steps of a millisecond in which the whole way takes so long, ms.
fn pace(m: &Moment<'_>, takes: i32) -> i32 {
    (1_000_000 / (takes * m.drag()).max(1)).max(1)
}

pub(crate) mod cylinder {
    use super::*;
    kind! {
        "cylinder" Motion "A pneumatic cylinder; without `retract`, a spring retracts it" "Um cilindro pneumático; sem `retract`, uma mola o recua"
        [180, 50];
        fields {
            extend: Form::Drive, "the solenoid that extends it" "o solenoide que o avança";
            retract: Form::MayDrive, "the solenoid that retracts it" "o solenoide que o recua";
            takes: Form::Number(Unit::Ms, 50, 60_000, 800), "how long the full stroke takes" "quanto tempo leva o curso completo";
            is_in: Form::Sense, "the input of its retracted limit switch" "a entrada do fim de curso de recuo";
            is_out: Form::Sense, "the input of its extended limit switch" "a entrada do fim de curso de avanço";
        }
        values {
            position: SHARE, "how far it is extended" "quanto está avançado";
            at_home: Slot { first: Limit::Is(1), ..FLAG }, "whether it is fully retracted" "se está totalmente recuado";
            out: FLAG, "whether it is fully extended" "se está totalmente avançado";
            moves: FLAG, "whether it is moving" "se está em movimento";
            hand_in: HAND, "whether somebody has a hand in its way" "se alguém está com a mão no caminho";
            hurt: DAMAGE, "whether it has hit that hand" "se atingiu essa mão";
            fine: FINE, "its position in small steps" "a posição em passos pequenos";
            valve: inner(0, 1), "where its valve stands" "como está a válvula";
        }
        faults { Stuck Slow Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let (out, back) = (m.drive(F::extend), m.drive(F::retract));
        if m.has(F::retract) {
            // A valve with two coils stays; with both driven too.
            if out != back {
                m.put(V::valve, out);
            }
        } else {
            m.put(V::valve, out);
        }
        let before = m.get(V::fine);
        if !m.fails(Fault::Stuck) {
            let to = if m.is(V::valve) { 1_000_000 } else { 0 };
            let by = pace(m, m.number(F::takes));
            m.approach(V::fine, to, by);
        }
        let fine = m.get(V::fine);
        m.set(V::position, fine / 1000);
        m.put(V::moves, fine != before);
        m.put(V::at_home, fine <= 20_000);
        m.put(V::out, fine >= 980_000);
        if m.is(V::hand_in) && fine > before && fine > 500_000 {
            m.put(V::hurt, true);
        }
        m.sense(F::is_in, fine <= 20_000);
        m.sense(F::is_out, fine >= 980_000);
    }
}

pub(crate) mod gate {
    use super::*;
    kind! {
        "gate" Motion "A barrier gate" "Uma cancela que sobe e desce"
        [180, 110];
        fields {
            raise: Form::Drive, "what raises it" "o que a levanta";
            lower: Form::MayDrive, "what lowers it; without this key, the gate falls by itself" "o que a abaixa; sem esta chave, a cancela desce sozinha";
            takes: Form::Number(Unit::Ms, 100, 60_000, 2000), "how long it takes to rise or to fall" "quanto tempo leva para subir ou descer";
            is_up: Form::Sense, "the input of its upper limit switch" "a entrada do fim de curso de cima";
            is_down: Form::Sense, "the input of its lower limit switch" "a entrada do fim de curso de baixo";
        }
        values {
            position: SHARE, "how far it is raised" "quanto está levantada";
            up: FLAG, "whether it is fully raised" "se está totalmente levantada";
            down: Slot { first: Limit::Is(1), ..FLAG }, "whether it is fully lowered" "se está totalmente abaixada";
            lowers: FLAG, "whether it is moving down" "se está descendo";
            strained: DAMAGE, "whether its motor has pushed against the end of its travel for 3 s" "se o motor forçou a cancela contra o batente por 3 s";
            fine: FINE, "its position in small steps" "a posição em passos pequenos";
            push: inner(0, 10_000), "how long it has pushed against the end of its travel" "há quanto tempo força a cancela contra o batente";
        }
        faults { Stuck Slow Open Short }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let (up, down) = (m.drive(F::raise), m.drive(F::lower));
        let falls = !m.has(F::lower) && !up;
        let to = match (up, down || falls) {
            (true, false) => Some(1_000_000),
            (false, true) => Some(0),
            _ => None,
        };
        let before = m.get(V::fine);
        if let Some(to) = to.filter(|_| !m.fails(Fault::Stuck)) {
            let by = pace(m, m.number(F::takes));
            m.approach(V::fine, to, by);
        }
        let fine = m.get(V::fine);
        m.set(V::position, fine / 1000);
        m.put(V::up, fine >= 980_000);
        m.put(V::down, fine <= 20_000);
        m.put(V::lowers, fine < before);
        let pushes = m.has(F::lower) && (up && fine == 1_000_000 || down && fine == 0);
        m.add(V::push, if pushes { 1 } else { -10_000 });
        if m.get(V::push) >= 3000 {
            m.put(V::strained, true);
        }
        m.sense(F::is_up, fine >= 980_000);
        m.sense(F::is_down, fine <= 20_000);
    }
}

pub(crate) mod door {
    use super::*;
    kind! {
        "door" Motion "A motor-driven door; somebody may stand in the doorway" "Uma porta motorizada; pode haver alguém no vão"
        [160, 130];
        fields {
            open: Form::Drive, "what opens it" "o que a abre";
            close: Form::MayDrive, "what closes it; without this key, the door closes by itself" "o que a fecha; sem esta chave, a porta fecha sozinha";
            takes: Form::Number(Unit::Ms, 100, 120_000, 6000), "how long it takes to open or to close" "quanto tempo leva para abrir ou fechar";
            is_open: Form::Sense, "the input of the limit switch for the open door" "a entrada do fim de curso da porta aberta";
            is_closed: Form::Sense, "the input of the limit switch for the closed door" "a entrada do fim de curso da porta fechada";
            beam: Form::Sense, "the input of its light barrier" "a entrada da barreira óptica no vão";
        }
        values {
            position: SHARE, "how far it is open" "quanto está aberta";
            opened: FLAG, "whether it is fully open" "se está totalmente aberta";
            shut: Slot { first: Limit::Is(1), ..FLAG }, "whether it is fully closed" "se está totalmente fechada";
            closes: FLAG, "whether it is closing" "se está fechando";
            obstacle: HAND, "whether somebody stands in the doorway" "se alguém está no vão";
            crushed: DAMAGE, "whether it has crushed somebody" "se esmagou quem estava ali";
            strained: DAMAGE, "whether its motor has pushed against the end of its travel for 3 s" "se o motor forçou a porta contra o batente por 3 s";
            fine: FINE, "its position in small steps" "a posição em passos pequenos";
            push: inner(0, 10_000), "how long it has pushed against the end of its travel" "há quanto tempo força a porta contra o batente";
        }
        faults { Stuck Slow Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let (open, close) = (m.drive(F::open), m.drive(F::close));
        let by_itself = !m.has(F::close) && !open;
        let mut to = match (open, close || by_itself) {
            (true, false) => Some(1_000_000),
            (false, true) => Some(0),
            _ => None,
        };
        let before = m.get(V::fine);
        let obstacle = m.is(V::obstacle);
        // Who stands there takes two fifths of the way.
        if obstacle && to == Some(0) && before <= 400_000 && before > 0 {
            m.put(V::crushed, true);
            to = None;
        }
        if let Some(to) = to.filter(|_| !m.fails(Fault::Stuck)) {
            let by = pace(m, m.number(F::takes));
            m.approach(V::fine, to, by);
        }
        let fine = m.get(V::fine);
        m.set(V::position, fine / 1000);
        m.put(V::opened, fine >= 980_000);
        m.put(V::shut, fine <= 10_000);
        m.put(V::closes, fine < before);
        let pushes = m.has(F::close) && (open && fine == 1_000_000 || close && fine == 0);
        m.add(V::push, if pushes { 1 } else { -10_000 });
        if m.get(V::push) >= 3000 {
            m.put(V::strained, true);
        }
        m.sense(F::is_open, fine >= 980_000);
        m.sense(F::is_closed, fine <= 10_000);
        m.sense(F::beam, obstacle);
    }
}

pub(crate) mod elevator {
    use super::*;
    kind! {
        "elevator" Motion "The car of an elevator with three or four floors" "A cabine de um elevador de três ou quatro andares"
        [110, 330];
        fields {
            up: Form::Drive, "what moves it up" "o que a faz subir";
            down: Form::Drive, "what moves it down" "o que a faz descer";
            door: Form::Part(&["door"]), "its door" "a porta dela";
            floors: Form::Number(Unit::Count, 3, 4, 3), "the number of floors" "o número de andares";
            takes: Form::Number(Unit::Ms, 500, 60_000, 4000), "how long it takes from one floor to the next" "quanto tempo leva de um andar ao seguinte";
            at_1: Form::Sense, "the input of the sensor at floor 1" "a entrada do sensor do 1.º andar";
            at_2: Form::Sense, "the input of the sensor at floor 2" "a entrada do sensor do 2.º andar";
            at_3: Form::Sense, "the input of the sensor at floor 3" "a entrada do sensor do 3.º andar";
            at_4: Form::Sense, "the input of the sensor at floor 4" "a entrada do sensor do 4.º andar";
        }
        values {
            position: number(Unit::Permille, 0, 3000), "its height; floor 1 is at 0%, floor 2 at 100%, and so on" "a altura; o 1.º andar fica em 0%, o 2.º em 100%, e assim por diante";
            floor: number(Unit::Count, 0, 4), "the floor where it is; 0 between two floors" "o andar em que está; 0 entre dois andares";
            moves: FLAG, "whether it is moving" "se está em movimento";
            crashed: DAMAGE, "whether it has run into an end of the shaft" "se bateu em uma extremidade do poço";
            fine: inner(0, 3_000_000), "its height in small steps" "a altura em passos pequenos";
            push: inner(0, 10_000), "how long it has pushed against the end of its travel" "há quanto tempo força um fim do poço";
        }
        faults { Stuck Slow }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        let (up, down) = (m.drive(F::up), m.drive(F::down));
        let floors = m.number(F::floors);
        let to = match (up, down) {
            (true, false) => Some((floors - 1) * 1_000_000),
            (false, true) => Some(0),
            _ => None,
        };
        let before = m.get(V::fine);
        let still = m.fails(Fault::Stuck) || m.is(V::crashed);
        if let Some(to) = to.filter(|_| !still) {
            let by = pace(m, m.number(F::takes));
            m.approach(V::fine, to, by);
        }
        let fine = m.get(V::fine);
        m.set(V::position, fine / 1000);
        m.put(V::moves, fine != before);
        m.add(V::push, if to == Some(fine) { 1 } else { -10_000 });
        if m.get(V::push) >= 500 {
            m.put(V::crashed, true);
        }
        let at = |floor: i32| (fine - floor * 1_000_000).abs() <= 25_000;
        let floor = (0..floors).find(|floor| at(*floor));
        let floor = floor.map_or(0, |floor| floor + 1);
        m.set(V::floor, floor);
        for (field, number) in [(F::at_1, 1), (F::at_2, 2), (F::at_3, 3), (F::at_4, 4)] {
            m.sense(field, floor == number);
        }
    }
}

pub(crate) mod call {
    use super::*;
    use crate::parts::motion::{door, elevator};
    kind! {
        "call" Motion "The call button on a floor, and the people waiting there" "O botão de chamada de um andar e as pessoas que esperam ali"
        [60, 72];
        fields {
            of: Form::Part(&["elevator"]), "the elevator" "o elevador";
            floor: Form::Number(Unit::Count, 1, 4, 1), "the floor" "o andar";
            to: Form::Sense, "the input that it switches" "a entrada que ele aciona";
        }
        values {
            pressed: HAND, "whether it is pressed" "se está apertado";
            waiting: FLAG, "whether somebody is waiting there" "se há alguém esperando ali";
            waited: number(Unit::Ms, 0, 3_600_000), "how long somebody has been waiting there" "há quanto tempo alguém espera ali";
        }
        faults { Stuck Open Short Bouncing }
    }
    pub(crate) fn step(m: &mut Moment<'_>) {
        if m.is(V::pressed) {
            m.put(V::waiting, true);
        }
        if let Some(car) = m.other(F::of) {
            let door = m
                .plant
                .parts
                .get(car)
                .and_then(|own| own.given.get(elevator::F::door as usize));
            let opened = match door {
                Some(crate::signal::Given::Part(door)) => m.of(*door, door::V::opened) != 0,
                _ => false,
            };
            let here = m.of(car, elevator::V::floor) == m.number(F::floor);
            if opened && here && m.of(car, elevator::V::moves) == 0 && !m.is(V::pressed) {
                m.put(V::waiting, false);
            }
        }
        m.add(V::waited, if m.is(V::waiting) { 1 } else { -3_600_000 });
        m.sense(F::to, m.is(V::pressed));
    }
}
