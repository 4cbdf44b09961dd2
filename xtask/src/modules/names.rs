//! From the paths in the code to the files that define what they name.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

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
    let names = Names {
        modules,
        known: RefCell::default(),
    };
    let mut needs = BTreeMap::new();
    for (index, module) in modules.all.iter().enumerate() {
        for named in &module.paths {
            let (files, path) = match named {
                Named::Path(path) => (names.defining(index, path), path.join("::")),
                Named::All(path) => (names.whole(index, path), path.join("::") + "::*"),
                Named::Macro(name) => (names.of_macro(index, name), format!("{name}!")),
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

/// Names of modules as they are looked up.
struct Names<'m> {
    modules: &'m Modules,
    /// What a name in a module has been found to stand for: many ways lead to each.
    known: RefCell<HashMap<(usize, String, u8), Vec<Found>>>,
}

impl Names<'_> {
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
                Found::Module(module) => self.modules.all[module].file,
            })
            .collect()
    }

    /// The files that define the macro of this name.
    fn of_macro(&self, module: usize, name: &str) -> Vec<usize> {
        let found = self.defining(module, &[name.to_owned()]);
        if found.is_empty() {
            self.modules.macros.get(name).cloned().unwrap_or_default()
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
                "super" => match self.modules.all[module].parent {
                    Some(parent) => parent,
                    None => return Vec::new(),
                },
                _ => break,
            };
            rest = others;
        }
        let mut found = vec![Found::Module(module)];
        for (at, name) in rest.iter().enumerate() {
            let leads_on = at + 1 < rest.len();
            let next = found.into_iter().flat_map(|found| match found {
                Found::Module(module) if leads_on => self.leading_on(module, name, depth),
                Found::Module(module) => self.named(module, name, depth),
                // A variant, or what belongs to a type.
                item => vec![item],
            });
            found = next.collect();
        }
        found
    }

    /// What a name stands for that another follows: where it is a module's, a function of the same name is not meant.
    fn leading_on(&self, module: usize, name: &str, depth: u8) -> Vec<Found> {
        let names = self.modules.all[module].names.get(name);
        let own = names.into_iter().flatten().find_map(|name| match name {
            Name::Module(module) => Some(Found::Module(*module)),
            _ => None,
        });
        own.map_or_else(|| self.named(module, name, depth), |own| vec![own])
    }

    /// All that a name may stand for in this module.
    fn named(&self, module: usize, name: &str, depth: u8) -> Vec<Found> {
        let key = (module, name.to_owned(), depth);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = self.look_up(module, name, depth);
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    fn look_up(&self, module: usize, name: &str, depth: u8) -> Vec<Found> {
        let Some(depth) = depth.checked_sub(1) else {
            return Vec::new();
        };
        let Some(names) = self.modules.all[module].names.get(name) else {
            let globs = self.modules.all[module].globs.iter();
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
            Name::Here => vec![Found::In(self.modules.all[module].file)],
            Name::Alias(path) => self.find(module, path, depth),
        };
        names.iter().flat_map(stands_for).collect()
    }
}
