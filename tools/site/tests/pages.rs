//! What `docs/site.md` shows is a right site file, in both languages.

use std::fs;
use std::path::Path;
use unoclp_program::Lang;
use unoclp_site::{Files, plan, read};

/// The panel that the page shows, and its drawing.
const PANEL: &str = include_str!("../../../docs/site/estufa.panel.toml");
const DRAWING: &str = include_str!("../../../docs/site/estufa.svg");

struct Folder;

impl Files for Folder {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, String> {
        if name == "estufa.panel.toml" {
            return Ok(PANEL.into());
        }
        if name == "estufa.svg" {
            return Ok(DRAWING.into());
        }
        if name == "keys.panel.toml" {
            return Ok("x = 1\n[[item]]\nx = 1\n[[bind]]\nx = 1\n".into());
        }
        assert_eq!(name, "estufa.st");
        Ok(include_bytes!("../../../docs/site/estufa.st").into())
    }
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../docs")
        .join(name);
    fs::read_to_string(path).unwrap()
}

/// The blocks of a page that are TOML, one after the other.
fn blocks(page: &str) -> String {
    let blocks = page.split("```toml\n").skip(1);
    blocks
        .filter_map(|block| block.split("```").next())
        .collect()
}

#[test]
fn the_steps_of_the_page_make_one_site() {
    let english = blocks(&page("site.md"));
    assert_eq!(english, blocks(&page("site.pt-BR.md")));
    let site = read(&english, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}\n{english}"));
    assert_eq!(site.boards().count(), 5);
    let told = plan(&site, Lang::En);
    assert!(told.contains("can write estufa.target, bomba.M1"), "{told}");
    assert_eq!((site.alarms.len(), site.users.len()), (2, 1));
    let panel = &site.panels[0];
    assert_eq!((&*panel.name, panel.items.len()), ("estufa", 4));
    // What the panel moves is in its drawing.
    for bind in &panel.binds {
        assert!(DRAWING.contains(&format!("id=\"{}\"", bind.id)), "{bind:?}");
    }
}

#[test]
fn each_key_has_its_row() {
    let known = "[other]\n[mqtt]\nx = 1\nsparkplug = { x = 1 }\n[[line]]\nx = 1\n[http]\nx = 1\ntls = { x = 1 }\n[modbus]\nx = 1\n[[line.board]]\nx = 1\n[history]\nx = 1\n[journal]\nx = 1\n[[alarm]]\nx = 1\ntext = { x = 1 }\n[[user]]\nx = 1\n[[panel]]\nx = 1\nfile = \"keys.panel.toml\"\n";
    let told = read(known, &Folder).unwrap_err();
    let told: Vec<String> = told.iter().map(|wrong| wrong.reason(Lang::En)).collect();
    let keys: Vec<&str> = told
        .iter()
        .filter_map(|told| told.split_once("known keys: `"))
        .flat_map(|(_, keys)| keys.split('`').step_by(2))
        .collect();
    assert!(keys.len() >= 50, "{keys:?}");
    for name in ["site.md", "site.pt-BR.md"] {
        let page = page(name);
        let rows: String = page.lines().filter(|line| line.starts_with("| ")).collect();
        for key in &keys {
            let is_there = ["`{}`", "`[{}]`", "`[[{}]]`", "`[[line.{}]]`"]
                .iter()
                .any(|form| rows.contains(&form.replace("{}", key)));
            assert!(is_there, "{name}: {key}");
        }
    }
}
