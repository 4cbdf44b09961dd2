//! The pages `docs/machine-benchmarks.md` and its translation: what a machine costs the board beside it, how fast it is drawn,
//! and how long it takes to grade a class with one.

use crate::shell::{self, cargo, say};
use crate::{lab, node};
use anyhow::{Context, Result};
use serde::Deserialize;
use std::fs;
use std::process::Command;

/// What the page's bench says (`page/web/test/bench/machines.ts`).
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Beside {
    /// The share of the pace that the dearest machine takes, and which it is.
    lost: f64,
    lost_by: String,
    /// The longest drawing, ms, and of which machine.
    drawing: f64,
    drawing_of: String,
}

/// What `tools/plant/examples/step.rs` says: the longest step, µs, and of which machine.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Step {
    step: f64,
    step_of: String,
}

/// What `tools/exercise/examples/class.rs` says, s.
#[derive(Deserialize)]
struct Class {
    cases: f64,
    machine: f64,
}

/// Measures, and writes the pages.
///
/// # Errors
/// If a step fails. A target that is not met is no failure: the pages say so.
pub fn run() -> Result<()> {
    lab::build()?;
    let mut built = Command::new("node");
    shell::run(
        built
            .current_dir(node::folder())
            .args(["build.mjs", "bench"]),
    )?;
    say("bench: the machines in the page");
    let mut bench = Command::new("node");
    bench.arg(shell::root().join("target/lab/bench/machines.mjs"));
    let beside: Beside = said(bench.arg("--json"))?;
    say("bench: the machines alone");
    let step: Step = said(&mut example("unoclp-plant", "step"))?;
    say("bench: a class");
    let class: Class = said(&mut example("unoclp-exercise", "class"))?;
    let rows = rows(&step, &beside, &class);
    for (file, page) in [
        ("machine-benchmarks.md", english(&rows)),
        ("machine-benchmarks.pt-BR.md", portuguese(&rows)),
    ] {
        let path = shell::root().join("docs").join(file);
        fs::write(&path, page).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// The command that runs an example, built as the tests are: what is measured is optimized there too, and compiled already.
fn example(package: &str, name: &str) -> Command {
    let mut command = cargo();
    command.args(["run", "--quiet", "--package", package]);
    command.args(["--example", name, "--", "--json"]);
    command
}

/// What a command prints, as JSON.
fn said<T: for<'d> Deserialize<'d>>(command: &mut Command) -> Result<T> {
    let told = shell::output(command).with_context(|| format!("{command:?} failed"))?;
    serde_json::from_str(&told).with_context(|| format!("{command:?} said {told}"))
}

/// What was measured, and whether that is the target.
type Row = (String, bool);

/// The rows as a person reads them.
fn rows(step: &Step, beside: &Beside, class: &Class) -> [Row; 4] {
    let all = class.cases + class.machine;
    let a_second = 1000.0 / beside.drawing;
    [
        (
            format!("{:.2} µs (`{}`)", step.step, step.step_of),
            step.step <= 5.0,
        ),
        (
            format!("{:.1} % (`{}`)", 100.0 * beside.lost, beside.lost_by),
            beside.lost <= 0.05,
        ),
        (
            format!("{a_second:.0} (`{}`)", beside.drawing_of),
            a_second >= 60.0,
        ),
        (
            format!("{all:.1} s ≈ {:.1} s + {:.1} s", class.cases, class.machine),
            all <= 20.0,
        ),
    ]
}

fn table(head: &str, names: [(&str, &str); 4], rows: &[Row; 4], met: [&str; 2]) -> String {
    let rows = names
        .iter()
        .zip(rows)
        .map(|((what, target), (figure, is_met))| {
            let [yes, no] = met;
            let met = if *is_met { yes } else { no };
            format!("| {what} | {figure} | {target} | {met} |\n")
        });
    format!(
        "{head}\n| --- | ---: | ---: | --- |\n{}",
        rows.collect::<String>()
    )
}

fn english(rows: &[Row; 4]) -> String {
    let names = [
        ("a step of 1 ms in native code, slowest machine", "≤ 5 µs"),
        (
            "speed that a simulated board, UNO or Mega, loses to its machine, worst case",
            "≤ 5 %",
        ),
        ("drawings per second, slowest machine", "≥ 60"),
        (
            "grading 200 programs × 20 cases with a machine: cases + machine",
            "≤ 20 s",
        ),
    ];
    let head = "| what | measured | target | |";
    let table = table(head, names, rows, ["met", "not met"]);
    format!(
        "# Benchmarks of the machines\n\n*[Leia em português](machine-benchmarks.pt-BR.md)*\n\n\
A program writes this page: do not edit it; run the benchmark again.\n\n```\ncargo xtask bench --machines\n```\n\n\
The figures depend on the computer. A simulated board with the unmodified firmware runs the model solution of each machine,\n\
alternately with the machine and without it. Without it, the contacts stay as the machine left them. The machine advances one\n\
step per simulated millisecond and is drawn 60 times a second, as in the lab. The loss of speed is the median of 150\n\
differences in processor time. A drawing is the output of the Rust code, as JavaScript reads it; rendering in the browser is not\n\
counted. Native code is built with the settings of the tests. `npm run bench` in `page/web` prints the figures of each machine.\n\n{table}"
    )
}

fn portuguese(rows: &[Row; 4]) -> String {
    let names = [
        (
            "um passo de 1 ms em código nativo, máquina mais lenta",
            "≤ 5 µs",
        ),
        (
            "velocidade que uma placa simulada, UNO ou Mega, perde por causa da máquina, pior caso",
            "≤ 5 %",
        ),
        ("desenhos por segundo, máquina mais lenta", "≥ 60"),
        (
            "correção de 200 programas × 20 casos com uma máquina: casos + máquina",
            "≤ 20 s",
        ),
    ];
    let head = "| o quê | medido | meta | |";
    let rows = rows
        .clone()
        .map(|(figure, met)| (figure.replace('.', ","), met));
    let table = table(head, names, &rows, ["atingida", "não atingida"]);
    format!(
        "# Medições das máquinas\n\n*[Read in English](machine-benchmarks.md)*\n\n\
Um programa gera esta página: não a edite; repita a medição.\n\n```\ncargo xtask bench --machines\n```\n\n\
Os números dependem do computador. Uma placa simulada, com o firmware sem alterações, executa a solução-modelo de cada máquina,\n\
alternadamente com a máquina e sem ela. Sem a máquina, os contatos ficam como ela os deixou. A máquina avança um passo por\n\
milissegundo simulado e é desenhada 60 vezes por segundo, como no laboratório. A perda de velocidade é a mediana de 150\n\
diferenças de tempo de processador. Um desenho é a saída do código em Rust, como o JavaScript a lê; a renderização no navegador\n\
não conta. O código nativo é compilado com as opções dos testes. `npm run bench` em `page/web` mostra os números de cada\n\
máquina.\n\n{table}"
    )
}
