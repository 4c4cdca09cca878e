//! Keys of `campaign.toml` and `robot.toml`: docs/*.md list them from the schemas, and every sample follows these.

use crate::support::root;
use etalon::robots::{Quantity, Role};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Units by the ending of a key.
const UNITS: [(&str, &str); 17] = [
    ("_um_per_m", "µm/m"),
    ("_per_c", "1/°C"),
    ("_uncertainty_c", "°C"),
    ("_mm_s", "mm/s"),
    ("_mm", "mm"),
    ("_um", "µm"),
    ("_deg", "deg"),
    ("_hz", "Hz"),
    ("_s", "s"),
    ("_rad", "rad"),
    ("_m", "m"),
    ("_kg", "kg"),
    ("_percent", "%"),
    ("_minutes", "min"),
    ("_months", "months"),
    ("temperature_c", "°C"),
    ("per_count", "of the joint"),
];
/// Numbers without a unit.
const PURE: [&str; 15] = [
    "coverage_factor",
    "cycle",
    "tolerance",
    "seed",
    "drift_set",
    "path_points",
    "weave_across",
    "actuator",
    "occurrence",
    "number",
    "zero_count",
    "header",
    "widths",
    "gravity",
    "direction",
];

/// One schema, and the schemas to which it refers.
struct Schema(Value);

/// A table of keys.
struct Section<'a> {
    title: String,
    /// How examples reach it; `*` is any name.
    path: Vec<String>,
    schema: &'a Value,
}

impl Schema {
    fn of(name: &str) -> Self {
        let (_, text) = etalon::campaign::SCHEMAS.iter().find(|(n, _)| *n == name).unwrap();
        Self(serde_json::from_str(text).unwrap())
    }

    /// The schemas of which a value has to meet one; `null` is left out.
    fn alternatives<'a>(&'a self, schema: &'a Value) -> Vec<&'a Value> {
        if let Some(name) = schema["$ref"].as_str() {
            return self.alternatives(&self.0["$defs"][name.rsplit('/').next().unwrap()]);
        }
        match schema.get("anyOf").or(schema.get("oneOf")).and_then(Value::as_array) {
            Some(all) => all.iter().flat_map(|s| self.alternatives(s)).collect(),
            None if schema["type"] == "null" => Vec::new(),
            None => vec![schema],
        }
    }

