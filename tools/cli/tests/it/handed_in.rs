//! What students hand in from the page: `unoclp grade` computes all of it anew, and believes nothing.

use crate::common::{empty_folder, outcome, outcome_in};
use serde_json::{Value, json};
use std::fs::{self, File};
use std::path::{Path, PathBuf};

const FOLLOWS: &str = "LD I1\nST Q1\n";
const INVERTS: &str = "LDN I1\nST Q1\n";

fn put(folder: &Path, name: &str, content: impl AsRef<[u8]>) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, content).unwrap();
}

/// A lamp that follows its button, and one that does the contrary.
fn exercises(test: &str) -> PathBuf {
    let folder = empty_folder(test);
    for (name, title, out) in [("lamp", "A lamp", 1), ("dark/lamp-out", "=A lamp out", 0)] {
        let (before, after) = (1 - out, out);
        put(
            &folder,
            &format!("exercises/{name}.toml"),
            format!(
                "title = \"{title}\"\n[[case]]\ntitle = \"On\"\nstep = [{{ at = 0, expect = {{ Q1 = {before} }} }}, \
                 {{ at = 50, set = {{ I1 = 1 }}, expect = {{ Q1 = {after} }} }}]\nuntil = 100\n"
            ),
        );
    }
    put(
        &folder,
        "exercises/machine.toml",
        "title = \"t\"\n[[part]]\n",
    );
    folder
}

/// What the page writes.
fn hand_in(student: &str, exercise: &str, text: &str) -> Value {
    json!({
        "form": "unoclp-hand-in-1",
        "student": { "name": student, "number": "" },
        "exercise": { "name": exercise },
        "program": { "name": "lamp.il", "text": text },
        "drawing": null,
        "verdicts": { "passed": true },
        "minutes": 12,
    })
}

fn put_in(folder: &Path, name: &str, of: &Value) {
    put(folder, &format!("class/{name}.unoclp.json"), of.to_string());
}

#[test]
fn several_exercises_stand_in_one_table_by_names() {
    let folder = exercises("handed-in-table");
    put_in(&folder, "ana-lamp", &hand_in("Ana Lima", "lamp", FOLLOWS));
    put_in(
        &folder,
        "ana-out",
        &hand_in("Ana Lima", "own/dark/lamp-out", INVERTS),
    );
    put_in(&folder, "bia", &hand_in("Bia", "lamp-out", FOLLOWS));
    put_in(&folder, "caio", &hand_in("Caio", "crane", FOLLOWS));
    put(&folder, "class/plain.il", FOLLOWS);
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (tasks, class, page) = (path("exercises"), path("class"), path("class.html"));
    let (code, out, err) = outcome(&["grade", &tasks, &class, "--html", &page]);
    assert_eq!(code, 1, "{err}");
    let rows: Vec<String> = out
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
        .collect();
    assert_eq!(rows[0], "name exercise cases first failing case");
    assert_eq!(rows[1], "Ana Lima A lamp 1/1 passed");
    assert_eq!(rows[2], "Ana Lima =A lamp out 1/1 passed");
    assert!(
        rows[3].starts_with("Bia =A lamp out 0/1 On: Q1 at "),
        "{out}"
    );
    assert!(
        rows[4].contains("the exercise crane, which is not graded here"),
        "{out}"
    );
    assert!(rows[5].contains("does not say which exercise"), "{out}");
    assert_eq!(
        rows[6..],
        ["=A lamp out: 1 of 2 passed", "A lamp: 1 of 1 passed"]
    );
    for boasts in ["bia.unoclp.json", "caio.unoclp.json"] {
        assert!(
            err.contains(&format!(
                "{boasts}: the hand-in claims to have passed, but it did not"
            )),
            "{err}"
        );
    }

    let text = fs::read_to_string(page).unwrap();
    assert_eq!(text.matches("<figure class=\"ladder\"><svg").count(), 3);
    assert!(text.contains("<td>12</td>") && text.contains(">Ana Lima</a>"));
    let (_, csv, _) = outcome(&["grade", &tasks, &class, "--csv"]);
    assert!(
        csv.lines()
            .next()
            .unwrap()
            .ends_with("first failing case,name,number,minutes")
    );
    assert!(csv.contains(",yes,1,1,,Ana Lima,,12\n"), "{csv}");
}

#[test]
fn moodle_takes_the_points_of_each_student() {
    let folder = exercises("handed-in-moodle");
    let mut ana = hand_in("+Ana", "lamp", INVERTS);
    ana["student"]["number"] = "@2026-17".into();
    put_in(&folder, "1", &ana);
    ana["program"]["text"] = FOLLOWS.into();
    put_in(&folder, "2", &ana);
    // Who is in a folder of Moodle is known by that, whatever the file says.
    let bia = hand_in("Ana", "dark/lamp-out", INVERTS);
    put_in(&folder, "Bia Reis_4711_assignsubmission_file/x", &bia);
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let arguments = ["grade", &path("exercises"), &path("class"), "--moodle"];
    let (code, out, _) = outcome(&arguments);
    assert_eq!(code, 1);
    let due = "Identifier,Full name,ID number,'=A lamp out,A lamp\n,'+Ana,'@2026-17,,100\n4711,Bia Reis,,100,\n";
    assert_eq!(out, due);
    let (_, out, _) = outcome_in(&arguments, "pt_BR.UTF-8");
    assert!(
        out.starts_with("Identificador,Nome completo,Número de identificação,"),
        "{out}"
    );
}

