//! Command `etalon fit`.

use super::fit_text::as_text;
use super::fit_tracim;
use super::{Output, Verdict};
use crate::stages::observe::qif_fit::{ProbeStated, refit};
use crate::tasks::text_format::stated_format;
use crate::tasks::{self, Criterion, Figure, Table, TextFormat};
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::{Place, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_documents::{FitDocument, to_json};
use etalon_fit::{CircleMethod, Element, FitSettings, PackedPoints, Probe, Side, Source};
use etalon_formats::Format;
use etalon_formats::dialect::Unit;
use std::path::{Path, PathBuf};

/// Fit a geometric element to the points of files.
///
/// Points are read as PolyWorks text (`[name] x y z [i j k]`, separated by blanks) unless --format
/// or --columns sets another format. In a QIF file each measured feature is fitted to its points
/// and compared with the values in the file.
#[derive(Debug, clap::Args)]
pub struct FitCommand {
    /// Element: line, line2d, plane, circle2d, circle3d, sphere, cylinder, cone, torus,
    /// enclosing-circle or enclosing-sphere; may be omitted for QIF files, whose features are all
    /// fitted.
    #[arg(value_name = "ELEMENT")]
    element: String,
    /// Files with points.
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Format of the files as in campaigns: by name (inspec, geopak_gws, ply, stl, polyworks_report
    /// ...), or as a table of keys ('{ delimiter = ";", columns = ["label", "x", "y", "z"] }').
    #[arg(long, value_name = "FORMAT", conflicts_with_all = ["columns", "angle_unit"])]
    format: Option<String>,
    #[command(flatten)]
    text: TextFormat,
    /// Fit each label separately instead of all points together.
    #[arg(long)]
    by_label: bool,
    #[command(flatten)]
    least_squares: LeastSquaresOptions,
    #[command(flatten)]
    probe: ProbeOptions,
    /// Fit a line2d, plane, circle2d, circle3d, sphere, cylinder or cone by minimum zone
    /// (Chebyshev) instead of least squares: the form of ISO 1101.
    #[arg(long, conflicts_with_all = [
        "radius_mm", "orthogonal", "probe_radius_mm", "probe_side", "standard_uncertainty_um",
    ])]
    minimum_zone: bool,
    /// Exclude points that are far from the element of all others, and list them (trimmed least
    /// squares).
    #[arg(long, conflicts_with = "minimum_zone")]
    robust: bool,
    /// Print JSON: an object, or a list of objects with --by-label and for QIF.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    test: TracimOptions,
}

/// Options of a fit by least squares.
#[derive(Clone, Copy, Debug, clap::Args)]
struct LeastSquaresOptions {
    /// Keep this radius of a circle, sphere or cylinder during the fit.
    #[arg(long, value_name = "MM")]
    radius_mm: Option<f64>,
    /// Standard uncertainty (k = 1) of one point in micrometres; by default estimated from the
    /// residuals.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Fit a circle in space by orthogonal distances instead of plane, projection and circle.
    #[arg(long)]
    orthogonal: bool,
}

/// Options of a test of TraCIM.
#[derive(Clone, Debug, clap::Args)]
struct TracimOptions {
    /// Answer a test of TraCIM (PTB): the only file is the test data, and the answer is XML.
    #[arg(long, conflicts_with_all = [
        "files", "format", "columns", "unit", "by_label", "radius_mm", "probe_radius_mm", "probe_side", "orthogonal",
        "minimum_zone", "robust", "json", "standard_uncertainty_um",
    ])]
    tracim: bool,
    /// Customer as registered with TraCIM.
    #[arg(long, value_name = "NAME", requires = "tracim")]
    customer: Option<String>,
}

