//! How the types of answers are written in TypeScript.

use std::collections::BTreeMap;
use std::fmt::Write;

/// The types of all answers, by their names.
#[derive(Default)]
pub struct Types(BTreeMap<&'static str, String>);

/// A field.
pub struct Row {
    key: String,
    about: &'static str,
    name: String,
}

impl Row {
    /// A field of Rust, and what TypeScript calls what stands in it.
    pub fn new(field: &str, about: &'static str, name: String) -> Row {
        let mut words = field.split('_');
        let first = words.next().unwrap_or_default().to_owned();
        let key = words.fold(first, |key, word| {
            let (head, rest) = word.split_at(1);
            key + &head.to_uppercase() + rest
        });
        Row { key, about, name }
    }
}

/// A comment in front of what it is about.
fn comment(to: &mut String, indent: &str, about: &str) {
    let about = about.trim();
    if !about.is_empty() {
        let _ = writeln!(to, "{indent}/** {about} */");
    }
}

impl Types {
    /// Adds an object; whether it is new.
    pub fn object(&mut self, name: &'static str, about: &str, rows: &[Row]) -> bool {
        let mut text = String::new();
        comment(&mut text, "", about);
        let _ = writeln!(text, "export interface {name} {{");
        for Row { key, about, name } in rows {
            comment(&mut text, "  ", about);
            let _ = writeln!(text, "  readonly {key}: {name};");
        }
        text.push_str("}\n");
        self.add(name, text)
    }

    /// Adds what is one of several; whether it is new.
    pub fn either(&mut self, name: &'static str, about: &str, variants: &[String]) -> bool {
        let mut text = String::new();
        comment(&mut text, "", about);
        let _ = writeln!(text, "export type {name} =\n{};", join(variants));
        self.add(name, text)
    }

    /// One of several that are told by a key.
    pub fn variant(
        tag: &str,
        variant: &str,
        about: &str,
        whole: Option<String>,
        rows: &[Row],
    ) -> String {
        let mut text = String::new();
        comment(&mut text, "  ", about);
        let (head, rest) = variant.split_at(1);
        let mut fields = format!("readonly {tag}: \"{}{rest}\"", head.to_lowercase());
        for Row { key, name, .. } in rows {
            let _ = write!(fields, "; readonly {key}: {name}");
        }
        let object = format!("{{ {fields} }}");
        text + "  | " + &whole.map_or(object.clone(), |whole| format!("({object} & {whole})"))
    }

    fn add(&mut self, name: &'static str, text: String) -> bool {
        if let Some(own) = self.0.get(name) {
            assert_eq!(*own, text, "two are called {name}");
            return false;
        }
        self.0.insert(name, text);
        true
    }

    /// What they are called.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.0.keys().copied()
    }

    /// All of them.
    pub fn written(&self) -> String {
        let texts: Vec<&str> = self.0.values().map(String::as_str).collect();
        texts.join("\n")
    }
}

fn join(variants: &[String]) -> String {
    let line = |variant: &String| match variant.contains("  | ") {
        true => variant.clone(),
        false => format!("  | {variant}"),
    };
    let lines: Vec<String> = variants.iter().map(line).collect();
    lines.join("\n")
}