/// The machine counts as one of the cases, and an answer that was handed in is what a search is graded by.
#[test]
fn a_machine_and_a_fault_that_is_found_are_worth_points() {
    let folder = empty_folder("handed-in-machine");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/exercises");
    let mut found = hand_in("Ana", "find/01-motor", "");
    found["answer"] = "ol stuck\nk1 welded\n".into();
    put_in(&folder, "ana", &found);
    put_in(&folder, "bia", &hand_in("Bia", "05-motor", FOLLOWS));
    let class = folder.join("class");
    let (tasks, class) = (root.to_str().unwrap(), class.to_str().unwrap());
    let (_, out, err) = outcome(&["grade", tasks, class, "--moodle"]);
    let rows: Vec<&str> = out.lines().collect();
    assert!(
        rows[1].starts_with(",Ana,,") && rows[1].contains("100"),
        "{out}{err}"
    );
    assert!(
        rows[2].starts_with(",Bia,,") && !rows[2].contains("100"),
        "{out}"
    );
    assert_eq!(err.matches(".toml:").count(), 0, "{err}");
}

/// What cannot be graded is a row that says where, why, and what to do, in both languages.
#[test]
fn what_is_no_hand_in_is_told_and_ends_nothing() {
    let folder = exercises("handed-in-wrong");
    let task = folder.join("exercises/lamp.toml");
    let right = hand_in("Ana", "lamp", FOLLOWS);
    put_in(&folder, "good", &right);
    let without = |key: &str| {
        let mut of = right.clone();
        of[key] = Value::Null;
        of
    };
    let mut nobody = right.clone();
    nobody["student"]["name"] = " \n".into();
    let mut later = right.clone();
    later["form"] = "unoclp-hand-in-9".into();
    #[rustfmt::skip]
    let bad = [
        ("student", without("student"), "`student.name` is missing", "falta `student.name`"),
        ("nobody", nobody, "`student.name` is missing", "falta `student.name`"),
        ("program", without("program"), "`program.text` is missing", "falta `program.text`"),
        ("later", later, "`form` is unoclp-hand-in-9, but this unoclp reads", "`form` é unoclp-hand-in-9, mas este unoclp lê"),
        ("list", json!([]), "`form` is missing", "falta `form`"),
        ("other", hand_in("Ana", "crane", FOLLOWS), "exercise crane, which is not graded here; name", "exercício crane, que não está sendo avaliado; indique"),
    ];
    for (name, of, ..) in &bad {
        put_in(&folder, name, of);
    }
    put(&folder, "class/cut.unoclp.json", &right.to_string()[..40]);
    put(&folder, "class/deep.unoclp.json", "[".repeat(100_000));
    put(&folder, "class/empty.unoclp.json", "");
    let large = File::create(folder.join("class/large.unoclp.json")).unwrap();
    large.set_len(50 << 20).unwrap();
    let class = folder.join("class");
    let arguments = ["grade", task.to_str().unwrap(), class.to_str().unwrap()];
    for (lang, is_pt) in [("en_US.UTF-8", false), ("pt_BR.UTF-8", true)] {
        let (code, out, err) = outcome_in(&arguments, lang);
        assert_eq!(code, 1, "{err}");
        for (name, _, en, pt) in &bad {
            assert!(out.contains(if is_pt { pt } else { en }), "{name}: {out}");
        }
        let told = match is_pt {
            false => [
                "cut.unoclp.json:1:40: the file is damaged",
                "deep.unoclp.json:1:128: ",
                "empty.unoclp.json:1:0: ",
                "has 52428800 bytes",
                "ask for a new hand-in",
            ],
            true => [
                "cut.unoclp.json:1:40: o arquivo está danificado",
                "deep.unoclp.json:1:128: ",
                "empty.unoclp.json:1:0: ",
                "tem 52428800 bytes",
                "peça ao aluno que entregue de novo",
            ],
        };
        for told in told {
            assert!(out.contains(told), "{told}: {out}");
        }
        assert!(
            out.contains(if is_pt {
                "A lamp: programas que passam: 1 de 11"
            } else {
                "A lamp: 1 of 11 passed"
            }),
            "{out}"
        );
    }
    let none = empty_folder("handed-in-none");
    for (lang, told) in [
        ("en_US.UTF-8", "contains no exercise"),
        ("pt_BR.UTF-8", "não tem nenhum exercício"),
    ] {
        let (code, _, err) = outcome_in(
            &["grade", none.to_str().unwrap(), class.to_str().unwrap()],
            lang,
        );
        assert!(code == 2 && err.contains(told), "{err}");
    }
}
