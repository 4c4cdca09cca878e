//! Evaluates functions of exported kinematics: each line of their text is one operation.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A function in the text of an exported program (C99 or Python).
pub(crate) struct Function<'t> {
    lines: Vec<&'t str>,
}

impl<'t> Function<'t> {
    /// Finds a function by its name.
    pub fn find(text: &'t str, name: &str) -> Option<Self> {
        let (python, c) = (format!("def {name}(q):"), format!("void etalon_{name}(const double q["));
        let mut lines = text.lines().map(str::trim);
        // a declaration in C ends with a semicolon
        lines.find(|line| *line == python || line.starts_with(&c) && !line.ends_with(';'))?;
        let body = lines.take_while(|line| *line != "}" && !line.starts_with("def "));
        Some(Self { lines: body.collect() })
    }

    /// Outputs at these inputs; `None` if a line is not understood.
    pub fn at(&self, q: &[f64]) -> Option<Vec<f64>> {
        let (mut t, mut out) = (BTreeMap::new(), BTreeMap::new());
        for line in &self.lines {
            let line = line.trim_end_matches(';');
            if let Some(list) = line.strip_prefix("return [") {
                let list = list.strip_suffix(']')?;
                return list.split(", ").map(|word| operand(word, q, &t)).collect();
            }
            let Some((place, value)) = line.split_once(" = ") else { continue };
            match (indexed(place, "t"), indexed(place, "out")) {
                (Some(i), _) => drop(t.insert(i, evaluate_operation(value, q, &t)?)),
                (_, Some(i)) => drop(out.insert(i, operand(value, q, &t)?)),
                // the array of steps in Python
                _ => {}
            }
        }
        Some(out.into_values().collect())
    }
}

/// Index of `name[index]`.
fn indexed(text: &str, name: &str) -> Option<usize> {
    text.strip_prefix(name)?.strip_prefix('[')?.strip_suffix(']')?.parse().ok()
}

/// A number, an input or an earlier step.
fn operand(word: &str, q: &[f64], t: &BTreeMap<usize, f64>) -> Option<f64> {
    if let Some(i) = indexed(word, "q") {
        return q.get(i).copied();
    }
    if let Some(i) = indexed(word, "t") {
        return t.get(&i).copied();
    }
    let negative = word.strip_prefix('-').filter(|rest| rest.starts_with(['q', 't']));
    if let Some(rest) = negative {
        return Some(-operand(rest, q, t)?);
    }
    word.trim_start_matches('(').trim_end_matches(')').parse().ok()
}

/// One operation.
fn evaluate_operation(text: &str, q: &[f64], t: &BTreeMap<usize, f64>) -> Option<f64> {
    let of = |word: &str| operand(word, q, t);
    for (name, function) in FUNCTIONS {
        let arguments = text.strip_prefix(name).and_then(|rest| rest.strip_prefix('(')?.strip_suffix(')'));
        if let Some(arguments) = arguments {
            let mut words = arguments.split(", ");
            let first = of(words.next()?)?;
            return Some(function(first, words.next().map_or(Some(0.0), of)?));
        }
    }
    for (sign, operation) in OPERATIONS {
        if let Some((a, b)) = text.split_once(sign) {
            return Some(operation(of(a)?, of(b)?));
        }
    }
    of(text)
}

/// Name and function of two numbers.
type Named = (&'static str, fn(f64, f64) -> f64);

/// Functions of one or two numbers.
const FUNCTIONS: [Named; 6] = [
    ("sqrt", |a, _| a.sqrt()),
    ("sin", |a, _| a.sin()),
    ("cos", |a, _| a.cos()),
    ("atan2", f64::atan2),
    ("wrap", |a, _| wrap(a)),
    ("etalon_wrap", |a, _| wrap(a)),
];

const OPERATIONS: [Named; 4] =
    [(" + ", |a, b| a + b), (" - ", |a, b| a - b), (" * ", |a, b| a * b), (" / ", |a, b| a / b)];

fn wrap(angle: f64) -> f64 {
    let half = TAU / 2.0;
    if angle > half {
        angle - TAU
    } else if angle < -half {
        angle + TAU
    } else {
        angle
    }
}

#[cfg(test)]
mod tests {
    use super::Function;

    #[test]
    fn functions_of_both_languages_are_evaluated() {
        let python = "def wrap(angle):\n    return angle\n\n\ndef direct(q):\n    t = [0.0] * 4\n    t[0] = sin(q[0])\n    \
                      t[1] = t[0] * (-2.5)\n    t[2] = -t[1]\n    t[3] = atan2(t[2], 1e-05)\n    return [t[3], q[1], 4.0]\n";
        let c = "void etalon_direct(const double q[2], double out[2]);\nvoid etalon_direct(const double q[2], double out[2])\n{\n    \
                 double t[1];\n    t[0] = q[0] - q[1];\n    out[0] = t[0];\n    out[1] = etalon_wrap;\n}\n";
        let found = Function::find(python, "direct").unwrap().at(&[0.5, 7.0]).unwrap();
        let expected = [(2.5 * 0.5f64.sin()).atan2(1e-5), 7.0, 4.0];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
        // a line that is not understood is not skipped
        assert!(Function::find(c, "direct").unwrap().at(&[3.0, 1.0]).is_none());
        let right = c.replace("etalon_wrap;", "t[0];");
        assert_eq!(Function::find(&right, "direct").unwrap().at(&[3.0, 1.0]), Some(vec![2.0, 2.0]));
        assert!(Function::find(c, "inverse").is_none());
    }
}
