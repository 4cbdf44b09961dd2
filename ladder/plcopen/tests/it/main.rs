//! Projects in PLCopen XML.

mod adapted;
mod alike;
mod any_text;
mod bad;
mod bodies;
mod cases;
mod charts;
mod diagrams;
mod edited;
mod grown;
mod mixed;
mod no_such_points;
mod outlined;
mod round_trip;
mod texts;

/// A program of a project.
struct Pou<'t> {
    name: &'t str,
    variables: &'t str,
    body: &'t str,
}

/// A project of one program with these variables and this body.
fn project(variables: &str, body: &str) -> String {
    let name = "Main";
    let main = Pou {
        name,
        variables,
        body,
    };
    project_of(&[main], &[name])
}

/// A project of these programs, which its tasks name in this order.
fn project_of(programs: &[Pou<'_>], tasks: &[&str]) -> String {
    let pou = |pou: &Pou<'_>| {
        let (name, variables, body) = (pou.name, pou.variables, pou.body);
        format!(
            r#"
      <pou name="{name}" pouType="program">
        <interface><localVars>{variables}</localVars></interface>
        <body>{body}</body>
      </pou>"#
        )
    };
    let task = |(at, name): (usize, &&str)| {
        format!(
            r#"<task name="task{at}" priority="0" interval="T#20ms"><pouInstance name="instance{at}" typeName="{name}"/></task>"#
        )
    };
    let pous: String = programs.iter().map(pou).collect();
    let tasks: String = tasks.iter().enumerate().map(task).collect();
    format!(
        r#"<?xml version='1.0' encoding='utf-8'?>
<project xmlns:xhtml="http://www.w3.org/1999/xhtml" xmlns="http://www.plcopen.org/xml/tc6_0201">
  <fileHeader companyName="Unknown" productName="Unnamed" productVersion="1" creationDateTime="2026-01-01T00:00:00"/>
  <contentHeader name="Unnamed"><coordinateInfo><fbd><scaling x="10" y="10"/></fbd><ld><scaling x="10" y="10"/></ld><sfc><scaling x="10" y="10"/></sfc></coordinateInfo></contentHeader>
  <types>
    <dataTypes/>
    <pous>{pous}
    </pous>
  </types>
  <instances><configurations><configuration name="Config0"><resource name="Res0">{tasks}</resource></configuration></configurations></instances>
</project>
"#
    )
}

/// The codes of a program file.
fn codes(file: &str) -> Vec<i32> {
    let lines = file.lines().filter_map(|line| line.split('/').next());
    lines.filter_map(|line| line.trim().parse().ok()).collect()
}
