use std::path::Path;

use super::{Circle, circles_of};

/// The circles of a made-up crate, by the names and texts of its files.
fn circles(files: &[(&str, &str)]) -> Vec<Circle> {
    let read = |path: &Path| {
        let file = files.iter().find(|(name, _)| path == Path::new(name));
        file.map(|(_, text)| (*text).to_owned())
    };
    circles_of(Path::new("lib.rs"), read).expect("the crate can be read")
}

/// The files of the only circle.
fn only_circle(files: &[(&str, &str)]) -> Vec<String> {
    let circles = circles(files);
    let [circle] = circles.as_slice() else {
        panic!("one circle, not {circles:?}");
    };
    let files = circle.files.iter();
    files.map(|file| file.display().to_string()).collect()
}

#[test]
fn files_that_need_each_other_are_a_circle() {
    let files = [
        ("lib.rs", "mod a; mod b; mod c; mod d;"),
        ("a.rs", "use crate::b::B; pub struct A(B);"),
        ("b/mod.rs", "mod inner; pub struct B(inner::I);"),
        ("b/inner.rs", "pub struct I(Box<crate::c::C>);"),
        (
            "c.rs",
            "use super::a; pub struct C; fn c() { a::A::new(); }",
        ),
        ("d.rs", "use crate::a::A; pub struct D(A);"),
    ];
    assert_eq!(
        only_circle(&files),
        ["a.rs", "b/inner.rs", "b/mod.rs", "c.rs"]
    );
    let circle = &circles(&files)[0];
    let shown = circle.to_string();
    assert!(shown.contains("c.rs → a.rs: a::A::new"), "{shown}");
    assert!(!shown.contains("  d.rs"), "{shown}");
}

#[test]
fn a_reexport_leads_to_the_file_that_defines_the_name() {
    let facade = |own: &'static str| {
        [
            ("lib.rs", "mod house;"),
            ("house/mod.rs", own),
            ("house/a.rs", "use super::B; pub struct A(B);"),
            ("house/b.rs", "pub struct B;"),
        ]
    };
    let only_shown = "mod a; mod b; pub use a::A; pub use b::*;";
    assert_eq!(circles(&facade(only_shown)), []);
    // A facade with code of its own needs what that names, and is needed for what it defines.
    let used = "mod a; mod b; pub use a::A; pub struct B; impl A { fn b() -> A { A(B) } }";
    assert_eq!(only_circle(&facade(used)), ["house/a.rs", "house/mod.rs"]);
}

#[test]
fn needs_are_found_wherever_code_names_something() {
    let cases = [
        "fn a() -> crate::b::B { todo!() }",
        "fn a() { let _ = super::b::B::VALUE; }",
        "fn a(b: &dyn crate::b::T) {}",
        "impl crate::b::T for A {} struct A;",
        "use crate::b as other; fn a() { other::f(); }",
        "use crate::{b::{self}}; fn a() { b::f(); }",
        "use crate::b::*;",
        "fn a() { use crate::b::f; }",
        "fn a() { println!(\"{}\", crate::b::f()); }",
        "macro_rules! m { () => { $crate::b::f() }; }",
        "fn a() { shared!(1); }",
        "mod inner { use super::super::b::B; }",
        "mod inner { pub use crate::b::B; } fn a(b: inner::B) {}",
        "#[cfg(feature = \"x\")] use crate::b::B;",
    ];
    let b = "use crate::a::X; pub struct B; pub fn f() {} pub trait T {} macro_rules! shared { ($x:expr) => {}; }";
    for case in cases {
        let a = format!("{case} pub struct X;");
        let files = [
            ("lib.rs", "mod b; mod a;"),
            ("a.rs", a.as_str()),
            ("b.rs", b),
        ];
        assert_eq!(only_circle(&files), ["a.rs", "b.rs"], "{case}");
    }
}

#[test]
fn what_needs_nothing_of_the_crate_is_no_need() {
    let cases = [
        "mod c; pub use c::C;",
        "use core::mem; use other::b::B; fn a(b: ::b::B) {}",
        "#[cfg(test)] mod tests { use crate::b::B; }",
        "#[cfg(test)] use crate::b::B;",
        "fn a(b: u8) { let b = b + 1; println!(\"{b} {}\", b); }",
        "/// [`crate::b::B`]\nfn a() {}",
        "use self::X as Y; fn a(y: Y) {}",
        "pub(crate) fn a(x: X) { x.f(); }",
    ];
    for case in cases {
        let a = format!("{case} pub struct X;");
        let files = [
            ("lib.rs", "mod b; mod a;"),
            ("a.rs", a.as_str()),
            ("a/c.rs", "pub struct C;"),
            ("b.rs", "use crate::a::X; pub struct B;"),
        ];
        assert_eq!(circles(&files), [], "{case}");
    }
}

#[test]
fn a_module_without_its_file_is_an_error() {
    let read = |path: &Path| (path == Path::new("lib.rs")).then(|| "mod a;".to_owned());
    let error = circles_of(Path::new("lib.rs"), read).expect_err("there is no such file");
    assert!(error.to_string().contains("no file of a"), "{error}");
}

#[test]
fn a_function_is_not_what_a_path_through_its_module_names() {
    let files = [
        (
            "lib.rs",
            "mod house; mod yard; pub fn house() { house::door(); }",
        ),
        ("house.rs", "pub fn door() {} pub fn wall() {}"),
        ("yard.rs", "use crate::house::wall;"),
    ];
    assert_eq!(circles(&files), []);
}
