//! What the pages say.

use super::figures::{Line, Measured, Scale, Trend};

/// The language of a page.
#[derive(Clone, Copy)]
pub(super) enum Lang {
    En,
    Pt,
}

/// A row: what, the figure, the target, whether it is met.
struct Row {
    what: String,
    figure: String,
    target: &'static str,
    is_met: Option<bool>,
}

/// The page in this language.
pub(super) fn page(measured: &Measured, lang: Lang) -> String {
    let words = Words { lang };
    let rows: String = rows(measured, &words)
        .iter()
        .map(|row| {
            let met = match row.is_met {
                Some(true) => words.of("met", "atingida"),
                Some(false) => words.of("**not met**", "**não atingida**"),
                None => "",
            };
            let (what, figure, target) = (&row.what, &row.figure, row.target);
            format!("| {what} | {figure} | {target} | {met} |\n")
        })
        .collect();
    let [begin, end] = measured.load.map(|load| words.number(load, 1));
    let processors = measured.processors;
    let tail = words
        .of(ENGLISH, PORTUGUESE)
        .replace("{begin}", &begin)
        .replace("{end}", &end)
        .replace("{processors}", &processors.to_string());
    format!("{}{rows}{tail}", words.of(ENGLISH_HEAD, PORTUGUESE_HEAD))
}

struct Words {
    lang: Lang,
}

impl Words {
    fn of<'t>(&self, english: &'t str, portuguese: &'t str) -> &'t str {
        match self.lang {
            Lang::En => english,
            Lang::Pt => portuguese,
        }
    }

    fn number(&self, of: f64, digits: usize) -> String {
        let text = format!("{of:.digits$}");
        match self.lang {
            Lang::En => text,
            Lang::Pt => text.replace('.', ","),
        }
    }
}

fn rows(measured: &Measured, words: &Words) -> Vec<Row> {
    let Measured {
        scale,
        few,
        node_red,
        lines,
        trend,
        ..
    } = measured;
    let mut rows = Vec::from(many(scale, words));
    rows.extend(beside(few, node_red, words));
    rows.extend(lines.iter().map(|of| line(of, words)));
    rows.extend(past(trend, words));
    rows
}

/// A thousand boards.
fn many(scale: &Scale, words: &Words) -> [Row; 3] {
    let Scale {
        boards,
        up,
        gateways,
        ..
    } = scale;
    [
        Row {
            what: words
                .of(
                    "simulated boards of 32 points, each read twice a second: processors used",
                    "placas simuladas de 32 pontos, cada uma lida duas vezes por segundo: processadores em uso",
                )
                .to_owned(),
            figure: format!(
                "{} ({up} {} {boards} {}, {gateways} gateways)",
                words.number(scale.core, 2),
                words.of("of", "de"),
                words.of("boards", "placas")
            ),
            target: "≤ 1",
            is_met: Some(scale.core <= 1.0 && up == boards),
        },
        Row {
            what: words
                .of(
                    "the same: memory of all gateways",
                    "o mesmo: memória de todos os gateways",
                )
                .to_owned(),
            figure: format!("{} MB", words.number(scale.megabytes, 0)),
            target: "≤ 200 MB",
            is_met: Some(scale.megabytes <= 200.0),
        },
        Row {
            what: words
                .of(
                    "the same: points read per second",
                    "o mesmo: pontos lidos por segundo",
                )
                .to_owned(),
            figure: words.number(scale.readings, 0),
            target: "64000",
            // Each of them twice a second, but for what a machine at its work delays.
            is_met: Some(scale.readings >= f64::from(*boards) * 32.0 * 2.0 * 0.98),
        },
    ]
}

/// The same points of a hundred boards, read by unoclp and by Node-RED.
fn beside(few: &Scale, node_red: &Scale, words: &Words) -> [Row; 3] {
    let figure = |of: &Scale| {
        format!(
            "{} ({}/s, {} MB)",
            words.number(of.per_processor_second, 0),
            words.number(of.readings, 0),
            words.number(of.megabytes, 0)
        )
    };
    let what = |of: &Scale, name: &str| {
        let boards = of.boards;
        match words.lang {
            Lang::En => {
                format!("{boards} boards: points that {name} reads per second of processor time")
            }
            Lang::Pt => format!(
                "{boards} placas: pontos que o {name} lê por segundo de tempo de processador"
            ),
        }
    };
    let times = few.per_processor_second / node_red.per_processor_second;
    [
        Row {
            what: what(few, "unoclp"),
            figure: figure(few),
            target: "–",
            is_met: None,
        },
        Row {
            what: what(node_red, "Node-RED"),
            figure: figure(node_red),
            target: "–",
            is_met: None,
        },
        Row {
            what: words
                .of(
                    "the ratio of these two figures",
                    "a razão entre esses dois números",
                )
                .to_owned(),
            figure: words.number(times, 1),
            target: "≥ 5",
            is_met: Some(times >= 5.0),
        },
    ]
}

fn line(of: &Line, words: &Words) -> Row {
    let Line {
        boards, up, rate, ..
    } = of;
    let percent = |part: f64| format!("{} %", words.number(100.0 * part, 1));
    let (used, bytes) = (percent(of.used), percent(of.bytes));
    let readings = words.number(of.readings, 0);
    let (what, figure) = match words.lang {
        Lang::En => (
            format!("a line of {boards} boards at {rate} baud: time in use"),
            format!(
                "{used} ({up} of {boards} boards, bytes alone {bytes}, {readings} boards per second)"
            ),
        ),
        Lang::Pt => (
            format!("uma linha de {boards} placas a {rate} baud: tempo em uso"),
            format!(
                "{used} ({up} de {boards} placas, só os bytes {bytes}, {readings} placas por segundo)"
            ),
        ),
    };
    Row {
        what,
        figure,
        target: "≥ 90 %",
        is_met: Some(of.used >= 0.9 && up == boards),
    }
}

