//! Tables in Markdown that can be read as they stand, and numbers as they are written there.

use unoclp_uno_sim::CYCLES_PER_MS;

/// A table: first column to the left, the others to the right.
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these heads.
    pub fn new(heads: &[&str]) -> Table {
        let heads = heads.iter().map(|head| (*head).to_owned());
        Table {
            rows: vec![heads.collect()],
        }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(cells.into());
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let width = |column: usize| {
            let cells = self.rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        for (n, row) in self.rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let width = width(column).max(3);
                match column {
                    0 => write!(f, "| {cell:<width$} |")?,
                    _ => write!(f, " {cell:>width$} |")?,
                }
            }
            writeln!(f)?;
            if n > 0 {
                continue;
            }
            for column in 0..row.len() {
                let dashes = "-".repeat(width(column).max(3) - 1);
                match column {
                    0 => write!(f, "| {dashes}- |")?,
                    _ => write!(f, " {dashes}: |")?,
                }
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

/// A number of cycles or bytes: `1,081`; below 100, where it is not whole, with one decimal.
pub fn number(value: f64) -> String {
    let tenths = (value * 10.0).round();
    if value.abs() < 100.0 && tenths % 10.0 != 0.0 {
        return format!("{:.1}", tenths / 10.0);
    }
    let digits = format!("{:.0}", value.abs());
    let mut text = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    if value < 0.0 && digits != "0" {
        format!("−{text}")
    } else {
        text
    }
}

/// Cycles as µs at 16 MHz.
pub fn micros(cycles: f64) -> String {
    let micros = cycles * 1000.0 / CYCLES_PER_MS as f64;
    match micros.abs() {
        ..0.005 => "0".to_owned(),
        ..10.0 => format!("{micros:.2}"),
        ..1000.0 => format!("{micros:.1}"),
        _ => number(micros),
    }
}

/// How many times as much `other` takes as `own`.
pub fn ratio(other: f64, own: f64) -> String {
    let ratio = other / own;
    match ratio {
        ..1.0 => format!("× {ratio:.2}"),
        ..10.0 => format!("× {ratio:.1}"),
        _ => format!("× {ratio:.0}"),
    }
}

/// Whether a target is met.
pub fn verdict(met: bool) -> String {
    if met { "met" } else { "**not met**" }.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_one_form() {
        let cases = [
            (0.0, "0"),
            (30.04, "30"),
            (30.06, "30.1"),
            (99.94, "99.9"),
            (999.6, "1,000"),
            (1_234_567.0, "1,234,567"),
            (-0.04, "0"),
            (-1_081.0, "−1,081"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
        assert_eq!(micros(32.0), "2.00");
        assert_eq!(micros(3_400.0), "212.5");
        assert_eq!(ratio(355.0, 32.0), "× 11");
        assert_eq!(micros(53_404.0), "3,338");
        assert_eq!(ratio(42.0, 30.0), "× 1.4");
        assert_eq!(ratio(16.0, 32.0), "× 0.50");
    }

    #[test]
    fn the_columns_of_a_table_stand_in_line() {
        let mut table = Table::new(&["what", "cycles"]);
        table.row(["a rung".into(), "30.1".into()]);
        table.row(["µ".into(), "1,081".into()]);
        let expected = "\
            | what   | cycles |\n\
            | ------ | -----: |\n\
            | a rung |   30.1 |\n\
            | µ      |  1,081 |\n";
        assert_eq!(table.to_string(), expected);
    }
}
