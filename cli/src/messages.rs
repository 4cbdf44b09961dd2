//! What the command line says, in the two languages that it speaks: one table, in which no text is without its twin.
//!
//! Owns the words, and which language this process speaks. Must not know who says them, nor where.

use std::fmt::Display;
use std::sync::OnceLock;
use unoclp_board::diagnostics::Trouble;
use unoclp_board::map;
use unoclp_core::Cause;
use unoclp_lang::Lang;
use unoclp_source::{Size, diagnosis};

static SPOKEN: OnceLock<Lang> = OnceLock::new();

/// Speaks this language from now on. A process chooses once, before it says anything.
pub fn speak(lang: Lang) {
    // The first choice holds.
    let _ = SPOKEN.set(lang);
}

/// The language of this process; English before it has chosen.
pub fn spoken() -> Lang {
    #[cfg(test)]
    if let Some(lang) = tests::SPOKEN_HERE.get() {
        return lang;
    }
    SPOKEN.get().copied().unwrap_or_default()
}

/// The one of these two that is spoken.
pub fn either<T>(english: T, portuguese: T) -> T {
    match spoken() {
        Lang::En => english,
        Lang::Pt => portuguese,
    }
}

/// A fault without its place: `fault 75: too many jumps back in one scan (NC-19)`.
pub fn fault(cause: Cause) -> String {
    let (number, text) = (cause.number(), diagnosis::cause(cause, spoken()));
    format!("{} {number}: {text}", either("fault", "falha"))
}

/// The fault that a board tells: `fault 24, line 7: no such code`.
pub fn trouble(trouble: Trouble) -> String {
    if spoken() == Lang::En {
        return trouble.to_string();
    }
    let line = trouble
        .line
        .map_or_else(String::new, |line| format!(", linha {line}"));
    let number = trouble.number;
    match trouble.fault() {
        Some(fault) => format!(
            "falha {number}{line}: {}",
            diagnosis::portuguese(fault.cause)
        ),
        None => format!("falha {number}{line}: desconhecida por esta versão do unoclp"),
    }
}

/// How much of the board a program takes.
pub fn size(size: &Size) -> String {
    match spoken() {
        Lang::En => size.to_string(),
        Lang::Pt => size.in_portuguese(),
    }
}

/// The cause of a board's start.
pub fn start(cause: u16) -> &'static str {
    let english = map::cause(cause);
    match english {
        "power" => either(english, "energia"),
        "unknown" => either(english, "desconhecida"),
        "no reset" => either(english, "sem reset"),
        "command" => either(english, "comando"),
        // The words of the data sheet: watchdog, reset.
        other => other,
    }
}

/// `name(value, …) "English" "Portuguese";` becomes a function that gives the text in the language that is spoken.
macro_rules! messages {
    ($($name:ident($($value:ident),*) $english:literal $portuguese:literal;)*) => {
        $(
            #[doc = $english]
            pub fn $name($($value: impl Display),*) -> String {
                match spoken() {
                    Lang::En => format!($english),
                    Lang::Pt => format!($portuguese),
                }
            }
        )*

        /// All of them: name, English, Portuguese.
        pub const ALL: &[(&str, &str, &str)] = &[$((stringify!($name), $english, $portuguese)),*];
    };
}

