//! Columns computed from other columns of the row: `x_t - x_dif`, `(low + high) / 2`, `25.4 * $3`.

use etalon_base::error;
use etalon_base::message::Message;
use std::borrow::Cow;

/// Maximum length of an expression (bytes).
const LONGEST: usize = 1000;
/// Characters of an expression that is too long to be shown whole.
const SHOWN: usize = 40;
/// Maximum nesting depth of an expression.
const DEEPEST: usize = 40;

/// Expression of numbers and columns of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// Number.
    Number(f64),
    /// Column of this index.
    Column(usize),
    /// Negated expression.
    Negative(Box<Expression>),
    /// Two expressions and `+`, `-`, `*` or `/` between them.
    Pair(Box<Expression>, char, Box<Expression>),
}

/// State of the parser.
struct Parser<'a> {
    whole: &'a str,
    rest: &'a str,
    header: &'a [Cow<'a, str>],
    depth: usize,
}

impl Expression {
    /// Adds the indices of the columns that the expression names.
    pub fn add_columns(&self, to: &mut Vec<usize>) {
        match self {
            Self::Number(_) => {}
            Self::Column(at) => to.push(*at),
            Self::Negative(inner) => inner.add_columns(to),
            Self::Pair(left, _, right) => [left, right].iter().for_each(|part| part.add_columns(to)),
        }
    }

    /// Returns the index of a column that is the whole expression.
    pub fn column(&self) -> Option<usize> {
        if let Self::Column(at) = self { Some(*at) } else { None }
    }

    /// Returns an error if the expression names a column beyond the last one of a table.
    pub fn check_columns(&self, width: usize) -> Result<(), Message> {
        let mut columns = Vec::new();
        self.add_columns(&mut columns);
        match columns.into_iter().max() {
            Some(at) if at >= width => Err(error!("column-number-unknown", number = at + 1, columns = width)),
            _ => Ok(()),
        }
    }

    /// Parses an expression. A name is the longest heading that begins at its place; `$3` is the
    /// third column.
    ///
    /// # Errors
    /// Fails if a name is not a heading, or the text is malformed.
    pub fn parse(text: &str, header: &[Cow<str>]) -> Result<Self, Message> {
        if text.len() > LONGEST {
            let start: String = text.chars().take(SHOWN).collect();
            let expression = format!("{start}...");
            return Err(error!("expression-malformed", expression, fault = "too-long", rest = ""));
        }
        let mut parser = Parser { whole: text, rest: text, header, depth: 0 };
        let expression = parser.sum()?;
        match parser.rest.trim() {
            "" => Ok(expression),
            rest => Err(parser.wrong("left-over", rest)),
        }
    }

    /// Returns the value in a row; `None` if a cell was not measured.
    ///
    /// # Errors
    /// Returns the index of a cell that is not a number, and the message.
    pub fn value(&self, cell: &dyn Fn(usize) -> Result<Option<f64>, Message>) -> Result<Option<f64>, (usize, Message)> {
        Ok(match self {
            Self::Number(number) => Some(*number),
            Self::Column(at) => cell(*at).map_err(|message| (*at, message))?,
            Self::Negative(of) => of.value(cell)?.map(|value| -value),
            Self::Pair(a, operator, b) => {
                let (Some(a), Some(b)) = (a.value(cell)?, b.value(cell)?) else { return Ok(None) };
                Some(match operator {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    _ => a / b,
                })
            }
        })
    }

    /// `true` if a text looks like an expression and not like a heading alone.
    pub fn is_likely(text: &str) -> bool {
        text.starts_with('$') || text.contains(['+', '-', '*', '/', '\u{d7}', '\u{f7}', '\u{2212}', '(', ')'])
    }
}

