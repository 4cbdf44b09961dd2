//! Statements, and calls of blocks.

use super::{Author, MOMENTS, NUMBERS};

impl Author {
    fn line(&mut self, line: &str) {
        for _ in 0..self.depth {
            self.text.push_str("  ");
        }
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn body(&mut self, count: usize) {
        self.depth += 1;
        for _ in 0..count {
            self.statement();
        }
        self.depth -= 1;
    }

    pub(super) fn statement(&mut self) {
        let deep = 1 + self.random.below(3);
        match self.random.below(26) {
            0..=5 => {
                let (ty, _) = self.random.pick(&NUMBERS);
                let to = self.name(ty);
                let value = self.value(ty, deep);
                self.line(&format!("{to} := {value};"));
            }
            6..=8 => {
                let to = match self.random.below(6) {
                    0 => "lamp".to_owned(),
                    1 => "horn".to_owned(),
                    2 => format!("f[{}]", self.subscript()),
                    _ => format!("b{}", self.random.below(4)),
                };
                let value = self.truth(deep);
                self.line(&format!("{to} := {value};"));
            }
            9 => {
                let to = match self.random.below(4) {
                    0 => format!("ra[{}]", self.subscript()),
                    1 => "q.r".to_owned(),
                    _ => format!("r{}", self.random.below(2)),
                };
                let value = self.real(deep);
                self.line(&format!("{to} := {value};"));
            }
            10 => {
                let to = self.random.pick(&["narrow", "level"]);
                let value = self.value("INT", deep);
                self.line(&format!("{to} := {value};"));
            }
            11 => {
                let (ty, _) = self.random.pick(&MOMENTS);
                let to = self.name(ty);
                let value = self.value(ty, deep.min(2));
                self.line(&format!("{to} := {value};"));
            }
            12 => {
                let value = self.color();
                let to = self.random.below(2);
                self.line(&format!("c{to} := {value};"));
            }
            13 => self.line("e0 := %S4;"),
            14 => {
                let (which, more) = (self.random.below(2), self.value("DINT", 1));
                let total = self.random.pick(&["d0", "d1", "q.pair.x"]);
                self.line(&format!(
                    "totals[{which}](more := {more}, total := {total}, calls => us1);"
                ));
            }
            15..=17 if self.depth < 4 => self.condition(deep.min(2)),
            18 if self.depth < 3 => self.choice(),
            19 | 20 if self.loops < 2 && self.depth < 3 => self.counted_loop(),
            21 if self.loops < 2 && self.depth < 3 => self.conditional_loop(),
            22..=24 => self.call(),
            _ => {
                let (to, from) = (self.name("DINT"), self.name("DINT"));
                self.line(&format!("{to} := {from} + 1;"));
            }
        }
    }

    fn condition(&mut self, deep: usize) {
        let condition = self.truth(deep);
        self.line(&format!("IF {condition} THEN"));
        let count = 1 + self.random.below(2);
        self.body(count);
        if self.random.percent(40) {
            let condition = self.truth(1);
            self.line(&format!("ELSIF {condition} THEN"));
            self.body(1);
        }
        if self.random.percent(50) {
            self.line("ELSE");
            self.body(1);
        }
        self.line("END_IF;");
    }

    fn choice(&mut self) {
        let (of, labels) = match self.random.percent(30) {
            true => (self.color(), ["Red", "Green, Blue"]),
            false if self.random.percent(40) => {
                (self.narrowed(Some("INT")), ["1, 3", "-5..0, 7..90"])
            }
            false => (self.value("INT", 1), ["1, 3", "-5..0, 7..90"]),
        };
        self.line(&format!("CASE {of} OF"));
        for label in labels {
            self.line(&format!("{label}:"));
            self.body(1);
        }
        if self.random.percent(60) {
            self.line("ELSE");
            self.body(1);
        }
        self.line("END_CASE;");
    }

    fn counted_loop(&mut self) {
        let number = self.loops;
        self.loops += 1;
        let (from, to) = (self.random.below(4), self.random.below(5));
        let to = match self.random.percent(50) {
            true => to.to_string(),
            false if self.random.percent(50) => {
                format!("MIN({to}, {})", self.narrowed(Some("INT")))
            }
            false => format!("MIN({to}, {})", self.value("INT", 1)),
        };
        let (to, by) = match self.random.percent(25) {
            true => ("0".to_owned(), " BY -1"),
            false => (to, ""),
        };
        self.line(&format!("FOR k{number} := {from} TO {to}{by} DO"));
        self.body(1);
        if self.random.percent(40) {
            let condition = self.truth(1);
            let word = self.random.pick(&["EXIT", "CONTINUE"]);
            self.line(&format!("  IF {condition} THEN {word}; END_IF;"));
        }
        self.body(1);
        self.line("END_FOR;");
    }

    fn conditional_loop(&mut self) {
        self.loops += 1;
        self.line("c := 0;");
        let condition = self.truth(1);
        let repeat = self.random.percent(50);
        match repeat {
            true => self.line("REPEAT"),
            false => self.line(&format!("WHILE c < 4 AND {condition} DO")),
        }
        self.body(1);
        self.line("  c := c + 1;");
        match repeat {
            true => self.line(&format!("UNTIL c >= 3 OR {condition} END_REPEAT;")),
            false => self.line("END_WHILE;"),
        }
    }

    /// A call of a block, often of one that has been called already, and perhaps what takes its values.
    fn call(&mut self) {
        let again = self.random.percent(40) && !self.called.is_empty();
        let block = match (again, self.blocks.pop()) {
            (false, Some(block)) => {
                self.called.push(block);
                block
            }
            (_, left) => {
                self.blocks.extend(left);
                let at = self.random.below(self.called.len());
                self.called[at]
            }
        };
        let name = format!("x{}", block.to_lowercase());
        let inputs = match block {
            "TON" | "TOF" | "TP" => {
                format!("IN := {}, PT := {}", self.truth(1), self.preset_time())
            }
            "CTU" => format!(
                "CU := {}, R := {}, PV := {}",
                self.truth(1),
                self.bit(),
                self.preset()
            ),
            "CTD" => format!(
                "CD := {}, LD := {}, PV := {}",
                self.truth(1),
                self.bit(),
                self.preset()
            ),
            "CTUD" => format!(
                "CU := {}, CD := {}, R := {}, LD := {}, PV := {}",
                self.truth(1),
                self.truth(1),
                self.bit(),
                self.bit(),
                self.preset()
            ),
            "SR" => format!("S1 := {}, R := {}", self.truth(1), self.truth(1)),
            "RS" => format!("S := {}, R1 := {}", self.truth(1), self.truth(1)),
            "Own" => format!("up := {}, step := {}", self.truth(1), self.value("INT", 1)),
            "Outer" => format!("go := {}", self.truth(1)),
            _ => format!("CLK := {}", self.truth(1)),
        };
        self.line(&format!("{name}({inputs});"));
        let outputs = match block {
            "TON" | "TP" | "TOF" => format!("b0 := {name}.Q; t1 := {name}.ET;"),
            "CTU" | "CTD" => format!("b1 := {name}.Q; i1 := {name}.CV;"),
            "CTUD" => format!("b1 := {name}.QU; b2 := {name}.QD; i1 := {name}.CV;"),
            "SR" | "RS" => format!("b2 := {name}.Q1;"),
            "Own" => format!("i0 := {name}.sum;"),
            "Outer" => format!("i0 := {name}.seen; b3 := {name}.done;"),
            _ => format!("b3 := {name}.Q;"),
        };
        if self.random.percent(70) {
            self.line(&outputs);
        }
    }

    fn preset_time(&mut self) -> String {
        match self.random.percent(70) {
            true => format!("T#{}ms", 10 * self.random.below(9)),
            false if self.random.percent(50) => {
                format!("USINT_TO_TIME({})", self.narrowed(Some("USINT")))
            }
            false => self.name("TIME"),
        }
    }

    fn preset(&mut self) -> String {
        match self.random.percent(70) {
            true => self.random.below(5).to_string(),
            false if self.random.percent(50) => self.narrowed(Some("INT")),
            false => self.name("INT"),
        }
    }
}
