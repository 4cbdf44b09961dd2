//! The cases of `cases/`: what a text is told, and what it does on the board's own engine.
//!
//! A case is data, so that a text in another language can stand beside the one in Instruction List.

use crate::common::{LARGE, large, plc};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use unoclp_core::Image;
use unoclp_lang::{Lang, TextLanguage, compile};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    case: Vec<Case>,
}

/// A text, and what comes of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// What the case shows.
    name: String,
    il: String,
    /// The codes of what is told, in the order of their places.
    #[serde(default)]
    told: Vec<String>,
    /// For each of them, a part of its message or help in English.
    #[serde(default)]
    says: Vec<String>,
    /// Likewise in Portuguese.
    #[serde(default)]
    diz: Vec<String>,
    /// What the program keeps over a power cut, as its codes spell it.
    #[serde(default)]
    kept: Vec<String>,
    /// M 57 to M 64 as another program has left them; bit 0 is M 57.
    #[serde(default)]
    left: u8,
    /// The scans before which the power is cut, the first 0.
    #[serde(default)]
    cuts: Vec<u32>,
    /// The inputs of each scan; bit 0 is input 01.
    #[serde(default)]
    inputs: Vec<u128>,
    /// When each scan begins, ms; where they do not say, 1 ms apart.
    #[serde(default)]
    times: Vec<u32>,
    /// The outputs of each scan; bit 0 is output 01.
    #[serde(default)]
    outputs: Vec<u128>,
    /// Registers after the last scan, by their numbers.
    #[serde(default)]
    registers: BTreeMap<String, i32>,
    /// The PWM of output 01 after the last scan.
    pwm: Option<u8>,
}

impl Case {
    /// What is not as it should be.
    fn fault(&self) -> Option<String> {
        let compiled = compile(&self.il, TextLanguage::Il, &large());
        let said = |lang| -> Vec<String> {
            let one = |d: &unoclp_lang::Diagnostic| [d.message(lang), d.help(lang)].join("; ");
            compiled.diagnostics.iter().map(one).collect()
        };
        let (told, dito) = (said(Lang::En), said(Lang::Pt));
        let codes: Vec<String> = compiled
            .diagnostics
            .iter()
            .map(|d| d.code.to_string())
            .collect();
        if codes != self.told {
            return Some(format!("told {codes:?} {told:#?}, not {:?}", self.told));
        }
        let says = self.says.iter().zip(&told);
        let silent = says
            .chain(self.diz.iter().zip(&dito))
            .find(|(part, told)| !told.contains(*part));
        if let Some((part, told)) = silent {
            return Some(format!("{told:?} does not say {part:?}"));
        }
        let spelt = compiled.lines.iter().map(|line| line.letters.as_str());
        let kept: Vec<&str> = spelt.filter(|letters| letters.starts_with('K')).collect();
        if kept != self.kept {
            return Some(format!("keeps {kept:?}"));
        }
        match compiled.file() {
            Some(file) => self.fault_of(&file),
            None => (!self.outputs.is_empty()).then(|| "there is no program".to_owned()),
        }
    }

    fn fault_of(&self, file: &str) -> Option<String> {
        let mut memory = vec![0; 64_000];
        let mut plc = plc(file, &mut memory, LARGE);
        let mut outputs = Vec::new();
        plc.retain(self.left);
        for (scan, &points) in (0..).zip(&self.inputs) {
            if self.cuts.contains(&scan) {
                plc.restart();
            }
            let at = self.times.get(scan as usize).copied().unwrap_or(scan);
            match plc.scan(Image(points), at) {
                Ok(image) => outputs.push(image.0),
                Err(fault) => return Some(fault.to_string()),
            }
        }
        let registers = self.registers.keys().map(|name| {
            let number: usize = name.trim_start_matches('D').parse().unwrap();
            (name.clone(), plc.registers()[number - 1])
        });
        let registers: BTreeMap<_, _> = registers.collect();
        let wrong = outputs != self.outputs || registers != self.registers;
        let pwm = self.pwm.map(|_| plc.pwm(1));
        (wrong || pwm != self.pwm)
            .then(|| format!("{outputs:?}, registers {registers:?}, PWM {pwm:?}\n{file}"))
    }
}

/// Each file of cases is run, and what is wrong in any of them is shown.
#[test]
fn cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    paths.sort();
    let (mut count, mut wrong) = (0, Vec::new());
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        let cases: Cases =
            toml::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        for case in cases.case {
            let most = case.says.len().max(case.diz.len());
            assert!(most <= case.told.len(), "{}", case.name);
            count += 1;
            if let Some(fault) = case.fault() {
                let file = path.file_name().unwrap_or_default().to_string_lossy();
                wrong.push(format!("{file}: {}: {fault}", case.name));
            }
        }
    }
    assert!(count >= 100, "{count}");
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n\n")
    );
}
