//! A diagram as XML.

use super::model::{BITS, Diagram, Element, Kind, NUMBERS};

impl Diagram {
    /// What its variables are.
    pub(super) fn variables(&self) -> String {
        let mut variables = String::new();
        let mut declare = |name: &str, kind: &str, address: Option<String>| {
            let address = address.map_or(String::new(), |at| format!(" address=\"{at}\""));
            variables +=
                &format!("<variable name=\"{name}\"{address}><type>{kind}</type></variable>");
        };
        for bit in 0..BITS {
            declare(&format!("i{bit}"), "<BOOL/>", Some(format!("%IX0.{bit}")));
            declare(&format!("b{bit}"), "<BOOL/>", None);
        }
        for bit in 0..BITS + NUMBERS {
            declare(&format!("q{bit}"), "<BOOL/>", Some(format!("%QX0.{bit}")));
        }
        for number in 0..NUMBERS {
            declare(&format!("n{number}"), "<DINT/>", None);
        }
        for element in &self.elements {
            if let Kind::Block(name, Some(instance)) = &element.kind {
                declare(instance, &format!("<derived name=\"{name}\"/>"), None);
            }
        }
        variables
    }

    /// Its body.
    pub(super) fn body(&self) -> String {
        let elements = self.elements.iter().enumerate();
        let elements = elements.map(|(at, element)| self.element(at, element));
        format!("<FBD>\n{}</FBD>", elements.collect::<String>())
    }

    fn element(&self, at: usize, element: &Element) -> String {
        let (y, x) = element.place;
        let place = format!("<position x=\"{x}\" y=\"{y}\"/>");
        let order = match element.order {
            0 => String::new(),
            order => format!(" executionOrderId=\"{order}\""),
        };
        let head = format!("localId=\"{at}\"{order} negated=\"{}\"", element.negated);
        let wire = |from: Option<(usize, usize)>| {
            let (from, output) = from.unwrap_or_default();
            let name = self.elements[from].outputs[output].0;
            let name = match name {
                "" => String::new(),
                name => format!(" formalParameter=\"{name}\""),
            };
            format!(
                "<connectionPointIn><connection refLocalId=\"{from}\"{name}/></connectionPointIn>"
            )
        };
        let led = || wire(element.pins[0].from);
        match &element.kind {
            Kind::Value(value) => format!(
                "<inVariable {head}>{place}<connectionPointOut/><expression>{value}</expression></inVariable>\n"
            ),
            Kind::Variable(name) => format!(
                "<outVariable {head}>{place}{}<expression>{name}</expression></outVariable>\n",
                led()
            ),
            Kind::Connector(name) => {
                format!(
                    "<connector name=\"c{name}\" {head}>{place}{}</connector>\n",
                    led()
                )
            }
            Kind::Continuation(name) => format!(
                "<continuation name=\"c{name}\" {head}>{place}<connectionPointOut/></continuation>\n"
            ),
            Kind::Block(name, instance) => {
                let instance = instance.as_ref();
                let instance =
                    instance.map_or(String::new(), |of| format!(" instanceName=\"{of}\""));
                let pins = element.pins.iter().map(|pin| {
                    let edge = match pin.edge {
                        "" => String::new(),
                        edge => format!(" edge=\"{edge}\""),
                    };
                    format!(
                        "<variable formalParameter=\"{}\" negated=\"{}\"{edge}>{}</variable>",
                        pin.name,
                        pin.negated,
                        wire(pin.from)
                    )
                });
                let outputs = element.outputs.iter().map(|(name, _, negated)| {
                    format!("<variable formalParameter=\"{name}\" negated=\"{negated}\"><connectionPointOut/></variable>")
                });
                format!(
                    "<block {head} typeName=\"{name}\"{instance}>{place}<inputVariables>{}</inputVariables><inOutVariables/><outputVariables>{}</outputVariables></block>\n",
                    pins.collect::<String>(),
                    outputs.collect::<String>()
                )
            }
        }
    }
}
