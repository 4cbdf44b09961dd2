//! Projects in PLCopen XML.

mod any_text;
mod cases;
mod round_trip;
mod texts;

/// A project of one program with these variables and this body.
fn project(variables: &str, body: &str) -> String {
    format!(
        r#"<?xml version='1.0' encoding='utf-8'?>
<project xmlns:xhtml="http://www.w3.org/1999/xhtml" xmlns="http://www.plcopen.org/xml/tc6_0201">
  <fileHeader companyName="Unknown" productName="Unnamed" productVersion="1" creationDateTime="2026-01-01T00:00:00"/>
  <contentHeader name="Unnamed"><coordinateInfo><fbd><scaling x="10" y="10"/></fbd><ld><scaling x="10" y="10"/></ld><sfc><scaling x="10" y="10"/></sfc></coordinateInfo></contentHeader>
  <types>
    <dataTypes/>
    <pous>
      <pou name="Main" pouType="program">
        <interface><localVars>{variables}</localVars></interface>
        <body>{body}</body>
      </pou>
    </pous>
  </types>
  <instances><configurations><configuration name="Config0"><resource name="Res0"><task name="task0" priority="0" interval="T#20ms"><pouInstance name="instance0" typeName="Main"/></task></resource></configuration></configurations></instances>
</project>
"#
    )
}

/// The codes of a program file.
fn codes(file: &str) -> Vec<i32> {
    let lines = file.lines().filter_map(|line| line.split('/').next());
    lines.filter_map(|line| line.trim().parse().ok()).collect()
}
