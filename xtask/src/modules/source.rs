//! The modules of a crate: which names each one has, and which paths its code names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Ident, Item, UseTree, Visibility};

/// All modules of a crate; the first is its root.
#[derive(Default)]
pub struct Modules {
    /// The files that they stand in.
    pub files: Vec<PathBuf>,
    /// The modules, those inside of a file too.
    pub all: Vec<Module>,
    /// By the name of a macro, the files that define one: without a path it is found by its name alone.
    pub macros: BTreeMap<String, Vec<usize>>,
}

/// A module.
pub struct Module {
    /// The index of its file.
    pub file: usize,
    /// The index of the module that it is declared in.
    pub parent: Option<usize>,
    /// What a name may stand for: more than one thing, as a type and a value may share it.
    pub names: BTreeMap<String, Vec<Name>>,
    /// Modules whose names are all names here.
    pub globs: Vec<Segments>,
    /// What the code names.
    pub paths: Vec<Named>,
}

/// The parts of a path.
pub type Segments = Vec<String>;

/// What a name stands for.
pub enum Name {
    /// The module with this index.
    Module(usize),
    /// Something defined in the module itself.
    Here,
    /// What this path names.
    Alias(Segments),
}

/// A path in the code.
pub enum Named {
    /// Something by its path.
    Path(Segments),
    /// All that this module has.
    All(Segments),
    /// A macro by its name alone.
    Macro(String),
}

/// Reads a crate from its root file on; `read` gives the text of a file, if it exists.
///
/// # Errors
/// If the file of a module does not exist, or is no Rust.
pub fn read(root: &Path, read: impl Fn(&Path) -> Option<String>) -> Result<Modules> {
    let mut modules = Modules::default();
    let folder = root.parent().unwrap_or(Path::new(""));
    let mut left = vec![File {
        path: root.to_owned(),
        children: folder.to_owned(),
        parent: None,
    }];
    while let Some(file) = left.pop() {
        let Some(text) = read(&file.path) else {
            bail!("there is no {}", file.path.display());
        };
        let syntax = syn::parse_file(&text)
            .with_context(|| format!("cannot parse {}", file.path.display()))?;
        modules.files.push(file.path);
        let index = modules.files.len() - 1;
        let module = modules.add(index, file.parent);
        let mut reader = Reader {
            modules: &mut modules,
            module,
            folder: file.children,
            declared: Vec::new(),
        };
        reader.visit_file(&syntax);
        for declared in reader.declared {
            left.push(declared.find(&read)?);
        }
    }
    Ok(modules)
}

impl Modules {
    /// Another module in this file, with this parent and its name there.
    fn add(&mut self, file: usize, parent: Option<(usize, String)>) -> usize {
        let index = self.all.len();
        self.all.push(Module {
            file,
            parent: parent.as_ref().map(|(parent, _)| *parent),
            names: BTreeMap::new(),
            globs: Vec::new(),
            paths: Vec::new(),
        });
        if let Some((parent, name)) = parent {
            self.all[parent].name(name, Name::Module(index));
        }
        index
    }
}

impl Module {
    fn name(&mut self, name: String, stands_for: Name) {
        self.names.entry(name).or_default().push(stands_for);
    }
}

/// A file to be read.
struct File {
    path: PathBuf,
    /// Where the files of its modules lie.
    children: PathBuf,
    /// The module that declares it, and its name there.
    parent: Option<(usize, String)>,
}

/// `mod name;`
struct Declared {
    folder: PathBuf,
    parent: usize,
    name: String,
}

impl Declared {
    fn find(self, read: impl Fn(&Path) -> Option<String>) -> Result<File> {
        let Declared {
            folder,
            parent,
            name,
        } = self;
        let children = folder.join(&name);
        let places = [folder.join(format!("{name}.rs")), children.join("mod.rs")];
        let path = places.into_iter().find(|path| read(path).is_some());
        Ok(File {
            path: path.with_context(|| format!("no file of {name} in {}", folder.display()))?,
            children,
            parent: Some((parent, name)),
        })
    }
}

/// Goes through the code of a file.
struct Reader<'m> {
    modules: &'m mut Modules,
    /// The module that the code stands in.
    module: usize,
    /// Where the files of its modules lie.
    folder: PathBuf,
    declared: Vec<Declared>,
}

