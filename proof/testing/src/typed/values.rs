//! Expressions of each type.

use super::{Author, COLORS, MOMENTS, NUMBERS};

/// Conversions to fewer bits, and after how much the result is the same again.
const NARROWED: [(&str, &str, u32); 9] = [
    ("DINT", "INT", 65_536),
    ("UDINT", "INT", 65_536),
    ("DINT", "UINT", 65_536),
    ("UDINT", "UINT", 65_536),
    ("INT", "SINT", 256),
    ("DINT", "SINT", 256),
    ("UINT", "SINT", 256),
    ("UINT", "USINT", 256),
    ("INT", "USINT", 256),
];

impl Author {
    /// A constant of a type of [`NUMBERS`] or [`MOMENTS`].
    pub(super) fn literal(&mut self, ty: &str) -> String {
        let (low, high): (i64, i64) = match ty {
            "SINT" => (-128, 127),
            "INT" => (-32768, 32767),
            "DINT" => (i32::MIN.into(), i32::MAX.into()),
            "USINT" | "BYTE" => (0, 255),
            "UINT" | "WORD" => (0, 65535),
            "UDINT" | "DWORD" => (0, u32::MAX.into()),
            _ => return self.moment_literal(ty).to_owned(),
        };
        let number = match self.random.below(4) {
            0 => low,
            1 => high,
            2 => (self.random.below(12) as i64).min(high),
            _ => low + (self.random.bits() % (high - low + 1) as u64) as i64,
        };
        match ty {
            "BYTE" | "WORD" | "DWORD" => format!("{ty}#16#{number:X}"),
            _ => format!("{ty}#{number}"),
        }
    }