messages! {
    cannot_read(file, error)
        "{file} cannot be read ({error}); check its name and folder"
        "não foi possível ler {file} ({error}); confira o nome e a pasta";
    cannot_write(file)
        "{file} cannot be written"
        "não foi possível gravar {file}";
    is_read(file)
        "{file} is what the command reads; name another file to write"
        "{file} é o arquivo que o comando lê; indique outro para gravar";
    is_compiled(file)
        "{file} is what is compiled; name another file with -o"
        "{file} é o que se compila; indique outro arquivo com -o";
    is_something_else(file, kind)
        "{file} is there already, and is not {kind}; it is left as it is. Name another file, or delete it"
        "{file} já existe e não é {kind}; ficou como estava. Indique outro arquivo ou apague-o";
    a_drawing() "an SVG drawing" "um desenho SVG";
    a_trace() "a VCD trace" "um registro VCD";
    a_program() "numeric code" "código numérico";
    forced(points)
        "forced: {points}"
        "forçados: {points}";
    forced_before(points)
        "forced since before: {points}; x lets all go"
        "já estavam forçados: {points}; x libera tudo";
    stays_forced(points)
        "still forced: {points}; a monitor lets them go with x, and so does a restart"
        "continuam forçados: {points}; um monitor os libera com x, um reinício também";
    let_go(points)
        "no longer forced: {points}"
        "não estão mais forçados: {points}";
    stays_on(outputs)
        "{outputs} stays on: no rung writes it; it goes off at STOP"
        "{outputs} continua ligada: nenhum degrau a escreve; ela desliga em STOP";
    may_stay_on(outputs)
        "{outputs} is on, and stays so unless the program writes it; it goes off at STOP"
        "{outputs} está ligada e assim fica se o programa não a escrever; ela desliga em STOP";
    interrupted_with_old(state)
        "interrupted; the board is in {state}, and keeps the program that it had"
        "interrompido; a placa está em {state} e mantém o programa que tinha";
    interrupted_with_new(state)
        "interrupted; the board is in {state}, and keeps the new program"
        "interrompido; a placa está em {state} e já tem o programa novo";
    interrupted_unknown(error)
        "interrupted; the board no longer answers ({error}): whether it runs, and which program it keeps, is open"
        "interrompido; a placa não responde mais ({error}): não se sabe se ela roda nem que programa ela tem";
    said_reset()
        "opening the port has probably reset the board; the next time it will not"
        "abrir a porta provavelmente reiniciou a placa; da próxima vez não reiniciará";
    was_reset()
        "opening the port has reset the board; the next time it will not"
        "abrir a porta reiniciou a placa; da próxima vez não reiniciará";
    no_answer(line, port)
        "no answer from {line}, on {port}; is the board powered and wired, and are these its settings? Another address or rate is given by --address and --rate; A5 and 01 to 04 closed at reset bring the defaults back"
        "sem resposta de {line}, em {port}; a placa está ligada e conectada, e são estes os ajustes dela? Outro endereço ou taxa se indica com --address e --rate; A5 e 01 a 04 fechados no reset trazem de volta os ajustes de fábrica";
    no_modbus(port, rate, parity)
        "what comes from {port} is no Modbus at {rate} baud, {parity}; is that the board's rate (--rate, --parity)?"
        "o que vem de {port} não é Modbus a {rate} baud, {parity}; é essa a taxa da placa (--rate, --parity)?";
    no_unoclp(port, foreign)
        "what answers at {port} is no unoclp{foreign}"
        "o que responde em {port} não é um unoclp{foreign}";
    no_port(port, others) "there is no port {port}; {others}" "não existe a porta {port}; {others}";
    no_ports()
        "this PC has none, so the board is not plugged in, or its cable only charges"
        "este PC não tem nenhuma: a placa não está conectada, ou o cabo só carrega";
    ports(names) "this PC has {names}" "este PC tem {names}";
    port_denied(port, remedy)
        "{port} may not be used by this user; {remedy}"
        "este usuário não pode usar {port}; {remedy}";
    join_group()
        "join the group that it belongs to, mostly by `sudo usermod -aG dialout $USER`, and log in anew"
        "entre no grupo dela, em geral com `sudo usermod -aG dialout $USER`, e inicie nova sessão";
    check_who() "check who may" "confira quem pode";
    port_busy(port)
        "{port} is in use by another program; close its serial monitor"
        "{port} está em uso por outro programa; feche o monitor serial dele";
    no_serial_port(port) "{port} is no serial port" "{port} não é uma porta serial";
    port_not_opened(port, reason)
        "{port} cannot be opened: {reason}"
        "não foi possível abrir {port}: {reason}";
    needs_terminal() "the monitor needs a terminal" "o monitor precisa de um terminal";
    sim_needs_terminal()
        "the simulator needs a terminal; without one, run a scenario: --scenario S.toml"
        "o simulador precisa de um terminal; sem um, execute um cenário: --scenario S.toml";
    nothing_to_simulate()
        "nothing to simulate; name a program or a --scenario"
        "nada a simular; indique um programa ou um --scenario";
    svg_is_a_ladder()
        "--svg draws a ladder diagram; leave out --as, or --svg"
        "--svg desenha um diagrama ladder; tire --as ou --svg";
    drawn(file) "{file}: drawn" "{file}: desenhado";
    is_numeric(file)
        "{file} is numeric code; there is nothing to compile"
        "{file} já é código numérico; não há o que compilar";
    stored(bytes, sum)
        "stored: {bytes} bytes, check sum {sum}"
        "gravado: {bytes} bytes, soma de verificação {sum}";
    in_stop() "in STOP" "em STOP";
    in_fault() "in FAULT" "em FAULT";
    in_stop_by_switch() "A5 is closed: in STOP" "A5 está fechado: em STOP";
    in_stop_until()
        "A5 is closed: in STOP, until A5 is opened"
        "A5 está fechado: em STOP até A5 ser aberto";
    in_fault_until()
        "in FAULT: it runs the program from its next restart on"
        "em FAULT: executa o programa a partir do próximo reinício";
    refused_program()
        "the board refuses the program, and keeps the one that it had:"
        "a placa recusa o programa e mantém o que tinha:";
    card_wins()
        "the program was stored, but the board's card has another PROGRAM.TXT, which it took at its restart; take the card out, or put the program on it"
        "o programa foi gravado, mas o cartão da placa tem outro PROGRAM.TXT, que ela leu ao reiniciar; tire o cartão ou grave nele o programa";
    inputs_toggle(last) "Inputs: 1 to {last} toggle" "Entradas: 1 a {last} alternam";
    inputs_held(last)
        "Inputs: closed while 1 to {last} is held"
        "Entradas: fechadas com 1 a {last} apertadas";
    inputs_force(last) "Inputs: 1 to {last} force" "Entradas: 1 a {last} forçam";
    outputs_force(last) "Outputs: 1 to {last} force" "Saídas: 1 a {last} forçam";
    inputs() "Inputs" "Entradas";
    outputs() "Outputs" "Saídas";
    memory() "Memory" "Memória";
    board() "Board" "Placa";
    timers() "Timers (ms)" "Temporizadores (ms)";
    timers_of(first, last, count)
        "Timers (ms): {first} to {last} of {count}"
        "Temporizadores (ms): {first} a {last} de {count}";
    timers_and_counters() "Timers (ms) and counters" "Temporizadores (ms) e contadores";
    lines_of(what, first, last, count)
        "{what}: lines {first} to {last} of {count}"
        "{what}: linhas {first} a {last} de {count}";
    text() "Text" "Texto";
    rungs() "Rungs" "Degraus";
    to_text() "text" "texto";
    fault_in_line(number, line) "FAULT {number}, line {line}" "FAULT {number}, linha {line}";
    paused() "PAUSED" "PAUSA";
    ran(ms, scans) "{ms} ms  {scans} scans " "{ms} ms  {scans} varreduras ";
    sim_keys(run, view, mode, more)
        " q quit  space {run}  s scan  r restart  v {view}  m {mode}{more}  ↑↓ scroll"
        " q sai  espaço {run}  s varre  r reinicia  v {view}  m {mode}{more}  ↑↓ rola";
    pause() "pause" "pausa";
    run() "run" "roda";
    stop() "stop" "para";
    toggle() "toggle" "alternar";
    momentary() "momentary" "momento";
    turn(input) "  a A{input}  +-<> turn" "  a A{input}  +-<> gira";
    t_timers() "  t timers" "  t tempos";
    d_memory() "  d memory" "  d memória";
    monitor_keys(run, other, view)
        " q quit  space {run}  1-8 force  o {other}  x free  s scan  r restart{view}  ↑↓"
        " q sai  espaço {run}  1-8 força  o {other}  x libera  s varre  r reinicia{view}  ↑↓";
    to_outputs() "outputs" "saídas";
    to_inputs() "inputs" "entradas";
    no_board() "NO BOARD" "SEM PLACA";
    waiting() "waiting for the board" "à espera da placa";
    lost(why) "lost, trying again: {why}" "perdida, tentando de novo: {why}";
    last_upload() "last upload: " "último envio: ";
    switch_closed()
        "A5 is closed: STOP until it is opened"
        "A5 está fechado: STOP até ser aberto";
    upload_under_way() "an upload is under way" "há um envio em andamento";
    card_failed()
        "the card failed: STATE.TXT is no longer kept"
        "o cartão falhou: STATE.TXT não é mais atualizado";
    another_program(file, bytes, sum, own_bytes, own_sum)
        "the board runs another program than {file}: {bytes} bytes {sum}, not {own_bytes} bytes {own_sum}"
        "a placa executa outro programa que não {file}: {bytes} bytes {sum}, não {own_bytes} bytes {own_sum}";
    figures(last, least, most, volts, stack)
        " scan {last} µs ({least} to {most})  supply {volts} V  stack {stack} bytes free"
        " varredura {last} µs ({least} a {most})  fonte {volts} V  pilha {stack} bytes livres";
    history(cause, restarts, faults)
        " last start: {cause}  since power-up: restarts {restarts}, faults {faults}"
        " última partida: {cause}  desde ligada: reinícios {restarts}, falhas {faults}";
    over(most) "over {most}" "mais de {most}";
    no_board_to_do_it() "there is no board to do it" "não há placa que o faça";
    refused_in_fault()
        "the board is in FAULT: r restarts it"
        "a placa está em FAULT: r a reinicia";
    refused_by_switch()
        "A5 is closed, which holds the board in STOP"
        "A5 está fechado e segura a placa em STOP";
    refused_in_upload()
        "an upload is under way: r restarts the board without it"
        "há um envio em andamento: r reinicia a placa sem ele";
    refused_scan()
        "single scans are for STOP: space stops the board"
        "varreduras avulsas são para STOP: espaço para a placa";
    refused() "the board does not do that now" "a placa não faz isso agora";
    too_small(columns, lines)
        "this screen is too small: {columns} x {lines}"
        "esta tela é pequena demais: {columns} x {lines}";
    needs(columns, lines)
        "at least {columns} x {lines} is needed"
        "é preciso pelo menos {columns} x {lines}";
    q_quits() "q quits" "q encerra";
    too_large(file, bytes)
        "{file} has more than {bytes} bytes; no program is as long"
        "{file} tem mais de {bytes} bytes; nenhum programa é tão longo";
    in_fault_later(ms)
        "in FAULT, within the first {ms} ms of its scans:"
        "em FAULT nos primeiros {ms} ms de varreduras:";
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use std::cell::Cell;

    thread_local! {
        /// The language of a test, apart from the others of the process.
        pub(crate) static SPOKEN_HERE: Cell<Option<Lang>> = const { Cell::new(None) };
    }

    /// The values that a text names, in order of their names.
    fn values(text: &str) -> Vec<&str> {
        let parts = text.split('{').skip(1);
        let mut names: Vec<&str> = parts
            .map(|part| part.split(['}', ':']).next().unwrap_or_default())
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    #[test]
    fn every_message_says_the_same_in_both_languages() {
        for (name, english, portuguese) in ALL {
            assert_eq!(values(english), values(portuguese), "{name}");
            assert!(!portuguese.trim().is_empty(), "{name}");
            assert_ne!(english, portuguese, "{name}");
        }
    }
}
