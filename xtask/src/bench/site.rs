//! The pages `docs/site-benchmarks.md` and its translation: what a gateway takes for many boards, and how long a trend takes.

use crate::lab;
use crate::shell::{self, cargo, say};
use anyhow::{Context, Result};
use serde::Deserialize;
use std::fs;
use std::process::Command;

/// What `tools/serve/examples/scale.rs` says.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Scale {
    boards: u32,
    up: u32,
    gateways: u32,
    /// Points read a second, and for each second of a processor.
    readings: f64,
    per_processor_second: f64,
    /// Processors in use, and memory.
    core: f64,
    megabytes: f64,
}

/// What `tools/history/examples/trend.rs` says.
#[derive(Deserialize)]
struct Trend {
    samples: u64,
    /// To write them, and what they take.
    seconds: f64,
    bytes: u64,
    rows: u32,
    /// Trends, ms.
    median: f64,
    longest: f64,
}

/// Measures, and writes the pages.
///
/// # Errors
/// If a step fails. A target that is not met is no failure: the pages say so.
pub fn run() -> Result<()> {
    lab::build()?;
    say("bench: the program as it is handed out");
    let mut program = cargo();
    let built = [
        "build",
        "--release",
        "--package=unoclp-cli",
        "--no-default-features",
        "--features=page",
    ];
    shell::run(program.args(built))?;
    say("bench: a thousand boards");
    let mut scale = example("unoclp-serve", "scale");
    let scale: Scale = said(scale.arg(shell::root().join("target/release/unoclp")))?;
    say("bench: a history of 100 million samples; this takes an hour or more, and 5 GB");
    let trend: Trend = said(&mut example("unoclp-history", "trend"))?;
    for (file, page) in [
        ("site-benchmarks.md", page(&scale, &trend, &ENGLISH)),
        (
            "site-benchmarks.pt-BR.md",
            page(&scale, &trend, &PORTUGUESE),
        ),
    ] {
        let path = shell::root().join("docs").join(file);
        fs::write(&path, page).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

fn example(package: &str, name: &str) -> Command {
    let mut command = cargo();
    command.args(["run", "--quiet", "--release", "--package", package]);
    command.args(["--example", name, "--"]);
    command
}

/// What a command prints, as JSON.
fn said<T: for<'d> Deserialize<'d>>(command: &mut Command) -> Result<T> {
    let told = shell::output(command).with_context(|| format!("{command:?} failed"))?;
    serde_json::from_str(&told).with_context(|| format!("{command:?} said {told}"))
}

/// A page in its language.
struct Words {
    head: &'static str,
    /// The rows: what, and the target.
    rows: [[&'static str; 2]; 4],
    met: [&'static str; 2],
    /// The decimal sign.
    point: &'static str,
    tail: &'static str,
}

const ENGLISH: Words = Words {
    head: "# Benchmarks of a site\n\n*[Leia em português](site-benchmarks.pt-BR.md)*\n\n`cargo xtask bench --site` measures, and writes this page. A target that is not met says so.\n\n| | measured | target | |\n| --- | ---: | ---: | --- |\n",
    rows: [
        [
            "simulated boards of 32 points, each read twice a second: processors in use",
            "≤ 1",
        ],
        ["the same: memory of all gateways", "≤ 200 MB"],
        ["points read for each second of a processor", "–"],
        [
            "a trend of 30 days in a history of that many samples, in SQLite: the longest of 25",
            "≤ 200 ms",
        ],
    ],
    met: ["met", "**not met**"],
    point: ".",
    tail: "\n- **Boards.** A process simulates them behind Modbus TCP, twenty on each line (`tools/serve/examples/scale.rs`). A gateway has 200 of\n  them, as Modbus has 247 units at most; the figures are those of all gateways together. Four of 32 points change from reading to reading,\n  and the history in SQLite takes each change. Boards at serial lines are bound by the line, and were not measured.\n- **Trend.** A thousand points change evenly over 30 days (`tools/history/examples/trend.rs`). A trend is the least, the most and the last of\n  each of 600 steps of one point, each time of another point, read beside nobody who writes.\n- **Not measured here:** Node-RED with the same points, 32 boards on one RS-485 line, PostgreSQL.\n",
};

const PORTUGUESE: Words = Words {
    head: "# Medições de uma instalação\n\n*[Read in English](site-benchmarks.md)*\n\n`cargo xtask bench --site` mede e escreve esta página. Uma meta que não foi atingida aparece assim.\n\n| | medido | meta | |\n| --- | ---: | ---: | --- |\n",
    rows: [
        [
            "placas simuladas de 32 pontos, cada uma lida duas vezes por segundo: processadores em uso",
            "≤ 1",
        ],
        ["o mesmo: memória de todos os gateways", "≤ 200 MB"],
        ["pontos lidos por segundo de processador", "–"],
        [
            "uma tendência de 30 dias em um histórico com tantas amostras, em SQLite: a mais longa de 25",
            "≤ 200 ms",
        ],
    ],
    met: ["atingida", "**não atingida**"],
    point: ",",
    tail: "\n- **Placas.** Um processo as simula por Modbus TCP, vinte em cada linha (`tools/serve/examples/scale.rs`). Um gateway tem 200 delas, pois o\n  Modbus tem no máximo 247 unidades; os números são os de todos os gateways juntos. Quatro de 32 pontos mudam de leitura a leitura, e o\n  histórico em SQLite recebe cada mudança. Placas em linhas seriais dependem da linha e não foram medidas.\n- **Tendência.** Mil pontos mudam por igual ao longo de 30 dias (`tools/history/examples/trend.rs`). Uma tendência é o menor, o maior e o\n  último valor de cada um de 600 passos de um ponto, cada vez de outro ponto, lida sem ninguém escrever ao mesmo tempo.\n- **Não medidos aqui:** o Node-RED com os mesmos pontos, 32 placas em uma linha RS-485, o PostgreSQL.\n",
};

fn page(scale: &Scale, trend: &Trend, words: &Words) -> String {
    let number = |of: f64, digits: usize| format!("{of:.digits$}").replace('.', words.point);
    let millions = trend.samples as f64 / 1e6;
    let Scale {
        boards,
        up,
        gateways,
        ..
    } = scale;
    let [is_busy, memory, each, longest] = [
        (
            format!(
                "{} ({up}/{boards}, {gateways} gateways)",
                number(scale.core, 2)
            ),
            Some(scale.core <= 1.0 && up == boards),
        ),
        (
            format!("{} MB", number(scale.megabytes, 0)),
            Some(scale.megabytes <= 200.0),
        ),
        (
            format!(
                "{} ({}/s)",
                number(scale.per_processor_second, 0),
                number(scale.readings, 0)
            ),
            None,
        ),
        (
            format!(
                "{} ms ({} × 10⁶, {} GB, {} s, {} ms, {})",
                number(trend.longest, 0),
                number(millions, 0),
                number(trend.bytes as f64 / 1e9, 1),
                number(trend.seconds, 0),
                number(trend.median, 0),
                trend.rows
            ),
            Some(trend.longest <= 200.0),
        ),
    ];
    let figures = [is_busy, memory, each, longest];
    let rows = words
        .rows
        .iter()
        .zip(&figures)
        .map(|([what, target], (figure, is_met))| {
            let [yes, no] = words.met;
            let met = is_met.map_or("", |is_met| if is_met { yes } else { no });
            format!("| {what} | {figure} | {target} | {met} |\n")
        });
    format!("{}{}{}", words.head, rows.collect::<String>(), words.tail)
}
