//! The charts of a running program: which of their steps are active, and for how long.

use std::collections::HashMap;
use unoclp_lang::typed::{Base, Value};
use unoclp_point::Address;
use unoclp_program::{Holding, Source, Variable};
use unoclp_sfc::{Document, Live, Look, Sheet, State, picture};

/// The charts of a program, with the variables that say what is active.
#[derive(Default)]
pub struct Charts(Vec<Chart>);

/// A chart, or one instance of it.
pub struct Chart {
    /// What it is called: its unit, or the instance of its block.
    pub name: String,
    /// The chart.
    pub document: Document,
    sheet: Sheet,
    steps: Vec<OfStep>,
}

/// The variables of a step.
#[derive(Clone, Default)]
struct OfStep {
    active: Option<Variable>,
    /// None where nothing measures it.
    time: Option<Variable>,
}

impl Charts {
    /// Those of this program.
    pub fn new(program: &Source) -> Charts {
        let variables = program.variables.iter();
        let by_name: HashMap<String, &Variable> =
            variables.map(|of| (of.name.to_uppercase(), of)).collect();
        let mut all = Vec::new();
        for document in &program.charts {
            let Some(first) = document.steps.first() else {
                continue;
            };
            let first = format!("{}.X", first.name.to_uppercase());
            let named = program.variables.iter().filter_map(|of| {
                let upper = of.name.to_uppercase();
                let before = upper.strip_suffix(&first)?;
                let is_whole = before.is_empty() || before.ends_with('.');
                is_whole.then(|| of.name[..before.len()].to_owned())
            });
            for before in named {
                all.push(Chart::new(document, &before, &by_name));
            }
        }
        Charts(all)
    }

    /// Whether there are any.
    pub fn any(&self) -> bool {
        !self.0.is_empty()
    }

    /// All of them.
    pub fn all(&self) -> &[Chart] {
        &self.0
    }

    /// The active steps of all on one line, where `read` gives what stands at a point: `● Fill 1.2 s`.
    pub fn line(&self, read: impl Fn(Address) -> Option<i32>) -> String {
        let lines = self.0.iter().map(|chart| {
            let line = chart.live(&read).line(&chart.document);
            match self.0.len() {
                1 => line,
                _ => format!("{}: {line}", chart.name),
            }
        });
        let lines: Vec<String> = lines.collect();
        lines.join("   ")
    }

    /// All of them as they are drawn of characters, what is active with a dot.
    pub fn pictures(&self, read: impl Fn(Address) -> Option<i32>) -> Vec<String> {
        let mut all = Vec::new();
        for chart in &self.0 {
            if self.0.len() > 1 {
                all.push(chart.name.clone());
            }
            let live = chart.live(&read);
            let picture = picture(&chart.document, &chart.sheet, Some(&live));
            all.extend(picture.lines().map(str::to_owned));
            all.push(String::new());
        }
        all
    }
}

impl Chart {
    fn new(document: &Document, before: &str, variables: &HashMap<String, &Variable>) -> Chart {
        let variable = |step: &str, part: &str| {
            let name = format!("{before}{step}.{part}").to_uppercase();
            variables.get(&name).map(|of| (*of).clone())
        };
        let steps = document.steps.iter().map(|step| OfStep {
            active: variable(&step.name, "X"),
            time: variable(&step.name, "T")
                .filter(|of| !matches!(of.holding, Holding::Constant(..))),
        });
        let name = match before.trim_end_matches('.') {
            "" => document.unit.clone(),
            instance => instance.to_owned(),
        };
        Chart {
            name,
            steps: steps.collect(),
            sheet: Sheet::drawn(document, Look::Norm),
            document: document.clone(),
        }
    }

    /// What is active, where `read` gives what stands at a point.
    pub fn live(&self, read: impl Fn(Address) -> Option<i32>) -> Live {
        let steps = self.steps.iter().map(|step| {
            let value = |of: &Option<Variable>| of.as_ref()?.value(&read);
            let active = match value(&step.active) {
                Some((Value::Int(is), Base::Bool)) => is != 0,
                _ => false,
            };
            let time = match value(&step.time) {
                Some((Value::Int(ms), Base::Time)) => i64::try_from(ms).ok(),
                _ => None,
            };
            State { active, time }
        });
        Live {
            steps: steps.collect(),
        }
    }

    /// The points of each step: whether it is active, and its time, where they stand at one.
    pub fn points(&self) -> impl Iterator<Item = [Option<Address>; 2]> {
        let point = |of: &Option<Variable>| match of.as_ref()?.holding {
            Holding::One((point, _)) => Some(point),
            _ => None,
        };
        self.steps
            .iter()
            .map(move |step| [point(&step.active), point(&step.time)])
    }
}