    /// This table and the tables in it, each once.
    fn sections<'a>(&'a self, title: &str, path: &[String], schema: &'a Value, all: &mut Vec<Section<'a>>) {
        if all.iter().any(|section| std::ptr::eq(section.schema, schema)) {
            return;
        }
        all.push(Section { title: title.to_owned(), path: path.to_vec(), schema });
        for (key, value) in schema["properties"].as_object().unwrap() {
            let alternatives = self.alternatives(value);
            let here = [path, std::slice::from_ref(key)].concat();
            let name = here.join(".");
            let single = alternatives.len() == 1 && (!title.contains("[[") || title.starts_with("`[log"));
            for s in &alternatives {
                match (is_table(s), self.named(s), self.listed(s)) {
                    (true, ..) if single => self.sections(&format!("`[{name}]`"), &here, s, all),
                    (true, ..) if path.is_empty() => {
                        self.sections(&format!("`[{name}]`, `[[{name}]]`"), &here, s, all);
                    }
                    (true, ..) => self.sections(&format!("`{key}` of {title}"), &here, s, all),
                    (_, Some(s), _) if single => {
                        self.sections(&format!("`[{name}.NAME]`"), &[&here[..], &["*".to_owned()]].concat(), s, all);
                    }
                    (_, Some(s), _) => {
                        let here = [&here[..], &["*".to_owned()]].concat();
                        self.sections(&format!("one of `{key}` of {title}"), &here, s, all);
                    }
                    // a table or a list of them is described once
                    (.., Some(s)) if !alternatives.iter().any(|s| is_table(s)) => {
                        self.sections(&format!("`[[{name}]]`"), &here, s, all);
                    }
                    _ => {}
                }
            }
        }
    }

    /// The table that each of the values is, of a table by name.
    fn named<'a>(&'a self, schema: &'a Value) -> Option<&'a Value> {
        let values = schema.get("additionalProperties").filter(|v| v.is_object())?;
        self.alternatives(values).into_iter().find(|s| is_table(s))
    }

    /// The table that each of the elements is.
    fn listed<'a>(&'a self, schema: &'a Value) -> Option<&'a Value> {
        self.alternatives(schema.get("items")?).into_iter().find(|s| is_table(s))
    }

    /// What a value may be, in words.
    fn kind(&self, schema: &Value) -> String {
        let mut kinds: Vec<String> = Vec::new();
        for s in self.alternatives(schema) {
            let words = s.get("const").map(|v| vec![format!("`{v}`")]);
            let words = words.or(s["enum"].as_array().map(|all| all.iter().map(|v| format!("`{v}`")).collect()));
            let kind = match type_of(s) {
                "string" => "text".to_owned(),
                "boolean" => "`true`, `false`".to_owned(),
                "array" if s["items"].is_object() => format!("list: {}", self.kind(&s["items"])),
                "array" => "list".to_owned(),
                "object" => "table".to_owned(),
                other => other.to_owned(),
            };
            kinds.extend(words.unwrap_or_else(|| vec![kind]).into_iter().filter(|k| *k != "`null`"));
        }
        kinds.dedup();
        kinds.join(", ")
    }

    fn is_number(&self, schema: &Value) -> bool {
        self.alternatives(schema).iter().any(|s| match type_of(s) {
            // numbers among texts are names
            "array" => self.is_number(&s["items"]) && !self.kind(&s["items"]).contains("text"),
            kind => ["number", "integer"].contains(&kind),
        })
    }

    /// What is wrong with a value, by the path of the key.
    fn check(&self, value: &Value, schema: &Value, path: &str) -> Result<(), String> {
        let alternatives = self.alternatives(schema);
        let tried: Vec<_> = alternatives.iter().map(|s| self.check_one(value, s, path)).collect();
        match tried.iter().any(Result::is_ok) {
            true => Ok(()),
            false => Err(tried.into_iter().filter_map(Result::err).collect::<Vec<_>>().join("; ")),
        }
    }

    fn check_one(&self, value: &Value, schema: &Value, path: &str) -> Result<(), String> {
        let allowed = schema["enum"].as_array().is_none_or(|all| all.contains(value));
        let same = schema.get("const").is_none_or(|constant| constant == value);
        let fits = match type_of(schema) {
            "string" => value.is_string(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_i64() || value.is_u64(),
            "number" => value.is_number(),
            "array" => value.is_array(),
            "object" => value.is_object(),
            _ => schema.get("const").is_some() || schema.get("enum").is_some(),
        };
        if !(allowed && same && fits) {
            return Err(format!("{path}: {value} is not {}", self.kind(schema)));
        }
        for element in value.as_array().into_iter().flatten().filter(|_| schema["items"].is_object()) {
            self.check(element, &schema["items"], path)?;
        }
        let Some(table) = value.as_object() else { return Ok(()) };
        for key in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            table.get(key).ok_or_else(|| format!("{path}.{key} is missing"))?;
        }
        for (key, value) in table {
            let others = schema.get("additionalProperties").filter(|s| s.is_object());
            let known = schema["properties"].get(key).or(others);
            self.check(value, known.ok_or_else(|| format!("{path}.{key} is unknown"))?, &format!("{path}.{key}"))?;
        }
        Ok(())
    }
}

fn is_table(schema: &Value) -> bool {
    schema["properties"].is_object()
}

/// The type, of an optional value that which it has if it is there.
fn type_of(schema: &Value) -> &str {
    let several = schema["type"].as_array().and_then(|all| all.iter().filter_map(Value::as_str).find(|t| *t != "null"));
    several.or(schema["type"].as_str()).unwrap_or("")
}

/// The first value at the path in any of the examples.
fn example(values: &[&toml::Value], path: &[String]) -> Option<toml::Value> {
    let Some((key, rest)) = path.split_first() else { return values.first().map(|v| (*v).clone()) };
    let inner: Vec<&toml::Value> = values
        .iter()
        .flat_map(|value| match value {
            toml::Value::Array(all) => all.iter().collect(),
            other => vec![*other],
        })
        .filter_map(toml::Value::as_table)
        .flat_map(|table| table.iter().filter(|(name, _)| *name == key || key == "*").map(|(_, value)| value))
        .collect();
    example(&inner, rest)
}

/// A row of a list of keys: key, value with unit and default, meaning, example.
#[derive(Clone)]
struct Row {
    key: String,
    value: String,
    meaning: String,
    example: String,
}

impl Row {
    fn markdown(&self) -> String {
        let cells = [&format!("`{}`", self.key), &self.value, &self.meaning, &self.example];
        format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "))
    }

    /// Text by which the key of two sections is the same key.
    fn sense(&self) -> [String; 3] {
        [self.key.clone(), self.value.clone(), self.meaning.clone()]
    }
}