    fn moment_literal(&mut self, ty: &str) -> &'static str {
        let choice: &[&str] = match ty {
            "TIME" => &[
                "T#0ms", "T#-1s", "T#1500ms", "T#2h3m", "T#24d20h", "T#999ms",
            ],
            "TOD" => &["TOD#00:00:00", "TOD#23:59:59.999", "TOD#12:30:00"],
            "DATE" => &[
                "D#1970-01-01",
                "D#2026-11-23",
                "D#2000-02-29",
                "D#2105-12-31",
            ],
            _ => &[
                "DT#1970-01-01-00:00:00",
                "DT#2026-11-23-14:30:00",
                "DT#2106-02-07-06:28:15",
            ],
        };
        self.random.pick(choice)
    }

    /// A variable of this type, an element or a member.
    pub(super) fn name(&mut self, ty: &str) -> String {
        let of_type = |(known, _): &&(&str, &str)| *known == ty;
        let prefix = NUMBERS.iter().chain(&MOMENTS).find(of_type);
        let prefix = prefix.map_or("i", |(_, prefix)| prefix);
        match self.random.below(6) {
            0 if ty == "INT" => format!("a[{}]", self.subscript()),
            1 if ty == "INT" => format!("m[{}, {}]", self.subscript(), self.subscript()),
            0 if ty == "DINT" => format!("p[{}].x", self.subscript()),
            1 if ty == "DINT" => "q.pair.x".to_owned(),
            0 if ty == "SINT" => format!("q.v[{}]", self.subscript()),
            _ => format!("{prefix}{}", self.random.below(2)),
        }
    }

    /// Mostly inside, of most arrays.
    pub(super) fn subscript(&mut self) -> String {
        match self.random.below(7) {
            0 => self.random.below(2).to_string(),
            1 => "i0 MOD 3".to_owned(),
            2 | 3 => format!("k{}", self.random.below(2)),
            4 => self.narrowed(None),
            5 => format!("{} MOD 3", self.narrowed(None)),
            _ => "d1 + 1".to_owned(),
        }
    }

    /// A conversion to fewer bits, of a number that mostly needs more of them; to this type or to any.
    pub(super) fn narrowed(&mut self, to: Option<&str>) -> String {
        let fits = |&&(_, ty, _): &&(&str, &str, u32)| to.is_none_or(|to| to == ty);
        let rows: Vec<_> = NARROWED.iter().filter(fits).copied().collect();
        if rows.is_empty() {
            return self.name(to.unwrap_or("INT"));
        }
        let (from, to, turn) = self.random.pick(&rows);
        let prefix = NUMBERS.iter().find(|(known, _)| *known == from);
        let name = format!(
            "{}{}",
            prefix.map_or("d", |(_, prefix)| prefix),
            self.random.below(2)
        );
        let small = self.random.below(3);
        let number = match self.random.below(3) {
            0 => name,
            1 => format!("{name} + {turn}"),
            _ => format!("{name} * {turn} + {small}"),
        };
        format!("{from}_TO_{to}({number})")
    }

    /// A number, a bit string, a time or a date.
    pub(super) fn value(&mut self, ty: &str, deep: usize) -> String {
        let Some(next) = deep.checked_sub(1) else {
            return match self.random.below(9) {
                8 => self.narrowed(Some(ty)),
                0..3 => self.literal(ty),
                3 if ty == "INT" => "%IW4".to_owned(),
                4 if ty == "INT" && self.random.percent(30) => "level".to_owned(),
                _ => self.name(ty),
            };
        };
        match ty {
            "BYTE" | "WORD" | "DWORD" => self.bits(ty, next),
            "TIME" | "TOD" | "DATE" | "DT" => self.moment(ty, next),
            _ => self.number(ty, next),
        }
    }

    fn bits(&mut self, ty: &str, next: usize) -> String {
        match self.random.below(8) {
            0 => format!("NOT ({})", self.value(ty, next)),
            1..5 => {
                let shift = self.random.pick(&["SHL", "SHR", "ROL", "ROR"]);
                let by = match self.random.percent(12) {
                    true => self.narrowed(None),
                    false => self.random.below(34).to_string(),
                };
                format!("{shift}({}, {by})", self.value(ty, next))
            }
            5 => self.converted(ty, next),
            _ => {
                let op = self.random.pick(&["AND", "OR", "XOR"]);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
        }
    }

    fn converted(&mut self, ty: &str, next: usize) -> String {
        let (from, _) = self.random.pick(&NUMBERS);
        match from == ty {
            true => self.value(ty, next),
            false => format!("{from}_TO_{ty}({})", self.value(from, next)),
        }
    }

    fn number(&mut self, ty: &str, next: usize) -> String {
        match self.random.below(14) {
            0 if !ty.starts_with('U') => format!("-({})", self.value(ty, next)),
            1 => format!("ABS({})", self.value(ty, next)),
            2 => self.either(ty, next),
            3 => format!(
                "SEL({}, {}, {})",
                self.truth(next),
                self.value(ty, next),
                self.value(ty, next)
            ),
            4 | 5 => self.converted(ty, next),
            6 => format!("BOOL_TO_{ty}({})", self.truth(next)),
            7 if ty != "UDINT" => format!("REAL_TO_{ty}({})", self.real(next)),
            8 => format!(
                "LIMIT({}, {}, {})",
                self.value(ty, 0),
                self.value(ty, next),
                self.value(ty, 0)
            ),
            9 if ty == "INT" => format!("Twice({})", self.value(ty, next)),
            9 if ty == "DINT" => match self.random.percent(50) {
                true => format!("TIME_TO_DINT({})", self.value("TIME", next)),
                false => format!("TRUNC({})", self.real(next)),
            },
            10 => format!(
                "MUX({}, {}, {}, {})",
                match self.random.percent(50) {
                    true => self.narrowed(None),
                    false => self.value("DINT", 0),
                },
                self.value(ty, next),
                self.value(ty, 0),
                self.value(ty, 0)
            ),
            _ => {
                let op = self.random.pick(&["+", "-", "*", "/", "MOD", "+", "-"]);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
        }
    }

    fn either(&mut self, ty: &str, next: usize) -> String {
        let which = self.random.pick(&["MAX", "MIN"]);
        format!(
            "{which}({}, {})",
            self.value(ty, next),
            self.value(ty, next)
        )
    }

    fn moment(&mut self, ty: &str, next: usize) -> String {
        let op = self.random.pick(&["+", "-"]);
        match (ty, self.random.below(6)) {
            (_, 0) => self.either(ty, next),
            (_, 1) => format!(
                "SEL({}, {}, {})",
                self.truth(next),
                self.value(ty, next),
                self.value(ty, next)
            ),
            ("TIME", 2) => format!("DINT_TO_TIME({})", self.value("DINT", next)),
            ("TIME", 3) => {
                let op = self.random.pick(&["*", "/"]);
                format!(
                    "({} {op} {})",
                    self.value(ty, next),
                    self.value("INT", next)
                )
            }
            ("TIME", 4) => {
                let (of, _) = self.random.pick(&MOMENTS[1..]);
                format!("({} - {})", self.value(of, next), self.value(of, next))
            }
            ("TOD", 2) => format!("DT_TO_TOD({})", self.value("DT", next)),
            ("TOD" | "DATE", 3) => {
                let (from, _) = self.random.pick(&NUMBERS);
                format!("{from}_TO_{ty}({})", self.name(from))
            }
            ("TIME", 5) => {
                let from = self.random.pick(&["SINT", "INT", "USINT"]);
                format!("{from}_TO_TIME({})", self.narrowed(Some(from)))
            }
            ("DT", 2) => format!("DATE_TO_DT({})", self.value("DATE", next)),
            ("DATE", _) => format!("DT_TO_DATE({})", self.value("DT", next)),
            _ => format!(
                "({} {op} {})",
                self.value(ty, next),
                self.value("TIME", next)
            ),
        }
    }

    pub(super) fn real(&mut self, deep: usize) -> String {
        let Some(next) = deep.checked_sub(1) else {
            return match self.random.below(6) {
                0 | 1 => self
                    .random
                    .pick(&["0.5", "-2.25", "1.0E10", "3.1415", "0.0", "-1.0E38"])
                    .to_owned(),
                2 => format!("ra[{}]", self.subscript()),
                3 => "q.r".to_owned(),
                _ => format!("r{}", self.random.below(2)),
            };
        };
        match self.random.below(10) {
            0 | 1 => {
                let (from, _) = self.random.pick(&NUMBERS[..6]);
                format!("{from}_TO_REAL({})", self.value(from, next))
            }
            2 => format!("ABS({})", self.real(next)),
            3 => format!("SQRT({})", self.real(next)),
            4 => format!("MAX({}, {})", self.real(next), self.real(next)),
            5 => format!("EXPT({}, {})", self.real(next), self.random.below(5)),
            6 => format!("Mean({}, {})", self.real(next), self.real(next)),
            _ => {
                let op = self.random.pick(&["+", "-", "*", "/"]);
                format!("({} {op} {})", self.real(next), self.real(next))
            }
        }
    }

    pub(super) fn color(&mut self) -> String {
        match self.random.below(3) {
            0 => self.random.pick(&COLORS).to_owned(),
            1 => format!("SEL({}, {}, c1)", self.bit(), self.random.pick(&COLORS)),
            _ => format!("c{}", self.random.below(2)),
        }
    }

    pub(super) fn bit(&mut self) -> String {
        match self.random.below(12) {
            0..2 => format!("%IX{}", 1 + self.random.below(4)),
            2 => format!("f[{}]", self.subscript()),
            3 => "p[1].on".to_owned(),
            4 => "lamp".to_owned(),
            5 => format!("%S{}", 1 + self.random.below(3)),
            _ => format!("b{}", self.random.below(4)),
        }
    }

    pub(super) fn truth(&mut self, deep: usize) -> String {
        let Some(next) = deep.checked_sub(1) else {
            return self.bit();
        };
        let op = self.random.pick(&["<", "<=", ">", ">=", "=", "<>"]);
        match self.random.below(11) {
            0 => format!("NOT {}", self.bit()),
            1 => format!("NOT ({})", self.truth(next)),
            2 | 3 => {
                let (ty, _) = self.random.pick(&NUMBERS);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
            4 => {
                let (ty, _) = self.random.pick(&MOMENTS);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
            5 => format!("({} {op} {})", self.real(next), self.real(next)),
            6 => format!("({} = {})", self.color(), self.color()),
            7 => match self.random.percent(50) {
                true => format!("DINT_TO_BOOL({})", self.value("DINT", next)),
                false => format!("INT_TO_BOOL({})", self.narrowed(Some("INT"))),
            },
            8 => format!(
                "SEL({}, {}, {})",
                self.bit(),
                self.truth(next),
                self.truth(next)
            ),
            _ => {
                let op = self.random.pick(&["AND", "OR", "XOR", "AND", "OR", "="]);
                format!("({} {op} {})", self.truth(next), self.truth(next))
            }
        }
    }
}
