//! `etalon fit`

use super::{Verdict, print, say};
use crate::campaign::{Decimal, Delimiter, Dialect, Format, Role, Unit};
use crate::document::FitDocument;
use crate::fit::{self, CircleMethod, Element, Settings};
use crate::message::{Message, Problems};
use crate::pose::Vector;
use crate::{files, import, output};
use std::fmt::Write;
use std::path::PathBuf;

/// Fit a geometric element to the points of files
///
/// Points are read as PolyWorks text (`[name] x y z [i j k]`, separated by blanks) unless --columns says otherwise.
#[derive(Debug, clap::Args)]
pub struct Fit {
    /// line, line2d, plane, circle2d, circle3d, sphere, cylinder, cone, torus, enclosing-circle or enclosing-sphere
    element: String,
    /// Files with points
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Length unit of the files: mm, m, um or inch; never guessed
    #[arg(long)]
    unit: Option<String>,
    /// What the columns hold, e.g. label,x,y,z; `-` for a column that is not read
    #[arg(long, value_delimiter = ',', requires = "delimiter")]
    columns: Vec<String>,
    /// blank, tab, comma or semicolon
    #[arg(long, requires = "columns")]
    delimiter: Option<String>,
    /// Decimal mark: point or comma
    #[arg(long, default_value = "point", requires = "columns")]
    decimal: String,
    /// Rows before the data
    #[arg(long, default_value_t = 0, requires = "columns")]
    header: usize,
    /// One fit for each label instead of one over all points
    #[arg(long)]
    by_label: bool,
    /// Hold the radius of a circle, sphere or cylinder
    #[arg(long, value_name = "MM")]
    radius_mm: Option<f64>,
    /// Fit a circle in space by the full orthogonal distance instead of plane, projection, circle
    #[arg(long)]
    orthogonal: bool,
    /// Fit a line2d, plane or circle2d by minimum zone (Chebyshev) instead of least squares: the form of ISO 1101
    #[arg(long, conflicts_with_all = ["radius_mm", "orthogonal"])]
    minimum_zone: bool,
    /// Print JSON: an object, with --by-label a list of them
    #[arg(long)]
    json: bool,
}

impl Fit {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let points = self.read()?;
        let mut groups: Vec<(String, Vec<Vector>)> = Vec::new();
        for (label, p) in points {
            let name = if self.by_label { label } else { String::new() };
            match groups.iter_mut().find(|g| g.0 == name) {
                Some(group) => group.1.push(p),
                None => groups.push((name, vec![p])),
            }
        }
        let documents: Vec<FitDocument> =
            groups.iter().map(|(label, points)| self.fit(label, points)).collect::<Result<_, Problems>>()?;
        for message in documents.iter().flat_map(|d| &d.messages) {
            say(format_args!("{message}\n"));
        }
        match (&documents[..], self.json) {
            ([one], true) if !self.by_label => print(output::to_json(one)?)?,
            (all, true) => print(output::to_json(&all)?)?,
            (all, false) => print(all.iter().map(as_text).collect::<String>())?,
        }
        Ok(Verdict::Met)
    }

    /// Labels and points of all files, in millimetres.
    fn read(&self) -> Result<Vec<(String, Vector)>, Problems> {
        let unit: Unit = match &self.unit {
            Some(name) => word("--unit", name)?,
            None => {
                let message = Message::error("the files do not say their length unit");
                return Err(message.hint("state it: --unit mm, m, um or inch; it is never guessed").into());
            }
        };
        let format = match &self.delimiter {
            None => Format::Polyworks,
            Some(delimiter) => Format::Delimited(Dialect {
                delimiter: word::<Delimiter>("--delimiter", delimiter)?,
                decimal: word::<Decimal>("--decimal", &self.decimal)?,
                columns: self.columns.iter().map(|c| word::<Role>("--columns", c)).collect::<Result<_, _>>()?,
                header: self.header,
                comment: None,
            }),
        };
        let mut all = Vec::new();
        for path in &self.files {
            all.extend(import::labelled_points(&path.display().to_string(), &files::read_text(path)?, &format, unit)?);
        }
        Ok(all)
    }

    fn fit(&self, label: &str, points: &[Vector]) -> Result<FitDocument, Problems> {
        let label = (!label.is_empty()).then(|| label.to_owned());
        match self.element.as_str() {
            "enclosing-circle" | "enclosing-sphere" if self.minimum_zone => {
                let message = Message::error(format!("there is no minimum zone of an {}", self.element));
                Err(message.hint("leave --minimum-zone out, or fit a circle2d").into())
            }
            "enclosing-circle" => {
                let plane: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
                let flat: Vec<Vector> = plane.iter().map(|p| [p[0], p[1], 0.0]).collect();
                Ok(FitDocument::enclosing("enclosing-circle", label, &flat, &fit::enclosing_circle(&plane)?))
            }
            "enclosing-sphere" => {
                Ok(FitDocument::enclosing("enclosing-sphere", label, points, &fit::enclosing_sphere(points)?))
            }
            name => {
                let element: Element = name.parse()?;
                if self.minimum_zone {
                    return Ok(FitDocument::minimum_zone(label, &fit::minimum_zone(element, points)?));
                }
                let circle = if self.orthogonal { CircleMethod::Orthogonal } else { CircleMethod::Projected };
                let settings = Settings { radius_mm: self.radius_mm, circle, ..Settings::default() };
                Ok(FitDocument::new(label, &fit::element(element, points, &settings)?))
            }
        }
    }
}