/// Rows of a section; what lacks a meaning, a unit or an example is in `wrong`.
fn rows(schema: &Schema, section: &Section, examples: &[toml::Value], wrong: &mut String) -> Vec<Row> {
    let required: Vec<&str> =
        section.schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let mut keys: Vec<(&String, &Value)> = section.schema["properties"].as_object().unwrap().iter().collect();
    keys.sort_by_key(|(key, _)| !required.contains(&key.as_str()));
    let row = |(key, value): (&String, &Value)| {
        let here = [&section.path[..], std::slice::from_ref(key)].concat();
        let unit = UNITS.iter().find(|(ending, _)| key.ends_with(ending)).map(|(_, unit)| *unit);
        let unit = match (schema.is_number(value), unit) {
            (true, Some(unit)) => format!(" ({unit})"),
            (true, None) if PURE.contains(&key.as_str()) => " (1)".to_owned(),
            (true, None) => {
                let _ = writeln!(wrong, "{}: no unit", here.join("."));
                String::new()
            }
            (false, _) => String::new(),
        };
        let meaning = value["description"].as_str().unwrap_or_default().replace('\n', " ");
        let shown = example(&examples.iter().collect::<Vec<_>>(), &here);
        // another name of `sheet`, which a section that stands once cannot state beside it
        let shown = shown.or_else(|| (key == "topic").then(|| toml::Value::from("/joint_states")));
        if meaning.is_empty() || shown.is_none() {
            let _ = writeln!(wrong, "{}: no meaning or no example", here.join("."));
        }
        let example = match shown {
            // these have a list of their own
            Some(toml::Value::Table(_)) | None => String::new(),
            Some(toml::Value::Array(all)) if all.iter().any(toml::Value::is_table) => String::new(),
            Some(value) => format!("`{value}`"),
        };
        let default = match value.get("default") {
            _ if required.contains(&key.as_str()) => "; required".to_owned(),
            None | Some(Value::Null | Value::Object(_)) => String::new(),
            Some(Value::Array(all)) if all.is_empty() => String::new(),
            Some(value) => format!("; default `{value}`"),
        };
        Row { key: key.clone(), value: schema.kind(value) + &unit + &default, meaning, example }
    };
    keys.into_iter().map(row).collect()
}

/// Minimum number of sections with the same key that is listed once for all of them.
const COMMON: usize = 4;

/// The list of keys in Markdown.
fn listing(schema: &Schema, examples: &[toml::Value], wrong: &mut String) -> String {
    const HEAD: &str = "| key | value | meaning | example |\n| --- | --- | --- | --- |\n";
    let mut sections = Vec::new();
    schema.sections("the file itself", &[], &schema.0, &mut sections);
    let all: Vec<Vec<Row>> = sections.iter().map(|section| rows(schema, section, examples, wrong)).collect();
    let mut uses: BTreeMap<[String; 3], usize> = BTreeMap::new();
    all.iter().flatten().for_each(|row| *uses.entry(row.sense()).or_default() += 1);
    let mut common: BTreeMap<String, Row> = BTreeMap::new();
    let mut text = String::new();
    for (Section { title, path, schema: table }, rows) in sections.iter().zip(&all) {
        let (shared, own): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| uses[&row.sense()] >= COMMON);
        let _ = write!(text, "### {}\n\n", title[..1].to_uppercase() + &title[1..]);
        if !path.is_empty() {
            let meaning = table["description"].as_str().unwrap_or_default().replace('\n', " ");
            let _ = write!(text, "{meaning}\n\n");
        }
        if !own.is_empty() {
            text += HEAD;
            text.extend(own.iter().map(|row| row.markdown()));
            text.push('\n');
        }
        if !shared.is_empty() {
            let names: Vec<String> = shared.iter().map(|row| format!("`{}`", row.key)).collect();
            let _ = write!(text, "[Keys of tables](#keys-of-tables): {}.\n\n", names.join(", "));
        }
        for row in shared {
            let known = common.entry(row.key.clone()).or_insert_with(|| row.clone());
            assert_eq!(known.sense(), row.sense(), "`{}` has two common meanings", row.key);
            // most sections have no place for an example
            if known.example.is_empty() {
                known.example.clone_from(&row.example);
            }
        }
    }
    if !common.is_empty() {
        text +=
            "### Keys of tables\n\nThese keys are the same in all sections that name them ([tables](tables.md)).\n\n";
        text += HEAD;
        text.extend(common.values().map(Row::markdown));
        text.push('\n');
    }
    text
}

fn read(path: &Path) -> toml::Value {
    std::fs::read_to_string(path).unwrap().parse::<toml::Table>().map(toml::Value::Table).unwrap()
}

