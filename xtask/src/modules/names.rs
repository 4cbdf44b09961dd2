//! From the paths in the code to the files that define what they name.

use std::collections::BTreeMap;

use super::source::{Modules, Name, Named};

/// No re-export leads through more modules than this.
const DEPTH: u8 = 8;

/// What a path leads to.
#[derive(Clone, Copy)]
enum Found {
    /// The module with this index.
    Module(usize),
    /// Something that the file with this index defines.
    In(usize),
}

/// Which file needs which other one, by their indexes, and a path for each that shows it.
pub fn needs(modules: &Modules) -> BTreeMap<(usize, usize), String> {
    let mut needs = BTreeMap::new();
    for (index, module) in modules.all.iter().enumerate() {
        for named in &module.paths {
            let (files, path) = match named {
                Named::Path(path) => (modules.defining(index, path), path.join("::")),
                Named::All(path) => (modules.whole(index, path), path.join("::") + "::*"),
                Named::Macro(name) => (modules.of_macro(index, name), format!("{name}!")),
            };
            for file in files.into_iter().filter(|file| *file != module.file) {
                needs
                    .entry((module.file, file))
                    .or_insert_with(|| path.clone());
            }
        }
    }
    needs
}

impl Modules {
    /// The files that define what this path names in this module. What a module is named for, the paths
    /// through it say.
    fn defining(&self, module: usize, path: &[String]) -> Vec<usize> {
        let found = self.find(module, path, DEPTH).into_iter();
        found
            .filter_map(|found| match found {
                Found::In(file) => Some(file),
                Found::Module(_) => None,
            })
            .collect()
    }

    /// The file of the module or type that has all of its names brought in.
    fn whole(&self, module: usize, path: &[String]) -> Vec<usize> {
        let found = self.find(module, path, DEPTH).into_iter();
        found
            .map(|found| match found {
                Found::In(file) => file,
                Found::Module(module) => self.all[module].file,
            })
            .collect()
    }

    /// The files that define the macro of this name.
    fn of_macro(&self, module: usize, name: &str) -> Vec<usize> {
        let found = self.defining(module, &[name.to_owned()]);
        if found.is_empty() {
            self.macros.get(name).cloned().unwrap_or_default()
        } else {
            found
        }
    }

    /// All that this path may stand for in this module; nothing where it leads to another crate.
    fn find(&self, mut module: usize, path: &[String], depth: u8) -> Vec<Found> {
        let mut rest = path;
        while let [first, others @ ..] = rest {
            module = match first.as_str() {
                "crate" => 0,
                "self" => module,
                "super" => match self.all[module].parent {
                    Some(parent) => parent,
                    None => return Vec::new(),
                },
                _ => break,
            };
            rest = others;
        }
        let [first, others @ ..] = rest else {
            return vec![Found::Module(module)];
        };
        let mut found = self.named(module, first, depth);
        for name in others {
            let next = found.into_iter().flat_map(|found| match found {
                Found::Module(module) => self.named(module, name, depth),
                // A variant, or what belongs to a type.
                item => vec![item],
            });
            found = next.collect();
        }
        found
    }

    /// All that a name may stand for in this module.
    fn named(&self, module: usize, name: &str, depth: u8) -> Vec<Found> {
        let Some(depth) = depth.checked_sub(1) else {
            return Vec::new();
        };
        let Some(names) = self.all[module].names.get(name) else {
            let globs = self.all[module].globs.iter();
            let brought = globs.flat_map(|path| self.find(module, path, depth));
            return brought
                .flat_map(|found| match found {
                    Found::Module(from) if from != module => self.named(from, name, depth),
                    _ => Vec::new(),
                })
                .collect();
        };
        let stands_for = |name: &Name| match name {
            Name::Module(module) => vec![Found::Module(*module)],
            Name::Here => vec![Found::In(self.all[module].file)],
            Name::Alias(path) => self.find(module, path, depth),
        };
        names.iter().flat_map(stands_for).collect()
    }
}
