//! The elements of a ladder body as XML, in the shape in which OpenPLC Editor writes them.

use std::fmt::Write;

/// An output of an element: its number, and the name of the output.
pub(crate) type Source = (u32, &'static str);

/// Where an element stands.
#[derive(Clone, Copy)]
pub(crate) struct At {
    pub x: i64,
    pub y: i64,
}

/// The text of a body, element by element.
#[derive(Default)]
pub(crate) struct Body {
    pub text: String,
    last: u32,
}

impl Body {
    fn next(&mut self) -> u32 {
        self.last += 1;
        self.last
    }

    /// A left rail of this height.
    pub(crate) fn rail(&mut self, at: At) -> u32 {
        let id = self.next();
        let At { x, y } = at;
        let _ = write!(
            self.text,
            "            <leftPowerRail localId=\"{id}\" height=\"40\" width=\"10\">
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointOut formalParameter=\"\">
                <relPosition x=\"10\" y=\"20\"/>
              </connectionPointOut>
            </leftPowerRail>\n"
        );
        id
    }

    /// A right rail that these lead to.
    pub(crate) fn end(&mut self, from: &[Source], at: At) {
        let id = self.next();
        let At { x, y } = at;
        let wires = wires(from);
        let _ = write!(
            self.text,
            "            <rightPowerRail localId=\"{id}\" height=\"40\" width=\"10\">
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointIn>
                <relPosition x=\"0\" y=\"20\"/>
{wires}              </connectionPointIn>
            </rightPowerRail>\n"
        );
    }

    /// A contact or a coil, with these attributes.
    pub(crate) fn symbol(
        &mut self,
        kind: &str,
        attributes: &str,
        variable: &str,
        from: &[Source],
        at: At,
    ) -> u32 {
        let id = self.next();
        let At { x, y } = at;
        let wires = wires(from);
        let variable = escaped(variable);
        let _ = write!(
            self.text,
            "            <{kind} localId=\"{id}\" height=\"20\" width=\"30\"{attributes}>
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointIn>
                <relPosition x=\"0\" y=\"10\"/>
{wires}              </connectionPointIn>
              <connectionPointOut>
                <relPosition x=\"30\" y=\"10\"/>
              </connectionPointOut>
              <variable>{variable}</variable>
            </{kind}>\n"
        );
        id
    }

    /// A jump or a return.
    pub(crate) fn leave(&mut self, kind: &str, attributes: &str, from: &[Source], at: At) {
        let id = self.next();
        let At { x, y } = at;
        let wires = wires(from);
        let _ = write!(
            self.text,
            "            <{kind} localId=\"{id}\" height=\"20\" width=\"40\"{attributes}>
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointIn>
                <relPosition x=\"0\" y=\"10\"/>
{wires}              </connectionPointIn>
            </{kind}>\n"
        );
    }

    /// A label, or a comment of this text.
    pub(crate) fn note(&mut self, label: Option<&str>, comment: &str, at: At) {
        let id = self.next();
        let At { x, y } = at;
        let _ = match label {
            Some(label) => write!(
                self.text,
                "            <label localId=\"{id}\" height=\"20\" width=\"60\" label=\"{label}\">
              <position x=\"{x}\" y=\"{y}\"/>
            </label>\n"
            ),
            None => write!(
                self.text,
                "            <comment localId=\"{id}\" height=\"30\" width=\"600\">
              <position x=\"{x}\" y=\"{y}\"/>
              <content>
                <xhtml:p>{}</xhtml:p>
              </content>
            </comment>\n",
                escaped(comment)
            ),
        };
    }

    /// A value.
    pub(crate) fn value(&mut self, expression: &str, negated: bool, at: At) -> Source {
        let id = self.next();
        let At { x, y } = at;
        let expression = escaped(expression);
        let _ = write!(
            self.text,
            "            <inVariable localId=\"{id}\" height=\"30\" width=\"60\" negated=\"{negated}\">
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointOut>
                <relPosition x=\"60\" y=\"15\"/>
              </connectionPointOut>
              <expression>{expression}</expression>
            </inVariable>\n"
        );
        (id, "")
    }

    /// A variable that takes a value, with these attributes.
    pub(crate) fn taken(&mut self, attributes: &str, expression: &str, from: Source, at: At) {
        let id = self.next();
        let At { x, y } = at;
        let wires = wires(&[from]);
        let expression = escaped(expression);
        let _ = write!(
            self.text,
            "            <outVariable localId=\"{id}\" height=\"30\" width=\"60\"{attributes}>
              <position x=\"{x}\" y=\"{y}\"/>
              <connectionPointIn>
                <relPosition x=\"0\" y=\"15\"/>
{wires}              </connectionPointIn>
              <expression>{expression}</expression>
            </outVariable>\n"
        );
    }

    /// A block with these inputs and outputs; a name after `!` is negated.
    pub(crate) fn block(
        &mut self,
        kind: &str,
        instance: Option<&str>,
        inputs: &[(&str, &[Source])],
        outputs: &[&str],
        at: At,
    ) -> u32 {
        let id = self.next();
        let At { x, y } = at;
        let instance = instance.map_or(String::new(), |name| {
            format!(" instanceName=\"{}\"", escaped(name))
        });
        let height = 20 + 20 * inputs.len().max(outputs.len());
        let _ = write!(
            self.text,
            "            <block localId=\"{id}\" typeName=\"{kind}\"{instance} height=\"{height}\" width=\"70\">
              <position x=\"{x}\" y=\"{y}\"/>
              <inputVariables>\n"
        );
        let wired = inputs.iter().filter(|(_, from)| !from.is_empty());
        for (row, (name, from)) in wired.enumerate() {
            let (negated, name) = match name.strip_prefix('!') {
                Some(name) => (" negated=\"true\"", name),
                None => ("", *name),
            };
            let y = 30 + 20 * row;
            let wires = wires(from);
            let _ = write!(
                self.text,
                "                <variable formalParameter=\"{name}\"{negated}>
                  <connectionPointIn>
                    <relPosition x=\"0\" y=\"{y}\"/>
{wires}                  </connectionPointIn>
                </variable>\n"
            );
        }
        let _ = write!(
            self.text,
            "              </inputVariables>
              <inOutVariables/>
              <outputVariables>\n"
        );
        for (row, name) in outputs.iter().enumerate() {
            let y = 30 + 20 * row;
            let _ = write!(
                self.text,
                "                <variable formalParameter=\"{name}\">
                  <connectionPointOut>
                    <relPosition x=\"70\" y=\"{y}\"/>
                  </connectionPointOut>
                </variable>\n"
            );
        }
        let _ = write!(
            self.text,
            "              </outputVariables>
            </block>\n"
        );
        id
    }
}

fn wires(from: &[Source]) -> String {
    let wire = |(id, output): &Source| match *output {
        "" => format!("                <connection refLocalId=\"{id}\"/>\n"),
        output => format!(
            "                <connection refLocalId=\"{id}\" formalParameter=\"{output}\"/>\n"
        ),
    };
    from.iter().map(wire).collect()
}

/// A text as XML has it; characters that XML lacks become spaces.
pub(crate) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\n' | '\t' => escaped.push(c),
            '\u{FFFE}' | '\u{FFFF}' => escaped.push(' '),
            c if c < ' ' => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