/// Files of this name in the samples and in `src/cli/init`.
fn samples(name: &str) -> Vec<PathBuf> {
    let root = root();
    let folders = std::fs::read_dir(root.join("samples")).unwrap().flatten().map(|entry| entry.path());
    let mut all: Vec<PathBuf> = folders.chain([root.join("src/cli/init")]).map(|folder| folder.join(name)).collect();
    all.retain(|path| path.is_file());
    all.sort();
    all
}

/// The parameters that `[nominal]` may state for a robot.
fn parameters(file: &Path) -> String {
    let robot = etalon::campaign::read_robot(file).unwrap().build(&["T".to_owned()]).unwrap();
    let mut text = format!("### `[nominal]` of `{}`\n\n", robot.model());
    text += "| parameter | unit | of | default |\n| --- | --- | --- | --- |\n";
    for p in robot.parameters() {
        let of = format!("{:?}", p.role).to_lowercase();
        // geometry of one machine is not that of another
        let stated = p.role == Role::Robot && p.quantity != Quantity::Ratio && p.nominal != 0.0;
        let default = if stated { "required".to_owned() } else { p.quantity.outward(p.nominal).to_string() };
        let _ = writeln!(text, "| `{}` | {} | {of} | {default} |", p.name, p.quantity.unit());
    }
    text + "\n"
}

/// Compares the list of keys in a page with what the schema makes, and with `more` below it.
fn check_page(name: &str, page: &str, examples: &[PathBuf], more: &str) {
    const MARK: &str = "<!-- From here on made from the types: ETALON_UPDATE=1 cargo test keys -->\n";
    let schema = Schema::of(name);
    let read: Vec<toml::Value> = examples.iter().map(|path| read(path)).collect();
    let mut wrong = String::new();
    let list = listing(&schema, &read, &mut wrong) + more;
    assert!(wrong.is_empty(), "{name}:\n{wrong}");
    let text = std::fs::read_to_string(root().join(page)).unwrap();
    let (above, _) = text.split_once(MARK).expect("the page has the mark");
    super::compare(page, &format!("{above}{MARK}\n{}\n", list.trim_end()));
}

fn check_values(name: &str, files: &[PathBuf]) {
    let schema = Schema::of(name);
    for path in files {
        let value = serde_json::to_value(read(path)).unwrap();
        schema.check(&value, &schema.0, "").unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    }
}

#[test]
fn keys_of_campaigns_are_documented() {
    let all = root().join("docs/keys/campaign.toml");
    let (_, problems) = etalon::campaign::Campaign::recover(&all).unwrap();
    let keys: Vec<_> = problems.0.iter().filter(|m| !m.what.contains("robot.toml")).collect();
    assert!(keys.is_empty(), "{keys:?}");
    check_page("campaign.toml", "docs/campaign.md", std::slice::from_ref(&all), "");
    check_values("campaign.toml", &[samples("campaign.toml"), vec![all]].concat());
}

#[test]
fn keys_of_robots_are_documented() {
    let folder = root().join("docs/keys");
    let all = [
        "prexyt",
        "five_bar",
        "serial",
        "serial-dh",
        "serial-poe",
        "urdf",
        "urdf-branches",
        "hexapod",
        "delta",
        "delta_linear",
    ]
    .map(|model| folder.join(format!("robot-{model}.toml")));
    for path in &all {
        let robot = etalon::campaign::read_robot(path).unwrap();
        robot.build(&["T".to_owned()]).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    }
    // joints of a serial arm state their own
    let nominal = all[..2].iter().map(|path| parameters(path)).collect::<String>();
    check_page("robot.toml", "docs/robot.md", &all, &nominal);
    check_values("robot.toml", &[samples("robot.toml"), all.to_vec()].concat());
}

#[test]
fn schemas_refuse_what_campaigns_do_not_have() {
    let schema = Schema::of("campaign.toml");
    let whole = std::fs::read_to_string("samples/prexyt-cmm/campaign.toml").unwrap();
    for (from, to) in [
        ("coverage_factor = 2", "coverage_factor = \"two\""),
        ("unit = \"mm\"", "unit = \"furlong\""),
        ("origin = ", "orgin = "),
        ("expanded_uncertainty_um = 2.7\n", ""),
        ("by = [\"pose\", \"cycle\"]", "by = \"colour\""),
    ] {
        assert!(whole.contains(from), "{from}");
        let value: BTreeMap<String, toml::Value> = toml::from_str(&whole.replacen(from, to, 1)).unwrap();
        assert!(schema.check(&serde_json::to_value(value).unwrap(), &schema.0, "").is_err(), "{to}");
    }
}