impl Reader<'_> {
    fn here(&mut self) -> &mut Module {
        &mut self.modules.all[self.module]
    }

    fn defines(&mut self, name: &Ident) {
        self.here().name(name.to_string(), Name::Here);
    }

    /// The names that a `use` brings in. Where others may use them too, the names alone are no need.
    fn brings(&mut self, tree: &UseTree, mut path: Segments, private: bool) {
        match tree {
            UseTree::Path(part) => {
                path.push(part.ident.to_string());
                self.brings(&part.tree, path, private);
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.brings(tree, path.clone(), private);
                }
            }
            UseTree::Glob(_) => {
                if private {
                    self.here().paths.push(Named::All(path.clone()));
                }
                self.here().globs.push(path);
            }
            UseTree::Name(name) => {
                let name = name.ident.to_string();
                let last = path.last().cloned();
                // `use a::b::{self}` brings in `b`.
                let brought = if name == "self" {
                    last
                } else {
                    Some(name.clone())
                };
                if name != "self" {
                    path.push(name);
                }
                self.bring(brought, path, private);
            }
            UseTree::Rename(name) => {
                if name.ident != "self" {
                    path.push(name.ident.to_string());
                }
                self.bring(Some(name.rename.to_string()), path, private);
            }
        }
    }

    fn bring(&mut self, name: Option<String>, path: Segments, private: bool) {
        if private {
            self.here().paths.push(Named::Path(path.clone()));
        }
        if let Some(name) = name {
            self.here().name(name, Name::Alias(path));
        }
    }

    /// The paths in the text of a macro, which may be anything: names in a row with `::` between them, and
    /// names on their own that begin as those of types do.
    fn text(&mut self, tokens: TokenStream) {
        let mut path = Segments::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == ':' => colons += 1,
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.named_in_text(&mut path);
                    }
                    path.push(name.to_string());
                    colons = 0;
                }
                other => {
                    self.named_in_text(&mut path);
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.text(group.stream());
                    }
                }
            }
        }
        self.named_in_text(&mut path);
    }

    fn named_in_text(&mut self, path: &mut Segments) {
        let path = std::mem::take(path);
        let is_type = |name: &String| name.starts_with(char::is_uppercase);
        if path.len() > 1 || path.first().is_some_and(is_type) {
            self.here().paths.push(Named::Path(path));
        }
    }
}

/// Whether this is there only in tests.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .parse_args::<Ident>()
                .is_ok_and(|name| name == "test")
    })
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_item(&mut self, item: &'ast Item) {
        if is_test(attributes(item)) {
            return;
        }
        match item {
            Item::Const(item) => self.defines(&item.ident),
            Item::Enum(item) => self.defines(&item.ident),
            Item::Fn(item) => self.defines(&item.sig.ident),
            Item::Static(item) => self.defines(&item.ident),
            Item::Struct(item) => self.defines(&item.ident),
            Item::Trait(item) => self.defines(&item.ident),
            Item::Type(item) => self.defines(&item.ident),
            Item::Union(item) => self.defines(&item.ident),
            _ => {}
        }
        visit::visit_item(self, item);
    }

    fn visit_foreign_item(&mut self, item: &'ast syn::ForeignItem) {
        match item {
            syn::ForeignItem::Fn(item) => self.defines(&item.sig.ident),
            syn::ForeignItem::Static(item) => self.defines(&item.ident),
            _ => {}
        }
        visit::visit_foreign_item(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        let name = item.ident.to_string();
        let Some((_, items)) = &item.content else {
            self.declared.push(Declared {
                folder: self.folder.clone(),
                parent: self.module,
                name,
            });
            return;
        };
        let (module, folder) = (self.module, self.folder.clone());
        self.folder.push(&name);
        let file = self.here().file;
        self.module = self.modules.add(file, Some((module, name)));
        for item in items {
            self.visit_item(item);
        }
        self.module = module;
        self.folder = folder;
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if item.leading_colon.is_none() {
            let private = matches!(item.vis, Visibility::Inherited);
            self.brings(&item.tree, Segments::new(), private);
        }
    }

    fn visit_item_macro(&mut self, item: &'ast syn::ItemMacro) {
        if let Some(name) = &item.ident {
            self.defines(name);
            let file = self.here().file;
            let files = self.modules.macros.entry(name.to_string()).or_default();
            files.push(file);
        }
        self.visit_macro(&item.mac);
    }

    fn visit_macro(&mut self, invoked: &'ast syn::Macro) {
        if let Some(name) = invoked.path.get_ident() {
            self.here().paths.push(Named::Macro(name.to_string()));
        } else {
            self.visit_path(&invoked.path);
        }
        self.text(invoked.tokens.clone());
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            let segments = path.segments.iter().map(|part| part.ident.to_string());
            let path = Named::Path(segments.collect());
            self.here().paths.push(path);
        }
        visit::visit_path(self, path);
    }
}