/// Probe whose centres are the points.
#[derive(Clone, Debug, clap::Args)]
struct ProbeOptions {
    /// Radius of the probe whose centres are the points; the element is offset to the surface.
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    probe_radius_mm: Option<f64>,
    /// Side of the probe: inside or outside; for a plane or line the direction to the probe, e.g.
    /// 0,0,1.
    #[arg(long, value_name = "SIDE", allow_hyphen_values = true)]
    probe_side: Option<String>,
}

impl FitCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if self.test.tracim {
            out.print_text(&fit_tracim::answer(Path::new(&self.element), self.test.customer.as_deref(), out)?)?;
            return Ok(Verdict::Met);
        }
        let (documents, qif) = match self.plain()? {
            Some(points) => (vec![self.fit("", Source::from(&points))?], false),
            None => {
                let texts = self.texts()?;
                let qif = texts.iter().any(|(_, text)| etalon_formats::qif::is_xml(text));
                (if qif { self.measured_features(&texts, out)? } else { self.groups(&texts, out)? }, qif)
            }
        };
        documents.iter().flat_map(|d| &d.messages).for_each(|message| out.say_message(message));
        match (&documents[..], self.json) {
            ([one], true) if !self.by_label && !qif => out.print(to_json(one)?)?,
            (all, true) => out.print(to_json(&all)?)?,
            (all, false) => out.print_text(&all.iter().map(as_text).collect::<String>())?,
        }
        Ok(Verdict::Met)
    }

    /// Names and texts of all files; a file may be given instead of the element.
    fn texts(&self) -> Result<Vec<(String, String)>, Problems> {
        let first = PathBuf::from(&self.element);
        let paths = if self.all_features() { [&[first], &self.files[..]].concat() } else { self.files.clone() };
        let format = self.format()?;
        let texts =
            paths.iter().map(|path| Ok((path.display().to_string(), self.text.text(Table::File(path), &format)?)));
        let texts: Vec<_> = texts.collect::<Result<_, Problems>>()?;
        if texts.is_empty() {
            return Err(error!("fit-file-missing", element = self.element).into());
        }
        match texts.iter().find(|(_, text)| self.all_features() && !etalon_formats::qif::is_xml(text)) {
            Some((file, _)) => Err(error!("fit-element-missing", file).at(Place::file(file)).into()),
            None => Ok(texts),
        }
    }

    /// `true` if a file is given instead of the element.
    fn all_features(&self) -> bool {
        self.element.parse::<Figure>().is_err() && Path::new(&self.element).is_file()
    }

    /// Fits all points together, or each label separately.
    fn groups(&self, texts: &[(String, String)], out: &Output) -> Result<Vec<FitDocument>, Problems> {
        let points = self.read(texts, out)?;
        let mut groups: Vec<(String, Vec<Vector>)> = Vec::new();
        for (label, p) in points {
            let name = if self.by_label { label } else { String::new() };
            match groups.iter_mut().find(|g| g.0 == name) {
                Some(group) => group.1.push(p),
                None => groups.push((name, vec![p])),
            }
        }
        if groups.is_empty() {
            groups.push((String::new(), Vec::new()));
        }
        groups.iter().map(|(label, points)| self.fit(label, Source::from(points))).collect()
    }

    /// Fits the measured features of QIF files; features that cannot be fitted are reported and
    /// omitted.
    fn measured_features(&self, texts: &[(String, String)], out: &Output) -> Result<Vec<FitDocument>, Problems> {
        if self.least_squares.radius_mm.is_some() || self.text.stated() {
            return Err(error!("qif-with-columns").into());
        }
        if self.robust {
            return Err(error!("qif-robust").into());
        }
        let wanted = (!self.all_features()).then(|| self.element.parse::<Element>()).transpose()?;
        let unit = self.text.stated_unit()?;
        let probe = ProbeStated { radius_mm: self.probe.probe_radius_mm, side: self.side()? };
        let mut documents = Vec::new();
        let mut seen = Vec::new();
        for (file, text) in texts {
            let read = etalon_formats::qif::read(file, text, unit.map(Unit::in_mm))?;
            out.remark(&read.messages);
            for feature in &read.features {
                seen.extend(feature.element().map(Element::name).filter(|_| !feature.points_mm.is_empty()));
                if wanted.is_some_and(|w| feature.element() != Some(w)) {
                    continue;
                }
                match refit(feature, &self.settings(None), probe) {
                    Ok(document) => documents.extend(document),
                    Err(problems) => problems.0.iter().for_each(|message| out.say_message(message)),
                }
            }
        }
        if documents.is_empty() {
            seen.sort_unstable();
            seen.dedup();
            let there = if seen.is_empty() { phrase!("fit-seen-none").argument() } else { seen.join(", ").argument() };
            let kind = wanted.map_or_else(|| phrase!("fit-any-element").argument(), |kind| kind.name().argument());
            return Err(error!("no-feature-fitted", kind, seen = there).into());
        }
        Ok(documents)
    }

    /// Settings of the options, with a probe.
    fn settings(&self, probe: Option<Probe>) -> FitSettings<'static> {
        let LeastSquaresOptions { radius_mm, standard_uncertainty_um, orthogonal } = self.least_squares;
        let circle = if orthogonal { CircleMethod::Orthogonal } else { CircleMethod::Projected };
        let standard_uncertainty_mm = standard_uncertainty_um.map(|u| u / 1000.0);
        FitSettings { radius_mm, circle, probe, standard_uncertainty_mm, ..FitSettings::default() }
    }

    /// Given side of the probe, if any.
    fn side(&self) -> Result<Option<Side>, Problems> {
        let Some(text) = self.probe.probe_side.as_deref() else { return Ok(None) };
        let numbers: Option<Vec<f64>> = text.split(',').map(|n| n.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[x, y, z]) => Ok(Some(Side::Towards([x, y, z]))),
            _ => tasks::named_side(text).map(Some),
        }
    }

    /// Labels and points of all files (mm).
    fn read(&self, texts: &[(String, String)], out: &Output) -> Result<Vec<(String, Vector)>, Problems> {
        let format = self.format()?;
        let mut all = Vec::new();
        for (file, text) in texts {
            let unit = self.text.unit(&format, text).map_err(|problems| problems.at(&Place::file(file)))?;
            let (points, refused) = etalon_formats::points_and_refused(file, text, &format, unit)?;
            let warnings = format.caution().map(|warning| warning.at(Place::file(file)));
            warnings.iter().chain(&refused).for_each(|message| out.say_message(message));
            all.extend(points);
        }
        Ok(all)
    }

    /// Points of all files, if all are plain tables and no label matters.
    fn plain(&self) -> Result<Option<PackedPoints>, Problems> {
        if !self.text.is_of_plain_text() || self.by_label || self.all_features() {
            return Ok(None);
        }
        let (format, unit) = (self.format()?, self.text.stated_unit()?);
        let mut all = PackedPoints::default();
        for path in self.files.iter() {
            match etalon_formats::packed_points(path, &format, unit) {
                Ok(Some(points)) => all.append(points),
                _ => return Ok(None),
            }
        }
        Ok((!all.is_empty()).then_some(all))
    }

    /// Format of the options.
    fn format(&self) -> Result<Format, Problems> {
        self.format.as_deref().map_or_else(|| self.text.format(), stated_format)
    }

    fn fit(&self, label: &str, points: Source) -> Result<FitDocument, Problems> {
        let figure: Figure = self.element.parse()?;
        let criterion = match (self.minimum_zone, self.robust) {
            (true, _) => Criterion::MinimumZone,
            (_, true) => Criterion::Robust,
            _ => Criterion::LeastSquares,
        };
        let settings = self.settings(tasks::stated_probe(self.probe.probe_radius_mm, self.side()?)?);
        let mut document = tasks::fit(figure, criterion, &points, &settings)?.document;
        document.label = (!label.is_empty()).then(|| label.to_owned());
        Ok(document)
    }
}
