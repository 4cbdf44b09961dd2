//! A project as a whole, in the shape in which OpenPLC Editor writes one.

use super::xml::escaped;

/// A project with these types and units, whose one task runs these instances, beside these global variables. It says no date
/// of its own.
pub(super) fn project(name: &str, types: &str, runs: &str, globals: &str) -> String {
    let name = match name.trim() {
        "" => "Main".to_owned(),
        name => escaped(name),
    };
    format!(
        "<?xml version='1.0' encoding='utf-8'?>
<project xmlns:xhtml=\"http://www.w3.org/1999/xhtml\" xmlns:xsd=\"http://www.w3.org/2001/XMLSchema\" xmlns=\"http://www.plcopen.org/xml/tc6_0201\">
  <fileHeader companyName=\"Unknown\" productName=\"unoclp\" productVersion=\"1\" creationDateTime=\"2000-01-01T00:00:00\"/>
  <contentHeader name=\"{name}\" modificationDateTime=\"2000-01-01T00:00:00\">
    <coordinateInfo>
      <fbd>
        <scaling x=\"10\" y=\"10\"/>
      </fbd>
      <ld>
        <scaling x=\"10\" y=\"10\"/>
      </ld>
      <sfc>
        <scaling x=\"10\" y=\"10\"/>
      </sfc>
    </coordinateInfo>
  </contentHeader>
  <types>
{types}  </types>
  <instances>
    <configurations>
      <configuration name=\"Config0\">
        <resource name=\"Res0\">
          <task name=\"task0\" priority=\"0\" interval=\"T#20ms\">
{runs}          </task>
{globals}        </resource>
      </configuration>
    </configurations>
  </instances>
</project>
"
    )
}