/// A word of an option, as the campaign spells it.
fn word<T: serde::de::DeserializeOwned>(option: &str, text: &str) -> Result<T, Problems> {
    let value = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(text);
    T::deserialize(value).map_err(|e| Message::error(format!("{option}: {e}")).into())
}

fn as_text(document: &FitDocument) -> String {
    let mut text = String::new();
    let vector = |v: &Vector| format!("{:.6} {:.6} {:.6}", v[0], v[1], v[2]);
    let label = document.label.as_deref().map(|l| format!(" `{l}`")).unwrap_or_default();
    let _ = writeln!(text, "{}{label}: {} points", document.element, document.points);
    let u = document.standard_uncertainty.as_ref();
    let mut line = |name: &str, value: Option<String>, unit: &str, u: Option<f64>| {
        if let Some(value) = value {
            let u = u.map(|u| format!("  (u = {u:.2e} {unit})")).unwrap_or_default();
            let _ = writeln!(text, "  {name:<12} {value} {unit}{u}");
        }
    };
    let point = document.center_mm.as_ref().or(document.point_mm.as_ref());
    let point_name = if document.center_mm.is_some() { "center" } else { "point" };
    line(point_name, point.map(vector), "mm", u.map(|u| u.point_mm));
    line("normal", document.normal.as_ref().map(vector), "", None);
    line("axis", document.axis.as_ref().map(vector), "", None);
    line("radius", document.radius_mm.map(|r| format!("{r:.6}")), "mm", u.and_then(|u| u.radius_mm));
    line("minor radius", document.minor_radius_mm.map(|r| format!("{r:.6}")), "mm", u.and_then(|u| u.minor_radius_mm));
    line("apex angle", document.apex_angle_deg.map(|a| format!("{a:.6}")), "deg", u.and_then(|u| u.apex_angle_deg));
    let spread = format!("rms {:.6}, max {:.6}, form {:.6}", document.rms_mm, document.max_mm, document.form_mm);
    line("residuals", Some(spread), "mm", None);
    if let Some(contacts) = &document.contacts {
        let numbers = |points: &[usize]| points.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
        let _ = writeln!(text, "  held by      points {} and {}", numbers(&contacts.upper), numbers(&contacts.lower));
    }
    text
}