impl Parser<'_> {
    fn wrong(&self, fault: &str, rest: &str) -> Message {
        error!("expression-malformed", expression = self.whole, fault, rest)
    }

    fn next(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn take(&mut self, operators: &[(char, char)]) -> Option<char> {
        let found = self.next()?;
        let (_, meant) = operators.iter().find(|(written, _)| *written == found)?;
        self.rest = &self.rest[found.len_utf8()..];
        Some(*meant)
    }

    fn sum(&mut self) -> Result<Expression, Message> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.wrong("brackets-too-deep", ""));
        }
        let mut left = self.product()?;
        while let Some(operator) = self.take(&[('+', '+'), ('-', '-'), ('\u{2212}', '-')]) {
            left = Expression::Pair(Box::new(left), operator, Box::new(self.product()?));
        }
        self.depth -= 1;
        Ok(left)
    }

    fn product(&mut self) -> Result<Expression, Message> {
        let mut left = self.factor()?;
        while let Some(operator) = self.take(&[('*', '*'), ('\u{d7}', '*'), ('/', '/'), ('\u{f7}', '/')]) {
            left = Expression::Pair(Box::new(left), operator, Box::new(self.factor()?));
        }
        Ok(left)
    }

    fn factor(&mut self) -> Result<Expression, Message> {
        if let Some(at) = self.heading() {
            return Ok(Expression::Column(at));
        }
        if self.take(&[('-', '-'), ('\u{2212}', '-')]).is_some() {
            self.depth += 1;
            if self.depth > DEEPEST {
                return Err(self.wrong("too-many-signs", ""));
            }
            let of = self.factor()?;
            self.depth -= 1;
            return Ok(Expression::Negative(Box::new(of)));
        }
        if self.take(&[('(', '(')]).is_some() {
            let inner = self.sum()?;
            return match self.take(&[(')', ')')]) {
                Some(_) => Ok(inner),
                None => Err(self.wrong("bracket-open", "")),
            };
        }
        if self.take(&[('$', '$')]).is_some() {
            let digits = self.rest.bytes().take_while(u8::is_ascii_digit).count();
            let number = self.rest[..digits].parse().ok().and_then(|n: usize| n.checked_sub(1));
            self.rest = &self.rest[digits..];
            return number.map(Expression::Column).ok_or_else(|| self.wrong("column-number", ""));
        }
        self.number()
    }

    /// Takes the longest heading that begins here.
    fn heading(&mut self) -> Option<usize> {
        self.rest = self.rest.trim_start();
        let ends = |name: &str| !self.rest[name.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_');
        let begins = |name: &&str| !name.is_empty() && self.rest.starts_with(*name) && ends(name);
        let numeric = |name: &&str| name.parse::<f64>().is_err();
        let names = self.header.iter().map(|name| name.trim());
        let longest = names.filter(begins).filter(numeric).max_by_key(|name| name.len())?;
        let at = self.header.iter().position(|name| name.trim() == longest)?;
        self.rest = &self.rest[longest.len()..];
        Some(at)
    }

    fn number(&mut self) -> Result<Expression, Message> {
        let rest = self.rest;
        let mut end = 0;
        let mut last = ' ';
        for c in rest.chars() {
            let sign = matches!(c, '+' | '-') && matches!(last, 'e' | 'E') && end > 1;
            let exponent = matches!(c, 'e' | 'E') && end > 0;
            if !(c.is_ascii_digit() || c == '.' || exponent || sign) {
                break;
            }
            end += c.len_utf8();
            last = c;
        }
        if let Some(number) = rest[..end].parse::<f64>().ok().filter(|n| n.is_finite()) {
            self.rest = &rest[end..];
            return Ok(Expression::Number(number));
        }
        let name = rest.split(['+', '*', '/', '(', ')']).next().unwrap_or("").trim();
        if name.is_empty() {
            return Err(self.wrong("incomplete", ""));
        }
        let names = self.header.iter().map(|name| name.as_ref());
        Err(error!("column-unknown", column = name).hint_names(name, names))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_are_computed_with_the_usual_precedence() {
        let header: Vec<Cow<str>> = ["x_t", "x_dif", "X-Ist", "X", "Goal x", "1"].map(Cow::from).to_vec();
        let row = [10.0, 4.0, 100.0, 1000.0, 7.0, 55.0];
        let value = |text: &str| {
            let expression = Expression::parse(text, &header).unwrap();
            expression.value(&|i| Ok(row.get(i).copied())).unwrap()
        };
        for (text, right) in [
            ("x_t - x_dif", 6.0),
            ("x_t-x_dif", 6.0),
            ("x_t \u{2212} x_dif", 6.0),
            ("X-Ist", 100.0),
            ("X - x_t", 990.0),
            ("2 * x_t + x_dif / 4", 21.0),
            ("2 \u{d7} (x_t + x_dif) \u{f7} 7", 4.0),
            ("-x_t - -x_dif", -6.0),
            ("25.4e0 * $4", 25400.0),
            ("Goal x * 1e-3", 0.007),
            ("1 + x_t", 11.0),
            ("x_t - x_dif - 1", 5.0),
        ] {
            assert_eq!(value(text), Some(right), "{text}");
        }
        let lacking = Expression::parse("x_t - x_dif", &header).unwrap();
        assert_eq!(lacking.value(&|i| Ok((i == 0).then_some(1.0))).unwrap(), None);
    }

    #[test]
    fn what_is_no_expression_is_refused() {
        let header: Vec<Cow<str>> = ["x_t", "x_dif"].map(Cow::from).to_vec();
        let refused = |text: &str| Expression::parse(text, &header).unwrap_err();
        let unknown = refused("x_t - x_dff");
        assert!(unknown.is("column-unknown", &[("column", &"x_dff")]), "{unknown}");
        assert!(unknown.hint.is_some_and(|hint| hint.contains("`x_dif`")));
        let (brackets, signs, long) = ("(".repeat(900), "-".repeat(900), "x".repeat(1001));
        for (wrong, fault, rest) in [
            ("", "incomplete", ""),
            ("x_t -", "incomplete", ""),
            ("(x_t", "bracket-open", ""),
            ("x_t x_dif", "left-over", "x_dif"),
            ("$0", "column-number", ""),
            ("$", "column-number", ""),
            ("x_t ^ 2", "left-over", "^ 2"),
            ("x_t)", "left-over", ")"),
            (&brackets, "brackets-too-deep", ""),
            (&signs, "too-many-signs", ""),
            (&long, "too-long", ""),
        ] {
            let message = refused(wrong);
            assert!(message.is("expression-malformed", &[("fault", &fault), ("rest", &rest)]), "{message}");
        }
        assert!(refused("1..2").is("column-unknown", &[]));
    }
}