fn past(trend: &Trend, words: &Words) -> [Row; 2] {
    let millions = trend.samples as f64 / 1e6;
    let rate = trend.samples as f64 / trend.seconds;
    [
        Row {
            what: format!(
                "{} {}",
                words.number(millions, 0),
                words.of(
                    "million samples written to SQLite: samples per second",
                    "milhões de amostras gravadas em SQLite: amostras por segundo"
                )
            ),
            figure: format!(
                "{} ({} s, {} GB)",
                words.number(rate, 0),
                words.number(trend.seconds, 0),
                words.number(trend.bytes as f64 / 1e9, 1)
            ),
            target: "–",
            is_met: None,
        },
        Row {
            what: words
                .of(
                    "a trend of 30 days in that history: the slowest of 25",
                    "uma tendência de 30 dias nesse histórico: a mais lenta de 25",
                )
                .to_owned(),
            figure: format!(
                "{} ms ({} {} ms, {} {})",
                words.number(trend.longest, 0),
                words.of("median", "mediana"),
                words.number(trend.median, 0),
                trend.rows,
                words.of("steps", "intervalos")
            ),
            target: "≤ 200 ms",
            is_met: Some(trend.longest <= 200.0),
        },
    ]
}

const ENGLISH_HEAD: &str = "# Benchmarks of a site

*[Leia em português](site-benchmarks.pt-BR.md)*

A program writes this page: do not edit it; run the benchmark again.

```
cargo xtask bench --site
```

| what | measured | target | |
| --- | ---: | ---: | --- |
";

const PORTUGUESE_HEAD: &str = "# Medições de uma instalação

*[Read in English](site-benchmarks.md)*

Um programa gera esta página: não a edite; repita a medição.

```
cargo xtask bench --site
```

| o quê | medido | meta | |
| --- | ---: | ---: | --- |
";

const ENGLISH: &str = "
- **The computer** has {processors} processors, and also simulates the boards. On average, {begin} programs were using a
  processor or waiting for one in the minute before the measurement, and {end} in its last minute. Any other load makes the
  figures worse.
- **Boards.** One process simulates them over Modbus TCP, twenty on each line (`tools/cli/examples/scale`). Each gateway has
  200 of them, because Modbus allows at most 247 units; the figures are totals for all gateways. Four of the 32 points
  change from one reading to the next, and the history in SQLite records each change. At each reading, a gateway checks
  whether the board still has its program.
- **Node-RED** 4 with node-red-contrib-modbus 5 reads the same boards at the same interval, after unoclp in the same run.
  Two *Modbus Read* nodes per board read its values and outputs, and a function converts the registers to numbers. Node-RED
  stores nothing, and does not check which program the board has. Its nodes use `modbus-serial` from npm instead of their
  authors' fork, which is not on npm.
- **A line** is a pseudo-terminal on which each byte takes as long as on real wires. Each board is due every 10 ms, which no
  line can keep up with, so a request is always waiting. The *time in use* is that of the bytes and of the silences that
  Modbus requires before each request and each answer. If the system allows it, the gateway and the line have a higher
  priority than everything else (`nice -n -19`).
- **Trend.** A thousand points change at regular intervals over 30 days (`tools/history/examples/trend.rs`), and are written in
  chronological order. A trend is the minimum, the maximum and the last value of one point in each of 600 steps. Each trend
  is for a different point, and nothing is written meanwhile. A trend reads all samples of its point, so it takes longer for
  a point that changes more often.
- **PostgreSQL** is not measured here.
";

const PORTUGUESE: &str = "
- **O computador** tem {processors} processadores e também simula as placas. Em média, {begin} programas usavam ou esperavam
  um processador no minuto anterior à medição, e {end} no último minuto dela. Qualquer outra carga piora os números.
- **Placas.** Um só processo as simula por Modbus TCP, vinte em cada linha (`tools/cli/examples/scale`). Cada gateway tem
  200 delas, porque o Modbus permite no máximo 247 unidades; os números são totais de todos os gateways. Quatro dos 32
  pontos mudam de uma leitura para outra, e o histórico em SQLite registra cada mudança. A cada leitura, o gateway verifica
  se a placa ainda tem o seu programa.
- **O Node-RED** 4 com node-red-contrib-modbus 5 lê as mesmas placas com o mesmo intervalo, depois do unoclp e na mesma
  execução. Dois nós *Modbus Read* por placa leem os valores e as saídas, e uma função converte os registradores em números.
  O Node-RED não guarda nada nem verifica que programa a placa tem. Os nós usam o `modbus-serial` do npm em vez do fork dos
  autores, que não está no npm.
- **Uma linha** é um pseudoterminal em que cada byte leva o mesmo tempo que em fios reais. Cada placa deve ser lida a cada
  10 ms, mais rápido do que qualquer linha permite; por isso, sempre há uma requisição na fila. O *tempo em uso* é o
  tempo ocupado pelos bytes e pelos silêncios que o Modbus exige antes de cada requisição e resposta. Se o sistema permitir, o gateway e a linha
  têm prioridade sobre todo o resto (`nice -n -19`).
- **Tendência.** Mil pontos mudam a intervalos iguais ao longo de 30 dias (`tools/history/examples/trend.rs`) e são gravados em
  ordem cronológica. Uma tendência é o mínimo, o máximo e o último valor de um ponto em cada um de 600 intervalos. Cada
  tendência é de um ponto diferente, sem gravações simultâneas. Uma tendência lê todas as amostras do ponto e, por isso,
  demora mais para um ponto que muda com mais frequência.
- **O PostgreSQL** não é medido aqui.
";
